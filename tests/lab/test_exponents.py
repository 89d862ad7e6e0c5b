"""Bounds hold wherever they are stated, for arguments of every exponent that doubles have.

A bound stated too far fails where squares, cubes and low words leave the range of doubles. Sizes
are drawn evenly by exponent. An angle that a ratio of radii multiplies is drawn by its multiple, or
hardly any would lie where the bound is stated. Seeds are fixed.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

import numpy as np
import pytest
from quantities import KERNELS, find_subject

from mechproof.lab.sampling.draws import draw_published
from mechproof.lab.sampling.stated_sizes import Columns
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Arguments, Array
from mechproof.lab.worst_search import mark_accuracy_domain, scaled_errors
from mechproof.record import LENGTH

# How many powers of ten each band of sizes extends to either side of 1.
BANDS = (3, 20, 160, 308)
TURNED = (["phi1", "R1", "R2"], ["phi1", "R4", "R5"])
DRAWN = 2500
LINKAGE = "wedge_linkage"
# The least number of drawn points where the bound is stated; the most judged for a linkage.
FEW, MOST = 20, 100
# Sums over elements have tests of their own.
NAMES = [name for name in KERNELS if not name.startswith("track_wheel.error_sum")]


def draw_sizes(rng: np.random.Generator) -> Array:
    """Draw sizes evenly by exponent, of either sign, some of them just below 1."""
    sizes = 10.0 ** (rng.uniform(-1, 1, DRAWN) * rng.choice(BANDS, DRAWN))
    below = 1 - 10.0 ** rng.uniform(-16, -1, DRAWN)
    drawn = np.where(rng.random(DRAWN) < 0.15, below, sizes)
    return np.asarray(drawn * rng.choice([1, 1, -1], DRAWN))


def draw_turned(rng: np.random.Generator) -> tuple[Array, Array, Array]:
    """Draw an angle and two radii: first the multiplied angle, near or far from a quarter turn."""
    beside = 10.0 ** rng.uniform(-18, 6, DRAWN) * rng.choice([-1, 1], DRAWN)
    angles = rng.integers(-4, 5, DRAWN) * np.pi / 2 + beside
    driven = 10.0 ** rng.uniform(-150, 150, DRAWN)
    driving = driven * 10.0 ** rng.uniform(-150, 150, DRAWN)
    return angles * (driven / driving), driving, driven


def draw_similar(subject: Subject, rng: np.random.Generator) -> Columns:
    """Draw published sizes, half of them scaled as a whole: other linkages hardly ever close."""
    factor = np.where(rng.random(DRAWN) < 0.5, 10.0 ** rng.uniform(-60, 60, DRAWN), 1)
    sizes = draw_published(subject.facts, rng, DRAWN)
    lengths = {v.symbol for v in subject.paper.variables if v.dimension == LENGTH}
    return {s: c * factor if s in lengths else c for s, c in sizes.items()}


def draw_points(subject: Subject) -> Arguments:
    """Draw points of the domain at which the bound is stated."""
    rng, region = np.random.default_rng(20263), subject.facts.region
    columns = {s: draw_sizes(rng) for s in region.symbols}
    if subject.paper.system == LINKAGE:
        columns |= draw_similar(subject, rng)
    if [a.name for a in subject.quantity.arguments][:3] in TURNED:
        columns |= dict(zip(region.symbols, draw_turned(rng), strict=False))
    for symbol in filter(region.is_count, region.symbols):
        columns[symbol] = np.ceil(np.abs(columns[symbol]))
    inside = region.mark_inside(columns)
    parts = [[columns[s][inside] for s in a.symbols] for a in subject.quantity.arguments]
    points = tuple(np.stack(p, -1) if len(p) > 1 else p[0] for p in parts)
    within = np.flatnonzero(mark_accuracy_domain(subject, points))
    kept = within[:MOST] if subject.paper.system == LINKAGE else within
    return tuple(column[kept] for column in points)


@pytest.mark.thorough
@pytest.mark.parametrize("name", NAMES)
def test_a_bound_holds_wherever_it_is_stated(name: str) -> None:
    subject, (system, _, quantity) = find_subject(name), name.partition(".")
    points = draw_points(subject)
    assert len(points[0]) > FEW
    assert subject.quantity.accuracy is not None
    kernel: Any = getattr(import_module(f"mechproof.kernels.{system}"), quantity)
    errors = scaled_errors(subject, kernel, points)
    worst = int(np.argmax(np.where(np.isnan(errors), np.inf, errors)))
    assert errors[worst] <= subject.quantity.accuracy.ulp, [c[worst] for c in points]


def test_no_step_of_the_jerk_overflows_where_its_bound_is_stated() -> None:
    """The first input, once found, lies beyond; the second has the largest R1/R2 with a bound."""
    subject = find_subject("elliptic_planetary.jerk")
    kernel = import_module("mechproof.kernels.elliptic_planetary").jerk
    ratio = 1e75 * (1 - 2.0**-50)
    points = tuple(
        np.array(pair)
        for pair in (
            (2.3952193734660827e-88, 2 * np.pi / ratio),
            (7.052731365051122e-22, ratio),
            (2.688578798115918e-110, 1.0),
            (0.9999999999999994, 1 - 2.0**-53),
        )
    )
    with np.errstate(over="ignore"):
        errors = scaled_errors(subject, kernel, points)
    assert subject.quantity.accuracy is not None
    assert errors[0] == -1
    assert 0 <= errors[1] <= subject.quantity.accuracy.ulp
