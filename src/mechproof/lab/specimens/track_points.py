"""Where poses and tracks hurt: tiny angles, half turns, gimbal lock, points near the axis."""

from __future__ import annotations

import numpy as np

from mechproof.lab.points import draw_ladder, draw_within, join, spread_ulps
from mechproof.lab.specimen import Arguments, Array
from mechproof.lab.subject import Box, Cells, Map, PointSet

RADIUS, AMPLITUDE, HEIGHT = 41.5, 3.75, 20.0
COUNT = 150
CELLS = (
    Cells("points", (0.0, 1.0, 10.0, 50.0, 100.0, 1000.0)),
    Cells("angles", (0.0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 3.141592653589793)),
    Cells("shift", (0.0, 1.0)),
)


def generic_angles(rng: np.random.Generator) -> Array:
    """Draw any turns."""
    return rng.uniform(-np.pi, np.pi, (COUNT, 3))


def small_angles(rng: np.random.Generator) -> Array:
    """Climb the ladder from 1e-300, all three angles of one size, then of different sizes."""
    size = np.concatenate([[0.0], draw_ladder(rng, 60)])
    alike = size[:, None] * rng.uniform(-1, 1, (len(size), 3))
    apart = np.stack([draw_ladder(rng, 40) for _ in range(3)], axis=1)
    return np.concatenate([alike, rng.permuted(apart, axis=0)])


def near_gimbal(rng: np.random.Generator) -> Array:
    """Surround beta = +-pi/2 and turns by pi: up to 1000 ulps, and ladders on both sides."""
    special = np.array([np.pi / 2, -np.pi / 2, np.pi, -np.pi])
    close = spread_ulps(special, rng)
    beside = np.add.outer(special, draw_ladder(rng, 12, 1e-15)).ravel()
    beta = np.concatenate([close, beside])
    others = rng.choice([0.0, np.pi / 2, np.pi, 1e-9, 1.0], (len(beta), 2))
    return np.stack([others[:, 0], beta, others[:, 1]], axis=1)


def near_axis(angles: Array, rng: np.random.Generator) -> Array:
    """Return points almost on the axis of each turn, where the displacement nearly vanishes."""
    from scipy.spatial.transform import Rotation

    axis = Rotation.from_euler("XYZ", angles).as_rotvec()
    length = np.linalg.norm(axis, axis=1, keepdims=True)
    along = np.where(length > 0, axis / np.where(length > 0, length, 1), [1.0, 0.0, 0.0])
    beside = rng.normal(size=angles.shape) * np.abs(draw_ladder(rng, len(angles), 1e-15))[:, None]
    moved: Array = 50 * along + beside
    return moved


def poses(name: str, draw: str, axis: bool = False) -> PointSet:
    """Return poses whose angles are drawn by a function of this module."""

    def make(rng: np.random.Generator) -> Arguments:
        angles = ANGLES[draw](rng)
        points = near_axis(angles, rng) if axis else rng.uniform(-50, 50, angles.shape)
        size = np.max(np.abs(angles), axis=1, keepdims=True)
        # No shift, or one of the size of the displacement by the turn.
        shift = rng.choice([0.0, 1.0], (len(angles), 1)) * rng.uniform(-50, 50, angles.shape) * size
        return points, angles, shift

    return PointSet(name, make)


ANGLES = {"generic": generic_angles, "small": small_angles, "gimbal": near_gimbal}
POSES = (
    poses("generic", "generic"),
    poses("angles from 1e-300", "small"),
    poses("near gimbal lock", "gimbal"),
    poses("near the axis", "generic", axis=True),
)


def turns_of(name: str) -> PointSet:
    """Return the angles of poses as three arguments."""
    return PointSet(name, lambda rng: tuple(ANGLES[name](rng).T))


TURNS = tuple(map(turns_of, ANGLES))


