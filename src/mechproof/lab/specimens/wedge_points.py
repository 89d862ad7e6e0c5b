"""Where the linkage hurts: small motion, the clearance's edge, R = 0, the dead centres."""

from __future__ import annotations

import numpy as np

from mechproof.kernels import wedge_linkage as kernels
from mechproof.lab.points import draw_ladder, draw_within, join, spread_ulps
from mechproof.lab.specimen import Arguments, Array
from mechproof.lab.subject import Box, Cells, PointSet
from mechproof.wedge_linkage import WedgeLinkage

EPS = float(np.finfo(float).eps)
COUNT = 60
# Sizes of both reconstructions: nominal, lower and upper limit; in the order of the arguments.
TABLES = [WedgeLinkage.published_sizes(number).values() for number in (1, 2)]
NOMINAL = np.array([[size.nominal for size in table] for table in TABLES])
LIMITS = np.array([[size.limits for size in table] for table in TABLES])
L_BC, L_GH, L_KL, ALPHA_KL = 1, 4, 5, 8
STROKE = 40.0
# Relative error that the kernel's rod may have, of what its inputs' rounding makes of it.
ROD_ULP = 16

CELLS = (Cells("x1", (0.0, 1.0, 10.0, 20.0, STROKE)),)


def draw_sizes(rng: np.random.Generator, count: int, spread: float) -> Array:
    """Draw sizes of both sets, off by up to `spread` of themselves; shape (10, count)."""
    nominal = NOMINAL[rng.integers(0, 2, count)].T
    sizes: Array = nominal * (1 + rng.uniform(-spread, spread, nominal.shape))
    return sizes


def run_of(x1: Array, sizes: Array) -> Array:
    """Return the displacement of the rod."""
    l_ab, l_bc, l_cd, l_de, alpha_de = sizes[[0, 1, 2, 3, 7]]
    turned = kernels.lever_angle(x1, l_ab, l_bc, l_cd)
    return np.asarray(kernels.rod_displacement(turned, l_de, alpha_de))


def radicand(x1: Array, sizes: Array) -> Array:
    """Return the square of the present length of the guide."""
    return np.asarray(sizes[L_BC] ** 2 + x1 * (2 * (sizes[0] + sizes[2]) + x1))


def closing(x1: Array, sizes: Array) -> Arguments:
    """Keep the points at which the linkage closes, by a margin for the rounding here."""
    margin = 1 + 8 * EPS
    with np.errstate(invalid="ignore"):
        push = np.maximum(0, run_of(x1, sizes) - sizes[L_GH])
        room = 2 * sizes[L_KL] * np.cos(sizes[ALPHA_KL] / 2) ** 2
        kept = (radicand(x1, sizes) > 0) & (push * margin < room)
    return tuple(np.array([x1, *sizes])[:, kept])


def generic(rng: np.random.Generator) -> Arguments:
    """Draw the working stroke of both sets, and sizes off by half."""
    near = closing(rng.uniform(-STROKE, 0, COUNT), draw_sizes(rng, COUNT, 0.02))
    wide = closing(rng.uniform(-60, 40, 2 * COUNT), draw_sizes(rng, 2 * COUNT, 0.5))
    return join(near, wide)


def limit_combinations(rng: np.random.Generator) -> Arguments:
    """Draw from all combinations of limits of both sets."""
    chosen = rng.integers(0, 2, (2 * COUNT, 10, 1))
    sizes = np.take_along_axis(LIMITS[rng.integers(0, 2, 2 * COUNT)], chosen, axis=2)[..., 0].T
    return closing(rng.uniform(-STROKE, 0, 2 * COUNT), sizes)


def small_motion(rng: np.random.Generator) -> Arguments:
    """Climb the ladder of x1 to either side, the clearance a part of the rod's run."""
    x1 = draw_ladder(rng, 2 * COUNT, 1e-250)
    sizes = draw_sizes(rng, 2 * COUNT, 0.02)
    sizes[L_GH] = np.abs(run_of(x1, sizes)) * rng.uniform(0.01, 1.2, 2 * COUNT)
    return closing(x1, sizes)


