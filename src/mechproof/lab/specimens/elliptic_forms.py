"""The elliptical pair as others compute it: hand-written NumPy, and SciPy's ways."""

from __future__ import annotations

import numpy as np

from mechproof.kernel_support.arrays import in_blocks
from mechproof.kernels import elliptic_planetary as kernels
from mechproof.lab.specimen import Array

KNOTS = 1024


def unwrapped(phi: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Join the branches of the arctangent by np.unwrap."""
    branch = 2 * np.arctan((1 + e) / (1 - e) * np.tan(r1 / r2 * phi / 2))
    return np.asarray(phi + np.unwrap(branch))


def floored(phi: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Count the branches by floor."""
    x = r1 / r2 * phi
    branch = 2 * np.arctan((1 + e) / (1 - e) * np.tan(x / 2))
    return np.asarray(phi + branch + 2 * np.pi * np.floor((x + np.pi) / (2 * np.pi)))


def atan2_form(phi: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Return the popular form: 1 - e cos x cancels near x = 0."""
    x = r1 / r2 * phi
    return np.asarray(phi + x + 2 * np.arctan2(e * np.sin(x), 1 - e * np.cos(x)))


def atan2_stable(phi: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Return the same without the cancellation."""
    x = r1 / r2 * phi
    return np.asarray(phi + x + 2 * np.arctan2(e * np.sin(x), (1 - e) + 2 * e * np.sin(x / 2) ** 2))


def tan_half(phi: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Return the form with one tangent and one arctangent, written by hand."""
    x = r1 / r2 * phi
    t = np.tan(x / 2)
    return np.asarray(phi + x + 2 * np.arctan(2 * e * t / ((1 - e) + (1 + e) * t * t)))


def fourier(terms: int, phi: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Add `terms` terms 2/m e**m sin(m x) by Clenshaw's recurrence."""
    x = r1 / r2 * phi
    twice, first, second = 2 * np.cos(x), np.zeros_like(x), np.zeros_like(x)
    for m in range(terms, 0, -1):
        first, second = twice * first - second + 2 / m * e**m, first
    return np.asarray(phi + x + np.sin(x) * first)


def fourier_single(terms: int, phi: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Add the same terms in float32, whose sine and cosine NumPy has SIMD loops for."""

    def prepare(r1: Array, r2: Array, e: Array) -> tuple[Array, ...]:
        terms_of_sum = (np.float32(2) / m * e**m for m in range(1, terms + 1))
        return r1 / r2, *(np.asarray(a, np.float32)[()] for a in terms_of_sum)

    def evaluate(phi: Array, k: Array, *coefficients: Array) -> Array:
        x = k * phi
        y = (x - 2 * np.pi * np.rint(x / (2 * np.pi))).astype(np.float32)
        twice, first, second = 2 * np.cos(y), np.zeros_like(y), np.zeros_like(y)
        for coefficient in reversed(coefficients):
            first, second = twice * first - second + np.float32(coefficient), first
        return np.asarray(phi + x + np.sin(y) * first)

    return np.asarray(in_blocks(evaluate, (phi,), prepare, (r1, r2, e)))


def simpson(phi: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Integrate the samples of the ratio."""
    from scipy.integrate import cumulative_simpson

    return np.asarray(cumulative_simpson(kernels.ratio(phi, r1, r2, e), x=phi, initial=0))


def integrated(phi: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Solve the differential equation with the tightest usual tolerance."""
    from scipy.integrate import solve_ivp

    done = solve_ivp(
        lambda t, y: [kernels.ratio(t, r1, r2, e)],
        (phi[0], phi[-1]), [0.0], "DOP853", t_eval=phi, rtol=1e-12, atol=1e-12,
    )  # fmt: skip
    return np.asarray(done.y[0])


def splined(phi: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Interpolate the periodic part at 1024 knots; one spline for each eccentricity."""
    from scipy.interpolate import CubicSpline

    knots = np.linspace(0, 2 * np.pi, KNOTS + 1)
    x, eccentricity = np.broadcast_arrays(r1 / r2 * phi, e)
    result = np.empty(x.shape)
    for value in np.unique(eccentricity):
        part = atan2_stable(knots, np.array(1.0), np.array(1.0), value) - 2 * knots
        part[-1] = part[0] = 0.0
        mine = eccentricity == value
        spline = CubicSpline(knots, part, bc_type="periodic")
        result[mine] = spline(x[mine])
    return np.asarray(phi + x + result)


def wrapped_cauchy(phi: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Use the distribution function of the wrapped Cauchy law, turn by turn."""
    from scipy.stats import wrapcauchy

    x = r1 / r2 * phi
    turn = np.floor(x / (2 * np.pi))
    share = wrapcauchy.cdf(x - 2 * np.pi * turn, np.broadcast_to(e, np.shape(x)))
    return np.asarray(phi + 2 * np.pi * (turn + share))


def by_kepler(phi: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Take the true anomaly from kepler.py, x being the eccentric anomaly."""
    from kepler import kepler

    x, largest = r1 / r2 * phi, np.nextafter(1.0, 0.0)
    orbit = np.broadcast_to(np.minimum(2 * e / (1 + e**2), largest), np.shape(x))
    _, cosine, sine = kepler(x - orbit * np.sin(x), orbit)
    turn = 2 * np.pi * np.floor((x + np.pi) / (2 * np.pi))
    return np.asarray(phi + turn + np.arctan2(sine, cosine))


def direct_ratio(phi: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Compute equation (8) as printed."""
    k = r1 / r2
    return np.asarray(1 + k * (1 - e**2) / (1 + e**2 - 2 * e * np.cos(k * phi)))


def stable_ratio(phi: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Compute equation (8) with the half-angle denominator."""
    k = r1 / r2
    below = (1 - e) ** 2 + 4 * e * np.sin(k * phi / 2) ** 2
    return np.asarray(1 + k * (1 - e) * (1 + e) / below)


def direct_acceleration(phi: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Differentiate equation (8) on paper and type it in."""
    k = r1 / r2
    below = 1 + e**2 - 2 * e * np.cos(k * phi)
    return np.asarray(-2 * e * k**2 * (1 - e**2) * np.sin(k * phi) / below**2)


def stable_acceleration(phi: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Compute the same with the half-angle denominator."""
    k = r1 / r2
    below = (1 - e) ** 2 + 4 * e * np.sin(k * phi / 2) ** 2
    return np.asarray(-2 * e * k**2 * (1 - e) * (1 + e) * np.sin(k * phi) / below**2)
