"""Arctangents of two arguments by that of one."""

from __future__ import annotations

import sympy as sp

from mechproof.programs.evaluation import Evaluation


def positive_atan2(evaluation: Evaluation) -> Evaluation:
    """Rewrite atan2(y, x) -> atan(y/x); legal where x > 0."""
    found = {node for e in evaluation.expressions() for node in e.atoms(sp.atan2)}
    positive = [sp.Gt(node.args[1], 0) for node in sorted(found, key=sp.default_sort_key)]
    changed = evaluation.transform(lambda e: e.replace(sp.atan2, lambda y, x: sp.atan(y / x)))
    return changed.oblige(positive)
