"""Arguments of the kernels of paper 4, and how their accuracy is conditioned."""

from collections.abc import Iterable

import sympy as sp
from sympy import Abs, Eq, cos

from mechproof.record import LENGTH, Accuracy, Argument, Scale, Singular, Variable

from ..._algebra import EPS, POWER, is_moderate, is_zero_or_moderate
from ..mechanics import *
from .chain import MEANT, SIZES, chain_slope

# Arguments -------------------------------------------------------------------------------------

turns = sp.Symbol("m_turns", integer=True)
ANGLES = {
    alpha_DE: MEANING[alpha_DE],
    alpha_KL: "direction of KL at x1 = 0, in (0, pi)",
    alpha_LM: MEANING[alpha_LM],
}
ARGUMENT = {
    x1: Argument("x1", (x1,), MEANING[x1], "mm", usual=(0, 1, 10, 20, 40)),
    **{
        size: Argument(str(size), (size,), MEANING[size], "mm")
        for size in SIZES
        if size not in ANGLES
    },
    **{angle: Argument(str(angle), (angle,), meaning, "rad") for angle, meaning in ANGLES.items()},
}


def arguments(*symbols: sp.Symbol) -> tuple[Argument, ...]:
    """Return the arguments of a kernel, the running variable first."""
    return tuple(ARGUMENT[symbol] for symbol in symbols)


# Domains and singular sets ---------------------------------------------------------------------

SHORT_GUIDE = "NaN where guide_radicand is negative"
AT_REST = Singular(Eq(x1, 0))
PIVOT = Singular(Eq(x1, -(l_AB + l_CD)))
# Accuracy --------------------------------------------------------------------------------------

# In eps, 1/2 for an operation, 1 for a sine or cosine, 4 for atan (what NumPy's vector loops are
# allowed). An error of a term of a sum equals one of the inputs of that term, which is in the
# scale; a common factor of the lengths absorbs the rounding of a sum itself.

CONDITION = "|value| + sum of |p * d value/d p| over the arguments p"


def condition(value: sp.Expr, inputs: Iterable[sp.Symbol], *, tidy: bool = True) -> sp.Expr:
    """Return the value's size plus the effect of the rounding of every input on it, in contact."""
    parts = (value, *(s * chain_slope(value, s) for s in inputs))
    return sp.Add(*(Abs(part, evaluate=tidy) for part in parts))


def conditioned(
    ulp: float, value: sp.Expr, inputs: Iterable[sp.Symbol], within: tuple[sp.Basic, ...] = ()
) -> Accuracy:
    """Bound the error by the conditioning of a value."""
    return Accuracy(ulp, Scale(CONDITION, condition(value, inputs)), within)


# At the clearance's edge a derivative jumps; where the guide or the roller lever can just follow,
# it has a pole, and beyond there is NaN. On which side the inputs are is certain from EDGE_ULP eps
# onwards: the run of the rod, both squares and l_KL + KL_x are computed with less than a third of
# that, and a pole like 1/sqrt makes no more than 1.4 times the first order of it.
EDGE_ULP = 16
OF_RUN = (x1, l_AB, l_BC, l_CD, l_DE, alpha_DE)
EDGES = {
    "run_condition": (MEANT.travel, OF_RUN, LENGTH),
    "guide_condition": (radicand, (x1, l_AB, l_BC, l_CD), LENGTH**2),
    "height_condition": (l_KL**2 - PRINTED_R**2, (x5, l_KL, alpha_KL), LENGTH**2),
    "roller_condition": (
        l_KL * (1 + cos(alpha_KL)) - (MEANT.travel - l_GH),
        (*OF_RUN, l_GH, l_KL, alpha_KL),
        LENGTH,
    ),
}
SIDES = {name: sp.Symbol(name, real=True) for name in EDGES}
VARIABLES = tuple(
    Variable(SIDES[name], "conditioning of an edge", dimension, given=condition(value, inputs))
    for name, (value, inputs, dimension) in EDGES.items()
)


def beside(gap: sp.Expr, name: str) -> sp.Basic:
    """State that a gap from an edge is wider than the error that the kernels make of the inputs."""
    return gap > EDGE_ULP * EPS * SIDES[name]


BEYOND_SQUARES = (
    f"lengths and displacements are squared: of sizes beyond 1e-{POWER} to 1e{POWER} squares may "
    "leave the range of doubles, and the result is NaN, 0 where it should not be, or another wrong "
    "number"
)


def moderate(displacement: sp.Symbol, *lengths: sp.Symbol) -> tuple[sp.Basic, ...]:
    """State that lengths, and a displacement that is not zero, are neither vast nor tiny."""
    return is_zero_or_moderate(displacement), *map(is_moderate, lengths)


CLOSING = beside(guide_square, "guide_condition")
CONDITIONING = "the conditioning |value| + sum of |p * d value/d p|"
OF_GUIDE = "guide_condition of guide_square = guide_radicand"
