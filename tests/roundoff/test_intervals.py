"""Intervals hold every exact result, which they would not if rounded to nearest."""

from __future__ import annotations

import operator
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from flint import arb

from mechproof.arithmetic import interval_functions, intervals
from mechproof.arithmetic.balls import working_precision
from mechproof.arithmetic.intervals import Interval, careful, exactly
from mechproof.roundoff.endpoint_rounding import AT_ENDPOINTS, limit_by_spacing, round_endpoints

COUNT = 400
OPERATIONS: dict[str, Callable[[Any, Any], Any]] = {
    "sum": operator.add,
    "difference": operator.sub,
    "product": operator.mul,
    "quotient": operator.truediv,
}
# Operations on doubles, rounded as the processor rounds them.
ROUNDED: dict[str, Callable[..., Any]] = {
    "add": operator.add,
    "subtract": operator.sub,
    "multiply": operator.mul,
    "square": lambda a: a * a,
}
FUNCTIONS: dict[str, tuple[Callable[[Interval], Interval], Callable[[arb], arb], float]] = {
    "tan": (interval_functions.tangent, arb.tan, 1.55),
    "cot": (interval_functions.cotangent, arb.cot, 3.1),
    "arctan": (interval_functions.arctangent, arb.atan, 50.0),
    "sin": (interval_functions.sine, arb.sin, 50.0),
    "cos": (interval_functions.cosine, arb.cos, 50.0),
}


def draw(seed: int, reach: float = 10.0, *, mixed: bool = True) -> Interval:
    """Draw positive intervals, or mixed ones, some of which end at zero or are single numbers."""
    rng = np.random.default_rng(seed)
    ends = rng.uniform(-reach if mixed else 0.1, reach, (2, COUNT))
    ends *= 2.0 ** -rng.integers(0, 20, COUNT) if mixed else 1.0
    low, high = np.sort(ends, axis=0)
    if mixed:
        low[:20], high[:20] = 0.0, np.abs(high[:20])
        low[20:40], high[20:40] = -np.abs(low[20:40]), 0.0
        high[40:60] = low[40:60]
    return Interval(low, high)


def points_of(span: Interval, seed: int) -> list[np.ndarray]:
    """Return the ends of the intervals and three sets of numbers between them."""
    shares = np.random.default_rng(seed).uniform(0, 1, (3, len(span.low)))
    between = [
        np.clip(span.low + share * (span.high - span.low), span.low, span.high) for share in shares
    ]
    return [span.low, span.high, *between]


def count_missed(found: Interval, exact: list[Any]) -> int:
    """Count the exact numbers outside their interval; one that is not finite claims nothing."""
    known = np.broadcast_to(found.is_finite, len(exact))
    low, high = (np.broadcast_to(end, len(exact)) for end in (found.low, found.high))
    return sum(
        not Fraction(float(low[i])) <= value <= Fraction(float(high[i]))
        for i, value in enumerate(exact)
        if known[i] and value is not None
    )


def miss_operations(kind: str, *, mixed: bool) -> int:
    a, b = draw(1, mixed=mixed), draw(2, mixed=mixed)
    compute = OPERATIONS[kind]
    with careful(moves=False):
        found = compute(a, b)
    assert np.sum(found.is_finite) > COUNT / 4
    missed = 0
    for x in points_of(a, 3):
        for y in points_of(b, 4):
            pairs = [(Fraction(float(p)), Fraction(float(q))) for p, q in zip(x, y, strict=True)]
            is_open = [kind == "quotient" and q == 0 for _, q in pairs]
            exact = [None if o else compute(p, q) for (p, q), o in zip(pairs, is_open, strict=True)]
            missed += count_missed(found, exact)
    return missed


@pytest.mark.slow
@pytest.mark.parametrize("mixed", [True, False])
@pytest.mark.parametrize("kind", OPERATIONS)
def test_operations_hold_all_exact_results(kind: str, mixed: bool) -> None:
    assert miss_operations(kind, mixed=mixed) == 0


