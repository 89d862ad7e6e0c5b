"""Definite integrals: only an antiderivative proved to be one gives their value."""

from __future__ import annotations

import pytest
import sympy as sp

from mechproof.proof import integrals
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Verdict
from mechproof.record import Equality
from mechproof.record.substitution import put_values
from mechproof.statement_domains.domain import Domain

x, y, z, e = sp.symbols("x y z e", real=True)
DOMAIN = Domain({e: sp.Interval.open(0, 1)}, (), {})
TURN = 2 * sp.pi


def integral(integrand: sp.Expr, lower: sp.Expr, upper: sp.Expr) -> sp.Integral:
    return sp.Integral(integrand, (x, lower, upper))


def over(integrand: sp.Expr, *limits: tuple[sp.Expr, ...]) -> sp.Integral:
    return sp.Integral(integrand, *limits)


TRUE = {
    "power": (integral(x**2, 0, 1), sp.Rational(1, 3)),
    "power of any exponent": (integral(x ** (1 + e), 1, 2), (2 ** (2 + e) - 1) / (2 + e)),
    "quotient to any power": (integral((e / x) ** (1 + e), e, 1), 1 - e**e),
    "power of a base that vanishes": (integral(x ** (1 + e), 0, 1), 1 / (2 + e)),
    "root of a base that vanishes": (integral(x ** sp.Rational(4, 3), 0, 1), sp.Rational(3, 7)),
    "square of a sine": (integral(sp.sin(x) ** 2, 0, TURN), sp.pi),
    "logarithm": (integral(1 / x, 1, 2), sp.log(2)),
    "quarter of a circle": (integral(sp.sqrt(1 - x**2), 0, 1), sp.pi / 4),
    "orthogonal": (integral(sp.cos(3 * x) * sp.cos(2 * x), 0, sp.pi), sp.S.Zero),
    "over the jump of the tangent": (integral(1 / (2 + sp.cos(x)), 0, TURN), TURN / sp.sqrt(3)),
    "with a parameter": (integral(1 / (1 - e * sp.cos(x)), 0, TURN), TURN / sp.sqrt(1 - e**2)),
    "within a formula": (e + e * integral(3 * x**2, -1, 1), 3 * e),
    "against the axis": (integral(x, 1, 0), -sp.Rational(1, 2)),
    "to a parameter": (integral(sp.cos(x), 0, e), sp.sin(e)),
    "between parameters": (integral(1 / x**2, e, 2 * e), 1 / (2 * e)),
    "of negative numbers": (integral(1 / x, -2, -1), -sp.log(2)),
    "a modulus": (integral(sp.Abs(sp.sin(x)), 0, TURN), sp.S(4)),
    "a modulus of a polynomial": (integral(sp.Abs(x**2 - 1), -1, 2), sp.Rational(8, 3)),
    "an arc of a cycloid": (
        integral(sp.sqrt((1 - sp.cos(x)) ** 2 + sp.sin(x) ** 2), 0, 2 * TURN),
        sp.S(16),
    ),
    "a root of a cosine": (
        integral(sp.sqrt(e - e * sp.cos(2 * x)), 0, sp.pi),
        2 * sp.sqrt(2) * sp.sqrt(e),
    ),
    "to infinity": (integral(x * sp.exp(-x), 0, sp.oo), sp.S.One),
    "to infinity, of a bell": (integral(x * sp.exp(-(x**2)), 0, sp.oo), sp.S.Half),
    "to infinity, a parameter": (integral(sp.exp(-e * x), 0, sp.oo), 1 / e),
    "from a quarter turn": (integral(1 / (1 + e * sp.sin(x)), 0, TURN), TURN / sp.sqrt(1 - e**2)),
    "over the whole line, a parameter": (integral(1 / (e**2 + x**2), -sp.oo, sp.oo), sp.pi / e),
    "over the whole line": (integral(1 / (1 + x**2), -sp.oo, sp.oo), sp.pi),
    "by parts, back to itself": (
        integral(sp.exp(-x) * sp.cos(e * x), 0, sp.oo),
        1 / (1 + e**2),
    ),
    "square of a denominator": (
        integral((1 - e * sp.cos(x)) ** -2, 0, TURN),
        TURN / (1 - e**2) ** sp.Rational(3, 2),
    ),
    "logarithms of roots": (
        integral(1 / (1 + x**4), 0, 1),
        (sp.pi + 2 * sp.log(1 + sp.sqrt(2))) / (4 * sp.sqrt(2)),
    ),
    "over a triangle": (over(x * y, (y, 0, x), (x, 0, 1)), sp.Rational(1, 8)),
    "over a rectangle": (over(x * y, (y, 0, e), (x, 0, 2 * e)), e**4),
    "over a disc": (over(x, (x, 0, e), (y, 0, TURN)), sp.pi * e**2),
    "over a ball": (
        over(x**2 * sp.sin(y), (x, 0, e), (y, 0, sp.pi), (z, 0, TURN)),
        4 * sp.pi * e**3 / 3,
    ),
    "over a quarter of the plane": (over(sp.exp(-x - y), (x, 0, sp.oo), (y, 0, sp.oo)), sp.S.One),
    "of a square of an integral": (
        sp.Integral(sp.Integral(y, (y, 0, x)) ** 2, (x, 0, 1)),
        sp.Rational(1, 20),
    ),
    "iterated, against the axis": (over(y, (y, 0, x), (x, 1, 0)), -sp.Rational(1, 6)),
    "odd": (integral(x**3 / (1 + x**4 + sp.cos(x)), -e, e), sp.S.Zero),
    "odd, over the whole line": (integral(sp.sin(x) / (1 + x**2), -sp.oo, sp.oo), sp.S.Zero),
    "a root that comes to zero": (integral(sp.sqrt(1 + sp.cos(2 * x)), 0, sp.pi), 2 * sp.sqrt(2)),
    "a root of a sine": (integral(sp.sqrt(1 + sp.sin(x)), 0, sp.pi), sp.S(4)),
    "over the pole of a logarithm": (integral(sp.log(sp.Abs(x)), -1, 1), sp.S(-2)),
    "the larger number": (integral(sp.Max(x, 1), 0, 2), sp.Rational(5, 2)),
    "the larger wave": (integral(sp.Max(sp.sin(x), sp.cos(x)), 0, sp.pi / 2), sp.sqrt(2)),
    "by pieces": (
        integral(sp.Piecewise((x**2, x < 1), (2 - x, True)), 0, 2),
        sp.Rational(5, 6),
    ),
    "by pieces that meet at a letter": (
        integral(sp.Piecewise((x, x < e), (e, True)), 0, 1),
        e - e**2 / 2,
    ),
    "a modulus between letters": (integral(sp.Abs(x), z, y), (y * sp.Abs(y) - z * sp.Abs(z)) / 2),
    "from both ends, of roots": (
        integral(sp.sqrt(sp.sin(x)) / (sp.sqrt(sp.sin(x)) + sp.sqrt(sp.cos(x))), 0, sp.pi / 2),
        sp.pi / 4,
    ),
    "a modulus of a wave of any length": (
        integral(sp.Abs(sp.sin(TURN * x / e)), 0, e),
        2 * e / sp.pi,
    ),
    "a sign": (integral(sp.sign(x), 0, y), y * sp.sign(y)),
    "a floor": (integral(x - sp.floor(x), 0, 3), sp.Rational(3, 2)),
    "from a pole": (integral(1 / sp.sqrt(x), 0, 1), sp.S(2)),
    "between two poles": (integral(1 / sp.sqrt(1 - x**2), -1, 1), sp.pi),
    "from a logarithm's pole": (integral(x * sp.log(x), 0, 1), -sp.Rational(1, 4)),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", TRUE)
def test_a_true_integral_is_proved(name: str) -> None:
    answer = decide(Equality(*TRUE[name]), DOMAIN)
    assert answer.verdict is Verdict.PROVED
    assert integrals.RUNG in answer.rung


@pytest.mark.slow
@pytest.mark.parametrize("name", TRUE)
def test_its_wrong_neighbour_is_refuted(name: str) -> None:
    left, right = TRUE[name]
    answer = decide(Equality(left, right + sp.Rational(1, 100)), DOMAIN)
    assert answer.verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    "value",
    [
        integral(1 / x, -1, 1),
        integral(x**3 / (1 - x**4), -e, e + 1),
        integral(x / (1 + x**2), -sp.oo, sp.oo),
        integral(sp.log(sp.Abs(x)) / x, -1, 1),
        integral(x**2 / (1 + x**2) - sp.Rational(1, 10**30), -e, e),
    ],
    ids=["a pole between", "other ends", "without an end", "odd, a pole", "not odd"],
)
def test_no_other_integral_is_nothing(value: sp.Integral) -> None:
    assert decide(Equality(value, sp.S.Zero), DOMAIN).verdict is not Verdict.PROVED


