"""What paper 1 prints of the evaluation of readings: (13) to (16)."""

from .._metrology import estimate_row, qbar, s2, s2_mean, u_mean, unbiased_row
from .symbols import PRINT

TYPE_A_EQUATIONS = EQUATION_13, EQUATION_14, EQUATION_15, EQUATION_16 = (
    PRINT.equation("(13)", defines=(qbar,), note="The mean of the readings; a definition."),
    PRINT.equation("(14)", defines=(s2,), note="Needs n >= 2."),
    PRINT.equation("(15)", defines=(s2_mean,)),
    PRINT.equation(
        "(16)", defines=(u_mean,), note="The GUM's type A standard uncertainty of the mean."
    ),
)
TYPE_A_ROWS = (
    EQUATION_13,
    EQUATION_14,
    unbiased_row("(14)"),
    EQUATION_15,
    estimate_row("(15)"),
    EQUATION_16,
)
