"""Ways to get the numbers of paper 2 without a formula: joined branches, integrals, solvers."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from mechproof.kernels import oval_planetary as kernels
from mechproof.record import Peer

from .._peers import Array, solve_by_steps, sum_by_simpson


def take_branch(driver: Array, eccentricity: Array) -> Array:
    """Return the angle of a driven wheel by one arctangent, on a single branch."""
    tangent: Array = np.arctan((1 + eccentricity) / (1 - eccentricity) * np.tan(driver))
    return tangent


def join_branches(driver: Array, eccentricity: Array) -> Array:
    """Return the same over any number of turns of the samples."""
    joined: Array = np.unwrap(take_branch(driver, eccentricity), period=np.pi)
    return joined


def unwrap_ovals(phi1: Array, e1: Array, e2: Array, mount: Array) -> Array:
    """Return the output angle through both pairs."""
    wheel_6 = join_branches(phi1, e1) + mount
    return phi1 - (join_branches(wheel_6, e2) - take_branch(mount, e2))


def unwrap_cylindrical(phi1: Array, r4: Array, r5: Array, e2: Array) -> Array:
    """Return the output angle through the pair 6-3."""
    return phi1 - join_branches(r4 / r5 * phi1, e2)


def list_peers(ratio: Callable[..., Any], unwrap: Callable[..., Any]) -> tuple[Peer, ...]:
    """Return the peers of a position function."""
    return (
        Peer(
            "tan/arctan + unwrap",
            unwrap,
            ordered=True,
            note="right only if no step of the samples turns a wheel by half of pi",
        ),
        sum_by_simpson(
            ratio, "a bound would need the fourth derivative of the ratio over the samples"
        ),
        solve_by_steps(ratio),
    )


PEERS: Mapping[str, tuple[Peer, ...]] = {
    "position": list_peers(kernels.ratio, unwrap_ovals),
    "position_cylindrical": list_peers(kernels.ratio_cylindrical, unwrap_cylindrical),
}
