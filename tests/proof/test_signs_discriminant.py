"""Signs of quadratics with symbolic coefficients: the discriminant, and its wrong neighbours."""

import pytest
import sympy as sp

from mechproof.proof.coordinates import Coordinates
from mechproof.proof.polynomial_signs import StrictSign, sign_of_quotient
from mechproof.proof.signs import find_sign
from mechproof.statement_domains.domain import Domain

a, b, x, y = sp.symbols("a b x y", real=True)
e = sp.Symbol("e", real=True)
u, v, w = sp.symbols("u v w", real=True)
ECCENTRIC = {e: sp.Interval.Ropen(0, 1)}
TWO_ANGLES = sp.cos(x) * sp.cos(y) - sp.sin(x) * sp.sin(y)

KNOWN = {
    "definite form": (a**2 + a * b + b**2 + 1, {}, StrictSign(1, True)),
    "zero at the origin": (a**2 + a * b + b**2, {}, StrictSign(1, False)),
    "square of a sum": (a**2 + 2 * a * b + b**2, {}, StrictSign(1, False)),
    "square of a sum, lifted": (a**2 + 2 * a * b + b**2 + 1, {}, StrictSign(1, True)),
    "negative": (-(a**2) + a * b - b**2 - 1, {}, StrictSign(-1, True)),
    "two angles": (1 - e * TWO_ANGLES, ECCENTRIC, StrictSign(1, True)),
}
UNKNOWN = {
    "indefinite form": (a**2 + 3 * a * b + b**2 + 1, {}),
    "leading coefficient may vanish": (a**2 * b**2 + a * b + 1, {}),
    "leading coefficient changes sign": (a**2 * b + a + 1, {}),
    "cubic": (a**3 + a * b + b**2 + 1, {}),
    "two angles, too steep": (
        1 - e * (sp.cos(x) * sp.cos(y) - 2 * sp.sin(x) * sp.sin(y)),
        ECCENTRIC,
    ),
}


@pytest.mark.parametrize("name", KNOWN)
def test_a_quadratic_without_real_roots_has_a_sign(name):
    expression, within, sign = KNOWN[name]
    assert find_sign(expression, Domain(within, (), {})) == sign


@pytest.mark.parametrize("name", UNKNOWN)
def test_a_wrong_neighbour_has_none(name):
    expression, within = UNKNOWN[name]
    assert find_sign(expression, Domain(within, (), {})) is None


@pytest.mark.parametrize(
    ("expression", "sign"),
    [
        ((sp.sqrt(u) + 1) / (u + v), StrictSign(1, True)),
        (-sp.sqrt(u) / v, StrictSign(-1, False)),
        (u**2 - u + 1, StrictSign(1, True)),
        ((sp.sqrt(u) - 1) / (u + v), None),
        (u / (v - 1), None),
        (u + w, None),
        (sp.sqrt(sp.sin(w)) + 1, None),
        (u * 0, StrictSign(1, False)),
    ],
)
def test_signs_of_terms_are_those_of_quotients(expression, sign):
    coordinates = Coordinates({}, positive={v}, nonnegative={u})
    assert sign_of_quotient(expression, coordinates) == sign
