"""The oval pairs as others compute them: hand-written NumPy, and SciPy's ways."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from mechproof.kernels import oval_planetary as kernels
from mechproof.lab.specimen import Array

Function = Callable[..., Array]


def lead(e: Array, angle: Array) -> Array:
    """Return by how much the driven oval is ahead: 1 - e cos 2 phi cancels near 0."""
    return np.asarray(np.arctan2(e * np.sin(2 * angle), 1 - e * np.cos(2 * angle)))


def atan2_form(phi: Array, e1: Array, e2: Array, mount: Array) -> Array:
    """Add the leads of both pairs, wheel 6 turned by its mount; the popular form."""
    wheel_6 = phi + lead(e1, phi) + mount
    return np.asarray(phi - (wheel_6 + lead(e2, wheel_6) - mount - lead(e2, mount)))


def driven_tangent(phi: Array, e: Array) -> Array:
    """Return arctan((1 + e)/(1 - e) tan(phi)), one branch."""
    return np.asarray(np.arctan((1 + e) / (1 - e) * np.tan(phi)))


def driven_floor(phi: Array, e: Array) -> Array:
    """Return the same with the branches counted by floor."""
    return np.asarray(driven_tangent(phi, e) + np.pi * np.floor(phi / np.pi + 0.5))


def _through_both(driven: Function, phi: Array, e1: Array, e2: Array, mount: Array) -> Array:
    wheel_6 = driven(phi, e1)
    return np.asarray(phi - (driven(wheel_6 + mount, e2) - driven(mount, e2)))


def floored(phi: Array, e1: Array, e2: Array, mount: Array) -> Array:
    """Send the angle through both pairs, branches counted by floor."""
    return _through_both(driven_floor, phi, e1, e2, mount)


def unwrapped(phi: Array, e1: Array, e2: Array, mount: Array) -> Array:
    """Send it through both pairs, branches joined by np.unwrap with the period pi."""
    wheel_6 = np.unwrap(driven_tangent(phi, e1), period=np.pi)
    wheel_3 = np.unwrap(driven_tangent(wheel_6 + mount, e2), period=np.pi)
    return np.asarray(phi - (wheel_3 - driven_tangent(mount, e2)))


def by_tangent(phi: Array, e1: Array, e2: Array, mount: Array) -> Array:
    """Compute the one arctangent from unsplit coefficients, as the Moebius map gives them."""
    alpha, beta, gamma = coefficients(e1, e2, mount)
    t = np.tan(phi)
    return np.asarray(np.arctan2(t * (gamma * t - alpha + beta), beta + gamma * t + alpha * t * t))


def coefficients(e1: Array, e2: Array, mount: Array) -> tuple[Array, Array, Array]:
    """Return the coefficients of tan(chi) as printed in the ledger, with cos and sin of 2 mount."""
    return (
        np.asarray((1 + e1) * (1 - e2**2)),
        np.asarray((1 - e1) * (1 + e2**2 - 2 * e2 * np.cos(2 * mount))),
        np.asarray(2 * (1 + e1) * e2 * np.sin(2 * mount)),
    )


def simpson(phi: Array, e1: Array, e2: Array, mount: Array) -> Array:
    """Integrate the samples of the ratio: the paper's integral (11)."""
    from scipy.integrate import cumulative_simpson

    return np.asarray(cumulative_simpson(kernels.ratio(phi, e1, e2, mount), x=phi, initial=0))


def _solve(ratio: Function, phi: Array, sizes: tuple[Array, ...]) -> Array:
    """Solve the differential equation with the tightest usual tolerance."""
    from scipy.integrate import solve_ivp

    done = solve_ivp(
        lambda t, y: [ratio(t, *sizes)],
        (phi[0], phi[-1]), [0.0], "DOP853", t_eval=phi, rtol=1e-12, atol=1e-12,
    )  # fmt: skip
    return np.asarray(done.y[0])


def integrated(phi: Array, e1: Array, e2: Array, mount: Array) -> Array:
    """Solve the differential equation of the integral (11)."""
    return _solve(kernels.ratio, phi, (e1, e2, mount))


