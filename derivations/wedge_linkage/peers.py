"""Derivatives of the chain by central differences of its kernel."""

from collections.abc import Mapping
from functools import partial

import numpy as np

from mechproof.kernels import wedge_linkage as kernels
from mechproof.record import Peer

from .._peers import Array

# mm or rad: the error of the difference, STEP**2/6 of the third derivative, and that of rounding,
# eps/STEP of the position, are of similar size.
STEP = 1e-4


def take_difference(index: int, *arguments: Array) -> Array:
    """Return the central difference of the position by one argument."""
    before, at, after = arguments[:index], arguments[index], arguments[index + 1 :]
    moved = ((*before, at + step, *after) for step in (-STEP, STEP))
    low, high = (kernels.position(*point) for point in moved)
    return np.asarray((high - low) / (2 * STEP))


def take_by_sizes(*arguments: Array) -> Array:
    """Return the central differences by all ten sizes."""
    columns = (take_difference(index, *arguments) for index in range(1, len(arguments)))
    return np.stack(np.broadcast_arrays(*columns), axis=-1)


PEERS: Mapping[str, tuple[Peer, ...]] = {
    "velocity": (Peer("central difference", partial(take_difference, 0)),),
    "sensitivities": (Peer("central differences", take_by_sizes),),
}
