"""Proofs: what is proved of the rounding errors of the kernels that come with the package."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from importlib.resources import files

from mechproof.measured import KERNELS, Record
from mechproof.roundoff.certificate import Certificate, Claim
from mechproof.roundoff.compiled import WAY
from mechproof.roundoff.files import find_certificate

AT_MOST = "\N{LESS-THAN OR EQUAL TO}"


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


def tell_proved(record: Record) -> Mapping[str, str]:
    """Tell the largest bound of all forms of a way, and the worst error found, in eps."""
    claims: dict[str, list[Claim]] = {}
    for claim in list_claims(record):
        claims.setdefault(find_way(record, claim), []).append(claim)
    return {way: _tell_largest(mine) for way, mine in claims.items()}


def _tell_largest(claims: Iterable[Claim]) -> str:
    found, proved = (
        max(numbers) for numbers in zip(*((c.found, c.proved) for c in claims), strict=True)
    )
    return f"found {found:.3g}, proved {AT_MOST} {proved:g}"


def tell_where(record: Record) -> str:
    """Say for which arguments the bounds are, form by form; nothing without any."""
    places = {claim.form: " or ".join(claim.where) for claim in list_claims(record)}
    told = "; ".join(f"{form}, where {where}" for form, where in places.items())
    return f"Proved: {told}." if told else ""
