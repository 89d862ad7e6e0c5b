"""Kernels of the oval wheels against their definitions, at points chosen to hurt.

The bounds are those of the worst case (derived beside the quantities): there is no false alarm
to allow for; the random points have fixed seeds.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from itertools import product
from typing import Any

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from scipy.integrate import quad
from weights import first_of

from mechproof.derivation import load_packaged
from mechproof.kernels import oval_planetary as kernels
from mechproof.record import Quantity

EPS = float(np.finfo(float).eps)
# The smallest angle is 1e-100 and the definitions subtract its cosine from one.
DIGITS = 250
ECCENTRICITIES = (0.0, 1e-9, 0.2, 0.9, 1 - 1e-12)
MOUNTS = (0.0, 1e-9, math.pi / 4, math.pi / 2, -1.2)
RADII = ((25.0, 25.0), (30.0, 20.0), (32.0, 18.0), (18.0, 32.0), (50.3, 0.7))
LADDER = tuple(10.0**-k for k in (1, 8, 16, 40, 100))
Point = tuple[float, ...]


def near(value: float) -> tuple[float, ...]:
    return (float(np.nextafter(value, 0)), value, float(np.nextafter(value, np.inf)))


def oval_points() -> Iterator[Point]:
    random = np.random.default_rng(20240)
    for e1, e2, mount in product(ECCENTRICITIES, ECCENTRICITIES, MOUNTS):
        angles = [0.0, float(random.choice(LADDER)), -1.0, float(random.uniform(-1e6, 1e6))]
        angles += near(math.pi / 2 * int(random.integers(1, 5)))[::2]
        # Where both oval pairs change fastest, and where a mount makes beta + gamma*t vanish.
        beta = (1 - e1) * math.hypot((1 - e2) * math.cos(mount), (1 + e2) * math.sin(mount)) ** 2
        gamma = 2 * (1 + e1) * e2 * math.sin(2 * mount)
        angles += [(1 - e1) * (1 - e2), math.atan2(-beta, gamma)]
        yield from ((angle, e1, e2, mount) for angle in angles)


def cylinder_points() -> Iterator[Point]:
    random = np.random.default_rng(20241)
    for e2, (r4, r5) in product(ECCENTRICITIES, RADII):
        angles = [0.0, *LADDER, *random.uniform(-30, 30, 6), *random.uniform(-1e6, 1e6, 3)]
        for turns in (1, 2, 3, 101, 100_000):
            angles += near(turns * math.pi * r5 / r4 / 2)
        angles += [(1 - e2) * r5 / r4]
        far = (1 - e2) / (4 * EPS) * r5 / r4 / 2
        yield from ((float(phi), r4, r5, e2) for phi in angles if abs(phi) <= far)


def points_of(name: str) -> Iterator[Point]:
    return cylinder_points() if name.endswith("cylindrical") else oval_points()


def quantity_of(name: str) -> Quantity:
    return next(q for q in load_packaged("oval_planetary").quantities if q.name == name)


def oracle(quantity: Quantity, expression: sp.Expr) -> Callable[..., Any]:
    inputs = [s for a in quantity.arguments for s in a.symbols]
    variables = load_packaged("oval_planetary").variables
    given = {v.symbol: v.given for v in variables if v.given is not None}
    function: Callable[..., Any] = sp.lambdify(
        inputs, expression.subs(given).subs(given), "mpmath", cse=True
    )
    return function


def measure(name: str, function: Callable[..., Any]) -> float:
    """Return the worst error in eps of the bound's scale; infinite where the result is NaN."""
    quantity = quantity_of(name)
    assert quantity.accuracy is not None
    assert quantity.accuracy.scale is not None
    exact = oracle(quantity, quantity.definition)
    scale = oracle(quantity, quantity.accuracy.scale.written_out())
    points = list(points_of(name))
    with np.errstate(all="raise", under="ignore"):
        found = function(*np.array(points).T)
    assert found.shape == (len(points),)
    worst = 0.0
    with mp.workdps(DIGITS):
        for point, value in zip(points, found, strict=True):
            if not math.isfinite(value):
                return math.inf
            at = tuple(map(mp.mpf, point))
            error = abs(mp.mpf(float(value)) - exact(*at))
            # Smaller errors are roundings of the definition itself, where the value is zero.
            if error > mp.mpf(10) ** (20 - DIGITS):
                worst = max(worst, float(error / (EPS * scale(*at))))
    return worst


@pytest.mark.slow
@pytest.mark.parametrize("name", first_of(["ratio", *sorted({*kernels.__all__} - {"ratio"})]))
def test_bound(name: str) -> None:
    accuracy = quantity_of(name).accuracy
    assert accuracy is not None
    assert measure(name, getattr(kernels, name)) <= accuracy.ulp


