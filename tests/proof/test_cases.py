"""Piecewise sides, and sides with letters of few values, are proved equal case by case."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
import sympy as sp

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.cases import decide_by_pieces, narrow
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Verdict
from mechproof.record import Equality, Holds, Statement
from mechproof.statement_domains.domain import Domain

x, y, s = (sp.Symbol(name, real=True) for name in "xys")
DOMAIN = Domain({x: sp.Interval(-3, 3), y: sp.S.Reals, s: sp.FiniteSet(-1, 1)}, (), {})
PIECES = sp.Piecewise((1 - x, x < 1), ((x - 1) ** 2, True))


@pytest.mark.parametrize(
    ("printed", "rebuilt", "verdict"),
    [
        # Other seams: harmless only where both pieces have the same value.
        (PIECES, sp.Piecewise((1 - x, x <= 1), (x**2 - 2 * x + 1, True)), Verdict.PROVED),
        (PIECES, sp.Piecewise((1 - x, x < 2), ((x - 1) ** 2, True)), Verdict.REFUTED),
        (
            PIECES,
            sp.Piecewise((1 - x, x < 1), ((x - 1) ** 2 + sp.Rational(1, 99), True)),
            Verdict.REFUTED,
        ),
        # Seams at a letter.
        (
            sp.Piecewise((x, x <= y), (y, True)),
            sp.Piecewise((x, x < y), (y, True)),
            Verdict.PROVED,
        ),
        (
            sp.Piecewise((x, x <= 2 * y), (y, True)),
            sp.Piecewise((x, x < 2 * y), (y, True)),
            Verdict.REFUTED,
        ),
        # Each piece equals the other side on its own part only.
        (sp.Piecewise((x, x >= 0), (-x, True)), sp.sqrt(x**2), Verdict.PROVED),
        (sp.Piecewise((x - y, x >= y), (y - x, True)), sp.Abs(x - y), Verdict.PROVED),
        (sp.Piecewise((x, x >= 0), (x, True)), sp.sqrt(x**2), Verdict.REFUTED),
        # A piece outside the domain.
        (sp.Piecewise((x, x < 5), (y, True)), x, Verdict.PROVED),
        (s**2 * x + 1 / s, x + s, Verdict.PROVED),
        (s**2 * x + 1 / s, x - s, Verdict.REFUTED),
        (sp.Sum(x**y, (y, 1, 3)), x**3 + x**2 + x, Verdict.PROVED),
    ],
)
def test_equal_by_cases(printed: sp.Expr, rebuilt: sp.Expr, verdict: Verdict) -> None:
    assert decide(Equality(printed, rebuilt), DOMAIN).verdict is verdict


@pytest.mark.parametrize(
    ("statement", "verdict"),
    [
        (Holds(sp.Abs(x + y) <= sp.Abs(x) + sp.Abs(y)), Verdict.PROVED),
        (Holds(sp.Abs(x + y) <= sp.Abs(x) + sp.Abs(y) / 2), Verdict.REFUTED),
        (Holds(sp.Abs(x) + sp.Abs(y) >= x - y), Verdict.PROVED),
        (Holds(sp.Abs(x) - sp.Abs(y) >= x - y), Verdict.REFUTED),
        (Equality(sp.Max(x, y), (x + y + sp.Abs(x - y)) / 2), Verdict.PROVED),
        (Equality(sp.Max(x, y), (x + y - sp.Abs(x - y)) / 2), Verdict.REFUTED),
        (Equality(sp.Min(x, y), (x + y - sp.Abs(x - y)) / 2), Verdict.PROVED),
        (Equality(sp.Min(x, y), (x + y + sp.Abs(x - y)) / 2), Verdict.REFUTED),
        (Equality(sp.Max(x, y) + sp.Min(x, y), x + y), Verdict.PROVED),
        (Equality(sp.Max(x, y) - sp.Min(x, y), x - y), Verdict.REFUTED),
    ],
)
def test_moduli_and_the_largest_by_cases(statement: Statement, verdict: Verdict) -> None:
    assert decide(statement, DOMAIN).verdict is verdict


@pytest.mark.parametrize(
    ("apart", "verdict"), [((), Verdict.REFUTED), ((sp.Ne(2 * x, 2 * y),), Verdict.PROVED)]
)
def test_a_seam_counts_unless_the_domain_leaves_it_out(
    apart: tuple[sp.Basic, ...], verdict: Verdict
) -> None:
    sides = (sp.Piecewise((0, x < y), (1, True)), sp.Piecewise((0, x <= y), (1, True)))
    domain = replace(DOMAIN, where=apart, within={x: sp.S.Reals, y: sp.S.Reals})
    assert decide(Equality(*sides), domain).verdict is verdict
    at_one = (side.subs(y, 1) for side in sides)
    there = replace(domain, where=tuple(r.subs(y, 1) for r in apart))
    assert decide(Equality(*at_one), there).verdict is verdict


@pytest.mark.parametrize(
    "bind",
    [
        lambda piece: sp.Integral(piece, (x, -1, 1)),
        lambda piece: sp.Integral(piece, (x, 0, x)),
        lambda piece: sp.Sum(piece, (x, 1, 3)),
        lambda piece: sp.Limit(piece, x, 0),
    ],
)
def test_a_condition_on_a_bound_symbol_makes_no_cases(
    bind: Callable[[sp.Expr], sp.Expr],
) -> None:
    """The bound symbol is not the free x of the same name next to it."""
    piece = sp.Piecewise((1, x > 0), (0, True))
    assert decide_by_pieces((piece, x), DOMAIN, lambda *_: "any") == "case by case, any"
    assert decide_by_pieces((x + bind(piece), piece), DOMAIN, lambda *_: "any") is None


def test_the_part_of_a_condition() -> None:
    def part(relation: sp.Basic) -> sp.Set | None:
        narrowed = narrow(DOMAIN, relation)
        return narrowed and narrowed.within[x]

    assert part(x < 1) == sp.Interval.Ropen(-3, 1)
    assert part(sp.pi * x >= 1) == sp.Interval(1 / sp.pi, 3)
    assert part(x > 4) is None
    assert narrow(DOMAIN, x < y) == replace(DOMAIN, where=(x < y,))


@pytest.mark.parametrize(
    ("latex", "true", "wrong"),
    [
        (r"\sgn(xy)=%s", r"\sgn(x)\sgn(y)", r"\sgn(x)+\sgn(y)"),
        (r"\sgn(xyz)=%s", r"\sgn(x)\sgn(y)\sgn(z)", r"\sgn(x)\sgn(y)"),
        (r"\sgn(x)=\begin{cases}1&x>0\\%s&x=0\\-1&x<0\end{cases}", "0", "1"),
        (r"x^2-2x=\begin{cases}x^2-2x&x\ne3\\%s&x=3\end{cases}", "3", "4"),
        (r"\max(x,y)=\begin{cases}x&x>y\\%s&x=y\\y&x<y\end{cases}", "y", "x+1"),
        (r"\sgn(x)=\begin{cases}1&x>0\\0&x=%s\\-1&x<0\end{cases}", "0", "1"),
    ],
)
def test_signs_and_single_values_are_taken_case_by_case(latex: str, true: str, wrong: str) -> None:
    for value, is_true in ((true, True), (wrong, False)):
        printed = (latex % value).replace(r"\sgn", r"\operatorname{sgn}")
        (found,) = judge_pasted(Pasted(printed)).judgements
        assert (found.verdict is Verdict.PROVED) is is_true
