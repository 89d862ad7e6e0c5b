"""Ways to compute the shares: the package's quadrature, simulation, Owen's T, other libraries."""

import warnings
from collections.abc import Callable, Mapping
from importlib import import_module
from importlib.util import find_spec

import numpy as np

from mechproof.conformity import Normal, simulate_shares
from mechproof.record import Peer

from .._peers import Array
from . import CONFORMING, DEFINITIONS

Share = Callable[..., Array]
SEED = 20221
POSITIVE = "positive quadrature"
OURS = (
    ("mechproof.conformity", "mechproof.conformity", ""),
    ("mechproof.conformity, compiled", "mechproof.conformity.compiled", "fast"),
)


def by_quadrature(name: str, module: str) -> Share:
    """Return a way to compute a share by a module's quadrature; NaN outside the domain."""

    def compute(
        mean: Array, std: Array, offset: Array, error: Array, low: Array, high: Array
    ) -> Array:
        shares = import_module(module).shares
        inside = (std > 0) & (error > 0) & (low < high) & np.isfinite(high - low)
        std, error, low = (np.where(inside, value, np.nan) for value in (std, error, low))
        done = shares(Normal(mean, std), Normal(offset, error), (low, high))
        return np.asarray(getattr(done, name))

    return compute


def simulated(name: str, count: int) -> Peer:
    """Return the peer that simulates `count` parts."""

    def compute(
        mean: Array, std: Array, offset: Array, error: Array, low: Array, high: Array
    ) -> Array:
        rng = np.random.default_rng(SEED)
        laws = Normal(mean, std), Normal(offset, error)
        done = simulate_shares(*laws, (low, high), rng=rng, count=count)
        return np.asarray(getattr(done, name))

    note = f"binomial: standard error sqrt(p (1 - p)/{count:g}), not a bound"
    return Peer(f"simulation, {count:.0e} parts", compute, slow=True, note=note)


def bivariate(h: Array, k: Array, rho: Array) -> Array:
    """Return P(Z1 < h, Z2 < k) at correlation rho by Owen's T function."""
    from scipy.special import ndtr, owens_t

    root = np.sqrt((1 - rho) * (1 + rho))
    with np.errstate(all="ignore"):
        first, second = (k - rho * h) / (h * root), (h - rho * k) / (k * root)
    opposite = np.where((h * k < 0) | ((h * k == 0) & (h + k < 0)), 0.5, 0.0)
    return np.asarray((ndtr(h) + ndtr(k)) / 2 - owens_t(h, first) - owens_t(k, second) - opposite)


def from_rectangle(name: str, margins: tuple[Array, Array], inside: Array) -> Array:
    """Return a share as a difference of the margins (conforming, accepted) and the rectangle."""
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
    """Return a way to compute a share from the mass of the rectangle, the sum of four corners."""

    def compute(
        mean: Array, std: Array, offset: Array, error: Array, low: Array, high: Array
    ) -> Array:
        from scipy.special import ndtr

        whole = np.hypot(std, error)
        h = [(limit - mean) / std for limit in (low, high)]
        k = [(limit - mean - offset) / whole for limit in (low, high)]
        corners = [[bivariate(a, b, std / whole) for b in k] for a in h]
        inside = corners[1][1] - corners[0][1] - corners[1][0] + corners[0][0]
        margins = ndtr(h[1]) - ndtr(h[0]), ndtr(k[1]) - ndtr(k[0])
        return from_rectangle(name, margins, inside)

    return compute


def by_distribution(name: str) -> Share:
    """Return a way to compute a share by `scipy.stats.multivariate_normal`, one set at a time."""

    def one(mean: float, std: float, offset: float, error: float, low: float, high: float) -> float:
        from scipy.special import ndtr
        from scipy.stats import multivariate_normal

        whole, means = float(np.hypot(std, error)), (mean, mean + offset)
        law = multivariate_normal(means, [[std**2, std**2], [std**2, whole**2]], True)
        inside = law.cdf([high, high], lower_limit=[low, low])
        ends = ((high - at) / s for at, s in zip(means, (std, whole), strict=True))
        starts = ((low - at) / s for at, s in zip(means, (std, whole), strict=True))
        conforming, accepted = (ndtr(b) - ndtr(a) for a, b in zip(starts, ends, strict=True))
        return float(from_rectangle(name, (conforming, accepted), inside))

    return over_sets(one)


def by_quad(name: str) -> Share:
    """Return a way to compute a share by `scipy.integrate.quad` over the true deviation.

    It takes one set of parameters at a time.
    """

    def one(mean: float, std: float, offset: float, error: float, low: float, high: float) -> float:
        from scipy.integrate import quad
        from scipy.special import ndtr

        def accept(y: float) -> float:
            return float(ndtr((high - offset - y) / error) - ndtr((low - offset - y) / error))

        def reject(y: float) -> float:
            return float(ndtr((y + offset - high) / error) + ndtr((low - offset - y) / error))

        chance = accept if name.endswith("accepted") else reject

        def integrand(y: float) -> float:
            return float(np.exp(-(((y - mean) / std) ** 2) / 2) / std * chance(y))

        ranges = ((low, high),) if name in CONFORMING else ((-np.inf, low), (high, np.inf))
        parts = (quad(integrand, *ends, epsabs=0, limit=200)[0] for ends in ranges)
        return float(sum(parts) / np.sqrt(2 * np.pi))

    return over_sets(one)


def by_suncal(name: str) -> Share:
    """Return a way to compute a share by `suncal.risk`, one set at a time."""

    def one(mean: float, std: float, offset: float, error: float, low: float, high: float) -> float:
        from scipy.stats import norm
        from suncal import risk

        risk_of = risk.PFA if name == "wrongly_accepted" else risk.PFR
        return float(risk_of(norm(mean, std), norm(0, error), low, high, testbias=offset))

    return over_sets(one)


def over_sets(one: Callable[..., float]) -> Share:
    """Return a function of arrays that calls a function of numbers for every set."""

    def compute(*arguments: Array) -> Array:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # quad warns where it misses its tolerance
            sets = zip(*map(np.ravel, np.broadcast_arrays(*arguments)), strict=True)
            return np.array([one(*map(float, row)) for row in sets])

    return compute


def list_peers(name: str) -> tuple[Peer, ...]:
    """Return the ways to compute a share, the package's first; suncal has only the two risks."""
    cancels = "margins less a rectangle of four corners: small shares cancel"
    suncal = find_spec("suncal") is not None and name.startswith("wrongly")
    return (
        *(
            Peer(
                way, by_quadrature(name, module), ours=True, note="positive quadrature", needs=needs
            )
            for way, module, needs in OURS
            if not needs or find_spec("numba") is not None
        ),
        simulated(name, 10_000),
        simulated(name, 1_000_000),
        Peer("Owen's T", by_owen(name), note=cancels),
        Peer("scipy.integrate.quad", by_quad(name), slow=True),
        Peer("multivariate_normal", by_distribution(name), slow=True),
        *([Peer("suncal.risk", by_suncal(name), slow=True)] if suncal else []),
    )


PEERS: Mapping[str, tuple[Peer, ...]] = {name: list_peers(name) for name in DEFINITIONS}
