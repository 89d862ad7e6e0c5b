"""The sign rung proves true inequalities, but no neighbours and none that fails at an end."""

import pytest
import sympy as sp

from mechproof.proof.half_angles import is_shown_there
from mechproof.proof.ladder import decide
from mechproof.proof.polynomial_signs import StrictSign
from mechproof.proof.signs import find_sign
from mechproof.proof.verdict import Verdict
from mechproof.record import Holds, Slack
from mechproof.statement_domains.domain import Domain

x, y, z, e = sp.symbols("x y z e", real=True)
R1, R2 = sp.symbols("R1 R2", positive=True)
n = sp.Symbol("n", integer=True, positive=True)
q = sp.IndexedBase("q", real=True)
i = sp.Symbol("i", integer=True, positive=True)
RADII = {R1: sp.Interval.open(0, sp.oo), R2: sp.Interval.open(0, sp.oo)}
UNIT = {x: sp.Interval(0, 1)}
HALF_OPEN = {x: sp.Interval.Ropen(0, 1)}
OPEN = {x: sp.Interval.open(0, 1)}
RUNG = "sign in positive coordinates"
# Equal to 1 - x*cos(y).
TANGENT_OF_HALF = sp.cos(y) - x + sp.tan(y / 2) * sp.sin(y) * (1 + x)
PRODUCT_OF_ROOTS = sp.sqrt((1 + x) / (1 - x)) * sp.sqrt(1 - x**2)


def later(kind, left, right):
    """Return the relation without letting SymPy evaluate it."""
    return kind(left, right, evaluate=False)


TRUE = {
    "square": (later(sp.Ge, x**2, 0), {}, ()),
    "quadratic without real roots": (x**2 + x + 1 > 0, {}, ()),
    "half line": (x**3 + x > 0, {x: sp.Interval.open(0, sp.oo)}, ()),
    "half line to the left": (x**3 + x < 0, {x: sp.Interval.open(-sp.oo, 0)}, ()),
    "closed right end": (x * (1 - x) >= 0, UNIT, ()),
    "open right end": (1 - x > 0, HALF_OPEN, ()),
    "open at both ends": (x * (1 - x) > 0, OPEN, ()),
    "double root, not strict": ((x - sp.Rational(1, 3)) ** 2 * (x + 1) >= 0, UNIT, ()),
    "cosine": (1 + sp.cos(x) >= 0, {}, ()),
    "cosine, strict": (2 + sp.cos(x) > 0, {}, ()),
    "two angles, strict": (3 + sp.cos(x) + sp.sin(y) > 0, {}, ()),
    "polar denominator": (1 + e**2 - 2 * e * sp.cos(x) > 0, {e: sp.Interval.Ropen(0, 1)}, ()),
    "of a joint": (sp.cos(x) / (1 - sp.sin(x) ** 2 * sp.cos(y) ** 2) - sp.cos(x) >= 0, OPEN, ()),
    "of a joint, strict": (1 - sp.sin(x) ** 2 * sp.cos(y) ** 2 > 0, OPEN, ()),
    "root with a parameter": (
        1 + sp.cos(y) + (1 - sp.cos(y)) / sp.sqrt((1 - x) / (1 + x)) > 0,
        OPEN,
        (),
    ),
    "roots whose product has none": (PRODUCT_OF_ROOTS > 1, OPEN, ()),
    "tangent of half an angle": (TANGENT_OF_HALF > 0, OPEN, ()),
    "relation of a cosine": ((sp.cos(y) - x) / (2 + sp.sin(y)) > 0, OPEN, (sp.cos(y) > x,)),
    "tangent": (later(sp.Gt, 1 + sp.tan(x) ** 2, 0), {}, ()),
    "cosine within a quarter turn": (sp.cos(x) > 0, {x: sp.Interval(-1, 1)}, ()),
    "smaller radius": (R1 - R2 > 0, RADII, (R2 < R1,)),
    "smaller radius, weak": (R1 - R2 >= 0, RADII, (R2 <= R1,)),
    "smaller radius twice": (R1**2 - R2**2 > 0, RADII, (R2 < R1,)),
    "chain": (z - x > 0, {}, (y > x, z > y)),
    "relation with a closed end": (y >= 0, {z: sp.Interval(0, 1)}, (y >= 1 - z,)),
    "root": (later(sp.Ge, sp.sqrt(x) + 1, 1), {x: sp.Interval(0, sp.oo)}, ()),
    "modulus": (later(sp.Gt, sp.Abs(x + y) + 1, 0), {}, ()),
    "modulus below": (R1**2 - x**2 >= 0, RADII, (sp.Abs(x) <= R1,)),
    "count": (later(sp.Ge, n * (n - 1), 0), {n: sp.S.Naturals}, ()),
    "indexed": (later(sp.Gt, q[i] ** 2 + 1, 0), {}, ()),
    "unequal": (sp.Ne(x**2 + 1, 0, evaluate=False), {}, ()),
}

