"""Bars that are not in the derivations' units: orthogonality, and displacement against K - I."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from mechproof.lab.error import find_errors
from mechproof.lab.oracle import find_truth
from mechproof.lab.points import REPORT, draw_points, list_sets
from mechproof.lab.specimen import Array
from mechproof.lab.subject import PointSet, Subject, find_subjects

ROTATION, DISPLACEMENT = (find_subjects((name,))[0] for name in ("rotation", "displacement"))


@pytest.mark.parametrize("point_set", list_sets(ROTATION), ids=lambda s: s.name)
def test_rotation_is_orthogonal(point_set: PointSet) -> None:
    matrices = np.asarray(ROTATION.kernel(*draw_points(point_set, REPORT)), np.longdouble)
    products = np.einsum("nji,njk->nik", matrices, matrices)
    assert np.max(np.abs(products - np.eye(3))) <= 8e-16


def norm_of_turn(subject: Subject, angles: Array) -> Array:
    """Return the norm of K - I, the same across its axis in all directions: Frobenius/sqrt(2)."""
    columns = []
    for axis in np.eye(3):
        points = np.broadcast_to(axis, angles.shape)
        columns.append(find_truth(subject, (points, angles, np.zeros_like(angles))).high)
    norms = [np.hypot(np.hypot(*c.T[:2]), c.T[2]) for c in columns]
    whole: Array = np.hypot(np.hypot(*norms[:2]), norms[2]) / np.sqrt(2)
    return whole


def against_turn(
    points: Array, angles: Array, shift: Array, subject: Subject = DISPLACEMENT
) -> Array:
    """Return the error of the kernel relative to |K - I|*|p| + |t|."""
    truth = find_truth(subject, (points, angles, shift))
    absolute = find_errors(subject.kernel(points, angles, shift), truth).absolute
    size = norm_of_turn(subject, angles) * np.linalg.norm(points, axis=1)
    size += np.linalg.norm(shift, axis=1)
    # A few subnormal spacings are the range of doubles, not the formula.
    visible = np.where(absolute <= 1e-322, 0.0, absolute)
    return np.divide(visible, size, out=np.zeros_like(size), where=size > 0)


@pytest.mark.parametrize("angle", [1e-300, 1e-12, 1e-9, 1e-6, 1e-3, 0.1, 0.5])
def test_displacement_relative_to_the_turn(angle: float) -> None:
    rng = np.random.default_rng(5)
    points = rng.uniform(-50, 50, (40, 3))
    angles = angle * rng.uniform(-1, 1, (40, 3))
    assert np.max(against_turn(points, angles, np.zeros((40, 3)))) <= 3e-15


@pytest.mark.parametrize("step", [1e-12, 1e-8, 1e-3])
def test_displacement_near_three_half_turns(step: float) -> None:
    """Turns by about pi each cancel: K is near I though no angle is small."""
    angles = np.pi + step * np.array([[1.0, 2.0, 1.0]])
    found = against_turn(np.array([[40.0, 1.0, -20.0]]), angles, np.zeros((1, 3)))
    assert found[0] <= 3e-15


def test_the_direct_form_is_beyond_that() -> None:
    """K^T p - p cancels near three half turns: the same measure sees it."""
    direct = next(s for s in DISPLACEMENT.specimens if s.name == "direct K^T p - (p - t)")
    subject = replace(DISPLACEMENT, kernel=direct.compute)
    angles = np.pi + 1e-8 * np.array([[1.0, 2.0, 1.0]])
    found = against_turn(np.array([[40.0, 1.0, -20.0]]), angles, np.zeros((1, 3)), subject)
    assert found[0] > 1e-10
