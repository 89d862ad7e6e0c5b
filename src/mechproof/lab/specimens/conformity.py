"""Shares of wrongly accepted and rejected parts: simulation, Owen's T, quadrature.

The definitions integrate over the finite window: the density of the true deviation times the
probability to be accepted or rejected, or the density of what is measured times the probability
not to conform given that; the fourth share is what remains of the parts that do not conform.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from importlib.util import find_spec

import numpy as np
import sympy as sp

from mechproof.conformity import Normal, shares, simulate_shares
from mechproof.lab.specimen import Array, Specimen
from mechproof.lab.specimens import conformity_points as points
from mechproof.lab.subject import Study, Table
from mechproof.record import LENGTH, Argument, Bar, Form, Paper, Quantity, Variable

EPS = float(np.finfo(float).eps)
SEED = 20221
mu, bias, low, high, m = sp.symbols("mu b L U m", real=True)
sigma, s = sp.symbols("sigma s", positive=True)
SYMBOLS = (mu, sigma, bias, s, low, high)
MEANINGS = {
    mu: "mean of the true deviation",
    sigma: "standard deviation of the true deviation",
    bias: "mean of the measurement error",
    s: "standard deviation of the measurement error",
    low: "lower limit of tolerance and acceptance",
    high: "upper limit of tolerance and acceptance",
}
NAMES = ("mean", "true_std", "bias", "error_std", "low", "high")


def outside(mean: sp.Expr, variance: sp.Expr) -> sp.Expr:
    """Probability of a normal law outside the limits, from its two tails."""
    root = sp.sqrt(2 * variance)
    return (sp.erfc((mean - low) / root) + sp.erfc((high - mean) / root)) / 2


def beyond(at: sp.Expr) -> sp.Expr:
    """How far a mean lies outside the limits, 0 inside."""
    return sp.Max(0, low - at, at - high)


def within(at: sp.Expr) -> sp.Expr:
    """How far a mean lies inside the limits, 0 outside."""
    return sp.Max(0, sp.Min(at - low, high - at))


def inside(mean: sp.Expr, variance: sp.Expr) -> sp.Expr:
    """Probability of a normal law between the limits."""
    root = sp.sqrt(2 * variance)
    return (sp.erf((high - mean) / root) - sp.erf((low - mean) / root)) / 2


VARIANCE = sigma**2 + s**2
GIVEN_MEAN = mu + sigma**2 / VARIANCE * (m - mu - bias)
GIVEN = GIVEN_MEAN, sigma**2 * s**2 / VARIANCE


def over_window(
    centre: sp.Expr, variance: sp.Expr, chance: sp.Expr, distances: tuple[sp.Expr, sp.Expr]
) -> sp.Expr:
    """Integrate a normal density times a probability over the window.

    A ball integral has an absolute tolerance: exp(-exponent), which no share of parts at these
    distances of Y and of M from their means exceeds, is taken out.
    """
    (true, measured), z = distances, m - centre
    exponent = sp.Max(true**2 / sigma**2, measured**2 / VARIANCE) / 2
    scaled = sp.exp(exponent - z**2 / (2 * variance)) / sp.sqrt(2 * sp.pi * variance)
    return sp.exp(-exponent) * sp.Integral(scaled * chance, (m, low, high))


MEASURED = mu + bias
ACCEPTED = over_window(MEASURED, VARIANCE, outside(*GIVEN), (within(mu), beyond(MEASURED)))
REJECTED = over_window(mu, sigma**2, outside(m + bias, s**2), (beyond(mu), within(MEASURED)))
DEFINITIONS = {
    "rightly_accepted": over_window(
        mu, sigma**2, inside(m + bias, s**2), (beyond(mu), beyond(MEASURED))
    ),
    "wrongly_accepted": ACCEPTED,
    "rightly_rejected": outside(mu, sigma**2) - ACCEPTED,
    "wrongly_rejected": REJECTED,
}

ARGUMENTS = tuple(
    Argument(name, (symbol,), MEANINGS[symbol], "mm")
    for name, symbol in zip(NAMES, SYMBOLS, strict=True)
)


def quantity(name: str, definition: sp.Expr) -> Quantity:
    """Return one of the four shares; the bar is 1e-12 relative."""
    form = Form("arc integrals", definition)
    summary = f"Share of the {name.replace('_', ' ')} parts, two normal laws."
    return Quantity(
        name, summary, ARGUMENTS, definition, form, "JCGM 106:2012, 9.5", bar=Bar(1e-12 / EPS)
    )


PAPER = Paper(
    system="conformity",
    citation="JCGM 106:2012",
    variables=tuple(
        Variable(
            symbol,
            meaning,
            LENGTH,
            sp.Interval.open(0, sp.oo) if symbol in (sigma, s) else sp.S.Reals,
        )
        for symbol, meaning in MEANINGS.items()
    ),
    rows=(),
    where=(low < high,),
    quantities=tuple(quantity(name, share) for name, share in DEFINITIONS.items()),
)

Share = Callable[..., Array]


def ours(name: str) -> Share:
    """Return the positive quadrature of `mechproof.conformity`; NaN outside the domain."""

    def compute(
        mean: Array, std: Array, offset: Array, error: Array, low: Array, high: Array
    ) -> Array:
        inside = (std > 0) & (error > 0) & (low < high) & np.isfinite(high - low)
        std, error, low = (np.where(inside, value, np.nan) for value in (std, error, low))
        done = shares(Normal(mean, std), Normal(offset, error), (low, high))
        return np.asarray(getattr(done, name))

    return compute


def simulated(name: str, count: int) -> Specimen:
    """Return the row of a simulation of `count` parts."""

    def compute(
        mean: Array, std: Array, offset: Array, error: Array, low: Array, high: Array
    ) -> Array:
        rng = np.random.default_rng(SEED)
        laws = Normal(mean, std), Normal(offset, error)
        done = simulate_shares(*laws, (low, high), rng=rng, count=count)
        return np.asarray(getattr(done, name))

    note = f"binomial: standard error sqrt(p (1 - p)/{count:g}), not a bound"
    return Specimen(f"simulation, {count:.0e} parts", compute, slow=True, note=note)


def bivariate(h: Array, k: Array, rho: Array) -> Array:
    """Return P(Z1 < h, Z2 < k) at correlation rho by Owen's T function."""
    from scipy.special import ndtr, owens_t

    root = np.sqrt((1 - rho) * (1 + rho))
    with np.errstate(all="ignore"):
        first, second = (k - rho * h) / (h * root), (h - rho * k) / (k * root)
    opposite = np.where((h * k < 0) | ((h * k == 0) & (h + k < 0)), 0.5, 0.0)
    return np.asarray((ndtr(h) + ndtr(k)) / 2 - owens_t(h, first) - owens_t(k, second) - opposite)


