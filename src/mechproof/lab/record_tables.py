"""Tables of the records: what every way loses and costs, relative to what, as one page.

Next to the measurements are the claims of the certificates: the proved bounds of rounding errors.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache
from importlib.resources import files
from itertools import groupby

from mechproof.lab.chart_points import write_eps
from mechproof.measured import (
    COPY,
    KERNELS,
    MEASURED,
    MeasuredWay,
    Record,
    Searched,
    SetErrors,
    Timing,
)
from mechproof.roundoff.certificate import (
    Certificate,
    RoundingClaim,
    describe_bound,
    describe_place,
)
from mechproof.roundoff.certificate_files import find_certificate
from mechproof.roundoff.compiled_kernels import WAY
from mechproof.roundoff.steps import NORMAL

AT_MOST = "\N{LESS-THAN OR EQUAL TO}"


def list_claims(record: Record) -> tuple[RoundingClaim, ...]:
    """Return the proved claims about a quantity's kernels; none outside the package."""
    certificate = _find_packaged(record.quantity.partition(".")[0])
    return select_claims(record, [certificate] if certificate else ())


def select_claims(record: Record, certificates: Iterable[Certificate]) -> tuple[RoundingClaim, ...]:
    """Return the claims of certificates about a quantity."""
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
    """Return the worst error in eps that any search found for each way, measuring or proving."""
    found = [(searched.way, searched.scaled) for searched in record.searched]
    found += [(find_way(record, claim), claim.found) for claim in list_claims(record)]
    return {way: max(error for name, error in found if name == way) for way, _ in found}


def describe_proved(record: Record) -> Mapping[str, str]:
    """Return, for each way, the largest bound of its forms and the worst error found, in eps."""
    highest: dict[str, RoundingClaim] = {}
    for claim in sorted(list_claims(record), key=lambda claim: claim.proved):
        highest[find_way(record, claim)] = claim
    searched = find_searched(record)
    return {
        way: f"{write_eps(searched[way])} by search, proved {AT_MOST} {describe_bound(claim)}"
        for way, claim in highest.items()
    }


def describe_where(record: Record) -> str:
    """Return the arguments for which the bounds hold, form by form; "" if there are no bounds."""
    places = {claim.form: describe_place(claim.where) for claim in list_claims(record)}
    told = "; ".join(f"{form}{place}" for form, place in places.items())
    return f"Proved: {told}; provided {NORMAL}." if told else ""


PAGE = "TABLES.md"
WAY_HEAD = (
    "way", "kind", "verdict", "points", "undecided", "worst, scaled", "worst, ulp", "mean, bits",
    "worst, absolute", "wrong branch", "nan", "inf", "fails first on",
)  # fmt: skip
SHIPPED_HEAD = ("quantity", "way", "bound", "worst on the sets", "worst searched", "tried")
PROVED_HEAD = (
    "quantity", "form", "computed", "where", "at most", "found", "worst on the sets", "assumed",
)  # fmt: skip
PROVED = """
## What is proved of rounding errors

In eps of the scale. *at most*: the bound proved over everything that is named; *found*: the worst
error that any search found, one of them starting from the boxes with the largest bounds; after it
the worst error of that way on the point sets, in all its forms.
"""
INTRODUCTION = """# What the kernels and the other ways lose and cost

Errors are measured against balls at the exact doubles, on the points of the reporting seed. The
search climbed from the points of the tuning seed, led by balls and by long doubles, and balls
judged what it found. *scaled*: the error in units of 2**-52 times the scale named with each
quantity, where the accuracy bound of the kernel holds (without such a bound, in ulp of the value);
the other columns cover all points. *bits*: log2(1 + ulps). Ways listed in one line have equal
errors. Times are medians, in ns per point, of rounds in which all ways took turns; in brackets is
the ratio to the first way in the same round. Quartiles, errors set by set, and the times of NumPy's
own functions are in the records in this folder.
"""


def headline(record: Record) -> str:
    """Return a line with the worst error of the shipped way against its accuracy bound."""
    rows = record.errors_of(record.ways[0].name)
    found = (e for s in record.searched for e in (record.worst_of(s.way), s.scaled))
    worst = max(error for error in found if error is not None)
    bound = "" if record.bound is None else f" of {record.bound:.3g}"
    points, undecided = sum(r.points for r in rows), sum(r.undecided for r in rows)
    return f"worst {worst:.3g}{bound} {record.error_unit}; {points} points, {undecided} undecided"


