"""Proofs: what is proved of the rounding errors of the kernels that come with the package."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from importlib.resources import files

from mechproof.measured import KERNELS, Record
from mechproof.roundoff.certificate import Certificate, Claim
from mechproof.roundoff.compiled import WAY
from mechproof.roundoff.files import find_certificate


def list_claims(record: Record) -> tuple[Claim, ...]:
    """List what is proved of a quantity's kernels, none if they are not of the package."""
    certificate = _find_packaged(record.quantity.partition(".")[0])
    return select_claims(record, [certificate] if certificate else ())


def select_claims(record: Record, certificates: Iterable[Certificate]) -> tuple[Claim, ...]:
    """List what certificates claim of a quantity."""
    claims = ((f"{c.system}.{claim.quantity}", claim) for c in certificates for claim in c.claims)
    return tuple(claim for name, claim in claims if name == record.quantity)


@cache
def _find_packaged(system: str) -> Certificate | None:
    return find_certificate(files(KERNELS), system)


def find_way(record: Record, claim: Claim) -> str:
    """Return the way of a record that a claim is about."""
    shipped = record.ways[0].name
    return f"{shipped}, {WAY}" if claim.way == WAY else shipped


def find_proved(record: Record) -> Mapping[str, float]:
    """Return the largest bound of all forms of a way, in eps of the scale."""
    proved: dict[str, float] = {}
    for claim in list_claims(record):
        way = find_way(record, claim)
        proved[way] = max(claim.proved, proved.get(way, 0.0))
    return proved


def tell_where(record: Record) -> str:
    """Say for which arguments the bounds are, form by form; nothing without any."""
    places = {claim.form: " or ".join(claim.where) for claim in list_claims(record)}
    told = "; ".join(f"{form}, where {where}" for form, where in places.items())
    return f"Proved: {told}." if told else ""
