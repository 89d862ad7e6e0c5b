"""Type A evaluation of readings by the GUM: the experimental standard deviation of one reading."""

from sympy import Sum, sqrt

from mechproof.record import Accuracy, Argument, Equality, Equation, Paper, Quantity, ours

from .._metrology import (
    TYPE_A_VARIABLES,
    estimate_row,
    i,
    m,
    mean,
    n,
    q,
    qbar,
    s2,
    s2_mean,
    u_mean,
    unbiased_row,
    variance,
)

VARIANCE = variance.subs(qbar, mean)
ONE_PASS = (Sum(q[i] ** 2, (i, 1, n)) - Sum(q[i], (i, 1, n)) ** 2 / n) / (n - 1)
CORRECTION = Sum(q[m] - mean, (m, 1, n)) / n
CENTRED_TWICE = Sum((q[i] - mean - CORRECTION) ** 2, (i, 1, n)) / (n - 1)

ROWS = (
    Equation("4.2.1, equation (3)", r"\bar q=\frac1n\sum_{k=1}^n q_k", defines=(qbar,)),
    Equation(
        "4.2.2, equation (4)",
        r"s^2(q_k)=\frac1{n-1}\sum_{k=1}^n(q_k-\bar q)^2",
        note="Needs n >= 2.",
        defines=(s2,),
    ),
    unbiased_row("4.2.2, equation (4)"),
    Equation("4.2.3, equation (5)", r"s^2(\bar q)=\frac{s^2(q_k)}{n}", defines=(s2_mean,)),
    estimate_row("4.2.3, equation (5)"),
    Equation(
        "4.2.3",
        r"u(q)=\sqrt{s^2(q)}",
        note="The type A standard uncertainty of the mean.",
        defines=(u_mean,),
    ),
    ours(
        "4.2.2, one pass",
        r"\sum(q_k-\bar q)^2=\sum q_k^2-\frac1n\left(\sum q_k\right)^2",
        Equality(ONE_PASS, VARIANCE),
        note="Rounded, two nearly equal sums are subtracted.",
        quantities=("standard_deviation",),
    ),
    ours(
        "4.2.2, centred twice",
        r"\sum(q_k-\bar q)^2=\sum(q_k-\bar q-c)^2,\ c=\frac1n\sum(q_k-\bar q)",
        Equality(CENTRED_TWICE, VARIANCE),
        note="Exactly, c is 0; rounded, it takes the error of the mean out.",
        quantities=("standard_deviation",),
    ),
)

CALL = """\
from mechproof.measurement import evaluate_type_a

evaluate_type_a(readings).standard_deviation"""

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
            call=CALL,
        ),
    ),
)
