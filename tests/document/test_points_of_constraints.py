"""Points at which constraints hold, equations that fail there, and slips in numbers."""

from __future__ import annotations

import warnings

import pytest
import sympy as sp

from mechproof.document.constraints.witnesses import enclose, find_points
from mechproof.document.misprints import find_failure, find_misprint
from mechproof.document.slips import PrintedSides, find_slip, list_changes
from mechproof.record import PrintedNumber
from mechproof.statement_domains.domain import Domain

X, Y = sp.symbols("x y", real=True)
PLANE = Domain({X: sp.S.Reals, Y: sp.S.Reals}, (), {})


def test_no_points_are_looked_for_where_slopes_cannot_be_computed() -> None:
    assert not [*find_points([Y - sp.floor(X)], {X, Y}, PLANE, 4)]
    assert [*find_points([Y - X], {X, Y}, PLANE, 4)]


def test_a_letter_that_counts_keeps_its_value_on_the_way_to_a_point() -> None:
    n = sp.Symbol("n", integer=True, positive=True)
    domain = Domain({X: sp.S.Reals, n: sp.S.Naturals}, (), {})
    point = next(find_points([n * X - sp.sqrt(2)], {X, n}, domain, 4))
    assert point[n].is_Integer
    held = enclose([n * X - sp.sqrt(2)], point)
    assert held is not None
    assert held[n].is_exact()
    k = sp.Symbol("k", integer=True)
    assert not [*find_points([sp.Sum(X**k, (k, 0, n)) - 2], {X, n}, domain, 4)]


def test_a_walk_onto_a_pole_finds_nothing_and_warns_nobody() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert not [*find_points([X - 1, Y / (X - 1) - 2], {X, Y}, PLANE, 4)]


def test_points_are_enclosed_where_a_constraint_has_a_zero() -> None:
    circle = X**2 + Y**2 - 2
    point = next(find_points([circle], {X, Y}, PLANE, 4))
    found = enclose([circle, 2 * circle], point)
    assert found is not None
    assert found[X].rad() < 1e-15
    assert enclose([circle], {**point, X: point[X] + sp.Rational(1, 10**6)}) is None
    # Near a double zero nothing shows that a zero exists.
    assert enclose([X**2 + sp.Rational(1, 10**30)], {X: sp.Rational(1, 10**9)}) is None


def test_what_holds_at_a_point_of_the_constraints_does_not_fail() -> None:
    circle = X**2 + Y**2 - 1
    assert find_failure((Y, sp.sqrt(1 - X**2)), [circle], PLANE) is None
    assert find_failure((Y, 1 + sp.sqrt(1 - X**2)), [circle], PLANE)
    assert find_failure((Y, X + 1), [X**2 + Y**2 + 1], PLANE) is None


def test_a_print_that_nothing_small_mends_is_no_misprint() -> None:
    sides = (sp.sin(2 * X), sp.sin(X) * sp.cos(X))
    assert find_misprint(PrintedSides(sides), [], PLANE)
    assert find_misprint(PrintedSides(sides, (False, False)), [], PLANE) is None
    assert find_misprint(PrintedSides((sp.sin(3 * X), sp.cos(X) + Y)), [], PLANE) is None


@pytest.mark.parametrize(
    ("printed", "meant"),
    [
        *(("80.91", "80.19"), ("80.18", "80.19"), ("81.19", "80.19"), ("91.08", ""), ("8.2", "")),
        *(("89.10", "80.19"), ("18.90", ""), ("81.09", "80.19"), ("81.90", "80.19"), ("83.49", "")),
        *(("83.492", "80.192"), ("83.494", "")),
    ],
)
def test_a_number_may_have_wrong_digits(printed: str, meant: str) -> None:
    value = sp.Rational("80.1921") / (10 if len(printed) == 3 else 1)
    assert find_slip(PrintedNumber(printed, value), value) == meant


def test_letters_made_equal_are_no_slip_for_others() -> None:
    one, other, third = sp.symbols("a b c")
    letters = (one, other, third)
    for sides, has_other in [((one, other), False), ((one, 2 * other), True)]:
        changes = list_changes(PrintedSides(sides), letters, {})
        found = {s for change in changes for side in change.sides for s in side.free_symbols}
        assert (third in found) == has_other
