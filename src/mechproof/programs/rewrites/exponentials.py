"""Exponentials near 1 and logarithms of what is near 1, without the digits that cancel there.

See Higham (2002, section 1.14.1) for what a difference from 1 loses, however exact the exponential.
"""

from __future__ import annotations

from sympy.codegen.rewriting import expm1_opt, log1p_opt, optimize

from mechproof.programs.evaluation import Evaluation


def expm1_log1p(evaluation: Evaluation) -> Evaluation:
    """Rewrite exp(u) - 1 -> expm1(u) and log(1 + u) -> log1p(u). Always legal."""
    return evaluation.transform(lambda e: optimize(e, (expm1_opt, log1p_opt)))
