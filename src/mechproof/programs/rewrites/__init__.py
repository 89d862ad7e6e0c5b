"""Rewrites: in, an evaluation; out, one with the same exact value that computes better.

Every rewrite is exact where it is legal, or to less than a rounding. Where that is not everywhere
it obliges the prover: the relations under which it is legal, and what it encloses, go along with
the evaluation and are rows of the ledger. A form names its rewrites; `REWRITES` resolves the names.
A person names them, or `improvement` finds them, which tries them in the order of the table.

Herbie (Panchekha et al. 2015) rewrites by rules between patterns, in a graph of equal expressions
as that of egg (Willsey et al. 2021), and tells by points what was gained; a rule need not hold
wherever both of its sides have values. Here a rewrite is a program with what it obliges, and that
is proved.
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
    low_word,
    positive_atan2,
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
            low_product,
            half_angle_tangent,
            small_arc,
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
    """Apply the named rewrites in order; ValueError names one that the table does not have."""
    for name in names:
        if name not in REWRITES:
            raise ValueError(f"rewrite {name!r} is not one of {sorted(REWRITES)}")
        evaluation = REWRITES[name](evaluation)
    return evaluation
