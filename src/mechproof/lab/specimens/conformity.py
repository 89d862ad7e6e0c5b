"""Shares of wrongly accepted and rejected parts: simulation, Owen's T, quadrature.

The definitions integrate over the finite window: the density of what is measured, times the
probability of the other side given the measured value; and the same from the true deviation.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec

import numpy as np
import sympy as sp

from mechproof.conformity import Normal, shares, simulate_shares
from mechproof.lab.points import draw_within
from mechproof.lab.specimen import Arguments, Array, Specimen
from mechproof.lab.subject import Box, Cells, PointSet, Study, Table
from mechproof.record import LENGTH, Argument, Bar, Form, Paper, Quantity, Variable

EPS = float(np.finfo(float).eps)
SETS = 80
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


def density(at: sp.Expr, mean: sp.Expr, variance: sp.Expr) -> sp.Expr:
    """Density of a normal law."""
    return sp.exp(-((at - mean) ** 2) / (2 * variance)) / sp.sqrt(2 * sp.pi * variance)


def outside(mean: sp.Expr, variance: sp.Expr) -> sp.Expr:
    """Probability of a normal law outside the limits, from its two tails."""
    root = sp.sqrt(2 * variance)
    return (sp.erfc((mean - low) / root) + sp.erfc((high - mean) / root)) / 2


VARIANCE = sigma**2 + s**2
GIVEN_MEAN = mu + sigma**2 / VARIANCE * (m - mu - bias)
ACCEPTED = sp.Integral(
    density(m, mu + bias, VARIANCE) * outside(GIVEN_MEAN, sigma**2 * s**2 / VARIANCE),
    (m, low, high),
)
REJECTED = sp.Integral(density(m, mu, sigma**2) * outside(m + bias, s**2), (m, low, high))

ARGUMENTS = tuple(
    Argument(name, (symbol,), MEANINGS[symbol], "mm")
    for name, symbol in zip(NAMES, SYMBOLS, strict=True)
)


def quantity(name: str, definition: sp.Expr) -> Quantity:
    """Return one of the two shares; the bar is 1e-12 relative."""
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
    quantities=(quantity("wrongly_accepted", ACCEPTED), quantity("wrongly_rejected", REJECTED)),
)

Share = Callable[..., Array]


def ours(name: str) -> Share:
    """Return the positive quadrature of `mechproof.conformity`."""

    def compute(
        mean: Array, std: Array, offset: Array, error: Array, low: Array, high: Array
    ) -> Array:
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


def by_owen(name: str) -> Share:
    """Return a share as a difference: one margin less the mass of the rectangle."""
    from scipy.special import ndtr

    def compute(
        mean: Array, std: Array, offset: Array, error: Array, low: Array, high: Array
    ) -> Array:
        whole = np.hypot(std, error)
        h = [(limit - mean) / std for limit in (low, high)]
        k = [(limit - mean - offset) / whole for limit in (low, high)]
        corners = [[bivariate(a, b, std / whole) for b in k] for a in h]
        inside = corners[1][1] - corners[0][1] - corners[1][0] + corners[0][0]
        margin = k if name == "wrongly_accepted" else h
        return np.asarray(ndtr(margin[1]) - ndtr(margin[0]) - inside)

    return compute


def by_quad(name: str) -> Share:
    """Return a share by `scipy.integrate.quad`, one set at a time."""
    from scipy.integrate import quad
    from scipy.special import ndtr

    def one(mean: float, std: float, offset: float, error: float, low: float, high: float) -> float:
        variance = std**2 + error**2

        def outside(m: float, spread: float) -> float:
            return float(ndtr((low - m) / spread) + ndtr((m - high) / spread))

        def integrand(m: float) -> float:
            if name == "wrongly_rejected":
                return float(np.exp(-(((m - mean) / std) ** 2) / 2) / std) * outside(
                    m + offset, error
                )
            given = mean + std**2 / variance * (m - mean - offset)
            peak = np.exp(-((m - mean - offset) ** 2) / variance / 2) / np.sqrt(variance)
            return float(peak) * outside(given, std * error / np.sqrt(variance))

        return float(quad(integrand, low, high, epsabs=0, limit=200)[0] / np.sqrt(2 * np.pi))

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


def windows(rng: np.random.Generator, count: int, std: Array, error: Array) -> Arguments:
    """Draw limits of 1 to 7 standard deviations, both laws shifted."""
    mean, offset = rng.uniform(-0.5, 0.5, count) * std, rng.uniform(-0.5, 0.5, count) * error
    reach = rng.uniform(1, 7, (2, count)) * np.hypot(std, error)
    return mean, std, offset, error, -reach[0], reach[1]


def usual(rng: np.random.Generator) -> Arguments:
    """Draw errors of 1 % to all of the true spread."""
    std = 10 ** rng.uniform(-2, 0, SETS)
    return windows(rng, SETS, std, std * 10 ** rng.uniform(-2, 0, SETS))


def in_cell(rng: np.random.Generator, box: Box) -> Arguments:
    """Draw spreads of one box."""
    columns = (np.abs(draw_within(rng, SETS, *box[n])) for n in ("true_std", "error_std"))
    return windows(rng, SETS, *columns)


def workload(count: int) -> Arguments:
    """Return N sets of parameters."""
    rng = np.random.default_rng(7)
    std = np.ones(count)
    return windows(rng, count, std, std * rng.uniform(0.1, 0.5, count))


def study(name: str) -> Study:
    """Return the rows of one share."""
    sign = "one margin less a rectangle of four corners: small shares cancel"
    peers = [
        Specimen("scipy.integrate.quad", by_quad(name), slow=True, source="peer"),
    ]
    if find_spec("suncal"):
        peers.append(Specimen("suncal.risk", by_suncal(name), slow=True, source="peer"))
    return Study(
        specimens=(
            simulated(name, 10_000),
            simulated(name, 1_000_000),
            Specimen("Owen's T", by_owen(name), note=sign),
            *peers,
        ),
        sets=(PointSet("limits of 1 to 7 standard deviations", usual),),
        cells=(Cells("true_std", (0.01, 1.0)), Cells("error_std", (0.001, 0.1, 1.0))),
        in_cell=in_cell,
        workloads=(("N sets", workload),),
    )


TABLE = Table(
    studies={q.name: study(q.name) for q in PAPER.quantities},
    paper=PAPER,
    kernels={q.name: ours(q.name) for q in PAPER.quantities},
)
