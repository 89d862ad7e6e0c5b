"""Common to peers and points: arrays; ways to integrate a ratio, by samples and by solving."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechproof.record import Peer

Array = NDArray[np.float64]
Arguments = tuple[Array, ...]
Draw = Callable[[np.random.Generator], Arguments]


def sum_by_simpson(ratio: Callable[..., Any], note: str = "") -> Peer:
    """Return the peer that sums the samples of a ratio."""

    def integrate(phi1: Array, *sizes: Array) -> Array:
        from scipy.integrate import cumulative_simpson

        return np.asarray(cumulative_simpson(ratio(phi1, *sizes), x=phi1, initial=0))

    return Peer("cumulative Simpson", integrate, ordered=True, note=note)


def solve_by_steps(ratio: Callable[..., Any]) -> Peer:
    """Return the peer that solves the differential equation, with the tightest usual tolerance."""

    def integrate(phi1: Array, *sizes: Array) -> Array:
        from scipy.integrate import solve_ivp

        done = solve_ivp(
            lambda angle, _: [ratio(angle, *sizes)],
            (phi1[0], phi1[-1]), [0.0], "DOP853", t_eval=phi1, rtol=1e-12, atol=1e-12,
        )  # fmt: skip
        return np.asarray(done.y[0])

    note = "the solver controls an estimate of the local error"
    return Peer("solve_ivp, DOP853 1e-12", integrate, ordered=True, slow=True, note=note)