WRONG = {
    "square, strict": (later(sp.Gt, x**2, 0), {}, ()),
    "modulus, strict": (later(sp.Gt, sp.Abs(x), 0), {}, ()),
    "modulus above": (R1**2 - 2 * x**2 >= 0, RADII, (sp.Abs(x) <= R1,)),
    "quadratic with a double root": (x**2 + 2 * x + 1 > 0, {}, ()),
    "quadratic with two roots": (x**2 + 3 * x + 1 > 0, {}, ()),
    "half line closed at the root": (x**3 + x > 0, {x: sp.Interval(0, sp.oo)}, ()),
    "strict at a closed right end": (1 - x > 0, UNIT, ()),
    "strict at a closed left end": (x > 0, UNIT, ()),
    "root inside": (x - sp.Rational(1, 2) > 0, OPEN, ()),
    "negative at the closed right end only": ((1 - x) * (2 - x) - x**9 / 1000 >= 0, UNIT, ()),
    "double root, strict": ((x - sp.Rational(1, 3)) ** 2 * (x + 1) > 0, UNIT, ()),
    "cosine, strict": (1 + sp.cos(x) > 0, {}, ()),
    "logarithm of one or less": (sp.log(1 + x) > 0, UNIT, ()),
    "cosine of another angle, strict": (1 + sp.cos(x / 3 + y) > 0, {}, ()),
    "two angles, strict": (2 + sp.cos(x) + sp.cos(y) > 0, {}, ()),
    "sum zero when both are half a turn": ((1 + sp.cos(x)) ** 2 + (1 + sp.cos(y)) ** 2 > 0, {}, ()),
    "polar denominator, e = 1": (
        1 + e**2 - 2 * e * sp.cos(x) > 0,
        {e: sp.Interval(0, 1)},
        (),
    ),
    "cosine beyond a quarter turn": (sp.cos(x) > 0, {x: sp.Interval(-2, 2)}, ()),
    "larger radius": (R2 - R1 > 0, RADII, (R2 < R1,)),
    "radius, strict from weak": (R1 - R2 > 0, RADII, (R2 <= R1,)),
    "radius without the relation": (R1 - R2 > 0, RADII, ()),
    "relation the wrong way": (R1 - 2 * R2 > 0, RADII, (R2 < R1,)),
    "relation with a closed end, strict": (y > 0, {z: sp.Interval(0, 1)}, (y >= 1 - z,)),
    "root, strict at its zero": (later(sp.Gt, sp.sqrt(x) + 1, 1), {x: sp.Interval(0, sp.oo)}, ()),
    "roots whose product has none": (PRODUCT_OF_ROOTS > 1, {x: sp.Interval.open(-1, 1)}, ()),
    "tangent of half an angle": (TANGENT_OF_HALF > 1, OPEN, ()),
    "relation of a cosine": (sp.cos(y) - 2 * x > 0, OPEN, (sp.cos(y) > x,)),
    "count, strict at one": (later(sp.Gt, n * (n - 1), 0), {n: sp.S.Naturals}, ()),
    "indexed": (later(sp.Gt, q[i], 0), {}, ()),
    "unequal": (sp.Ne(x**2 - 1, 0, evaluate=False), {}, ()),
    "largest of two": (later(sp.Gt, sp.Max(x, y), 0), {}, ()),
    "power with a symbol": (later(sp.Gt, 2**x, 1), {}, ()),
    "cube root": (later(sp.Gt, x ** sp.Rational(1, 3), 1), OPEN, ()),
}


