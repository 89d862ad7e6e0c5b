"""Endpoint rounding: an operation at the ends of its operands' intervals, rounded like itself.

Rounding to nearest is monotone: the results lie between the rounded results at the ends. The
remainders of the roundings there show whether an exact result passes a power of two.

A step's grid, the power of two of which its results are multiples, shows which sums are exact. A
double of at least 2**e in size is a multiple of 2**(e - 52); sums and products of multiples are
multiples again, and rounding a multiple gives one. A multiple of 2**g below 2**(g + 53) is a
double. Gappa (Daumas and Melquiond 2010) proves such facts by its predicate FIX; Sterbenz's lemma
is a special case.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from types import MappingProxyType

import numpy as np

from mechproof.arithmetic.intervals import EPS, UNIT, Ends, Interval, Mask, list_corners
from mechproof.kernel_support.error_free import product_rest
from mechproof.roundoff.running import add_exactly, fma
from mechproof.roundoff.steps import list_factors

# Exponent of a power of two that numbers are multiples of; minus infinity if unknown.
Grid = Ends
BITS = 53
NO_GRID = np.float64(-np.inf)
_OF_RESULTS: Mapping[str, Callable[..., Grid]] = MappingProxyType(
    {
        "add": np.minimum,
        "subtract": np.minimum,
        "multiply": np.add,
        "square": lambda a: 2 * a,
        "fma": lambda a, b, c: np.minimum(a + b, c),
        "negate": lambda a: a,
        "absolute": lambda a: a,
    }
)
# As a share of a power of two: less than a quarter of the spacing of the doubles below it.
HARDLY = 2.0**-56


def find_grid(kind: str, given: Sequence[Grid]) -> Grid:
    """Return the grid of an operation's exact result."""
    return _OF_RESULTS[kind](*given) if kind in _OF_RESULTS else NO_GRID


def find_own_grid(doubles: Interval) -> Grid:
    """Return the grid by the spacing at the smallest double in size; `NO_GRID` if that may be 0."""
    least = np.maximum(doubles.low, -doubles.high)
    apart = least > 0
    _, exponents = np.frexp(np.where(apart, least, 1.0))
    # The least has the finest spacing; all other spacings are multiples of it.
    return np.where(apart, exponents - float(BITS), NO_GRID)


def find_grid_of_number(number: float) -> Grid:
    """Return the exponent of the largest power of two that divides a double; infinity for zero."""
    above, below = float(number).as_integer_ratio()
    if above == 0:
        return np.float64(np.inf)
    # The lowest set bit of the numerator and the denominator are powers of two, whose bit lengths
    # exceed their exponents by one.
    return np.float64((above & -above).bit_length() - below.bit_length())


def are_doubles(grid: Grid, results: Interval) -> Mask:
    """Return where all multiples of a grid that round to these results are themselves doubles."""
    largest = results.largest()
    _, exponents = np.frexp(largest)
    return np.isfinite(largest) & (exponents <= grid + BITS)


@dataclass(frozen=True)
class RoundedEndpoints:
    """The span of rounded results, and a function that finds how far exact ones may lie outside it.

    That is only needed where an end is a power of two.
    """

    span: Interval
    find_beyond: Callable[[], Ends]


def _outward(span: Interval, find_rests: Callable[[], Sequence[Ends]]) -> RoundedEndpoints:
    """Return rounded ends, given what rounding took from the lower and the upper one."""

    def find_beyond() -> Ends:
        below, above = find_rests()
        beyond = np.where(-span.low > span.high, -below, above)
        return np.where(-span.low == span.high, np.maximum(-below, above), beyond)

    return RoundedEndpoints(span, find_beyond)


def _add(a: Interval, b: Interval) -> RoundedEndpoints:
    return _outward(
        Interval(a.low + b.low, a.high + b.high),
        lambda: (add_exactly(a.low, b.low)[1], add_exactly(a.high, b.high)[1]),
    )


def _multiply(a: Interval, b: Interval) -> RoundedEndpoints:
    def find_rests() -> Sequence[Ends]:
        corners = list_corners(a, b) or _choose_corners(a, b)
        return [product_rest(x, y, x * y) for x, y in corners]

    if known := list_corners(a, b):
        low, high = (x * y for x, y in known)
    else:
        products = [x * y for x in (a.low, a.high) for y in (b.low, b.high)]
        low, high = reduce(np.minimum, products), reduce(np.maximum, products)
    return _outward(Interval(low, high), find_rests)