def list_lines(
    records: Sequence[Record],
    find_claims: Callable[[Record], Sequence[RoundingClaim]] = list_claims,
) -> Iterator[str]:
    """Yield the lines of the page, including the claims about the quantities."""
    yield INTRODUCTION
    shipped = (_describe_shipped(record, found) for record in records for found in record.searched)
    yield from _table(SHIPPED_HEAD, shipped)
    proved = [(record, claim) for record in records for claim in find_claims(record)]
    if proved:
        shared = _share_assumptions([claim for _, claim in proved])
        yield PROVED
        if shared:
            yield f"Assumed throughout: {'; '.join(shared)}.\n"
        yield from _table(PROVED_HEAD, (_describe_claim(*pair, shared) for pair in proved))
    for record in records:
        yield f"\n## {record.quantity}\n"
        yield f"Scaled: {record.error_unit}. {_describe_run(record)}\n"
        yield from _table(WAY_HEAD, _join_equal(_describe_way(record, way) for way in record.ways))
        for workload in dict.fromkeys(row.workload for row in record.times):
            yield f"\n{workload}\n"
            yield from _list_times(record, workload)
    yield ""


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    yield _line(head)
    yield _line(["-"] * len(head))
    for row in rows:
        yield _line(row)


def _join_equal(rows: Iterable[Sequence[str]]) -> Iterator[Sequence[str]]:
    """Join consecutive ways that differ in nothing but their names into one line."""
    for shared, equal in groupby(rows, key=lambda row: tuple(row[1:])):
        yield "; ".join(row[0] for row in equal), *shared


def _line(entries: Sequence[str]) -> str:
    return "|" + "|".join(entry.replace("|", r"\|") for entry in entries) + "|"


def _describe_run(record: Record) -> str:
    machine = record.machine
    simd = machine.simd[-1] if machine.simd else "no SIMD"
    quick = ", quick" if record.quick else ""
    processor = machine.processor.replace("(R)", "").removesuffix(" Processor")
    taken = (
        f"Taken {record.taken[:10]} on {processor}, {simd}, load {record.load}, "
        f"numpy {machine.versions['numpy']}{quick}."
    )
    return f"{taken} {record.lacking}".rstrip()


def _describe_shipped(record: Record, found: Searched) -> Sequence[str]:
    bound, worst = _number(record.bound) or "none", _number(record.worst_of(found.way))
    searched, tried = _number(found.scaled), str(found.tried)
    return record.quantity, found.way, bound, worst, searched, tried


def _share_assumptions(claims: Sequence[RoundingClaim]) -> Sequence[str]:
    first, *others = claims
    return [text for text in first.assumptions if all(text in c.assumptions for c in others)]


def _describe_claim(record: Record, claim: RoundingClaim, shared: Sequence[str]) -> Sequence[str]:
    where = " or ".join(claim.where) or "everywhere"
    return (
        record.quantity,
        claim.form,
        claim.way.removesuffix("'s functions"),
        f"nothing shown: open at {claim.open}" if claim.open else where,
        describe_bound(claim),
        f"{claim.found:g}",
        _number(record.worst_of(find_way(record, claim))),
        "; ".join(text for text in claim.assumptions if text not in shared),
    )


def _describe_way(record: Record, way: MeasuredWay) -> Sequence[str]:
    rows = record.errors_of(way.name)
    known = [row for row in rows if row.points > row.undecided]
    return (
        way.name,
        way.kind,
        _describe_verdict(way),
        str(sum(row.points for row in rows)),
        _count(row.undecided for row in rows),
        _number(record.worst_of(way.name)),
        _number(max((row.worst_ulp for row in known), default=None)),
        _number(_mean_bits(known)),
        _number(max((row.worst_absolute for row in known), default=None)),
        _count(row.wrong_branch for row in rows),
        _count(row.nan for row in rows),
        _count(row.infinite for row in rows),
        next((row.set for row in rows if row.failed), ""),
    )


def _describe_verdict(way: MeasuredWay) -> str:
    """Return the verdict with its part of the domain, and whether a bound was proved with it."""
    part = f" on {way.proved_on}" if way.proved_on else ""
    if not way.bound:
        return way.verdict + part
    return (
        way.verdict
        + (", bounded separately" if way.verdict == MEASURED else ", with its bound")
        + part
    )


def _mean_bits(rows: Sequence[SetErrors]) -> float | None:
    """Return the average over the decided points of all sets, or None without a set."""
    counts = [row.points - row.undecided for row in rows]
    bits = sum(n * row.mean_bits for n, row in zip(counts, rows, strict=True))
    return bits / sum(counts) if rows else None


def _count(numbers: Iterable[int]) -> str:
    """Return the sum as text; "" for zero, so that failures stand out."""
    total = sum(numbers)
    return str(total) if total else ""


def _number(value: float | None) -> str:
    return "" if value is None else f"{value:.3g}"


def _list_times(record: Record, workload: str) -> Iterator[str]:
    rows = [row for row in record.times if row.workload == workload]
    counts = sorted({row.count for row in rows})
    by_place = {(row.way, row.count): row for row in rows}
    names = (*(way.name for way in record.ways), COPY)
    head = ("way", *(f"N = {count}" for count in counts))
    yield from _table(head, ([n, *(_time(by_place.get((n, c))) for c in counts)] for n in names))


def _time(row: Timing | None) -> str:
    """Return median and ratio as text, or "not timed" for a way too slow for the size."""
    if row is None:
        return "not timed"
    return f"{row.median:.3g}" + (f" ({row.ratio:.3g})" if row.ratio else "")
