r"""Several equations in one print, steps between them, cases and conditions in their spellings."""

from __future__ import annotations

import pytest
import sympy as sp

from mechproof.latex import Reader, ReadingError
from mechproof.record import Variable

f, g, t, T = sp.symbols("f g t T", real=True)
READER = Reader([Variable(s, "", latex=(str(s),)) for s in (f, g, t, T)])
ONE, TWO = sp.Eq(f, 2 * t, evaluate=False), sp.Eq(g, t**2, evaluate=False)

ROWS = [
    *(rf"\begin{{{x}}}f=2t\\g=t^2\end{{{x}}}" for x in ("matrix", "aligned", "gathered")),
    *(r"\begin{aligned}f&=2t\\g&=t^2,\end{aligned}", r"\begin{array}{l}f=2t,\\g=t^2\end{array}"),
    *(r"\begin{matrix}f=2t&g=t^2\end{matrix}", r"\begin{matrix}f=2t,&g=t^2\end{matrix}"),
    *(r"f=2t\to g=t^2", r"f=2t\Rightarrow g=t^2", r"f=2t\implies g=t^2"),
]
WITHIN = {sp.Le(0, t), sp.Le(t, T)}
CONDITIONS = [
    *((rf"f=2t{mark}t\in[0,T]", WITHIN) for mark in (",", r",\ ", r"\quad ", r"\text{ for }")),
    (r"f=2t,\ t\in(0,1)", {sp.Lt(0, t), sp.Lt(t, 1)}),
    (r"f=2t,\ t\in(0,T]", {sp.Lt(0, t), sp.Le(t, T)}),
    (r"\begin{matrix}f=2t,\text{if }t<T\\g=t^2,\text{if }t>T\end{matrix}", {sp.Lt(t, T)}),
    (r"\begin{matrix}f=2t\\g=t^2\end{matrix},\ t<=T", {sp.Le(t, T)}),
]
PIECES = sp.Piecewise((t, t < 0), (2 * t, sp.And(t >= 0, t < T, evaluate=False)), evaluate=False)
CASES = [
    r"\begin{cases}t&\text{if }t<0\\2t&\text{if }t\ge0,\ t<T\end{cases}",
    r"\begin{cases}t,&t<0,\\2t,&t\ge0\text{ and }t<T.\end{cases}",
    r"\left\{\begin{array}{ll}t&t<0\\2t&t\ge0,t<T\end{array}\right.",
    r"\begin{Bmatrix}\begin{matrix}t,&\text{if }t<0\\2t,&\text{if }t\ge0,\ t<T"
    r"\end{matrix}\end{Bmatrix}",
    r"\begin{cases}t&\text{if }t<0\\2t&\text{if }t\ge0,\ t<T\\\text{undefined}"
    r"&\text{if }t>T\end{cases}",
]


@pytest.mark.parametrize("latex", ROWS)
def test_each_row_is_an_equation(latex: str) -> None:
    read = READER.parse(latex)
    assert [read.meaning().relate(chain) for chain in read.chains] == [(ONE,), (TWO,)]


@pytest.mark.parametrize(("latex", "relations"), CONDITIONS)
def test_a_condition_is_that_of_its_row(latex: str, relations: set[sp.Basic]) -> None:
    read = READER.parse(latex)
    first, last = read.chains[0], read.chains[-1]
    assert first.condition is not None
    assert set(read.meaning().relate(first.condition)) == relations
    assert (first.condition == last.condition) == ("if" not in latex)


@pytest.mark.parametrize("latex", CASES)
def test_cases_are_read(latex: str) -> None:
    read = READER.parse(f"f={latex}")
    assert read.meaning().of(read.chains[0].members[1]) == PIECES


def test_a_row_may_go_on_with_a_chain() -> None:
    (chain,) = READER.parse(r"\begin{aligned}f&=t\\&=2t\\&=3t\end{aligned}").chains
    assert len(chain.members) == 4


def test_a_value_elsewhere_is_the_last_case() -> None:
    read = READER.parse(r"f=\begin{cases}t&t<0\\0&\text{otherwise}\end{cases}")
    found = read.meaning().of(read.chains[0].members[1])
    assert found == sp.Piecewise((t, t < 0), (0, True), evaluate=False)


REFUSED = [
    (r"t>0\Rightarrow f=1", "no meaning here"),
    (r"f=1,\ t\to 0", "no meaning here"),
    (r"f=\begin{matrix}t=1\end{matrix}", "in an unknown way"),
    (
        r"f=\begin{cases}t&t<0\\0&\text{otherwise}\\1&t>0\end{cases}",
        "after the value for all others",
    ),
    (r"f=\begin{cases}t\\0\end{cases}", "without its condition"),
    (r"f=1,\ t\in\{0,1\}", "sets are not read"),
    (r"f=g\in[0,1]", "in a set"),
    (r"=f", "="),
]


@pytest.mark.parametrize(("latex", "told"), REFUSED)
def test_what_does_not_part_is_refused(latex: str, told: str) -> None:
    with pytest.raises(ReadingError, match=told):
        READER.parse(latex)


def test_an_environment_that_an_arrow_cuts_is_refused() -> None:
    with pytest.raises(ReadingError, match="is continued in an unknown way"):
        READER.parse(r"\begin{array}{l} f=0 \to g=1")
