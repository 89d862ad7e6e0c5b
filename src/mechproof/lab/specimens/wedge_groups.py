"""Where single groups of the linkage hurt: the lever, the roller lever, the arms, the clearance."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from mechproof.lab.points import draw_ladder, join, pair_up, spread_ulps
from mechproof.lab.specimen import Arguments
from mechproof.lab.specimens.wedge_points import (
    COUNT,
    dead_centres,
    draw_sizes,
    generic,
    radicand,
    small_motion,
)
from mechproof.lab.subject import PointSet


def of_lever(*makers: Callable[[np.random.Generator], Arguments]) -> Callable[..., Arguments]:
    """Take the lever's arguments of points of the chain."""
    return lambda rng: join(*(make(rng)[:4] for make in makers))


def beyond_right_angle(rng: np.random.Generator) -> Arguments:
    """Draw pushers past the pivot: the lever has turned by more than a right angle."""
    sizes = draw_sizes(rng, COUNT, 0.5)
    x1 = -(sizes[0] + sizes[2]) * rng.uniform(1.0, 4.0, COUNT)
    kept = radicand(x1, sizes) > 0
    return tuple(np.array([x1, *sizes[:3]])[:, kept])


LEVER = (
    PointSet("generic", of_lever(generic)),
    PointSet("small motion", of_lever(small_motion)),
    PointSet("past the pivot", beyond_right_angle),
    PointSet("toward the dead centre", of_lever(dead_centres)),
)


def any_roller(rng: np.random.Generator) -> Arguments:
    """Draw directions in (0, pi) and displacements over all that the roller lever can follow."""
    alpha = rng.uniform(0, np.pi, 2 * COUNT)
    length = 60 * 10 ** rng.uniform(-1, 1, 2 * COUNT)
    ends = -2 * np.sin(alpha / 2) ** 2, 2 * np.cos(alpha / 2) ** 2
    return length * rng.uniform(*ends), length, alpha


def roller_upright(rng: np.random.Generator) -> Arguments:
    """Surround R = 0: up to 1000 ulps of x5, and ladders on both sides."""
    alpha = rng.uniform(0.3, 1.3, 6)
    middle = 60 * np.cos(alpha)
    close = spread_ulps(middle, rng)
    beside = (middle[:, np.newaxis] * (1 + draw_ladder(rng, 20, 1e-15))).ravel()
    x5 = np.concatenate([close, beside])
    repeats = len(close) // len(alpha)
    return x5, np.full(len(x5), 60.0), np.concatenate([np.repeat(alpha, repeats), alpha.repeat(20)])


def roller_small(rng: np.random.Generator) -> Arguments:
    """Climb the ladder of x5 from 0 on."""
    ladder = np.concatenate([[0.0], draw_ladder(rng, COUNT)])
    x5, alpha = pair_up(ladder, np.array([0.4, 1.13, 2.7]))
    return x5, np.full(len(x5), 60.0), alpha


def roller_flat(rng: np.random.Generator) -> Arguments:
    """Go down the ladder to both dead centres, and to directions next to them."""
    distance = np.abs(draw_ladder(rng, COUNT, 1e-14))
    alpha = rng.uniform(0.1, 3.0, COUNT)
    flat = np.where(rng.random(COUNT) < 0.5, distance, np.pi - distance)
    alpha = np.where(np.arange(COUNT) % 2, alpha, flat)
    ends = -2 * np.sin(alpha / 2) ** 2, 2 * np.cos(alpha / 2) ** 2
    part = np.where(rng.random(COUNT) < 0.5, *ends) * (1 - distance)
    return 60 * part, np.full(COUNT, 60.0), alpha


ROLLER = (
    PointSet("generic", any_roller),
    PointSet("R = 0", roller_upright),
    PointSet("small motion", roller_small),
    PointSet("toward dead centres", roller_flat),
)


def arm_angles(rng: np.random.Generator) -> Arguments:
    """Draw turns of an arm: any, small by the ladder, and to where sines of their halves vanish."""
    turned = np.concatenate([rng.uniform(-7, 7, COUNT), draw_ladder(rng, COUNT)])
    direction = rng.uniform(-np.pi, 2 * np.pi, 2 * COUNT)
    direction[::4] = -turned[::4] / 2
    direction[1::4] = np.pi / 2 - turned[1::4] / 2
    return turned, rng.uniform(10, 200, 2 * COUNT), direction


def link_runs(rng: np.random.Generator) -> Arguments:
    """Draw runs around the clearance: exactly it, up to 1000 ulps off, and by the ladder."""
    clearance = rng.uniform(0.1, 5, 4)
    close = spread_ulps(clearance, rng)
    beside = (clearance[:, np.newaxis] * (1 + draw_ladder(rng, 20, 1e-15, 10.0))).ravel()
    given = np.concatenate([clearance.repeat(len(close) // 4), clearance.repeat(20)])
    return np.concatenate([close, beside]), given


ARMS = (PointSet("arms", arm_angles),)
LINKS = (PointSet("around the clearance", link_runs),)
