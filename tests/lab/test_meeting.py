"""The digits that kernels of ovals keep where a wheel's long axis meets the centre line."""

from __future__ import annotations

import numpy as np
from ways import EPS, OVAL, at, bound_of, find_subject, run, truth_of


def find_meeting(e1: float, mount: float) -> float:
    """Return the angle at which the long axis of wheel 6 meets the centre line."""
    return float(np.arctan2(-(1 - e1) * np.sin(mount), (1 + e1) * np.cos(mount)))


def test_beside_the_meeting_the_kernel_keeps_what_the_tangent_leaves() -> None:
    e2, mount = 1 - 1e-12, np.pi / 4
    for h in (1e-3, 1e-5, 1e-7):
        phi1 = find_meeting(0.475, mount) + np.linspace(1, 2, 60) * h
        kernel = run(OVAL, "kernel", at(phi1, 0.475, e2, mount))
        assert np.max(kernel.scaled) <= bound_of(OVAL)
        # The tangent's last bit as amplified by the meeting, and 4 eps of a value below pi.
        assert np.max(kernel.absolute) < EPS * (13 + 1e-12 / h**2 * 40)


def test_what_the_meeting_costs() -> None:
    """The unavoidable error: on the flank of the peak a rounded tangent costs eps/(1 - e2) of W."""
    name = "oval_planetary.ratio"
    for exponent in (3, 6, 9, 12):
        e2, mount = 1 - 10.0**-exponent, np.pi / 4
        width = np.linspace(0.3, 3, 60) * (1 - e2)
        arguments = at(find_meeting(0.2, mount) + width, 0.2, e2, mount)
        errors, truth = run(name, "kernel", arguments), truth_of(name, arguments)
        relative = errors.absolute / np.maximum(1, np.abs(1 - truth.high)) / EPS
        assert 0.05 < relative.max() * (1 - e2) < 8
        assert np.max(errors.scaled) <= bound_of(name)


def test_far_from_the_meeting_the_ratio_is_of_its_largest_term() -> None:
    """Even at e2 = 1 - 1e-12 the scale exceeds 1 and W only where the axes meet."""
    phi1 = np.linspace(-3, 3, 200)
    for e2, mount in ((0.999999, 1.2), (1 - 1e-12, 1.2), (1 - 1e-12, np.pi / 2)):
        truth = truth_of("oval_planetary.ratio", at(phi1, 0.475, e2, mount))
        largest = np.maximum(1, np.abs(1 - truth.high))
        far = np.abs(np.sin(phi1 - find_meeting(0.475, mount))) > 0.1
        assert truth.scale is not None
        assert np.all(truth.scale[far] <= largest[far] * 1.001)


def test_at_rest_there_is_nothing_to_lose() -> None:
    """For circles the value is exactly 0, so no ball decides a digit; ours is 0 to 8 eps of 1."""
    phi1 = np.linspace(-7, 7, 30)
    ratio, position = (find_subject(n).kernel for n in ("oval_planetary.ratio", OVAL))
    assert np.abs(ratio(*at(phi1, 0.0, 0.0, 0.3))).max() <= EPS * 8
    assert not np.any(position(*at(phi1, 0.0, 0.0, 0.3)))