def _choose_corners(a: Interval, b: Interval) -> tuple[tuple[Ends, Ends], tuple[Ends, Ends]]:
    """Return the ends whose rounded products are the smallest and the largest, box by box."""
    found = [(x * y, x, y) for x in (a.low, a.high) for y in (b.low, b.high)]
    low, high = found[0], found[0]
    for other in found[1:]:
        less, more = other[0] < low[0], other[0] > high[0]
        # `[()]` turns zero-dimensional arrays, which plain numbers lead to, back into numbers.
        low = tuple(np.where(less, new, old)[()] for new, old in zip(other, low, strict=True))
        high = tuple(np.where(more, new, old)[()] for new, old in zip(other, high, strict=True))
    return low[1:], high[1:]


def _square(a: Interval) -> RoundedEndpoints:
    size = a.size()
    return _multiply(size, size)


def _fuse(a: Interval, b: Interval, c: Interval) -> RoundedEndpoints:
    """Fuse at the ends with the smallest and the largest product; all NaN if these are unknown."""
    corners = list_corners(a, b)
    if corners is None:
        nothing = np.full(np.shape(a.low + b.low + c.low), np.nan)
        return RoundedEndpoints(Interval(nothing, nothing), lambda: np.inf)
    factors = [(*corner, end) for corner, end in zip(corners, (c.low, c.high), strict=True)]
    low, high = (fma(*given) for given in factors)
    return _outward(Interval(low, high), lambda: [_fused_rest(*given) for given in factors])


def _fused_rest(x: Ends, y: Ends, end: Ends) -> Ends:
    """Return, with a small relative error, what rounding took from a fused product."""
    product = x * y
    total, left = add_exactly(product, end)
    return (total - fma(x, y, end)) + (left + product_rest(x, y, product))


AT_ENDPOINTS: Mapping[str, Callable[..., RoundedEndpoints]] = MappingProxyType(
    {
        "add": _add,
        "subtract": lambda a, b: _add(a, -b),
        "multiply": _multiply,
        "square": _square,
        "fma": _fuse,
        "copy": lambda a: RoundedEndpoints(a, lambda: 0.0),
        "negate": lambda a: RoundedEndpoints(-a, lambda: 0.0),
        "absolute": lambda a: RoundedEndpoints(a.size(), lambda: 0.0),
    }
)


def round_endpoints(kind: str, given: Sequence[Interval], whole: Interval) -> RoundedEndpoints:
    """Enclose an operation's rounded results by those at the ends, or by `whole` if narrower."""
    if kind not in AT_ENDPOINTS:
        return RoundedEndpoints(whole, lambda: np.inf)
    found = AT_ENDPOINTS[kind](*given)
    known = found.span.is_finite
    for span in given:
        known = known & span.is_finite
    # Negated, so that a NaN `whole`, about which nothing is known, never counts as the narrower.
    narrow = known & ~(whole.high - whole.low < found.span.high - found.span.low)
    low = np.where(narrow, found.span.low, whole.low)
    high = np.where(narrow, found.span.high, whole.high)
    return RoundedEndpoints(
        Interval(low, high), lambda: np.where(narrow, found.find_beyond(), np.inf)
    )


def limit_by_spacing(rounded: RoundedEndpoints, ulps: float) -> Ends:
    """Bound a rounding error by `ulps` times the spacing of doubles at the largest result."""
    largest = rounded.span.largest()
    share, exponent = np.frexp(largest)
    if np.any(is_power := share == 0.5):
        # A power of two is a double: a result barely beyond it rounds back to it, and is off by
        # less than results below it may be.
        passed = is_power & (rounded.find_beyond() <= largest * HARDLY)
        exponent = np.where(passed, exponent - 1, exponent)
    limit = ulps * np.ldexp(UNIT, exponent)
    return np.where(np.isfinite(largest), limit, np.inf)


def widen_by_ulps(span: Interval, ulps: float) -> Interval:
    """Enclose the numbers within `ulps` ulps of those in an interval."""
    # An ulp is at most EPS times its number; twice that covers the rounding of the ends.
    share = 2 * ulps * EPS
    return Interval(span.low - np.abs(span.low) * share, span.high + np.abs(span.high) * share)


def within_one(span: Interval) -> Interval:
    """Return the interval cut to [-1, 1]."""
    return Interval(np.maximum(span.low, -1.0), np.minimum(span.high, 1.0))


def shifts(kind: str, given: Sequence[Interval]) -> Mask:
    """Return where the operation multiplies or divides by a single power of two."""
    known: Mask = False
    for factor in list_factors(kind, given):
        known = known | (factor.low == factor.high) & (np.abs(np.frexp(factor.low)[0]) == 0.5)
    return known


def limit_by_terms(kind: str, given: Sequence[Interval]) -> Ends:
    """Bound the rounding error of a sum of doubles by its smaller term; else return infinity."""
    if kind in ("add", "subtract"):
        # The double nearest to a + b is no farther from it than a is, that is |b|, and no farther
        # than b, that is |a|. Where one size is unknown, the other still bounds.
        return np.fmin(given[0].largest(), given[1].largest())
    return np.inf
