"""Sums of arguments of plane vectors: equal directions, and the turn that may be lost."""

import pytest
import sympy as sp

from mechproof.proof.inverses import ARGUMENTS, decide_by_argument
from mechproof.statement_domains.domain import Domain

x, y = sp.symbols("x y", real=True)
SMALL = {x: sp.Interval.open(0, 1), y: sp.Interval.open(0, 1)}
POSITIVE = {x: sp.Interval.open(0, sp.oo), y: sp.Interval.open(0, sp.oo)}
SUM = sp.atan(x) + sp.atan(y)

TRUE = {
    "sum of two": (SUM, sp.atan2(x + y, 1 - x * y), POSITIVE),
    "sum of two below a quarter turn": (SUM, sp.atan((x + y) / (1 - x * y)), SMALL),
    "numbers": (sp.atan(sp.Rational(1, 2)) + sp.atan(sp.Rational(1, 3)), sp.pi / 4, {}),
    "Machin": (4 * sp.atan(sp.Rational(1, 5)) - sp.atan(sp.Rational(1, 239)), sp.pi / 4, {}),
    "half a turn": (sp.atan(1) + sp.atan(2) + sp.atan(3), sp.pi, {}),
    "same direction": (sp.atan2(x * y, x), sp.atan2(y, 1), POSITIVE),
}
WRONG = {
    "turn lost": (SUM, sp.atan((x + y) / (1 - x * y)), POSITIVE),
    "sign": (SUM, sp.atan2(x + y, 1 + x * y), POSITIVE),
    "difference for sum": (SUM, sp.atan2(x - y, 1 + x * y), POSITIVE),
    "opposite direction": (sp.atan2(x, 1), sp.atan2(-x, -1), POSITIVE),
    "factor": (2 * SUM, sp.atan2(x + y, 1 - x * y), POSITIVE),
    "sum that leaves the half turn": (
        sp.atan2(x, -1) + sp.atan2(y, -1),
        sp.atan2(-x - y, 1 - x * y),
        POSITIVE,
    ),
    "three arguments": (SUM + sp.atan(x * y), sp.atan(x + y), POSITIVE),
    "another number": (
        4 * sp.atan(sp.Rational(1, 5)) - sp.atan(sp.Rational(1, 238)),
        sp.pi / 4,
        {},
    ),
    "a whole turn": (sp.atan(1) + sp.atan(2) + sp.atan(3), -sp.pi, {}),
    "another constant": (SUM, sp.atan2(x + y, 1 - x * y) + sp.pi, POSITIVE),
}


@pytest.mark.parametrize("name", TRUE)
def test_equal_arguments_are_proved(name):
    left, right, within = TRUE[name]
    assert decide_by_argument(left, right, Domain(within, (), {})) == ARGUMENTS


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_neighbour_is_not_proved(name):
    left, right, within = WRONG[name]
    assert decide_by_argument(left, right, Domain(within, (), {})) is None
