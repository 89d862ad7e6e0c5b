"""The algebraic rungs: rational functions, circle points, square roots, opaque functions.

A table of true statements names the rung that must prove each; no rung may accept any of the
slightly wrong neighbours in the other table.
"""

import pytest
import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Verdict
from mechproof.record import Equality
from mechproof.statement_domains.domain import Domain

x, y, z, e, u = sp.symbols("x y z e u", real=True)
n = sp.Symbol("n", integer=True, positive=True)
i = sp.Symbol("i", integer=True, positive=True)
q = sp.IndexedBase("q", real=True)
f = sp.Function("f")
SUM = sp.Sum(q[i], (i, 1, n))
BELOW_ONE = {e: sp.Interval.Ropen(0, 1)}
POSITIVE = {x: sp.Interval.open(0, sp.oo)}
NEGATIVE = {x: sp.Interval.open(-sp.oo, 0)}
RATIONAL, CIRCLE, ROOTS = "rational field", "trigonometric field", "radicals"
ROOT_OF_SQUARE = sp.sqrt((e - 1) ** 2)
HALF_ANGLE = sp.tan(x / 2)

TRUE = {
    "difference of squares": (RATIONAL, (x - y) * (x + y), x**2 - y**2, {}),
    "partial fractions": (RATIONAL, 1 / x - 1 / (x + 1), 1 / (x * (x + 1)), {}),
    "removable quotient": (RATIONAL, (x**2 - 1) / (x - 1), x + 1, {}),
    "sine of a sum": (CIRCLE, sp.sin(x + y), sp.sin(x) * sp.cos(y) + sp.cos(x) * sp.sin(y), {}),
    "triple angle": (CIRCLE, sp.cos(3 * x), 4 * sp.cos(x) ** 3 - 3 * sp.cos(x), {}),
    "half-angle tangent": (CIRCLE, sp.sin(x), 2 * HALF_ANGLE / (1 + HALF_ANGLE**2), {}),
    "third of an angle": (CIRCLE, sp.sin(x), 3 * sp.sin(x / 3) - 4 * sp.sin(x / 3) ** 3, {}),
    "shift by pi/7": (
        CIRCLE,
        sp.cos(x + sp.pi / 7),
        sp.cos(x) * sp.cos(sp.pi / 7) - sp.sin(x) * sp.sin(sp.pi / 7),
        {},
    ),
    "cotangent": (CIRCLE, sp.cot(x) * sp.sin(x), sp.cos(x), {}),
    "root of a square, sign known": (ROOTS, ROOT_OF_SQUARE, 1 - e, BELOW_ONE),
    "root of a sum that is a square": (ROOTS, sp.sqrt(x**2 + 2 * x + 1), x + 1, POSITIVE),
    "root of a square, negative": (ROOTS, sp.sqrt(x**2 - 2 * x + 1), 1 - x, NEGATIVE),
    "modulus, negative": (ROOTS, sp.Abs(x), -x, NEGATIVE),
    "roots multiplied": (
        ROOTS,
        sp.sqrt((1 - e) / (1 + e)) * sp.sqrt(1 - e**2),
        1 - e,
        BELOW_ONE,
    ),
    "sine squared": (CIRCLE, sp.sqrt(1 - sp.cos(x) ** 2) ** 2, sp.sin(x) ** 2, {}),
    "opaque, equal arguments": (RATIONAL, f((x + 1) ** 2), f(x**2 + 2 * x + 1), {}),
    "atan2 to the right": (RATIONAL, sp.atan2(2 * x * y, 2 * x), sp.atan(y), POSITIVE),
}

