"""Ways to get the numbers of paper 1 without a formula: joined branches, solvers, libraries."""

from collections.abc import Mapping
from importlib.util import find_spec

import numpy as np

from mechproof.kernels import elliptic_planetary as kernels
from mechproof.record import Peer

from .._peers import Array, solve_by_steps, sum_by_simpson

KNOTS = 1024


def join_branches(phi1: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Join the branches of the arctangent by np.unwrap."""
    branch = 2 * np.arctan((1 + e) / (1 - e) * np.tan(r1 / r2 * phi1 / 2))
    return np.asarray(phi1 + np.unwrap(branch))


def interpolate(phi1: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Interpolate the periodic part at 1024 knots; one spline for each eccentricity."""
    from scipy.interpolate import CubicSpline

    knots = np.linspace(0, 2 * np.pi, KNOTS + 1)
    x, eccentricity = np.broadcast_arrays(r1 / r2 * phi1, e)
    result = np.empty(x.shape)
    for value in np.unique(eccentricity):
        part = 2 * np.arctan2(
            value * np.sin(knots), (1 - value) + 2 * value * np.sin(knots / 2) ** 2
        )
        part[-1] = part[0] = 0.0
        mine = eccentricity == value
        result[mine] = CubicSpline(knots, part, bc_type="periodic")(x[mine])
    return np.asarray(phi1 + x + result)


def distribute(phi1: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Use the distribution function of the wrapped Cauchy law, turn by turn."""
    from scipy.stats import wrapcauchy

    x = r1 / r2 * phi1
    turn = np.floor(x / (2 * np.pi))
    share = wrapcauchy.cdf(x - 2 * np.pi * turn, np.broadcast_to(e, np.shape(x)))
    return np.asarray(phi1 + 2 * np.pi * (turn + share))


def take_anomaly(phi1: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Use the true anomaly from kepler.py, x being the eccentric anomaly."""
    from kepler import kepler

    x, largest = r1 / r2 * phi1, np.nextafter(1.0, 0.0)
    orbit = np.broadcast_to(np.minimum(2 * e / (1 + e**2), largest), np.shape(x))
    _, cosine, sine = kepler(x - orbit * np.sin(x), orbit)
    turn = 2 * np.pi * np.floor((x + np.pi) / (2 * np.pi))
    return np.asarray(phi1 + turn + np.arctan2(sine, cosine))


def list_libraries() -> tuple[Peer, ...]:
    """Return the peers that need a library of the extra `bench`."""
    if not find_spec("kepler"):
        return ()
    note = "solves Kepler's equation on the way, which the position does not need"
    return (Peer("kepler.py", take_anomaly, note=note),)


PEERS: Mapping[str, tuple[Peer, ...]] = {
    "position": (
        Peer(
            "tan/arctan + unwrap",
            join_branches,
            ordered=True,
            note="right only if no step of the samples turns the output by pi",
        ),
        sum_by_simpson(kernels.ratio),
        Peer("cubic spline, 1024 knots", interpolate),
        solve_by_steps(kernels.ratio),
        Peer(
            "scipy.stats.wrapcauchy",
            distribute,
            note="its cdf is (position - phi1)/(2 pi) on the first turn of x",
        ),
        *list_libraries(),
    )
}
