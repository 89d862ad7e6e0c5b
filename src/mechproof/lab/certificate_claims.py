"""Certificate claims: what is proved of the rounding errors of the kernels of the package."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from importlib.resources import files

from mechproof.lab.chart_points import write_eps
from mechproof.measured import KERNELS, Record
from mechproof.roundoff.certificate import Certificate, RoundingClaim, tell_bound, tell_place
from mechproof.roundoff.certificate_files import find_certificate
from mechproof.roundoff.compiled_kernels import WAY
from mechproof.roundoff.premises import NORMAL

AT_MOST = "\N{LESS-THAN OR EQUAL TO}"


def list_claims(record: Record) -> tuple[RoundingClaim, ...]:
    """List what is proved of a quantity's kernels, none if they are not of the package."""
    certificate = _find_packaged(record.quantity.partition(".")[0])
    return select_claims(record, [certificate] if certificate else ())


def select_claims(record: Record, certificates: Iterable[Certificate]) -> tuple[RoundingClaim, ...]:
    """List what certificates claim of a quantity."""
    claims = ((f"{c.system}.{claim.quantity}", claim) for c in certificates for claim in c.claims)
    return tuple(claim for name, claim in claims if name == record.quantity)


@cache
def _find_packaged(system: str) -> Certificate | None:
    return find_certificate(files(KERNELS), system)


def find_way(record: Record, claim: RoundingClaim) -> str:
    """Return the way of a record that a claim is about."""
    shipped = record.ways[0].name
    return f"{shipped}, {WAY}" if claim.way == WAY else shipped


def find_searched(record: Record) -> Mapping[str, float]:
    """Find the worst error in eps that searches found for each way, when measuring or proving."""
    found = [(searched.way, searched.scaled) for searched in record.searched]
    found += [(find_way(record, claim), claim.found) for claim in list_claims(record)]
    return {way: max(error for name, error in found if name == way) for way, _ in found}


def tell_proved(record: Record) -> Mapping[str, str]:
    """Tell the largest bound of all forms of a way, and the worst error that was found, in eps."""
    highest: dict[str, RoundingClaim] = {}
    for claim in sorted(list_claims(record), key=lambda claim: claim.proved):
        highest[find_way(record, claim)] = claim
    searched = find_searched(record)
    return {
        way: f"{write_eps(searched[way])} by search, proved {AT_MOST} {tell_bound(claim)}"
        for way, claim in highest.items()
    }


def tell_where(record: Record) -> str:
    """Say for which arguments the bounds are, form by form; nothing without any."""
    places = {claim.form: tell_place(claim.where) for claim in list_claims(record)}
    told = "; ".join(f"{form}{place}" for form, place in places.items())
    return f"Proved: {told}; provided {NORMAL}." if told else ""