def printed_ratio(phi: Array, e1: Array, e2: Array, mount: Array) -> Array:
    """Compute equations (3)-(6) and (10) as printed, a = 1, with the sign of the mechanics."""
    wheel_6 = phi + lead(e1, phi)
    rho5 = (1 - e1**2) / (1 - e1 * np.cos(np.pi - 2 * wheel_6))
    rho6 = (1 - e2**2) / (1 - e2 * np.cos(2 * (wheel_6 + mount)))
    return np.asarray(2 * (rho5 - rho6) / (rho5 * (2 - rho6)))


def direct_ratio(phi: Array, e1: Array, e2: Array, mount: Array) -> Array:
    """Compute the definition with double angles."""
    alpha, beta, gamma = coefficients(e1, e2, mount)
    c, s = np.cos(2 * phi), np.sin(2 * phi)
    square = beta**2 * (1 + c) + 2 * beta * gamma * s + (alpha**2 + gamma**2) * (1 - c)
    return np.asarray(1 - 2 * alpha * beta / square)


def direct_acceleration(phi: Array, e1: Array, e2: Array, mount: Array) -> Array:
    """Compute the derivative with double angles."""
    alpha, beta, gamma = coefficients(e1, e2, mount)
    c, s = np.cos(2 * phi), np.sin(2 * phi)
    square = beta**2 * (1 + c) + 2 * beta * gamma * s + (alpha**2 + gamma**2) * (1 - c)
    tilt = 2 * beta * gamma * c + (alpha**2 - beta**2 + gamma**2) * s
    return np.asarray(4 * alpha * beta * tilt / square**2)


# A cylindrical pair 4-5 ----------------------------------------------------------------------


def atan2_cylindrical(phi: Array, r4: Array, r5: Array, e2: Array) -> Array:
    """Return the popular form: 1 - e cos x cancels near x = 0."""
    return np.asarray((1 - r4 / r5) * phi - lead(e2, r4 / r5 * phi))


def stable_cylindrical(phi: Array, r4: Array, r5: Array, e2: Array) -> Array:
    """Return the same without the cancellation."""
    half = r4 / r5 * phi
    below = (1 - e2) + 2 * e2 * np.sin(half) ** 2
    return np.asarray((1 - r4 / r5) * phi - np.arctan2(e2 * np.sin(2 * half), below))


def floored_cylindrical(phi: Array, r4: Array, r5: Array, e2: Array) -> Array:
    """Count the branches by floor."""
    return np.asarray(phi - driven_floor(r4 / r5 * phi, e2))


def unwrapped_cylindrical(phi: Array, r4: Array, r5: Array, e2: Array) -> Array:
    """Join the branches by np.unwrap with the period pi."""
    return np.asarray(phi - np.unwrap(driven_tangent(r4 / r5 * phi, e2), period=np.pi))


def simpson_cylindrical(phi: Array, r4: Array, r5: Array, e2: Array) -> Array:
    """Integrate the samples of the ratio: the paper's integral (11)."""
    from scipy.integrate import cumulative_simpson

    return np.asarray(
        cumulative_simpson(kernels.ratio_cylindrical(phi, r4, r5, e2), x=phi, initial=0)
    )


def integrated_cylindrical(phi: Array, r4: Array, r5: Array, e2: Array) -> Array:
    """Solve the differential equation of the integral (11)."""
    return _solve(kernels.ratio_cylindrical, phi, (r4, r5, e2))


def printed_ratio_cylindrical(phi: Array, r4: Array, r5: Array, e2: Array) -> Array:
    """Compute equations (4) and (10) as printed, with the sign of the mechanics."""
    a = (r4 + r5) / 2
    rho6 = a * (1 - e2**2) / (1 - e2 * np.cos(2 * r4 / r5 * phi))
    return np.asarray((r5 - rho6) * 2 * a / (r5 * (2 * a - rho6)))


def stable_ratio_cylindrical(phi: Array, r4: Array, r5: Array, e2: Array) -> Array:
    """Compute the ratio with the half-angle denominator."""
    k = r4 / r5
    below = (1 - e2) ** 2 + 4 * e2 * np.sin(k * phi) ** 2
    return np.asarray(1 - k * (1 - e2) * (1 + e2) / below)


def direct_acceleration_cylindrical(phi: Array, r4: Array, r5: Array, e2: Array) -> Array:
    """Differentiate on paper and type it in."""
    k = r4 / r5
    below = 1 + e2**2 - 2 * e2 * np.cos(2 * k * phi)
    return np.asarray(4 * e2 * k**2 * (1 - e2**2) * np.sin(2 * k * phi) / below**2)