@pytest.mark.parametrize("kind", OPERATIONS)
def test_operations_rounded_to_nearest_are_caught(
    kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(intervals, "OUTWARD", 0.0)
    assert miss_operations(kind, mixed=False) > 0


@pytest.mark.parametrize("exponent", [-2, -1, 1, 2, 3, 4, 5])
def test_powers_hold_all_exact_results(exponent: int) -> None:
    for mixed in (True, False):
        base = draw(5, mixed=mixed)
        found = base.power(exponent)
        assert np.sum(found.is_finite) > COUNT / 4
        for x in points_of(base, 6):
            exact = [Fraction(float(p)) ** exponent if p else None for p in x]
            assert count_missed(found, exact) == 0


def test_odd_powers_keep_the_order_of_signs() -> None:
    for exponent in (1, 3):
        found = Interval(np.array([-2.0]), np.array([1.0])).power(exponent)
        assert found.low[0] == pytest.approx(-(2.0**exponent))
        assert found.high[0] == pytest.approx(1.0)


def test_an_interval_with_zero_has_no_reciprocal() -> None:
    for low, high in ((-1.0, 1.0), (0.0, 1.0), (-1.0, 0.0)):
        assert not Interval(np.array([low]), np.array([high])).inverted().is_finite[0]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_hold_all_values(name: str) -> None:
    enclose, exact, reach = FUNCTIONS[name]
    span = draw(7, reach)
    found = enclose(span)
    assert np.sum(found.is_finite) > COUNT / 4
    missed = 0
    with working_precision(200):
        for x in points_of(span, 8):
            values = [exact(arb(float(p))) for p in x]
            missed += sum(
                not (arb(float(low)) <= value <= arb(float(high)))
                for low, high, value in zip(found.low, found.high, values, strict=True)
                if np.isfinite(low) and np.isfinite(high) and value.is_finite()
            )
    assert missed == 0


def test_crests_are_not_cut_off() -> None:
    span = Interval(np.array([1.0, -2.0, 3.0]), np.array([2.0, -1.0, 10.0]))
    assert interval_functions.sine(span).high.tolist()[0] == 1.0
    assert interval_functions.sine(span).low.tolist()[1] == -1.0
    assert (interval_functions.cosine(span).low[2], interval_functions.cosine(span).high[2]) == (
        -1.0,
        1.0,
    )


def test_roots_hold_all_values() -> None:
    span = draw(9, mixed=False)
    found = span.sqrt()
    for x in points_of(span, 10):
        for low, high, p in zip(found.low, found.high, x, strict=True):
            assert Fraction(low) ** 2 <= Fraction(p) <= Fraction(high) ** 2


def test_products_below_the_normal_range_are_seen_or_moved_away() -> None:
    small = Interval(np.array([-1e-200]), np.array([1e-200]))
    with careful(moves=False), pytest.raises(FloatingPointError):
        _ = small * small
    with careful(moves=True):
        moved = small + exactly(0.0)
        product = moved * moved
    assert product.low[0] < -1e-320
    assert product.high[0] > 1e-320


def list_doubles(kind: str) -> list[Interval]:
    count = 1 if kind == "square" else 2
    return [draw(11 + i, mixed=True) for i in range(count)]


@pytest.mark.parametrize("kind", ROUNDED)
def test_rounded_results_lie_between_those_at_the_ends(kind: str) -> None:
    given = list_doubles(kind)
    unknown = Interval(np.full(COUNT, np.nan), np.full(COUNT, np.nan))
    with np.errstate(invalid="ignore"):
        found = round_endpoints(kind, given, unknown)
        limit = limit_by_spacing(found, 0.5)
    reached = 0.0
    for seed in range(20):
        drawn = [points_of(span, seed + i)[-1] for i, span in enumerate(given)]
        computed = ROUNDED[kind](*drawn)
        assert np.all((found.span.low <= computed) & (computed <= found.span.high))
        for i in range(COUNT):
            exact = ROUNDED[kind](*(Fraction(float(x[i])) for x in drawn))
            off = abs(Fraction(float(computed[i])) - exact)
            assert off <= Fraction(float(limit[i]))
            reached = max(reached, float(off / Fraction(float(limit[i]))) if limit[i] else 0.0)
    # A limit lowered by a tenth would not hold.
    assert reached > 0.9


def test_what_is_rounded_hardly_above_a_power_of_two_is_off_by_less() -> None:
    one = Interval(np.array([0.5]), np.array([1.0]))
    zero = exactly(0.0)
    exact = round_endpoints("add", [one, zero], one)
    assert limit_by_spacing(exact, 0.5)[0] == 2.0**-54
    above = round_endpoints("add", [one, exactly(2.0**-54)], one + exactly(2.0**-54))
    assert above.span.high[0] == 1.0
    assert limit_by_spacing(above, 0.5)[0] == 2.0**-53


def test_nothing_is_said_of_what_is_not_known() -> None:
    unknown = Interval(np.array([np.nan, 0.0]), np.array([np.nan, np.inf]))
    assert "divide" not in AT_ENDPOINTS
    for kind in ("add", "divide"):
        with careful(moves=False):
            found = round_endpoints(kind, [unknown, exactly(1.0)], unknown)
            assert np.all(limit_by_spacing(found, 0.5) == np.inf)
