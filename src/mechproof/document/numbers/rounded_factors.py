"""Decimals that are factors, c = 1.41 a: the number that was rounded to each.

What stands beside the decimal is put on the other side, which is a number then.
"""

from __future__ import annotations

import re
from dataclasses import replace

import sympy as sp

from mechproof.document.tasks import Task
from mechproof.nomenclature.cells import Numeral
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Equality, PrintedNumber
from mechproof.statement_domains.domain import Domain

_DECIMAL = re.compile(r"\d\s*(?:\.|\{,\})\s*\d")
_OPEN = "the two sides differ, but a decimal may have been rounded"


def judge_factor(task: Task) -> Judgement | str:
    """Judge the one decimal of an equation that is a factor, where both sides agree otherwise.

    What is no rounding of the recomputed number accuses nobody where more may have been rounded:
    another decimal, or one in what defines letters.
    """
    number, sides = task.sign.factor, task.sign.sides
    if not (number and isinstance(task.row.says, Equality)):
        return _OPEN
    domain = Domain.of(task.paper, task.row.on)
    for one, other in (sides, sides[::-1]):
        factor, rest = one.as_coeff_Mul() if isinstance(one, sp.Expr) else (sp.S.Zero, one)
        if abs(factor) != sp.Rational(number) or not isinstance(other, sp.Expr):
            continue
        value = sp.cancel(domain.resolve(other) / domain.resolve(rest)) * sp.sign(factor)
        if value.free_symbols or not value.is_finite:
            continue
        found = judge(replace(task.row, says=PrintedNumber(number, value)), task.paper)
        is_alone = len(_DECIMAL.findall(task.row.printed_latex)) == 1
        is_exact = is_alone and not sp.cancel(other / rest).free_symbols
        is_told = found.verdict is Verdict.PROVED or (is_exact and is_far(number, value))
        return found if is_told else f"{_OPEN}: {found.reason}"
    return _OPEN


def is_far(number: str, value: sp.Expr) -> bool:
    """Return whether a number is off by more than its last digit, which may be rounded up."""
    last = 2 * Numeral(number, sp.S.One).half_place
    return bool(abs(abs(value) - abs(sp.Rational(number))) > last)
