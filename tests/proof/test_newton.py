"""Roots: enclosed in balls, and shown to be the limit of Newton's steps, or the reason why not."""

from __future__ import annotations

import mpmath as mp
import pytest
import sympy as sp

from mechproof.arithmetic import balls
from mechproof.proof import newton
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Answer, Verdict
from mechproof.record import Holds, RecordError, Root
from mechproof.record.implicit import LEFT, LastIterate
from mechproof.statement_domains.domain import Domain

E, M, x = sp.symbols("E M x", real=True)
e, y = sp.Symbol("e", nonnegative=True), sp.Symbol("y", positive=True)
SIGMA = sp.Symbol("sigma", real=True)
KEPLER = E - e * sp.sin(E) - M
INVOLUTE = sp.tan(x) - x - y
START = M + e * sp.sin(M)


def state(root: Root, bound: sp.Expr = LEFT) -> Holds:
    distance = sp.Abs(LastIterate.towards(root) - root)
    return Holds(sp.Le(distance, bound, evaluate=False))


def judge(root: Root, *where: sp.Basic, **within: sp.Set) -> Answer:
    sets = {s: within[str(s)] for s in root.free_symbols}
    return decide(state(root), Domain(sets, where, {}))


def between(low: str, high: str) -> sp.Interval:
    return sp.Interval(sp.Rational(low), sp.Rational(high))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("root", "within"),
    [
        (Root(KEPLER, (E, M - 1, M + 1), START), {"M": sp.S.Reals, "e": between("0", "0.6")}),
        (Root(sp.Eq(KEPLER, 0), (E, M - 1, M + 1), M, steps=7),
         {"M": between("-1", "20"), "e": between("0", "0.7")}),
        (Root(INVOLUTE, (x, sp.Rational(1, 20), sp.Rational(13, 10)), sp.cbrt(3 * y), 6),
         {"y": between("0.0001", "0.4")}),
        (Root(x**2 - 2 - y, (x, 2 * SIGMA - 1, 2 * SIGMA + 1), 2 * SIGMA, 6),
         {"y": between("0", "1"), "sigma": sp.FiniteSet(-1, 1)}),
    ],
)  # fmt: skip
def test_newton_is_shown_to_converge(root: Root, within: dict[str, sp.Set]) -> None:
    answer = judge(root, **within)
    assert (answer.verdict, answer.rung) == (Verdict.PROVED, newton.RUNG), answer.reason


REFUSED = {
    "too few steps": (
        Root(KEPLER, (E, M - 1, M + 1), START, steps=3),
        {"M": sp.S.Reals, "e": between("0", "0.6")},
        "after 3 Newton steps the error may be",
        "4 are enough there",
    ),
    "a start from which it leaves": (
        Root(INVOLUTE, (x, sp.Rational(1, 20), sp.Rational(7, 5)), sp.Rational(1, 20)),
        {"y": between("0.1", "0.4")},
        "Newton's steps from the start",
        "not shown to approach the root",
    ),
    "two roots": (
        Root(sp.sin(x) - y, (x, 0, 3)),
        {"y": between("0.3", "0.9")},
        "there are 2 roots in the bracket",
        "near",
    ),
    "no root": (
        Root(KEPLER, (E, M + 1, M + 2), M + 1),
        {"M": between("0", "1"), "e": between("0", "0.5")},
        "there is no root in the bracket",
        "at M = ",
    ),
    "a double root": (
        Root((x - y) ** 2, (x, 0, 1)),
        {"y": between("0.3", "0.6")},
        "the derivative may change sign near",
        "at y = ",
    ),
    "a bracket without width": (
        Root(KEPLER, (E, M - e, M + e), M),
        {"M": between("0", "1"), "e": sp.FiniteSet(0)},
        "the bracket has no width",
        "at M = ",
    ),
    "sizes without end": (
        Root(x**3 + x - y, (x, 0, y + 1), y),
        {"y": sp.Interval(0, sp.oo)},
        "y is not bounded",
        "state a closed interval",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_does_not_converge_is_told(case: str) -> None:
    root, within, *told = REFUSED[case]
    answer = judge(root, **within)
    assert answer.verdict in (Verdict.REFUTED, Verdict.UNDECIDED)
    assert all(words in answer.reason for words in told), answer.reason


def test_a_point_refutes_where_newton_leaves() -> None:
    root, within, *_ = REFUSED["a start from which it leaves"]
    answer = judge(root, **within)
    assert answer.verdict is Verdict.REFUTED
    assert answer.evidence


def test_another_root_is_no_bound() -> None:
    """Only the distance of an iterate from its own root is bounded."""
    root = Root(x**2 - 2, (x, 1, 2), steps=6)
    other = Root(x**2 - 3, (x, 1, 2), steps=6)
    distance = sp.Abs(LastIterate.towards(other) - root)
    relation = sp.Le(distance, 1, evaluate=False)
    assert not newton.converges(relation, Domain({}, (), {}))


def test_roots_are_enclosed() -> None:
    root = Root(KEPLER, (E, M - 1, M + 1))
    with mp.workdps(50):
        for mean, size in ((0.3, 0.5), (-40.1, 0.9), (3.14, 0.999), (0.0, 0.2), (2.0, 0.0)):
            ball = balls.evaluate(root, {M: mean, e: size}, 192)
            want = mp.findroot(lambda z, m=mean, s=size: z - s * mp.sin(z) - m, mean + 0.5)
            assert ball.is_finite()
            assert (
                ball.contains(balls.to_ball(sp.Rational(str(want))))
                or abs(mp.mpf(ball.mid().str(45, radius=False)) - want) <= mp.mpf(10) ** -40
            )


@pytest.mark.parametrize(
    "root",
    [Root(sp.sin(x), (x, 1, 7)), Root(x**2 + 1, (x, -2, 2)), Root((x - 1) ** 2, (x, 0, 2))],
)
def test_what_is_not_one_root_has_no_value(root: Root) -> None:
    assert not balls.evaluate(root, {}).is_finite()


def test_derivatives_are_those_of_implicit_functions() -> None:
    root = Root(KEPLER, (E, M - 1, M + 1))
    at = {M: sp.Rational(4, 5), e: sp.Rational(3, 10)}
    step = sp.Rational(1, 10**12)
    moved = root.subs(M, M + step)
    slope = balls.evaluate((moved - root) / step, at, 256)
    assert abs(slope - balls.evaluate(sp.diff(root, M), at, 256)) < 1e-11
    assert root.subs(E, 7) == root


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ((sp.floor(x) - y, (x, 0, 1)), "without floor"),
        ((x - y, (x, 0, x)), "neither bracket nor start"),
        ((y - 1, (x, 0, 1)), "does not contain the unknown x"),
        ((x - y, (x, 0, 1), 0, 99), "steps = 99: must be 1 to 20"),
        ((x - Root(x - y, (x, 0, 1)), (x, 0, 1)), "without"),
        ((sp.Symbol("z") - y, (sp.Symbol("z"), 0, 1)), "must be a real symbol"),
    ],
)
def test_what_is_no_root_is_refused(given: tuple[object, ...], told: str) -> None:
    with pytest.raises(RecordError, match=told):
        Root(*given)