def from_rectangle(name: str, margins: tuple[Array, Array], inside: Array) -> Array:
    """Return a share as a difference: margins of conforming and accepted less the rectangle."""
    conforming, accepted = margins
    return np.asarray(
        {
            "rightly_accepted": inside,
            "wrongly_accepted": accepted - inside,
            "rightly_rejected": 1 - conforming - accepted + inside,
            "wrongly_rejected": conforming - inside,
        }[name]
    )


def by_owen(name: str) -> Share:
    """Return a share from the mass of the rectangle, the sum of four corners."""
    from scipy.special import ndtr

    def compute(
        mean: Array, std: Array, offset: Array, error: Array, low: Array, high: Array
    ) -> Array:
        whole = np.hypot(std, error)
        h = [(limit - mean) / std for limit in (low, high)]
        k = [(limit - mean - offset) / whole for limit in (low, high)]
        corners = [[bivariate(a, b, std / whole) for b in k] for a in h]
        inside = corners[1][1] - corners[0][1] - corners[1][0] + corners[0][0]
        margins = ndtr(h[1]) - ndtr(h[0]), ndtr(k[1]) - ndtr(k[0])
        return from_rectangle(name, margins, inside)

    return compute


def by_distribution(name: str) -> Share:
    """Return a share by `scipy.stats.multivariate_normal`, one set at a time."""
    from scipy.special import ndtr
    from scipy.stats import multivariate_normal

    def one(mean: float, std: float, offset: float, error: float, low: float, high: float) -> float:
        whole, means = float(np.hypot(std, error)), (mean, mean + offset)
        law = multivariate_normal(means, [[std**2, std**2], [std**2, whole**2]], True)
        inside = law.cdf([high, high], lower_limit=[low, low])
        ends = ((high - at) / s for at, s in zip(means, (std, whole), strict=True))
        starts = ((low - at) / s for at, s in zip(means, (std, whole), strict=True))
        conforming, accepted = (ndtr(b) - ndtr(a) for a, b in zip(starts, ends, strict=True))
        return float(from_rectangle(name, (conforming, accepted), inside))

    return over_sets(one)


