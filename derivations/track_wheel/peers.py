"""Ways to get turns, displacements and sums of errors from libraries."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from mechproof.record import Peer

from .._peers import Array


def multiply_turns(alpha: Array, beta: Array, gamma: Array) -> Array:
    """Multiply the matrices of the three turns with NumPy."""
    one, none = np.ones_like(alpha), np.zeros_like(alpha)
    (sa, ca), (sb, cb), (sg, cg) = ((np.sin(t), np.cos(t)) for t in (alpha, beta, gamma))
    first = np.array([[one, none, none], [none, ca, sa], [none, -sa, ca]])
    second = np.array([[cb, none, -sb], [none, one, none], [sb, none, cb]])
    third = np.array([[cg, sg, none], [-sg, cg, none], [none, none, one]])
    a, b, c = (np.moveaxis(m, (0, 1), (-2, -1)) for m in (first, second, third))
    return np.asarray(c @ b @ a)


def turn_by_scipy(alpha: Array, beta: Array, gamma: Array) -> Array:
    """Get the matrix from SciPy; ours is seen from the part's frame, hence the transpose."""
    from scipy.spatial.transform import Rotation

    angles = np.stack(np.broadcast_arrays(alpha, beta, gamma), axis=-1)
    return np.asarray(Rotation.from_euler("XYZ", angles).as_matrix().swapaxes(-1, -2))


def displace_by_scipy(points: Array, angles: Array, shift: Array) -> Array:
    """Turn the points with SciPy."""
    from scipy.spatial.transform import Rotation

    return np.asarray(Rotation.from_euler("XYZ", angles).apply(points) - (points - shift))


def take_norm(displacement: Array) -> Array:
    """Take the norm of the vector with NumPy."""
    return np.asarray(np.linalg.norm(displacement, axis=-1))


def take_norm_of_terms(
    tolerances: Array, sensitivities: Array, scatters: Array, total_scatter: Array
) -> Array:
    """Take the norm of the products with NumPy."""
    terms = scatters * sensitivities * tolerances
    return np.asarray(np.linalg.norm(terms, axis=-1) / total_scatter)


def sum_covariances(
    tolerances: Array,
    sensitivities: Array,
    scatters: Array,
    correlation: Array,
    total_scatter: Array,
) -> Array:
    """Add the covariances with NumPy's einsum."""
    terms = scatters * sensitivities * tolerances
    total: Any = np.einsum("...i,...ij,...j", terms, correlation, terms)
    return np.asarray(np.sqrt(total) / total_scatter)


PEERS: Mapping[str, tuple[Peer, ...]] = {
    "rotation": (
        Peer("product of three matrices", multiply_turns),
        Peer("scipy Rotation", turn_by_scipy),
    ),
    "displacement": (Peer("scipy Rotation", displace_by_scipy),),
    "spatial_error": (Peer("np.linalg.norm", take_norm),),
    "error_sum": (Peer("np.linalg.norm", take_norm_of_terms),),
    "error_sum_correlated": (Peer("einsum", sum_covariances),),
}
