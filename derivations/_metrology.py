"""What papers that measure share: type A evaluation, normal laws, coverage, an encoder's data."""

from collections.abc import Callable

from sympy import (
    Expr,
    IndexedBase,
    Interval,
    KroneckerDelta,
    Rational,
    S,
    Sum,
    Symbol,
    betainc_regularized,
    erf,
    erfc,
    oo,
    sqrt,
    symbols,
)

from mechproof.record import (
    LENGTH,
    Claim,
    Completion,
    Completions,
    Definition,
    Equality,
    Equation,
    PrintedNumber,
    Statement,
    Variable,
)

POSITIVE = Interval.open(0, oo)

# Type A evaluation (GUM 4.2) --------------------------------------------------------------------

n = Symbol("n", integer=True, positive=True)
q = IndexedBase("q", real=True)
qbar, s2, s2_mean, u_mean, sigma2 = symbols("qbar s2 s2_mean u_mean sigma2", real=True)
i, j, m = symbols("i j m", integer=True)
mean = Sum(q[j], (j, 1, n)) / n
variance = Sum((q[i] - qbar) ** 2, (i, 1, n)) / (n - 1)

TYPE_A_VARIABLES = (
    Variable(n, "number of observations", within=S.Naturals, latex=("n",)),
    Variable(q, "measurement errors", latex=("q",)),
    Variable(qbar, "mean measurement error", latex=(r"\bar q",)),
    Variable(s2, "sample variance", latex=("s^2(q_k)",)),
    Variable(s2_mean, "estimate of the variance of the mean", latex=("s^2(q)", r"s^2(\bar q)")),
    Variable(u_mean, "type A standard uncertainty", latex=("u(q)",)),
    Variable(sigma2, "variance of one observation", within=POSITIVE),
)


def mean_row(number: str, note: str = "", marks: tuple[str, ...] = ()) -> Equation:
    """Introduce the mean of the readings."""
    return Equation(
        number,
        r"\bar q=\frac1n\sum_{k=1}^n q_k",
        note=note,
        defines=(qbar,),
        marks=marks,
    )


def variance_row(number: str, marks: tuple[str, ...] = ()) -> Equation:
    """Introduce the experimental variance of one reading."""
    return Equation(
        number,
        r"s^2(q_k)=\frac1{n-1}\sum_{k=1}^n(q_k-\bar q)^2",
        note="Needs n >= 2.",
        defines=(s2,),
        marks=marks,
    )


def unbiased_row(number: str) -> Claim:
    """State that the divisor n - 1 leaves no bias; `number` is that of the variance."""
    deviations = (KroneckerDelta(i, j) - 1 / n) * (KroneckerDelta(i, m) - 1 / n)
    covariance = sigma2 * KroneckerDelta(j, m)
    return Claim(
        f"{number} is free of bias",
        r"E\,s^2(q_k)=\sigma^2",
        Equality(
            Sum(deviations * covariance, (i, 1, n), (j, 1, n), (m, 1, n)),
            (n - 1) * sigma2,
        ),
        note="For independent observations of one variance; the reason for n - 1.",
        marks=("ours",),
    )


def variance_of_mean_row(number: str, latex: str, marks: tuple[str, ...] = ()) -> Equation:
    """State the variance of the mean; `latex` is the equation as printed."""
    return Equation(
        number,
        latex,
        note="The variance of the mean of n independent observations of the variance sigma^2.",
        derived={s2_mean: Sum(sigma2 * KroneckerDelta(i, j) / n**2, (i, 1, n), (j, 1, n))},
        substituted={s2: sigma2},
        marks=marks,
    )


def uncertainty_row(number: str, note: str, marks: tuple[str, ...] = ()) -> Equation:
    """Introduce the standard uncertainty of the mean."""
    return Equation(
        number,
        r"u(q)=\sqrt{s^2(q)}",
        note=note,
        defines=(u_mean,),
        marks=marks,
    )


# Laws and coverage ------------------------------------------------------------------------------


def normal_between(centre: Expr, variance: Expr, low: Expr, high: Expr) -> Expr:
    """Probability of a normal law between limits."""
    root = sqrt(2 * variance)
    return (erf((high - centre) / root) - erf((low - centre) / root)) / 2


def normal_outside(centre: Expr, variance: Expr, low: Expr, high: Expr) -> Expr:
    """Probability of a normal law outside limits, from its two tails."""
    root = sqrt(2 * variance)
    return (erfc((centre - low) / root) + erfc((high - centre) / root)) / 2


def student_coverage(count: int) -> Expr:
    """Percentage of Student's t with count - 1 degrees of freedom inside -2 ... 2."""
    freedom = Rational(count - 1)
    return 100 * betainc_regularized(S.Half, freedom / 2, 0, 4 / (4 + freedom))


def coverage_row(variant: int, count: int, note: str, marks: tuple[str, ...] = ()) -> Claim:
    """Recompute the level of the factor 2 for `count` readings of one variant."""
    return Claim(
        f"95 %, variant {variant}",
        rf"\text{{the 95 \% interval is }}\bar q\pm 2u,\ n={count}",
        PrintedNumber("95", student_coverage(count)),
        note=note,
        marks=marks,
    )


# The encoder of both test rigs ------------------------------------------------------------------

RESOLUTION = Rational(360, 4096)
FULL_SCALE_LINEARITY = Rational("0.003") * 360
READING_LINEARITY = Rational("0.003") * 90
read_time, output, diameter, millimetre = symbols("t_read V_out d_encoder mm", positive=True)

ENCODER_VARIABLES = (
    Variable(read_time, "read time of the encoder, s", within=POSITIVE),
    Variable(output, "output range of the encoder, V", within=POSITIVE),
    Variable(diameter, "diameter of the encoder", LENGTH, POSITIVE),
    Variable(millimetre, "the unit of length", LENGTH, POSITIVE),
)


def resolution_row(table: str, note: str = "", marks: tuple[str, ...] = ()) -> Claim:
    """State the step of a 12-bit encoder."""
    return Claim(
        f"{table}, resolution",
        r"360^\circ/4096\approx0.088^\circ",
        PrintedNumber("0.088", RESOLUTION),
        note=note,
        marks=marks,
    )


def linearity_row(table: str, which: str, below: Callable[[Expr], Statement]) -> Claim:
    """Compare the mean errors, `which`, with the linearity; `below` states that a limit holds."""
    return Claim(
        f"{table}, linearity",
        r"\text{linearity }0.3\,\%",
        Completions(
            "what the linearity of 0.3 % refers to",
            Completion(
                f"0.3 % of the full scale of 360 deg bounds {which}", below(FULL_SCALE_LINEARITY)
            ),
            Completion(f"0.3 % of a reading of 90 deg bounds {which}", below(READING_LINEARITY)),
        ),
        note="Not said of what the percentage is taken; as full scale it is 1.08 deg.",
    )


def encoder_rows(table: str) -> tuple[Claim, ...]:
    """List what else is printed of the encoder; no formula uses it."""
    data = (
        ("read time", r"0.6\text{ ms}", Definition(read_time, Rational("0.0006"))),
        ("output", r"0\dots5\text{ V}", Definition(output, S(5))),
        ("diameter", r"22\text{ mm}", Definition(diameter, 22 * millimetre)),
    )
    return tuple(
        Claim(f"{table}, {what}", latex, says, note="A datum; no formula of the paper uses it.")
        for what, latex, says in data
    )
