"""Linear forms in a box's sides hold a quantity's value at every place of the box."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from flint import arb

from mechproof.arithmetic import interval_functions, linear_forms
from mechproof.arithmetic.balls import to_ball, working_precision
from mechproof.arithmetic.intervals import Array, Interval, careful, list_spans
from mechproof.arithmetic.linear_forms import LinearForm, list_pairs

COUNT, SIDES = 300, 3
OPERATIONS: dict[str, Callable[..., Any]] = {
    "sum": lambda x, y, z: x + y + x,
    "difference": lambda x, y, z: x - y - z,
    "product": lambda x, y, z: x * y * z,
    "square of a sum": lambda x, y, z: (x + y) * (x - z),
    "quotient": lambda x, y, z: (x * y) / (y * z),
}
FUNCTIONS: dict[str, tuple[Callable[[Interval], Interval], Callable[[Any], Any]]] = {
    "tan": (interval_functions.tangent, arb.tan),
    "cot": (interval_functions.cotangent, arb.cot),
    "arctan": (interval_functions.arctangent, arb.atan),
    "sin": (interval_functions.sine, arb.sin),
    "cos": (interval_functions.cosine, arb.cos),
    "exp": (interval_functions.exponential, arb.exp),
    "log": (interval_functions.logarithm, arb.log),
    "sqrt": (Interval.sqrt, arb.sqrt),
    "1/x": (Interval.inverted, lambda x: 1 / x),
    "size": (Interval.size, abs),
    **{f"x**{n}": (lambda x, n=n: x.power(n), lambda x, n=n: x**n) for n in (-2, 2, 3, 5)},
}


def draw_boxes(seed: int, reach: float = 1.5, *, mixed: bool = True) -> Array:
    """Draw boxes of all widths, some no wider than a few ulps, and single points."""
    rng = np.random.default_rng(seed)
    middles = rng.uniform(-reach if mixed else 0.05, reach, (COUNT, SIDES))
    widths = np.abs(middles) * 2.0 ** -rng.integers(0, 54, (COUNT, SIDES))
    widths[:20] = 0.0
    return np.stack([middles - widths / 2, middles + widths / 2], axis=2)


def list_places(boxes: Array, seed: int) -> list[Array]:
    """Return places in the boxes: a corner of each, and three inside."""
    shares = np.random.default_rng(seed).uniform(0, 1, (4, COUNT, SIDES))
    shares[0] = np.rint(shares[0])
    low, high = boxes[:, :, 0], boxes[:, :, 1]
    return [np.clip(low + share * (high - low), low, high) for share in shares]


def count_missed(found: Interval, spans: list[Interval], at: Array, values: list[Any]) -> int:
    """Count the values outside their interval, and those farther from the form than its rest."""
    assert found.form is not None
    missed = 0
    parts = np.broadcast_arrays(found.low, found.high, found.form.middle, found.form.rest)
    changes = np.broadcast_to(found.form.changes, (SIDES, COUNT))
    pairs = list(zip(*list_pairs(SIDES), strict=True))
    bends = np.broadcast_to(found.form.bends, (len(pairs), COUNT))
    for row, value in enumerate(values):
        low, high, middle, rest = (float(part[row]) for part in parts)
        if not np.isfinite([low, high, middle, rest]).all():
            continue
        missed += not (to_ball(low) <= value <= to_ball(high))
        ways = [_find_way(span, side, row, at) for side, span in enumerate(spans)]
        about = arb(middle)
        for way, change in zip(ways, changes, strict=True):
            about += arb(float(change[row])) * way
        for (one, other), bend in zip(pairs, bends, strict=True):
            about += arb(float(bend[row])) * ways[one] * ways[other]
        missed += not abs(value - about) <= arb(rest)
    return missed


def _find_way(span: Interval, side: int, row: int, at: Array) -> arb:
    """Return how far a place is along a side, from -1 to 1."""
    assert span.form is not None
    way = Fraction(float(at[row, side])) - Fraction(float(span.form.middle[row]))
    return to_ball(way / Fraction(span.form.changes[side][row])) if way else arb(0)


def miss_operation(kind: str, *, is_bent: bool = False) -> int:
    boxes = draw_boxes(1)
    spans = list_spans(boxes, has_forms=True, is_bent=is_bent)
    with careful(moves=False):
        found = OPERATIONS[kind](*spans)
    assert np.sum(found.is_finite) > COUNT / 3
    with working_precision(400):
        return sum(
            count_missed(
                found, spans, at, [OPERATIONS[kind](*map(arb, map(float, row))) for row in at]
            )
            for at in list_places(boxes, 2)
        )


def miss_function(name: str, *, is_bent: bool = False) -> int:
    enclose, exact = FUNCTIONS[name]
    boxes = draw_boxes(3, mixed=name not in ("log", "sqrt"))
    spans = list_spans(boxes, has_forms=True, is_bent=is_bent)
    with careful(moves=False):
        found = enclose(spans[0])
    assert np.sum(found.is_finite) > COUNT / 3
    with working_precision(400):
        return sum(
            count_missed(found, spans, at, [exact(arb(float(row[0]))) for row in at])
            for at in list_places(boxes, 4)
        )


@pytest.mark.parametrize("is_bent", [False, True])
@pytest.mark.parametrize("kind", OPERATIONS)
def test_operations_hold_what_is_at_a_place(kind: str, is_bent: bool) -> None:
    assert miss_operation(kind, is_bent=is_bent) == 0


@pytest.mark.parametrize("is_bent", [False, True])
@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_hold_what_is_at_a_place(name: str, is_bent: bool) -> None:
    assert miss_function(name, is_bent=is_bent) == 0


@pytest.mark.parametrize("kind", ["product", "square of a sum", "quotient"])
def test_bends_that_are_left_out_are_caught(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(LinearForm, "_cross", lambda self, other: 0 * self.bends)
    assert miss_operation(kind, is_bent=True) > 0


@pytest.mark.parametrize("name", ["1/x", "sqrt"])
def test_a_series_with_a_wrong_coefficient_is_caught(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    expand = linear_forms._expand

    def change(form: Any, low: Any, high: Any, series: Any, last: Any) -> LinearForm:
        value, slope, half = series
        return expand(form, low, high, (value, slope, -half), last)

    monkeypatch.setattr(linear_forms, "_expand", change)
    assert miss_function(name, is_bent=True) > 0


@pytest.mark.parametrize("name", ["1/x", "sqrt"])
def test_a_series_without_its_error_is_caught(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    expand = linear_forms._expand
    monkeypatch.setattr(linear_forms, "_expand", lambda *given: expand(*given[:-1], 0.0))
    assert miss_function(name, is_bent=True) > 0


@pytest.mark.parametrize("kind", ["product", "square of a sum", "quotient"])
def test_a_product_without_what_bends_it_is_caught(
    kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(LinearForm, "_enclose_product", lambda self, other: (0.0, 0.0))
    assert miss_operation(kind) > 0


def test_a_way_along_a_side_that_is_taken_off_whole_is_caught(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    enclose = LinearForm._enclose_product

    def take_off(one: LinearForm, other: LinearForm) -> tuple[Any, Any]:
        shift, bent = enclose(one, other)
        return shift, bent - np.abs(one.changes * other.changes / 2).sum(axis=0)

    monkeypatch.setattr(LinearForm, "_enclose_product", take_off)
    assert miss_operation("square of a sum") > 0


@pytest.mark.parametrize("kind", OPERATIONS)
def test_roundings_that_are_left_out_are_caught(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(linear_forms, "ROUNDED", 0.0)
    assert miss_operation(kind) > 0


@pytest.mark.parametrize("name", ["tan", "arctan", "sin", "cos", "exp"])
def test_a_function_that_bends_the_other_way_is_caught(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    follow = Interval.follow

    def turn(self: Interval, z: Interval, values: Any, slopes: Interval, bend: Any) -> Interval:
        return follow(self, z, values, slopes, -bend)

    monkeypatch.setattr(Interval, "follow", turn)
    assert miss_function(name) > 0


def test_what_cancels_is_of_second_order() -> None:
    """The width of the result falls with the square of the box's width only with forms."""
    boxes = np.array([[(1 - h, 1 + h), (2 - h, 2 + h)] for h in (0.1, 0.05, 0.025)])
    widths = []
    for has_forms in (True, False):
        x, y = list_spans(boxes, has_forms=has_forms)
        found = (x + y) * (x - y) - x.power(2) + y.power(2)
        widths.append(found.high - found.low)
    assert np.all(widths[0][:-1] > 3.9 * widths[0][1:])
    assert np.all(widths[0] < 0.2 * widths[1])


def test_what_cancels_is_of_third_order_with_bends() -> None:
    boxes = np.array([[(1 - h, 1 + h), (2 - h, 2 + h)] for h in (0.1, 0.05, 0.025)])
    x, y = list_spans(boxes, has_forms=True, is_bent=True)
    found = x * y * (x + y).inverted() - (x.inverted() + y.inverted()).inverted()
    widths = found.high - found.low
    assert np.all(widths[:-1] > 7 * widths[1:])
    assert widths[-1] < 1e-4


def test_a_side_without_an_end_has_no_form() -> None:
    boxes = np.array([[(0.0, 1.0), (1.0, np.inf)]])
    first, second = list_spans(boxes, has_forms=True)
    assert first.form is not None
    assert second.form is None
    assert not (first * second).is_finite[0]
    assert all(span.form is None for span in list_spans(boxes))
