"""What paper 1 prints of the evaluation of readings: (13) to (16)."""

from .._metrology import (
    estimate_row,
    mean_row,
    unbiased_row,
    uncertainty_row,
    variance_of_mean_row,
    variance_row,
)

TYPE_A_EQUATIONS = EQUATION_13, EQUATION_14, EQUATION_15, EQUATION_16 = (
    mean_row("(13)", "The mean of the readings; a definition."),
    variance_row("(14)"),
    variance_of_mean_row("(15)", r"s^2(q)=\frac{s^2(q_k)}{n}"),
    uncertainty_row("(16)", "The GUM's type A standard uncertainty of the mean."),
)
TYPE_A_ROWS = (
    EQUATION_13,
    EQUATION_14,
    unbiased_row("(14)"),
    EQUATION_15,
    estimate_row("(15)"),
    EQUATION_16,
)