def by_quad(name: str) -> Share:
    """Return a share by `scipy.integrate.quad` over the true deviation, one set at a time."""
    from scipy.integrate import quad
    from scipy.special import ndtr

    def one(mean: float, std: float, offset: float, error: float, low: float, high: float) -> float:
        def accept(y: float) -> float:
            return float(ndtr((high - offset - y) / error) - ndtr((low - offset - y) / error))

        def reject(y: float) -> float:
            return float(ndtr((y + offset - high) / error) + ndtr((low - offset - y) / error))

        chance = accept if name.endswith("accepted") else reject

        def integrand(y: float) -> float:
            return float(np.exp(-(((y - mean) / std) ** 2) / 2) / std * chance(y))

        ranges = ((low, high),) if name in points.CONFORMING else ((-np.inf, low), (high, np.inf))
        parts = (quad(integrand, *ends, epsabs=0, limit=200)[0] for ends in ranges)
        return float(sum(parts) / np.sqrt(2 * np.pi))

    return over_sets(one)


def by_suncal(name: str) -> Share:
    """Return a share by `suncal.risk`, one set at a time."""
    from scipy.stats import norm
    from suncal import risk

    risk_of = risk.PFA if name == "wrongly_accepted" else risk.PFR

    def one(mean: float, std: float, offset: float, error: float, low: float, high: float) -> float:
        return float(risk_of(norm(mean, std), norm(0, error), low, high, testbias=offset))

    return over_sets(one)


def over_sets(one: Callable[..., float]) -> Share:
    """Call a function of numbers for every set."""

    def compute(*arguments: Array) -> Array:
        import warnings

        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # quad warns where it misses its tolerance
            sets = zip(*map(np.ravel, np.broadcast_arrays(*arguments)), strict=True)
            return np.array([one(*map(float, row)) for row in sets])

    return compute


def list_peers(name: str) -> list[Specimen]:
    """List the ways of other libraries; suncal has the two risks only."""
    found = [
        Specimen("scipy.integrate.quad", by_quad(name), slow=True, source="peer"),
        Specimen("multivariate_normal", by_distribution(name), slow=True, source="peer"),
    ]
    if find_spec("suncal") and name.startswith("wrongly"):
        found.append(Specimen("suncal.risk", by_suncal(name), slow=True, source="peer"))
    return found


def study(name: str) -> Study:
    """Return the rows of one share."""
    sign = "margins less a rectangle of four corners: small shares cancel"
    return Study(
        specimens=(
            simulated(name, 10_000),
            simulated(name, 1_000_000),
            Specimen("Owen's T", by_owen(name), note=sign),
            *list_peers(name),
        ),
        sets=points.SETS_OF_PARAMETERS,
        cells=points.CELLS,
        in_cell=points.in_cell,
        within=partial(points.is_far_from_underflow, name),
        workloads=(("N sets", points.workload),),
    )


TABLE = Table(
    studies={q.name: study(q.name) for q in PAPER.quantities},
    paper=PAPER,
    kernels={q.name: ours(q.name) for q in PAPER.quantities},
)
