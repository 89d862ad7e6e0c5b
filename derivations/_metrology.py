"""Common to papers with measurements: type A evaluation, normal laws, coverage."""

import sympy as sp

from mechproof.record import Claim, Equality, Variable, ours

POSITIVE = sp.Interval.open(0, sp.oo)

# Type A evaluation (GUM 4.2) --------------------------------------------------------------------

n = sp.Symbol("n", integer=True, positive=True)
q = sp.IndexedBase("q", real=True)
qbar, s2, s2_mean, u_mean, sigma2 = sp.symbols("qbar s2 s2_mean u_mean variance", real=True)
i, j, m = sp.symbols("i j m", integer=True)
mean = sp.Sum(q[j], (j, 1, n)) / n
variance = sp.Sum((q[i] - qbar) ** 2, (i, 1, n)) / (n - 1)

TYPE_A_VARIABLES = (
    Variable(n, "number of observations", within=sp.S.Naturals, latex=("n",)),
    Variable(q, "measurement errors", latex=("q",)),
    Variable(qbar, "mean measurement error", latex=(r"\bar q",)),
    Variable(s2, "sample variance", latex=("s^2(q_k)",)),
    Variable(s2_mean, "estimate of the variance of the mean", latex=("s^2(q)", r"s^2(\bar q)")),
    Variable(u_mean, "type A standard uncertainty", latex=("u(q)",)),
    Variable(sigma2, "variance of one observation", within=POSITIVE),
)


def expected_squares() -> sp.Expr:
    """Return the expected sum of (q_k - mean)^2 over independent readings of one variance."""
    deviations = (sp.KroneckerDelta(i, j) - 1 / n) * (sp.KroneckerDelta(i, m) - 1 / n)
    covariance = sigma2 * sp.KroneckerDelta(j, m)
    return sp.Sum(deviations * covariance, (i, 1, n), (j, 1, n), (m, 1, n))


def unbiased_row(number: str) -> Claim:
    """State that the divisor n - 1 leaves no bias; `number` is that of the variance's row."""
    return ours(
        f"{number} is free of bias",
        r"E\,s^2(q_k)=\sigma^2",
        Equality(expected_squares(), (n - 1) * sigma2),
        note="For independent observations of equal variance; this is why the divisor is n - 1.",
        quantities=("standard_deviation",),
    )


def estimate_row(
    number: str,
    marks: tuple[str, ...] = (),
    cites: tuple[str, ...] = (),
    latex: str = r"E\,\frac{s^2(q_k)}n=\mathrm{Var}\,\bar q",
) -> Claim:
    """State that the estimate of the variance of the mean, row `number`, has no bias."""
    return Claim(
        f"{number}, estimate of the variance of the mean",
        latex,
        Equality(
            expected_squares(),
            n * (n - 1) * sp.Sum(sigma2 * sp.KroneckerDelta(i, j) / n**2, (i, 1, n), (j, 1, n)),
        ),
        note="Its expected value is the variance of the mean of independent observations of equal "
        "variance; both sides are multiplied by n (n - 1).",
        marks=marks,
        cites=cites,
    )


# Laws and coverage ------------------------------------------------------------------------------


def normal_between(centre: sp.Expr, variance: sp.Expr, low: sp.Expr, high: sp.Expr) -> sp.Expr:
    """Probability of a normal law between limits."""
    root = sp.sqrt(2 * variance)
    return (sp.erf((high - centre) / root) - sp.erf((low - centre) / root)) / 2


def normal_outside(centre: sp.Expr, variance: sp.Expr, low: sp.Expr, high: sp.Expr) -> sp.Expr:
    """Probability of a normal law outside limits, from its two tails."""
    root = sp.sqrt(2 * variance)
    return (sp.erfc((centre - low) / root) + sp.erfc((high - centre) / root)) / 2


def student_coverage(count: int, multiple: sp.Expr) -> sp.Expr:
    """Percentage of Student's t with count - 1 degrees of freedom inside -multiple ... multiple."""
    freedom, square = sp.Rational(count - 1), multiple**2
    return 100 * sp.betainc_regularized(sp.S.Half, freedom / 2, 0, square / (square + freedom))
