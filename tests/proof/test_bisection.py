"""Bisection and derivatives: transcendental inequalities on a closed interval, and near misses."""

import pytest
import sympy as sp

from mechproof.proof.ladder import decide
from mechproof.proof.single_variable import BISECTION, holds_on_interval
from mechproof.proof.verdict import Verdict
from mechproof.record import Holds
from mechproof.statement_domains.domain import Domain

x, y = sp.symbols("x y", real=True)
ONE = sp.Interval(-1, 1)
RIGHT = sp.Interval(0, 1)

TRUE = {
    "strict": (x + sp.cos(x) + 1 > 0, ONE),
    "sine below its argument": (sp.sin(x) <= x, RIGHT),
    "cosine above its parabola": (sp.cos(x) >= 1 - x**2 / 2, ONE),
    "zero at the right end": (sp.sin(x - 1) >= x - 1, sp.Interval(0, 1)),
    "tangent above its argument": (sp.tan(x) >= x, RIGHT),
}
WRONG = {
    "strict where it vanishes": (sp.sin(x) < x, RIGHT),
    "sine below its argument on both sides": (sp.sin(x) <= x, ONE),
    "coefficient": (sp.cos(x) >= 1 - x**2 / 3, ONE),
    "zero at the right end, wrong way": (sp.sin(x - 1) <= x - 1, sp.Interval(0, 1)),
    "false on a short piece": (sp.exp(x) - x - 1 > sp.Rational(1, 10**6), ONE),
    "tangent past its pole": (sp.tan(x) >= x, sp.Interval(0, 2)),
    "logarithm of what is negative": (sp.log(x) <= x, ONE),
    "steep root at the end": (sp.sqrt(x) <= sp.sin(x) + x, RIGHT),
    "two variables": (sp.exp(x) + y >= 1 + x, ONE),
    "step": (sp.floor(x) + sp.sin(x) + 1 >= x, ONE),
}


@pytest.mark.parametrize("name", TRUE)
def test_a_true_inequality_is_proved(name):
    relation, where = TRUE[name]
    domain = Domain({x: where}, (), {})
    assert holds_on_interval(relation, domain)
    answer = decide(Holds(relation), domain)
    assert (answer.verdict, answer.rung) == (Verdict.PROVED, BISECTION)


@pytest.mark.slow
@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_neighbour_is_not_proved(name):
    relation, where = WRONG[name]
    domain = Domain({x: where}, (), {})
    assert not holds_on_interval(relation, domain)
    assert decide(Holds(relation), domain).verdict is not Verdict.PROVED


def test_an_open_line_is_not_bisected():
    assert not holds_on_interval(sp.exp(x) >= 1 + x, Domain({x: sp.S.Reals}, (), {}))