WRONG = {
    "sign": ((x - y) * (x + y), x**2 + y**2, {}),
    "factor": (1 / x - 1 / (x + 1), 2 / (x * (x + 1)), {}),
    "sine for cosine": (sp.sin(x + y), sp.sin(x) * sp.cos(y) + sp.cos(x) * sp.cos(y), {}),
    "swapped symbols": (sp.sin(x - y), sp.sin(y - x), {}),
    "angle halved": (sp.sin(x), 2 * HALF_ANGLE / (1 - HALF_ANGLE**2), {}),
    "wrong multiple": (
        sp.cos(3 * x),
        4 * sp.cos(x) ** 3 - 3 * sp.cos(x) + sp.Rational(1, 10**9),
        {},
    ),
    "shift by pi/7 with the wrong sign": (
        sp.cos(x + sp.pi / 7),
        sp.cos(x) * sp.cos(sp.pi / 7) + sp.sin(x) * sp.sin(sp.pi / 7),
        {},
    ),
    "root of a square, sign unknown": (sp.sqrt(x**2), x, {}),
    "root of a square, wrong sign": (ROOT_OF_SQUARE, e - 1, BELOW_ONE),
    "root of a sum, sign unknown": (sp.sqrt(x**2 + 2 * x + 1), x + 1, {}),
    "modulus, sign unknown": (sp.Abs(x), x, {}),
    "root of a cosine": (sp.sqrt(1 - sp.sin(x) ** 2), sp.cos(x), {}),
    "sine, end where it vanishes": (
        sp.sqrt(1 - sp.cos(x) ** 2),
        sp.sin(x),
        {x: sp.Interval(-1, 0)},
    ),
    "sine of a sum of many": (
        sp.sqrt(1 - sp.cos(SUM) ** 2),
        sp.sin(SUM),
        {q: sp.Interval.open(0, 1), n: sp.S.Naturals},
    ),
    "sine of an integral": (
        sp.sqrt(1 - sp.cos(sp.Integral(sp.exp(-(u**2)), (u, 0, x))) ** 2),
        sp.sin(sp.Integral(sp.exp(-(u**2)), (u, 0, x))),
        {},
    ),
    "root lost": (sp.sqrt((1 - e) / (1 + e)), (1 - e) / (1 + e), BELOW_ONE),
    "opaque, unequal arguments": (f((x + 1) ** 2), f(x**2 + x + 1), {}),
    "opaque, other function": (sp.exp(x), sp.log(x), POSITIVE),
    "opaque, arguments swapped": (sp.Function("g")(x, y), sp.Function("g")(y, x), {}),
    "atan2 to the left": (sp.atan2(2 * x * y, 2 * x), sp.atan(y), NEGATIVE),
    "atan2 across its cut": (sp.atan2(x * y, x), sp.atan(y), {}),
    "both sides of a cut root": (sp.sqrt(x) * sp.sqrt(x + 1), sp.sqrt(x**2 + x), {}),
    "piecewise": (sp.Piecewise((x, x > 0), (0, True)), sp.Piecewise((x, x > 1), (0, True)), {}),
    "infinite": (sp.zoo * x, sp.zoo * y, {}),
}


@pytest.mark.parametrize("name", TRUE)
def test_a_true_statement_is_proved_by_its_rung(name):
    rung, left, right, within = TRUE[name]
    assert decide_equal(left, right, Domain(within, (), {})) == rung
    assert decide_equal(right, left, Domain(within, (), {})) == rung


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_neighbour_is_not_accepted(name):
    left, right, within = WRONG[name]
    assert decide_equal(left, right, Domain(within, (), {})) is None
    assert decide_equal(right, left, Domain(within, (), {})) is None


def test_a_relation_between_symbols_gives_the_sign_under_a_root():
    large, small = sp.symbols("L S", real=True)
    root, difference = sp.sqrt(large**2 - 2 * large * small + small**2), large - small
    assert decide_equal(root, difference, Domain({}, (small < large,), {})) == ROOTS
    assert decide_equal(root, difference, Domain({}, (small > large,), {})) is None
    assert decide_equal(root, -difference, Domain({}, (small > large,), {})) == ROOTS


UNDEFINED = {
    "left side real on half of the domain": Equality((1 + sp.sqrt(x)) * (1 - sp.sqrt(x)), 1 - x),
    "defined nowhere": Equality(sp.nan, sp.nan),
    "root of a negative number": Equality(sp.sqrt(-1 - x**2) + y, y + sp.sqrt(-1 - x**2) + 0 * x),
    "divided by what vanishes identically": Equality(
        x * (sp.cos(x) ** 2 - 1 + sp.sin(x) ** 2) / (sp.cos(x) ** 2 - 1 + sp.sin(x) ** 2) ** 2,
        y * (sp.cos(x) ** 2 - 1 + sp.sin(x) ** 2) / (sp.cos(x) ** 2 - 1 + sp.sin(x) ** 2) ** 2,
    ),
}


@pytest.mark.parametrize("name", UNDEFINED)
def test_agreement_is_no_proof_where_a_side_has_no_value(name):
    assert decide(UNDEFINED[name], Domain({}, (), {})).verdict is not Verdict.PROVED