@pytest.mark.parametrize("name", TRUE)
def test_a_true_inequality_is_proved(name):
    relation, within, where = TRUE[name]
    answer = decide(Holds(relation), Domain(within, where, {}))
    assert (answer.verdict, answer.rung) == (Verdict.PROVED, RUNG)


@pytest.mark.slow
@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_neighbour_is_not_proved(name):
    relation, within, where = WRONG[name]
    assert decide(Holds(relation), Domain(within, where, {})).verdict is not Verdict.PROVED


@pytest.mark.parametrize("name", TRUE)
def test_the_opposite_of_a_true_inequality_is_refuted_or_open(name):
    relation, within, where = TRUE[name]
    opposite = relation.negated
    assert decide(Holds(opposite), Domain(within, where, {})).verdict is not Verdict.PROVED


NOT_SHOWN = {
    "sum": sp.Sum(q[i] ** 2, (i, 1, n)),
    "integral": sp.Integral(x**2, (x, 0, 1)) * y**2 + sp.Integral(sp.exp(y * x), (x, 0, 1)),
    "complex number": sp.sqrt(-2) * x,
    "undefined": sp.nan,
    "sine above its tangent": sp.sin(x) ** 3 + sp.Rational(1, 10**6),
}


@pytest.mark.parametrize("name", NOT_SHOWN)
def test_an_expression_beyond_the_rung_has_no_sign(name):
    assert find_sign(NOT_SHOWN[name], Domain({}, (), {})) is None


def test_the_product_of_signs():
    assert StrictSign(-1, True).times(StrictSign(-1, False)) == StrictSign(1, False)


@pytest.mark.parametrize(
    ("expression", "sign"),
    [
        (1 - x * y, StrictSign(1, True)),
        ((x * y - 1) / 3, StrictSign(-1, True)),
        ((1 + x**2) / (x * y - 1), StrictSign(-1, True)),
        (1 - x * y + (x + y) ** 2 / (1 - x * y), StrictSign(1, True)),
        (sp.Rational(1, 2) - x * y, None),
        ((x - y) * (1 - x * y), None),
        (1 + x * y, None),
    ],
)
def test_a_relation_says_the_sign_of_a_factor(expression: sp.Expr, sign: StrictSign | None) -> None:
    assert find_sign(expression, Domain({}, (sp.Lt(x * y, 1),), {})) == sign
    assert find_sign(expression, Domain({}, (), {})) is None


def test_what_may_be_zero_divides_nothing() -> None:
    domain = Domain({}, (sp.Le(x * y, 1),), {})
    assert find_sign(1 - x * y, domain) == StrictSign(1, False)
    assert find_sign(1 / (1 - x * y), domain) is None


POWERS = {
    "a power with a letter above": (-x) ** y * (2 + x),
    "an odd power": (-x) ** 3 * (2 + x),
    "a divisor that may be zero": (2 + x) / (1 - x),
}


@pytest.mark.parametrize("name", POWERS)
def test_the_sign_of_a_product_is_not_shown_by_other_powers(name: str) -> None:
    domain = Domain({x: sp.Interval(0, 1, left_open=True), y: sp.S.Reals}, (), {})
    assert not is_shown_there(Slack(POWERS[name], False), domain)
    assert is_shown_there(Slack((2 + x) / x, True), domain)
