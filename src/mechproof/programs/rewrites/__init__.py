"""Rewrites: in, an evaluation; out, one with the same exact value that computes better.

Every rewrite is exact, or off by less than a rounding, where it is legal. If that is not
everywhere, it creates obligations: the relations under which it is legal, and the steps it only
encloses, go along with the evaluation and become rows of the ledger. A form names its rewrites,
which `REWRITES` looks up. A person chooses them, or `improvement` does, which tries them in the
order of the table.

Herbie (Panchekha et al. 2015) rewrites by rules between patterns, in a graph of equal expressions
like egg's (Willsey et al. 2021), and measures the gain at sample points; its rules need not hold
wherever both sides have values. Here a rewrite is a program with obligations, and these are proved.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from mechproof.programs.evaluation import Evaluation
from mechproof.programs.rewrites.clenshaw import clenshaw, in_single
from mechproof.programs.rewrites.coefficients import name_coefficients
from mechproof.programs.rewrites.differences import (
    conjugate_root,
    difference_of_functions,
    difference_of_roots,
    difference_of_squares,
    expm1_log1p,
    hypotenuse,
)
from mechproof.programs.rewrites.half_angle import (
    cosine_minus_one,
    half_angle_tangent,
    low_product,
    low_sum,
    low_word,
    positive_atan2,
    quotient_arc,
    small_arc,
)
from mechproof.programs.rewrites.taylor import taylor

__all__ = ["REWRITES", "apply_rewrites"]

Rewrite = Callable[[Evaluation], Evaluation]

REWRITES: Mapping[str, Rewrite] = MappingProxyType(
    {
        function.__name__: function
        for function in (
            name_coefficients,
            positive_atan2,
            difference_of_functions,
            low_word,
            low_sum,
            low_product,
            half_angle_tangent,
            small_arc,
            quotient_arc,
            cosine_minus_one,
            hypotenuse,
            conjugate_root,
            difference_of_roots,
            difference_of_squares,
            expm1_log1p,
            taylor,
            clenshaw,
            in_single,
        )
    }
)


def apply_rewrites(evaluation: Evaluation, names: tuple[str, ...]) -> Evaluation:
    """Apply the named rewrites in order; ValueError for a name that is not in `REWRITES`."""
    for name in names:
        if name not in REWRITES:
            raise ValueError(f"rewrite {name!r} is not one of {sorted(REWRITES)}")
        evaluation = REWRITES[name](evaluation)
    return evaluation
