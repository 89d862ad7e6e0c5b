"""Balls enclose the true value (independently from mpmath, 60 digits) or are not finite."""

import mpmath
import pytest
import sympy as sp
from flint import arb

from mechproof.arithmetic import balls

x, y, u = sp.symbols("x y u", real=True)
i, j, n = sp.symbols("i j n", integer=True, positive=True)
q = sp.IndexedBase("q", real=True)
HALF, THIRD = sp.Rational(1, 2), sp.Rational(1, 3)
AT = {x: THIRD, y: sp.Rational(-5, 7)}
mpmath.mp.dps = 60

VALUES = {
    "polynomial": (x**3 - 2 * y, lambda m, x, y: x**3 - 2 * y),
    "negative power": ((x + y) ** -3, lambda m, x, y: (x + y) ** -3),
    "root": (x ** sp.Rational(3, 2) / sp.sqrt(1 - y), lambda m, x, y: x**1.5 / m.sqrt(1 - y)),
    "cube root": (x**THIRD, lambda m, x, y: m.cbrt(x)),
    "circle": (
        sp.sin(x) * sp.cos(y) - sp.tan(x * y),
        lambda m, x, y: m.sin(x) * m.cos(y) - m.tan(x * y),
    ),
    "cotangent": (sp.cot(y), lambda m, x, y: m.cot(y)),
    "inverse circle": (
        sp.asin(y) + sp.acos(x) * sp.atan(y),
        lambda m, x, y: m.asin(y) + m.acos(x) * m.atan(y),
    ),
    "argument": (sp.atan2(x, y), lambda m, x, y: m.atan2(x, y)),
    "argument on the cut": (sp.atan2(0, -x, evaluate=False), lambda m, x, y: m.pi),
    "exponential": (sp.exp(y) - sp.log(x), lambda m, x, y: m.exp(y) - m.log(x)),
    "error function": (sp.erf(x) - sp.erfc(y), lambda m, x, y: m.erf(x) - m.erfc(y)),
    "steps": (
        sp.floor(10 * x)
        + sp.ceiling(10 * y)
        + sp.sign(y) * sp.Abs(y)
        + sp.Max(x, y)
        - sp.Min(x, y),
        lambda m, x, y: m.floor(10 * x) + m.ceil(10 * y) + y + x - y,
    ),
    "elliptic": (sp.elliptic_e(x) - sp.elliptic_k(y), lambda m, x, y: m.ellipe(x) - m.ellipk(y)),
    "beta": (
        sp.betainc_regularized(HALF, 3, 0, x),
        lambda m, x, y: m.betainc(0.5, 3, 0, x, regularized=True),
    ),
    "constants": (sp.pi + sp.E * x + sp.EulerGamma, lambda m, x, y: m.pi + m.e * x + m.euler),
    "sum": (sp.Sum(x**i, (i, 1, 4)), lambda m, x, y: x + x**2 + x**3 + x**4),
    "double sum": (
        sp.Sum(sp.KroneckerDelta(i, j) * x + y, (i, 1, 3), (j, 1, 3)),
        lambda m, x, y: 3 * x + 9 * y,
    ),
    "integral": (
        sp.Integral(1 / (1 + x * sp.cos(u)), (u, 0, y)),
        lambda m, x, y: m.quad(lambda u: 1 / (1 + x * m.cos(u)), [0, y]),
    ),
    "integral with a root": (
        sp.Integral(sp.sqrt(1 + u**2), (u, y, x)),
        lambda m, x, y: m.quad(lambda u: m.sqrt(1 + u**2), [y, x]),
    ),
    "piecewise": (sp.Piecewise((x, y > 0), (x**2, True)), lambda m, x, y: x**2),
    "integral of one piece": (
        sp.Integral(sp.Piecewise((sp.exp(u), abs(u) <= 2), (0, True)), (u, y, x)),
        lambda m, x, y: m.exp(x) - m.exp(y),
    ),
}


def exact(number):
    return mpmath.mpf(number.p) / number.q


@pytest.mark.parametrize("name", VALUES)
@pytest.mark.parametrize("bits", [64, 160])
def test_the_ball_holds_the_true_value_and_is_narrow(name, bits):
    expression, true = VALUES[name]
    ball = balls.evaluate(expression, AT, bits)
    value = arb(mpmath.nstr(mpmath.mpf(true(mpmath, *map(exact, AT.values()))), 55))
    assert ball.overlaps(value + arb(0, 1e-45))
    assert ball.rad() < 2.0 ** (20 - bits)


