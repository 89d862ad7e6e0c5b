"""Turns meet more than the derivation states: orthogonality, and displacements against K - I."""

from __future__ import annotations

import numpy as np
import pytest
from ways import draw_set, find_subject, find_way, truth_of

from mechproof.lab.oracle import find_errors
from mechproof.lab.sampling.point_sets import list_sets
from mechproof.lab.ways import Array

ROTATION, DISPLACEMENT = "track_wheel.rotation", "track_wheel.displacement"


def test_rotation_is_orthogonal() -> None:
    """Within 3.6 eps; searches find 1.7. The entries' bound would allow 2*sqrt(3)*7 eps."""
    names = [point_set.name for point_set in list_sets(find_subject(ROTATION))]
    assert names
    for name in names:
        found = find_subject(ROTATION).kernel(*draw_set(ROTATION, name))
        matrices = np.asarray(found, np.longdouble)
        products = np.einsum("nji,njk->nik", matrices, matrices)
        assert np.max(np.abs(products - np.eye(3))) <= 8e-16, name


def norm_of_turn(angles: Array) -> Array:
    """Return the norm of K - I: Frobenius/sqrt(2), as all directions across the axis are equal."""
    columns = []
    for axis in np.eye(3):
        points = np.broadcast_to(axis, angles.shape)
        columns.append(truth_of(DISPLACEMENT, (points, angles, np.zeros_like(angles))).high)
    norms = [np.hypot(np.hypot(*c.T[:2]), c.T[2]) for c in columns]
    whole: Array = np.hypot(np.hypot(*norms[:2]), norms[2]) / np.sqrt(2)
    return whole


def against_turn(points: Array, angles: Array, way: str = "kernel") -> Array:
    """Return the error relative to |K - I|*|p|."""
    arguments = points, angles, np.zeros_like(points)
    result = find_way(DISPLACEMENT, way).compute(*arguments)
    absolute = find_errors(result, truth_of(DISPLACEMENT, arguments)).absolute
    size = norm_of_turn(angles) * np.linalg.norm(points, axis=1)
    # A few subnormal spacings are due to the range of doubles, not to the formula.
    visible = np.where(absolute <= 1e-322, 0.0, absolute)
    return np.divide(visible, size, out=np.zeros_like(size), where=size > 0)


@pytest.mark.parametrize("angle", [1e-300, 1e-12, 1e-9, 1e-6, 1e-3, 0.1, 0.5])
def test_displacement_relative_to_the_turn(angle: float) -> None:
    rng = np.random.default_rng(5)
    points = rng.uniform(-50, 50, (40, 3))
    angles = angle * rng.uniform(-1, 1, (40, 3))
    assert np.max(against_turn(points, angles)) <= 2e-15


@pytest.mark.parametrize("step", [1e-12, 1e-8, 1e-3])
def test_displacement_near_three_half_turns(step: float) -> None:
    """Three turns by about pi cancel: K is near I although no angle is small."""
    angles = np.pi + step * np.array([[1.0, 2.0, 1.0]])
    assert against_turn(np.array([[40.0, 1.0, -20.0]]), angles)[0] <= 2e-15


def test_the_direct_form_is_beyond_that() -> None:
    """Entries of K minus ones cancel near three half turns, which the same measure shows."""
    angles = np.pi + 1e-8 * np.array([[1.0, 2.0, 1.0]])
    direct = against_turn(np.array([[40.0, 1.0, -20.0]]), angles, "direct (K^T - I)*p + t")
    assert direct[0] > 1e-10
