"""Decimals that are factors, c = 1.41 a: the number to which each was rounded.

What stands beside the decimal is put on the other side, which is a number then.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from mechproof.document.tasks import DECIMAL, Task
from mechproof.proof.domain import Domain
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Equality, PrintedNumber

_OPEN = "the two sides differ, but a decimal may have been rounded"


def judge_factor(task: Task) -> Judgement | str:
    """Judge the one decimal of an equation that is a factor of what is else the same.

    What is no rounding of the recomputed number accuses nobody: more may have been rounded before.
    """
    numbers = [text.replace("{,}", ".") for text in DECIMAL.findall(task.row.printed_latex)]
    if len(numbers) != 1 or not isinstance(task.row.says, Equality):
        return _OPEN
    domain, sides = Domain.of(task.paper, task.row.on), task.sign.sides
    for one, other in (sides, sides[::-1]):
        factor, rest = one.as_coeff_Mul() if isinstance(one, sp.Expr) else (sp.S.Zero, one)
        if abs(factor) != sp.Rational(numbers[0]) or not isinstance(other, sp.Expr):
            continue
        value = sp.cancel(domain.resolve(other) / domain.resolve(rest)) * sp.sign(factor)
        if value.free_symbols or not value.is_finite:
            continue
        found = judge(replace(task.row, says=PrintedNumber(numbers[0], value)), task.paper)
        return found if found.verdict is Verdict.PROVED else f"{_OPEN}: {found.reason}"
    return _OPEN