UNDEFINED = {
    "division by zero": 1 / (x - THIRD),
    "negative root": sp.sqrt(y),
    "logarithm": sp.log(y),
    "arcsine": sp.asin(x + 1),
    "power of a negative number": y**THIRD,
    "not a number": x + sp.nan,
    "infinite": sp.zoo * x,
    "imaginary": x + sp.I,
    "elliptic beyond one": sp.elliptic_k(x + 1),
    "integral over a pole": sp.Integral(1 / u, (u, y, x)),
    "integral of a root that turns negative": sp.Integral(sp.sqrt(u), (u, y, x)),
    "no piece": sp.Piecewise((x, y > 0)),
    "piece not decided": sp.Piecewise(
        (x, sp.Gt(sp.sin(x) ** 2 + sp.cos(x) ** 2, 1, evaluate=False)), (y, True)
    ),
    "integral over a seam": sp.Integral(sp.Piecewise((u, u < 0), (u**2, True)), (u, y, x)),
    "sum to no integer": sp.Sum(i, (i, 1, x)),
    "sum that ends before it begins": sp.Sum(i, (i, 1, 3 * x - 3)),
    "argument of the zero vector": sp.atan2(3 * x - 1, y + sp.Rational(5, 7)),
    "sign of what is undefined": sp.sign(sp.sqrt(y)),
    "maximum with what is undefined": sp.Max(sp.sqrt(y), x),
    "delta not decided": sp.KroneckerDelta(sp.sin(x) ** 2 + sp.cos(x) ** 2, 1),
}


@pytest.mark.parametrize("name", UNDEFINED)
def test_what_is_undefined_or_undecided_is_not_finite(name):
    assert not balls.evaluate(UNDEFINED[name], AT).is_finite()


def test_what_has_no_ball_version_is_named():
    with pytest.raises(NotImplementedError, match="cannot be enclosed: lambert w"):
        balls.evaluate(sp.LambertW(x), AT)
    with pytest.raises(KeyError, match="no value given for the symbol u"):
        balls.evaluate(u + x, AT)


TRUTH = {
    "less": (x < HALF, True),
    "not less": (x > HALF, False),
    "equal exactly": (sp.Eq(3 * u, 1, evaluate=False), None),
    "weak at equality": (sp.Ge(u**2, u**2, evaluate=False), None),
    "not separable": (sp.Gt(sp.sin(x) ** 2 + sp.cos(x) ** 2, 1, evaluate=False), None),
    "and": (sp.And(x > 0, y > 0), False),
    "or": (sp.Or(x > 0, sp.Gt(sp.sin(y) ** 2 + sp.cos(y) ** 2, 1, evaluate=False)), True),
    "not": (sp.Not(sp.Or(x < 0, y > 0)), True),
    "unequal": (sp.Ne(x, y), True),
    "undefined side": (sp.Gt(sp.log(y), -100, evaluate=False), None),
}


@pytest.mark.parametrize("name", TRUTH)
def test_relations_are_decided_or_left_open(name):
    relation, expected = TRUTH[name]
    assert balls.truth(relation, {**AT, u: THIRD}) is expected


def test_precision_is_raised_until_enough_bits_are_correct_and_then_put_back():
    before = balls.flint.ctx.prec
    cancelling = 1 - sp.cos(sp.Rational(1, 10**30))
    ball = balls.evaluate_until(cancelling, {}, 80)
    assert ball.rel_accuracy_bits() >= 80
    assert not balls.evaluate_until(sp.log(y), AT, 80).is_finite()
    assert balls.flint.ctx.prec == before


def test_two_numbers_are_told_apart_and_equal_ones_are_as_they_are() -> None:
    near = balls.evaluate(1 + sp.Rational(1, 10**40), {}, 256), balls.evaluate(sp.S.One, {}, 256)
    one, other = balls.show_apart(*near)
    assert one != other
    assert balls.show_apart(near[1], near[1]) == (balls.show(near[1]), balls.show(near[1]))
    wide = balls.evaluate(sp.sqrt(2), {}, 256)
    assert "the difference is" in balls.show_apart(wide, wide)[1]


def test_a_wide_ball_without_zero_shows_its_sign() -> None:
    shown = balls.show(balls.flint.arb(-2, 0.9))
    assert shown == "[-2.00 +/- 0.901]"
    assert not balls.flint.arb(shown).contains(0)
    assert balls.show(balls.flint.arb(-2, 2.1)) == "[+/- 4.11]"
