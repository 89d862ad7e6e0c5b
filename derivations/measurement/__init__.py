"""Type A evaluation of readings by the GUM: the experimental standard deviation of one reading."""

from sympy import Sum, sqrt

from mechproof.record import (
    Accuracy,
    Argument,
    Claim,
    Equality,
    Paper,
    Quantity,
)

from .._metrology import (
    TYPE_A_VARIABLES,
    estimate_row,
    i,
    m,
    mean,
    mean_row,
    n,
    q,
    qbar,
    unbiased_row,
    uncertainty_row,
    variance,
    variance_of_mean_row,
    variance_row,
)

VARIANCE = variance.subs(qbar, mean)
ONE_PASS = (Sum(q[i] ** 2, (i, 1, n)) - Sum(q[i], (i, 1, n)) ** 2 / n) / (n - 1)
CORRECTION = Sum(q[m] - mean, (m, 1, n)) / n
CENTRED_TWICE = Sum((q[i] - mean - CORRECTION) ** 2, (i, 1, n)) / (n - 1)

ROWS = (
    mean_row("4.2.1, equation (3)"),
    variance_row("4.2.2, equation (4)"),
    unbiased_row("4.2.2, equation (4)"),
    variance_of_mean_row("4.2.3, equation (5)", r"s^2(\bar q)=\frac{s^2(q_k)}{n}"),
    estimate_row("4.2.3, equation (5)"),
    uncertainty_row("4.2.3", "The type A standard uncertainty of the mean."),
    Claim(
        "4.2.2, one pass",
        r"\sum(q_k-\bar q)^2=\sum q_k^2-\frac1n\left(\sum q_k\right)^2",
        Equality(ONE_PASS, VARIANCE),
        note="Rounded, two nearly equal sums are subtracted.",
        marks=("ours",),
    ),
    Claim(
        "4.2.2, centred twice",
        r"\sum(q_k-\bar q)^2=\sum(q_k-\bar q-c)^2,\ c=\frac1n\sum(q_k-\bar q)",
        Equality(CENTRED_TWICE, VARIANCE),
        note="Exactly, c is 0; rounded, it takes the error of the mean out.",
        marks=("ours",),
    ),
)

PAPER = Paper(
    system="measurement",
    citation="GUM (JCGM 100), 4.2",
    variables=TYPE_A_VARIABLES,
    rows=ROWS,
    quantities=(
        Quantity(
            "standard_deviation",
            "Compute the experimental standard deviation of a single reading.",
            (Argument("readings", (q,), "readings of one quantity"),),
            sqrt(VARIANCE),
            (),
            "GUM 4.2.2",
            accuracy=Accuracy(16),
        ),
    ),
)