def direct_ratio(phi1: Any, e1: Any, e2: Any, mount: Any) -> Any:
    alpha = (1 + e1) * (1 - e2**2)
    beta = (1 - e1) * (1 + e2**2 - 2 * e2 * np.cos(2 * mount))
    gamma = 2 * (1 + e1) * e2 * np.sin(2 * mount)
    c, s = np.cos(2 * phi1), np.sin(2 * phi1)
    square = beta**2 * (1 + c) + 2 * beta * gamma * s + (alpha**2 + gamma**2) * (1 - c)
    return 1 - 2 * alpha * beta / np.maximum(square, 1e-300)


def one_pair_position(phi1: Any, e1: Any, e2: Any, mount: Any) -> Any:
    """Compute the position as if the pairs were mounted as in the paper, whatever `mount` is."""
    return kernels.position(phi1, e1, e2) + 0 * mount


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "wrong"), first_of([("ratio", direct_ratio), ("position", one_pair_position)])
)
def test_the_measure_rejects(name: str, wrong: Callable[..., Any]) -> None:
    accuracy = quantity_of(name).accuracy
    assert accuracy is not None
    assert measure(name, wrong) > 1000 * accuracy.ulp


# quad's own estimate is 1e-11 here; the integrand is smooth, with peaks some 1 - e wide.
@pytest.mark.parametrize("mount", [0.0, 0.4, math.pi / 2, 2.5])
@pytest.mark.parametrize("turns", [0.1, 0.5, 1.75, 3.3])
def test_position_is_the_integral_of_the_ratio(mount: float, turns: float) -> None:
    end = 2 * math.pi * turns
    for e1, e2 in ((0.2, 0.2), (0.5, 0.3), (0.0, 0.7)):
        area, _ = quad(kernels.ratio, 0, end, (e1, e2, mount), epsabs=1e-11, limit=400)
        assert kernels.position(end, e1, e2, mount) == pytest.approx(area, abs=1e-10)
    area, _ = quad(kernels.ratio_cylindrical, 0, end, (30, 20, 0.2), epsabs=1e-11, limit=400)
    assert kernels.position_cylindrical(end, 30, 20, 0.2) == pytest.approx(area, abs=1e-10)


def test_acceleration_is_the_slope_of_the_ratio() -> None:
    # Central difference with h = 1e-5: error h**2/6 times the third derivative, about 1e-7.
    phi, h = np.linspace(-3, 3, 41), 1e-5
    for kernel, slope, rest in (
        (kernels.ratio, kernels.acceleration, (0.3, 0.2, 0.7)),
        (kernels.ratio_cylindrical, kernels.acceleration_cylindrical, (30, 20, 0.2)),
    ):
        difference = (kernel(phi + h, *rest) - kernel(phi - h, *rest)) / (2 * h)
        np.testing.assert_allclose(slope(phi, *rest), difference, atol=1e-6)


def simulate(phi1: float, e1: float, e2: float, mount: float) -> float:
    """Roll the ovals: integrate the satellite's angle, then the velocity plan, in one system."""
    from scipy.integrate import solve_ivp

    def rates(phi: float, angles: Any) -> list[float]:
        wheel_6, _ = angles
        rho5 = (1 - e1**2) / (1 - e1 * math.cos(math.pi - 2 * wheel_6))
        rho6 = (1 - e2**2) / (1 - e2 * math.cos(2 * (wheel_6 + mount)))
        return [(2 - rho5) / rho5, 2 * (rho5 - rho6) / (rho5 * (2 - rho6))]

    solved = solve_ivp(rates, (0, phi1), [0.0, 0.0], rtol=1e-10, atol=1e-12, method="DOP853")
    return float(solved.y[1, -1])


@pytest.mark.parametrize("mount", [0.0, 0.4, math.pi / 2, -1.0])
def test_position_against_the_rolling_ovals(mount: float) -> None:
    """Independent of the closed forms: only radii, rolling and the velocity plan."""
    for e1, e2 in ((0.2, 0.2), (0.5, 0.3)):
        found = simulate(7.0, e1, e2, mount)
        # The solver keeps 1e-10 per step of some hundred.
        assert kernels.position(7.0, e1, e2, mount) == pytest.approx(found, abs=1e-7)


def test_types_shapes_and_domain() -> None:
    phi = np.linspace(-1, 1, 5)
    assert kernels.position(phi[:, None], 0.2, [0.1, 0.3, 0.5]).shape == (5, 3)
    assert isinstance(kernels.ratio(1.0, 0.2, 0.2), np.float64)
    assert kernels.acceleration(phi.astype(np.float32), np.float32(0.2), np.float32(0.2)).dtype == (
        np.float32
    )
    for name in ("ratio", "position", "acceleration"):
        outside = getattr(kernels, name)(0.3, [1.0, -0.1, 0.2, np.nan], [0.2, 0.2, 1.0, 0.2])
        assert np.isnan(outside).all()
        outside = getattr(kernels, f"{name}_cylindrical")(
            0.3, [-1, 1, 1], [1, np.inf, 1], [0, 0, 1]
        )
        assert np.isnan(outside).all()
        assert np.isnan(getattr(kernels, name)(np.nan, 0.2, 0.2))
        with pytest.raises(TypeError, match="e1"):
            getattr(kernels, name)(0.3, 0.2j, 0.2)
