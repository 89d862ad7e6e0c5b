"""Moved matrices: in, how roundings move the entries of a matrix; out, how far they move its map.

A rounding moves all entries by a number times a matrix D, which is known up to its variation within
a box. All roundings together move the image of a point p by at most the sum of |q*D*p| in the
direction q. That sum is convex in p, in q and along the sides of the box, so over points of a
sphere it is at most its largest value at the corners of a polytope around it. The sum of the norms
of all D is larger, as they are not all attained for one p and q, and so is the norm of the sum of
their absolute values.
"""

from __future__ import annotations

import itertools
import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from mechproof.arithmetic.intervals import Array, Interval
from mechproof.arithmetic.linear_forms import list_pairs, state

GOLDEN = (1 + math.sqrt(5)) / 2
# The number of triangles along the side of an icosahedron's face, and the decimals of corners.
ALONG, DECIMALS = 3, 12
# The number of pairs of directions whose sums are bounded more closely.
CLOSELY = 64
# A factor that covers the roundings of a sum over many matrices.
SLACK = 1 + 2.0**-36


@dataclass(frozen=True)
class MovedMatrix:
    """The matrices by which roundings move a matrix in boxes, and a bound on everything else.

    For each rounding, `moves` has the matrix at the middle of a box, its change towards the end of
    each side and its bends; axes are roundings, middle, sides and pairs of them, rows, columns,
    boxes. `rest` has the axes rows, columns, boxes.
    """

    moves: Array
    rest: Array


def sort_moves(moves: Sequence[Sequence[Mapping[str, Interval]]]) -> MovedMatrix:
    """Collect the moves of all entries; roundings that move a single entry go to the rest."""
    known = [move for row in moves for cell in row for move in cell.items()]
    times = Counter(name for name, _ in known)
    shared = {name: place for place, name in enumerate(n for n in times if times[n] > 1)}
    forms = [move.form for _, move in known if move.form]
    sides = max((len(form.changes) for form in forms), default=0)
    pairs = max((len(form.bends) for form in forms if form.is_bent), default=0)
    shape = np.broadcast_shapes(*(np.shape(move.low) for _, move in known))
    size = (len(moves), len(moves[0]))
    parts = np.zeros((len(shared), 1 + sides + pairs, *size, *shape))
    rest = np.zeros((*size, *shape))
    for i, j in np.ndindex(size):
        for name, move in moves[i][j].items():
            if times[name] == 1:
                rest[i, j] += move.largest()
                continue
            plain, form = state(move.low, move.high), move.stated
            is_closer = form.rest < plain.rest
            part = parts[shared[name], :, i, j]
            part[0] = np.where(is_closer, form.middle, plain.middle)
            if sides:
                part[1 : 1 + sides] = np.where(is_closer, form.changes, 0.0)
            if form.is_bent:
                # The square of a distance, from 0 to 1, is within a half of a half.
                squares = np.equal(*list_pairs(sides))
                bends = np.where(is_closer, form.bends, 0.0)
                bends[squares] /= 2
                part[0] += bends[squares].sum(axis=0)
                part[1 + sides :] = bends
            rest[i, j] += np.where(is_closer, form.rest, plain.rest)
    return MovedMatrix(parts, rest)


def bound_stretch(moved: MovedMatrix) -> Array:
    """Bound the sum of |q*D*p| over all matrices D, for |p| = |q| = 1, in each box."""
    corners = list_corners()
    pairs = np.einsum("ai,bj->ijab", corners, corners).reshape(corners.shape[1] ** 2, -1)
    roundings, parts = moved.moves.shape[:2]
    boxes = math.prod(moved.rest.shape[2:])
    moves = np.moveaxis(moved.moves.reshape(roundings, parts, len(pairs), boxes), -1, 0)
    rests = moved.rest.reshape(len(pairs), -1).T
    # Box by box, so that the products with all pairs stay in the processor's cache.
    found = [_find_largest(*box, pairs) for box in zip(moves, rests, strict=True)]
    return np.reshape(found, moved.rest.shape[2:]) * SLACK


def _find_largest(moves: Array, rest: Array, pairs: Array) -> float:
    """Return the largest sum over pairs of directions, bounding the likeliest more closely."""
    sizes = np.abs(pairs)
    still = np.abs(moves[:, 0] @ pairs).sum(axis=0) + rest @ sizes
    if moves.shape[1] == 1:
        return float(still.max())
    high = still + np.abs(moves[:, 1:]).sum(axis=(0, 1)) @ sizes
    order = np.argpartition(-high, CLOSELY)
    near, others = order[:CLOSELY], order[CLOSELY:]
    values = moves @ pairs[:, near]
    middle, changes = values[:, 0], values[:, 1:]
    # Bends count as changes along sides of their own.
    # Where a product keeps its sign, its changes are added to those of others before any absolute
    # value is taken.
    turned = np.maximum(np.abs(changes).sum(axis=1) - np.abs(middle), 0.0).sum(axis=0)
    along = np.abs((np.sign(middle)[:, np.newaxis] * changes).sum(axis=0)).sum(axis=0)
    return float(np.maximum((still[near] + 2 * turned + along).max(), high[others].max()))


@cache
def list_corners() -> Array:
    """List the corners of a polytope around the unit sphere, one of each opposite pair.

    They are those of an icosahedron with divided faces, moved out until the planes of all triangles
    are outside the sphere.
    """
    pairs = [(s, t * GOLDEN) for s in (-1.0, 1.0) for t in (-1.0, 1.0)]
    solid = [np.roll((0.0, *pair), place) for pair in pairs for place in range(3)]
    faces = [face for face in itertools.combinations(solid, 3) if _measure_longest(face) < 2.1]
    triangles = np.array([part for face in faces for part in _divide(*face)])
    triangles /= np.linalg.norm(triangles, axis=2, keepdims=True)
    # Rounded, the corners of neighbours coincide; adding 0.0 removes the signs of zeros.
    triangles = np.round(triangles, DECIMALS) + 0.0
    one, two, three = np.moveaxis(triangles, 1, 0)
    normals = np.cross(two - one, three - one)
    distances = np.abs((normals * one).sum(axis=1)) / np.linalg.norm(normals, axis=1)
    corners = np.unique(triangles.reshape(-1, 3), axis=0)
    half = [corner for corner in corners if tuple(corner) > tuple(-corner)]
    found: Array = np.array(half) / distances.min() * SLACK
    return found


def _measure_longest(face: Sequence[Array]) -> float:
    return max(float(np.linalg.norm(a - b)) for a, b in itertools.combinations(face, 2))


def _divide(a: Array, b: Array, c: Array) -> Iterator[list[Array]]:
    """Yield the triangles of a subdivided triangle, with `ALONG` of them along each side."""
    for i, j in itertools.product(range(ALONG), repeat=2):
        if i + j < ALONG:
            places = [(i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)]
            points = [m * a + n * b + (ALONG - m - n) * c for m, n in places]
            yield from (points[:3],) if i + j == ALONG - 1 else (points[:3], points[1:])
