"""What is wrong in paper 4, what it costs, and how to see it."""

import sympy as sp

from mechproof.record import Check, Cost, Finding, Weight

from ..mechanics import *
from .boundaries import upright_at, upright_wedge
from .sizes import FIRST_SET, SECOND_SET, limits
from .transfer import SUBSTITUTED

UPRIGHT_RUN = (l_KL * sp.cos(alpha_KL)).xreplace(limits(FIRST_SET, {}))

FINDINGS = (
    Finding(
        SUBSTITUTED,
        "(7) holds for R > 0 and (8) for R < 0, and both divide by R inside the arctangent; the "
        "text at hand has no case for R = 0. There, in the middle of Fig. 4, KL is upright and "
        "y_9(x_1) has no value. Both cases tend to the same limit, so a third case closes the "
        "gap.",
        costs=(
            Cost(
                "x_1 of the gap",
                "mm",
                printed=upright_at(FIRST_SET),
                right=upright_at(SECOND_SET),
                names=("by the first reconstructed set of sizes", "by the second"),
            ),
        ),
        weight=Weight.FORMULA,
        mend="(7) and (8), at R = 0",
        check=Check(
            "R = 0 at x_5' = 60 cos 65° = {0}; y_9 there is 145 (sin 148.48° - sin 123.48°) = {1}.",
            (UPRIGHT_RUN, upright_wedge(FIRST_SET)),
            2,
            "mm",
        ),
    ),
)
