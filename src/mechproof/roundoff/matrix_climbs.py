"""Matrix climbs: in, a map of points; out, points to climb from, with badly rounded matrices.

The matrix depends on few arguments. So these alone climb first, towards the largest norm of the
error of the matrix; then points are drawn near the direction that this error stretches most.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from mechproof.arithmetic.intervals import Array
from mechproof.roundoff.affine import AffineMap
from mechproof.roundoff.climb import Points, Schedule, climb
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.running import IN_DOUBLES, IN_EXTENDED, LONG_DOUBLE, run

# Many small populations, as each soon crowds into one place.
CLIMBS, SCHEDULE, ROUNDS = 100, Schedule(300, 4), 60
# How many of the worst matrices get points, how many each, in how many octaves of size, and the
# powers of ten between which their directions, and the shift, are moved.
KEPT, DRAWN, OCTAVES, AWAY = 32, 3000, 6.0, (-16.0, -2.0)


def list_starts(
    subject: ComputedStage, drawn: Mapping[str, Array], rng: np.random.Generator
) -> list[dict[str, Array]]:
    """Return points to climb from, for each of the worst matrices that climbs from `drawn` find."""
    assert subject.map is not None
    names = _list_arguments(subject.map)
    columns = [drawn[name] for name in names]

    def measure(points: Points) -> Array:
        given = dict(zip(names, points, strict=True))
        sizes = np.linalg.norm(_find_errors(subject, given), 2, axis=(1, 2))
        return np.where(_are_inside(subject, given), sizes, -1.0)

    found = []
    for _ in range(CLIMBS):
        chosen = rng.integers(0, len(columns[0]), len(columns[0]))
        start = tuple(column[chosen] for column in columns)
        found.append(climb(measure, start, SCHEDULE, ROUNDS, rng).worst)
    found.sort(key=lambda pair: -pair[1])
    poses = [dict(zip(names, map(float, point), strict=True)) for point, _ in found[:KEPT]]
    return [_draw_points(subject, pose, rng) for pose in poses]


def _list_arguments(affine: AffineMap) -> list[str]:
    moved = {*affine.points, *affine.shift}
    return [name for name in affine.entries.inputs if name not in moved]


def _find_errors(subject: ComputedStage, given: Mapping[str, Array]) -> Array:
    """Return the errors of the matrices over their sizes, estimated in long doubles.

    The columns are the images of unit vectors, as products by one and by zero are exact.
    """
    affine = subject.map
    assert affine is not None
    assert subject.scale is not None
    count = len(next(iter(given.values())))
    columns = []
    with np.errstate(all="ignore"):
        for point in affine.points:
            unit = {name: np.full(count, float(name == point)) for name in affine.points}
            whole = {**given, **unit, **dict.fromkeys(affine.shift, np.zeros(count))}
            extended = {name: LONG_DOUBLE(column) for name, column in whole.items()}
            exact = run(subject.exact, extended, IN_EXTENDED)
            pairs = zip(subject.compute(whole), exact, strict=True)
            size = run(subject.scale.straights[0], extended, IN_EXTENDED)[0]
            columns.append([np.asarray((value - true) / size, float) for value, true in pairs])
    return np.nan_to_num(np.array(columns).transpose(2, 1, 0), posinf=0.0, neginf=0.0)


def _are_inside(subject: ComputedStage, given: Mapping[str, Array]) -> Array:
    with np.errstate(all="ignore"):
        inside: Array = subject.inside.holds(given, IN_DOUBLES)
    return inside


def _draw_points(
    subject: ComputedStage, pose: Mapping[str, float], rng: np.random.Generator
) -> dict[str, Array]:
    """Draw points near the direction that the error of a pose's matrix stretches most."""
    affine = subject.map
    assert affine is not None
    (errors,) = _find_errors(subject, {name: np.array([value]) for name, value in pose.items()})
    direction = np.linalg.svd(errors)[2][0]
    shape = (len(direction), DRAWN)
    sizes = 2.0 ** rng.uniform(0, OCTAVES, DRAWN)
    moves, shifts = rng.normal(size=(2, *shape)) * 10.0 ** rng.uniform(*AWAY, (2, *shape))
    points = direction[:, np.newaxis] * sizes * (1 + moves)
    return {
        **{name: np.full(DRAWN, value) for name, value in pose.items()},
        **dict(zip(affine.points, points, strict=True)),
        **dict(zip(affine.shift, shifts, strict=True)),
    }