@pytest.mark.parametrize(
    ("value", "proposed"),
    [
        (integral(x, 0, 1), x**2),
        (
            integral(1 / (2 + sp.cos(x)), 0, TURN),
            2 * sp.atan(sp.tan(x / 2) / sp.sqrt(3)) / sp.sqrt(3),
        ),
        (integral(1 / x**2, -1, 1), -1 / x),
        (integral(1 / x**2, 0, 1), -1 / x),
        (integral(1 / x, 1, sp.oo), sp.log(x)),
        (integral(sp.cos(x), 0, sp.oo), sp.sin(x)),
    ],
    ids=[
        "another derivative",
        "it jumps",
        "the integrand has a pole",
        "no limit at a pole",
        "no limit",
        "no limit, though bounded",
    ],
)
def test_what_is_no_continuous_antiderivative_is_no_proof(
    value: sp.Integral, proposed: sp.Expr, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(integrals, "propose", lambda *_: [proposed])
    _, (_, lower, upper) = value.args
    told = proposed.subs(x, upper) - proposed.subs(x, lower)
    prove = lambda left, right, domain: "equal" if left == right else None  # noqa: E731
    assert integrals.decide_by_antiderivative(value, told, DOMAIN, prove) is None


@pytest.mark.parametrize(
    "value",
    [
        over(1 / (x - y), (y, 0, 1), (x, 0, 1)),
        over(1 / x, (y, -1, 1), (x, -1, 1)),
        sp.Integral(over(1 / x, (y, 0, x)) - 1, (x, -1, 1)),
    ],
    ids=["a line of poles", "a pole of all", "an inner one has no value at one place"],
)
def test_an_iterated_integral_across_a_pole_has_no_value(value: sp.Integral) -> None:
    assert put_values(value, DOMAIN, (sp.Integral,), integrals.find_improper) == value


def test_what_is_bound_elsewhere_is_not_looked_at() -> None:
    prove = lambda *_: "equal"  # noqa: E731
    own = sp.Integral(x, (x, 0, x))
    inner = sp.Integral(1 / (2 - e), (e, 0, x))
    for value in (own, sp.Integral(inner, (x, 0, 5)), sp.Sum(inner, (x, 1, 5))):
        assert integrals.decide_by_antiderivative(value, sp.S.One, DOMAIN, prove) is None
        assert put_values(value, DOMAIN, (sp.Integral,), integrals.find_improper) == value


@pytest.mark.parametrize(
    "value",
    [
        integral(x, 1, 1),
        integral(sp.exp(-(x**4)), 0, sp.oo),
        integral(sp.sqrt(1 - e * sp.sin(x)), 0, 1),
    ],
    ids=["of nothing", "no antiderivative", "elliptic"],
)
def test_other_integrals_are_left(value: sp.Integral) -> None:
    prove = lambda *_: "equal"  # noqa: E731
    assert integrals.decide_by_antiderivative(value, value, DOMAIN, prove) is None
