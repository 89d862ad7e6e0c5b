"""Decimals that are factors, c = 1.41 a: the number that was rounded to each.

What stands beside the decimal is put on the other side, which is a number then.
"""

from __future__ import annotations

import re
from dataclasses import replace

import sympy as sp

from mechproof.document.tasks import DECIMAL, Task
from mechproof.proof.domain import Domain
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Equality, PrintedNumber

_RELATION = re.compile(r"=|\\approx(?![a-z])|\\equiv(?![a-z])")
_SUM = re.compile(r"[+-]|\\pm|\\mp")
_INNERMOST = re.compile(r"\{[^{}()\[\]]*\}|\([^{}()\[\]]*\)|\[[^{}()\[\]]*\]")
_OPEN = "the two sides differ, but a decimal may have been rounded"


def judge_factor(task: Task) -> Judgement | str:
    """Judge the one decimal of an equation that is a factor, where both sides agree otherwise.

    What is no rounding of the recomputed number accuses nobody: more may have been rounded before.
    """
    latex = task.row.printed_latex
    printed = [found for found in DECIMAL.finditer(latex) if _is_factor(latex, found)]
    if len(DECIMAL.findall(latex)) != 1 or not printed or not isinstance(task.row.says, Equality):
        return _OPEN
    number = printed[0][0].replace("{,}", ".")
    domain, sides = Domain.of(task.paper, task.row.on), task.sign.sides
    for one, other in (sides, sides[::-1]):
        factor, rest = one.as_coeff_Mul() if isinstance(one, sp.Expr) else (sp.S.Zero, one)
        if abs(factor) != sp.Rational(number) or not isinstance(other, sp.Expr):
            continue
        value = sp.cancel(domain.resolve(other) / domain.resolve(rest)) * sp.sign(factor)
        if value.free_symbols or not value.is_finite:
            continue
        found = judge(replace(task.row, says=PrintedNumber(number, value)), task.paper)
        return found if found.verdict is Verdict.PROVED else f"{_OPEN}: {found.reason}"
    return _OPEN


def _is_factor(latex: str, found: re.Match[str]) -> bool:
    """Return whether a number stands in no brace, bracket or power, on a side that is no sum."""
    before = latex[: found.start()]
    is_inside = any(before.count(a) != before.count(b) for a, b in ("{}", "()", "[]"))
    if is_inside or before.rstrip().endswith(("^", "_")):
        return False
    side = next(part for part in _list_sides(latex) if part[0] <= found.start() < part[1])
    return not _SUM.search(_hide_inside(latex[side[0] : side[1]].strip().lstrip("+-")))


def _list_sides(latex: str) -> list[tuple[int, int]]:
    """Return where the sides between relation signs begin and end."""
    signs = [0, *(place for sign in _RELATION.finditer(latex) for place in sign.span()), len(latex)]
    return list(zip(signs[::2], signs[1::2], strict=True))


def _hide_inside(text: str) -> str:
    """Leave out what stands in braces and brackets."""
    while (shorter := _INNERMOST.sub("", text)) != text:
        text = shorter
    return text