def in_cell(rng: np.random.Generator, box: Box) -> Arguments:
    """Draw poses of one box of sizes: of the largest coordinate, angle, shift."""
    columns = []
    for name in ("points", "angles", "shift"):
        low, high = box[name]
        size = draw_within(rng, COUNT, low, high)[:, None]
        direction = rng.uniform(-1, 1, (COUNT, 3))
        # A third of them along a diagonal, where a norm is largest beside its largest part.
        direction[::3] = rng.choice([-1.0, 1.0], (len(direction[::3]), 3))
        direction /= np.max(np.abs(direction), axis=1, keepdims=True)
        columns.append(direction * size)
    return tuple(columns)


def one_pose(count: int) -> Arguments:
    """Return N points of the track, one pose."""
    rng = np.random.default_rng(1)
    return rng.uniform(-50, 50, (count, 3)), np.full(3, 1e-3), np.full(3, 1e-2)


def many_poses(count: int) -> Arguments:
    """Return one point, N poses."""
    rng = np.random.default_rng(2)
    return np.full(3, 30.0), rng.uniform(-1e-3, 1e-3, (count, 3)), np.full(3, 1e-2)


def turns(count: int) -> Arguments:
    """Return N turns."""
    return tuple(np.random.default_rng(3).uniform(-np.pi, np.pi, (3, count)))


POSE_LOADS = (("N points, one pose", one_pose), ("N poses, one point", many_poses))


def map_of_turns(size: int) -> tuple[Arguments, Array, Array]:
    """Span the angle of a turn and the distance of the point, both by the logarithm."""
    angle, distance = np.logspace(-16, 0, size), np.logspace(-3, 3, size)
    upward, across = np.meshgrid(distance, angle, indexing="ij")
    points = upward.reshape(-1, 1) * np.array([0.6, 0.8, 0.3])
    angles = across.reshape(-1, 1) * np.array([0.9, -0.7, 0.4])
    return (points, angles, np.zeros(3)), angle, distance


MAPS = (
    Map(
        "without shift", map_of_turns, "angle, rad", "distance, mm",
        ("direct K^T p - (p - t)", "first order", "kernel"),
        against="across",
    ),
)  # fmt: skip


def circles(rng: np.random.Generator) -> Arguments:
    """Draw track angles: few and many turns, zeros of the cosine, |A| up to R."""
    sizes = np.array([[RADIUS, AMPLITUDE], [RADIUS, -AMPLITUDE], [1.0, 1 - 1e-16], [1.0, 0.99]])
    parts = []
    for (r, a), z in ((s, z) for s in sizes for z in (1.0, 6.0, 7.0)):
        zeros = spread_ulps(np.array([np.pi, np.pi / z, np.pi / 2 / z]), rng)
        phi = np.concatenate([zeros, draw_ladder(rng, 20), rng.uniform(-1e5, 1e5, 10)])
        parts.append((phi, *(np.full(len(phi), v) for v in (r, a, z))))
    return join(*parts)


CIRCLES = (PointSet("circles", circles),)
TRACKS = (PointSet("circles", lambda rng: (*(p := circles(rng)), np.full(len(p[0]), HEIGHT))),)


def circle_load(count: int) -> Arguments:
    """Return N polar angles, one wheel."""
    return np.linspace(0, 2 * np.pi, count), *map(np.array, (RADIUS, AMPLITUDE, 6.0))


def track_load(count: int) -> Arguments:
    """Return N polar angles, one wheel of some height."""
    return *circle_load(count), np.array(HEIGHT)


def vectors(rng: np.random.Generator) -> Arguments:
    """Draw error vectors, their parts of like and of very different sizes, up to 1e+-200."""
    parts = rng.normal(size=(COUNT, 3)) * 10.0 ** rng.integers(-9, 10, (COUNT, 1))
    wild = 10.0 ** rng.uniform(-200, 200, (COUNT, 3))
    return (np.concatenate([parts, wild, parts * 10.0 ** rng.integers(-9, 10, (COUNT, 3))]),)


def vector_load(count: int) -> Arguments:
    """Return N error vectors."""
    return (np.random.default_rng(4).normal(size=(count, 3)),)
