"""The search for all drives with a cylindrical and an oval pair that dwell, by tooth numbers."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Literal, NamedTuple

from mechproof.arguments.scalars import refuse, require
from mechproof.mechanisms.dwells.ratio import Place, Span
from mechproof.mechanisms.parameters import Number, check_number, check_teeth
from mechproof.tools.extras import describe_missing

CONVEX = Fraction(1, 3)
SHOWN = 20
PRECISION = 128
HEAD = "  z4   z5  e2 from       to     best  dwell, °   step, °  exact e2   place     larger"
PLACES = {"slowest": "x = π", "fastest": "x = 0", "turns": "turns"}


class Dwell(NamedTuple):
    """Drives that dwell: teeth of the cylindrical pair 4-5 and eccentricities of the oval pair.

    From `low` to `high`, the dwell is at least as long as asked; at `best` it is longest, over the
    carrier angle `width` (rad). `exact` is the eccentricity at which the ratio has a double zero,
    if it is among them. `step` is the advance of the output from one dwell to the next (rad).
    `place` is where the carrier passes the dwell: "slowest" (about x = pi) and "fastest" (x = 0) of
    wheel 3 against the carrier, or "turns", where the output turns back. `larger` counts the pairs
    within the limits that have the same ratio with more teeth.
    """

    z4: int
    z5: int
    low: Fraction
    high: Fraction
    best: Fraction
    width: float
    exact: Fraction | None
    step: float
    place: Place
    larger: int

    @property
    def _degrees(self) -> tuple[float, float]:
        return math.degrees(self.width), math.degrees(self.step)

    def __str__(self) -> str:
        """Return a line of the table."""
        low, high, best = map(float, (self.low, self.high, self.best))
        exact, (width, step) = str(self.exact or ""), self._degrees
        return (
            f"{self.z4:4d} {self.z5:4d}  {low:.6f} {high:.6f} {best:.6f}  "
            f"{width:8.3f} {step:9.3f}  {exact:<9}  {PLACES[self.place]:<8} {self.larger:7d}"
        )


class DwellInDegrees(Dwell):
    """A `Dwell` whose `width` and `step` are in degrees."""

    @property
    def _degrees(self) -> tuple[float, float]:
        return self.width, self.step


DWELL_ANGLES = {"width": "rad", "step": "rad"}
Rank = Literal["width", "step", "teeth"]
RANKS: dict[str, Callable[[Dwell], tuple[Any, ...]]] = {
    "width": lambda d: (-d.width, d.z4 + d.z5, d.low),
    "step": lambda d: (-abs(d.step), d.z4 + d.z5, d.low),
    "teeth": lambda d: (d.z4 + d.z5, -d.width, d.low),
}


@dataclass(frozen=True)
class Dwells:
    """All drives that dwell within the limits, ranked; printed as a table.

    `pairs` of tooth numbers with `ratios` different ratios were examined. `open` has those, with
    the reason, whose eccentricities could not be decided; without any, it is `complete`.
    """

    asked: str
    candidates: tuple[Dwell, ...]
    open: tuple[tuple[int, int, str], ...]
    pairs: int
    ratios: int

    @property
    def complete(self) -> bool:
        """Whether the candidates include every drive within the limits that dwells as asked."""
        return not self.open

    def __len__(self) -> int:
        """Return the number of candidates."""
        return len(self.candidates)

    def __str__(self) -> str:
        """Return the table of the first 20 candidates, and what was examined."""
        lines = [self.asked, HEAD, *map(str, self.candidates[:SHOWN])]
        if (more := len(self.candidates) - SHOWN) > 0:
            lines.append(f"and {more} more, in .candidates")
        lines.append(
            f"{len(self)} found; {self.pairs} pairs of tooth numbers, {self.ratios} ratios examined"
        )
        lines += [f"open: {z4}/{z5}, {reason}" for z4, z5, reason in self.open]
        if self.complete:
            lines.append("complete: in balls, by the proved rows 'dwells, ...' of the ledger")
        return "\n".join(lines)


def find_dwells(
    width: Any,
    *,
    eta: Any = None,
    band: Any = None,
    teeth: tuple[int, int] = (17, 60),
    largest_e: Any = CONVEX,
    rank: Rank = "width",
) -> Dwells:
    """Find all drives that dwell; see `OvalPlanetary.find_dwells`."""
    require(
        isinstance(rank, str) and rank in RANKS, "rank", rank, f"must be one of {', '.join(RANKS)}"
    )
    asked, search, bound = _check(width, eta, band, largest_e)
    first, last = check_teeth(teeth)
    pairs = _sort_pairs(first, last)
    found, left = [], []
    for k, sizes in pairs.items():
        z4, z5 = sizes[0]
        spans = _search(search, k)
        if isinstance(spans, str):
            left.append((z4, z5, spans))
            continue
        step = math.pi * float(1 / k - 1)
        found += [
            Dwell(z4, z5, s.low, s.high, s.best, s.width, s.exact, step, s.place, len(sizes) - 1)
            for s in spans
        ]
    return Dwells(
        asked=f"{asked}; teeth {first} to {last}, e2 up to {bound}",
        candidates=tuple(sorted(found, key=RANKS[rank])),
        open=tuple(left),
        pairs=(last - first + 1) ** 2,
        ratios=len(pairs),
    )


def _sort_pairs(first: int, last: int) -> dict[Fraction, list[tuple[int, int]]]:
    """Return the pairs of each ratio z4/z5, the fewest teeth first."""
    pairs: dict[Fraction, list[tuple[int, int]]] = defaultdict(list)
    for z4 in range(first, last + 1):
        for z5 in range(first, last + 1):
            pairs[Fraction(z4, z5)].append((z4, z5))
    return pairs


def _check(
    width: Any, eta: Any, band: Any, largest_e: Any
) -> tuple[str, Callable[[Fraction], list[Span]], Number]:
    """Return the request as text, the search for one ratio, and the largest eccentricity."""
    try:
        import flint  # noqa: F401

        from mechproof.mechanisms.dwells import band_dwells, ratio
    except ImportError as error:
        raise ImportError(describe_missing("find_dwells", "derive", error.name)) from error
    if (eta is None) == (band is None):
        refuse("band", band, f"give exactly one of band and eta = {eta!r}", TypeError)
    angle, limit = check_number("width", width), check_number("largest_e", largest_e)
    require(angle > 0, "width", width, "must be positive")
    require(0 < limit < 1, "largest_e", largest_e, "must be above 0 and below 1")
    words = f"dwells of at least {math.degrees(angle):g}° of the carrier"
    if band is None:
        small = check_number("eta", eta)
        require(0 < small < 1, "eta", eta, "must be above 0 and below 1")
        by_ratio = ratio.RestRequest(Fraction(angle), Fraction(small), Fraction(limit))
        return f"{words}, |ratio| <= {eta}", lambda k: ratio.find_spans(k, by_ratio), limit
    half = check_number("band", band)
    require(0 < half < math.pi / 4, "band", band, "must be above 0 and below pi/4")
    by_band = band_dwells.BandRequest(Fraction(angle), Fraction(half), Fraction(limit))
    text = f"{words}, output within ±{math.degrees(half):g}°"
    return text, lambda k: band_dwells.find_spans(k, by_band), limit


def _search(search: Callable[[Fraction], list[Span]], k: Fraction) -> list[Span] | str:
    """Return the spans of one ratio, or the reason why they are open."""
    from flint import ctx

    from mechproof.executors import BALLS
    from mechproof.mechanisms.dwells.ball_decisions import Open

    try:
        with BALLS, ctx.workprec(PRECISION):
            return search(k)
    except Open as reason:
        return str(reason)
