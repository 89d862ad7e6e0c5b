"""Values, slopes and bends of expressions over boxes, compared with SymPy's."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest
import sympy as sp
from flint import arb

from mechproof.arithmetic.balls import evaluate
from mechproof.arithmetic.slopes import BITS, GradientTape
from mechproof.derivations.wedge_linkage import PAPER
from mechproof.record import RecordError

x, y, g, h = sp.symbols("x y g h", real=True)
n = sp.Symbol("n", integer=True)

EXPRESSIONS = [
    x * y + 3,
    x**3 / (1 + y**2) - sp.sqrt(x + 4),
    sp.atan2(x, 2 + y) * sp.cos(x - sp.pi / 7) * y,
    sp.exp(-x * y) * sp.asin(x / 4) * sp.tan(y / 3),
    sp.Max(x, y, 3 * x - 1) + sp.Min(x, 2 * y) * sp.Abs(x - y),
    sp.Sum(x**n * y, (n, 1, 4)),
    sp.Integral(sp.exp(-x * g), (g, 0, sp.Max(y, x - 2))),
    g * h + sp.sin(h) * x,
]
GIVEN = {h: g**2 + x, g: sp.sin(x * y)}


def resolve(expression: sp.Expr) -> Any:
    bound = expression.atoms(sp.Integral)
    return expression if bound else expression.subs(h, GIVEN[h]).subs(g, GIVEN[g])


def differentiate(expression: sp.Expr, symbol: sp.Symbol) -> Any:
    """Differentiate `expression` away from its kinks, where the delta functions vanish."""
    slope = sp.diff(expression, symbol).replace(sp.DiracDelta, lambda *a: sp.S.Zero)
    return slope.replace(sp.Heaviside, lambda a, *rest: (1 + sp.sign(a)) / 2)


@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_at_points_all_is_that_of_sympy(expression: sp.Expr) -> None:
    given = {} if expression.has(sp.Integral) else GIVEN
    tape, whole = GradientTape(expression, given), resolve(expression)
    for point in np.random.default_rng(5).uniform(0.2, 1.2, (10, 2)).tolist():
        values = dict(zip((x, y), map(arb, point), strict=True))
        value, slopes = tape.differentiate(values, [x, y])
        assert value.overlaps(evaluate(whole, values, BITS))
        assert value.overlaps(tape.evaluate(values))
        for symbol in (x, y):
            (slope,) = slopes[symbol]
            derivative = differentiate(whole.replace(sp.Abs, lambda a: sp.Max(a, -a)), symbol)
            bend = differentiate(derivative, symbol)
            assert slope.overlaps(evaluate(derivative, values, BITS))
            assert slope.rad() < 1e-20
            assert tape.bend(values, symbol).overlaps(evaluate(bend, values, BITS))


@pytest.mark.parametrize("expression", EXPRESSIONS[:5], ids=str)
def test_over_a_box_all_points_are_enclosed(expression: sp.Expr) -> None:
    tape = GradientTape(expression, {})
    box = {x: arb(0.2).union(arb(0.9)), y: arb(0.3).union(arb(0.8))}
    value, slopes = tape.differentiate(box, [x, y])
    bends = {s: tape.bend(box, s) for s in (x, y)}
    for point in np.random.default_rng(6).uniform((0.2, 0.3), (0.9, 0.8), (50, 2)).tolist():
        values = dict(zip((x, y), map(arb, point), strict=True))
        one, slopes_there = tape.differentiate(values, [x, y])
        assert value.contains(one)
        for s in (x, y):
            hull = slopes[s][0]
            for branch in slopes[s]:
                hull = hull.union(branch)
            assert all(hull.contains(slope) for slope in slopes_there[s])
            assert not bends[s].is_finite() or bends[s].contains(tape.bend(values, s))


def test_at_a_kink_the_slopes_of_both_sides_are_given_and_no_bend() -> None:
    tape = GradientTape(sp.Max(0, x) + x**2, {})
    box = {x: arb(-1).union(arb(1))}
    _, slopes = tape.differentiate(box, [x])
    assert len(slopes[x]) == 2
    assert not tape.bend(box, x).is_finite()
    assert tape.bend({x: arb(2)}, x) == 2


def test_beyond_a_kink_nothing_counts() -> None:
    tape = GradientTape(sp.Max(1, x * sp.sqrt(x)) + y, {})
    _, slopes = tape.differentiate({x: arb(0), y: arb(1)}, [x, y])
    # The square root has no slope at 0, but there the maximum is the 1.
    assert slopes[x] == [0]
    assert slopes[y] == [1]


@pytest.mark.parametrize(
    "expression", [sp.floor(x), sp.sign(x), sp.Piecewise((x, x < 1), (2, True))]
)
def test_branches_that_need_not_meet_are_seen(expression: sp.Expr) -> None:
    assert not GradientTape(y + expression, {}).is_continuous
    assert GradientTape(y + sp.Abs(x), {}).is_continuous


def test_what_is_given_is_a_symbol_no_more() -> None:
    tape = GradientTape(g * h, GIVEN)
    assert tape.symbols == {x, y}
    assert GradientTape(h, {}).symbols == {h}


def test_what_was_sent_is_the_same_operations() -> None:
    given = {v.symbol: v.given for v in PAPER.variables if v.given is not None}
    (position,) = (q for q in PAPER.quantities if q.name == "position")
    for expression in (position.definition, position.shipped[-1].expression):
        tape = GradientTape(expression, given)
        again = pickle.loads(pickle.dumps(tape))
        values = {s: arb(k + 1) / 7 for k, s in enumerate(sorted(tape.symbols, key=str))}
        ours, theirs = (p.differentiate(values, [*values]) for p in (tape, again))
        assert str(ours) == str(theirs)


def test_a_bound_symbol_is_not_what_is_given_by_its_name() -> None:
    """The summation index k is not the k that is given as x + y."""
    k = sp.Symbol("k", integer=True)
    tape = GradientTape(sp.Sum(k * g, (k, 1, 3)) + k, {g: k * x, k: x + y})
    values = {x: arb(2), y: arb(3)}
    value, slopes = tape.differentiate(values, [x, y])
    assert tape.symbols == {x, y}
    assert value.contains(65)
    assert [slopes[s][0].contains(n) for s, n in ((x, 43), (y, 13))] == [True, True]


def test_what_is_given_in_a_circle_is_refused() -> None:
    with pytest.raises(RecordError, match="defined in terms of each other"):
        GradientTape(sp.Sum(g * n, (n, 1, 3)), {g: h, h: g})
