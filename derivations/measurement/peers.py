"""Ways to compute the standard deviation of readings."""

from collections.abc import Mapping

import numpy as np

from mechproof.measurement import evaluate_type_a
from mechproof.record import Peer

from .._peers import Array


def centred_twice(rows: Array) -> Array:
    """Evaluate each series of readings separately."""
    return np.array([evaluate_type_a(row).standard_deviation for row in np.atleast_2d(rows)])


def one_pass(rows: Array) -> Array:
    """Subtract the square of the sum from the sum of squares."""
    count = rows.shape[-1]
    squares = np.sum(rows**2, axis=-1) - np.sum(rows, axis=-1) ** 2 / count
    return np.asarray(np.sqrt(squares / (count - 1)))


def two_pass(rows: Array) -> Array:
    """Call the standard deviation of NumPy."""
    return np.asarray(np.std(rows, axis=-1, ddof=1))


PEERS: Mapping[str, tuple[Peer, ...]] = {
    "standard_deviation": (
        Peer("evaluate_type_a", centred_twice, ours=True, note="centred twice"),
        Peer("one pass", one_pass, note="two nearly equal sums are subtracted"),
        Peer("np.std", two_pass),
    )
}