def clearance_edge(rng: np.random.Generator) -> Arguments:
    """Set the clearance to the rod's run, exactly and up to 1000 ulps off, and by the ladder."""
    parts = []
    for x1 in rng.uniform(-STROKE, -1, 3):
        sizes = draw_sizes(rng, 1, 0.02)
        run = run_of(np.array([x1]), sizes)
        clearance = np.concatenate([spread_ulps(run, rng), run * (1 + draw_ladder(rng, 30, 1e-15))])
        many = np.repeat(sizes, len(clearance), axis=1)
        many[L_GH] = clearance
        parts.append(closing(np.full(len(clearance), x1), many))
    return join(*parts)


def find_r_zero(sizes: Array) -> Array:
    """Return the x1 of the working stroke next to R = 0, by bisection."""
    low, high = np.full(sizes.shape[1], -STROKE), np.zeros(sizes.shape[1])
    for _ in range(80):
        middle = (low + high) / 2
        r = sizes[L_KL] * np.cos(sizes[ALPHA_KL]) - run_of(middle, sizes) + sizes[L_GH]
        low, high = np.where(r > 0, low, middle), np.where(r > 0, middle, high)
    return low


def upright(rng: np.random.Generator) -> Arguments:
    """Surround R = 0: up to 1000 ulps of x1, and ladders on both sides."""
    parts = []
    for column in draw_sizes(rng, 3, 0.02).T:
        sizes = column[:, np.newaxis]
        middle = find_r_zero(sizes)
        x1 = np.concatenate([spread_ulps(middle, rng), middle * (1 + draw_ladder(rng, 20, 1e-15))])
        parts.append(closing(x1, np.repeat(sizes, len(x1), axis=1)))
    return join(*parts)


def dead_guide(x1_part: Array, sizes: Array) -> Array:
    """Return x1 by its relative distance from where a short guide has no length left."""
    arm, l_bc = sizes[0] + sizes[2], sizes[L_BC]
    return np.asarray(-(l_bc**2) / (arm + np.sqrt(arm**2 - l_bc**2)) * (1 - x1_part))


def dead_centres(rng: np.random.Generator) -> Arguments:
    """Go down the ladder to the dead centres: of the guide, and of the roller lever."""
    distance = np.abs(draw_ladder(rng, COUNT, 1e-14))
    short = draw_sizes(rng, COUNT, 0.02)
    short[L_BC] *= 0.4
    guide = closing(dead_guide(distance, short), short)
    flat, x1 = draw_sizes(rng, COUNT, 0.02), rng.uniform(-STROKE, -10, COUNT)
    push = run_of(x1, flat) - flat[L_GH]
    flat[L_KL] = push / (2 * np.cos(flat[ALPHA_KL] / 2) ** 2) * (1 + distance)
    return join(guide, closing(x1, flat))


CHAIN = (
    PointSet("generic", generic),
    PointSet("limit combinations", limit_combinations),
    PointSet("small motion", small_motion),
    PointSet("clearance's edge", clearance_edge),
    PointSet("R = 0", upright),
    PointSet("toward dead centres", dead_centres),
)


def off_the_edge(x1: Array, *columns: Array) -> Array:
    """Mark the points of the bars of derivatives: the rounded run tells whether there is contact.

    At the clearance's edge a derivative jumps, so that its conditioning is infinite.
    """
    sizes = np.array(np.broadcast_arrays(*columns, x1)[:-1])
    run, l_ab, l_bc, l_cd, l_de = run_of(x1, sizes), *sizes[:4]
    alpha_de = sizes[7]
    turned = kernels.lever_angle(x1, l_ab, l_bc, l_cd)
    guide = np.sqrt(radicand(x1, sizes))
    by_lever = np.abs(x1 * np.cos(turned)) + np.abs(l_bc * np.sin(turned))
    by_lever += (l_ab + l_cd) * (1 - np.cos(turned))
    moved = np.abs(l_de * np.sin(alpha_de + turned)) * by_lever / guide
    moved += np.abs(alpha_de * l_de * (np.sin(alpha_de) - np.sin(alpha_de + turned)))
    unsure = ROD_ULP * EPS * (2 * np.abs(run) + moved)
    return np.asarray(np.abs(run - sizes[L_GH]) > unsure)


def in_cell(rng: np.random.Generator, box: Box) -> Arguments:
    """Draw displacements of one box, sizes within the limits of both sets or at them."""
    x1 = -np.abs(draw_within(rng, COUNT, *box["x1"]))
    part = rng.random((COUNT, 10))
    part[::2] = np.round(part[::2])
    low, high = np.moveaxis(LIMITS[rng.integers(0, 2, COUNT)], -1, 0)
    return x1, *np.clip(low + (high - low) * part, low, high).T
