"""Kernels of the tooth thickness against their definitions, at points chosen to hurt.

The bounds are worst-case bounds (derived beside the quantities), so there is no false alarm to
allow for; the random points have fixed seeds.
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

from mechproof.derivations.tooth_thickness import PAPER, mechanics
from mechproof.kernels import tooth_thickness as kernels
from mechproof.kernels.forms import tooth_thickness as forms
from mechproof.record import Accuracy, Quantity

EPS = float(np.finfo(float).eps)
# The smallest tilt is 1e-100 and the definition cancels its square against one.
DIGITS = 330
ANGLES = (1e-6, 0.25, math.pi / 9, 0.61, math.nextafter(math.pi / 4, 0))
TEETH = (4, 5, 17, 50, 1000, 10**6)
MODULES = (1e-3, 3.0, 1e3)
LADDER = (1e-100, 1e-16, 1e-8, 1e-5, 1e-3, 0.1)
Point = tuple[float, ...]
QUANTITIES = {q.name: q for q in PAPER.quantities}
GIVEN = {v.symbol: v.given for v in PAPER.variables if v.given is not None}


def oracle(quantity: Quantity, expression: sp.Expr) -> Callable[..., Any]:
    inputs = [s for a in quantity.arguments for s in a.symbols]
    function: Callable[..., Any] = sp.lambdify(inputs, expression.subs(GIVEN), "mpmath")
    return function


def sizes() -> Iterator[Point]:
    random = np.random.default_rng(30)
    yield from product(MODULES, ANGLES)
    yield from ((float(m), float(a)) for m, a in random.uniform((0.1, 0.2), (20, 0.6), (40, 2)))


def flanks() -> Iterator[Point]:
    random = np.random.default_rng(31)
    for z, alpha in product(TEETH, ANGLES):
        tilts = [0.0, -alpha, math.pi / 2 - alpha, *LADDER, *(-t for t in LADDER if t < alpha)]
        tilts += list(random.uniform(-alpha, 0.5, 6))
        yield from ((float(t), 3.0, z, alpha) for t in tilts)


def heights() -> Iterator[Point]:
    for z, alpha, m in product(TEETH, ANGLES, MODULES):
        deepest = float(kernels.height_change(-alpha, m, z, alpha))
        parts = (0.0, 1e-100, 1e-9, 0.1, 0.9, 1 - 1e-9)
        yield from ((sign * part * deepest, m, z, alpha) for part in parts for sign in (1, -1))


def errors() -> Iterator[Point]:
    yield from product((0.0, 0.025, -1e-9), (0.0, 0.0125, -3e-3), ANGLES)


POINTS: dict[str, Callable[[], Iterator[Point]]] = {
    "constant_chord": sizes,
    "chord_height": sizes,
    "height_change": flanks,
    "thickness_change": flanks,
    "thickness_change_linear": lambda: product((0.0, 1e-300, -0.1, 7.0), ANGLES),
    "linearisation_bound": heights,
    "thickness_error": errors,
}


def accuracy_of(name: str) -> Accuracy:
    accuracy = QUANTITIES[name].accuracy
    assert accuracy is not None
    return accuracy


def measure(name: str, function: Callable[..., Any]) -> float:
    """Return the worst error in units of eps times the scale of the accuracy."""
    quantity = QUANTITIES[name]
    written = accuracy_of(name).scale
    exact = oracle(quantity, quantity.definition)
    scale = oracle(quantity, written.written_out() if written else sp.Abs(quantity.definition))
    worst = 0.0
    with mp.workdps(DIGITS):
        for point in POINTS[name]():
            values = [mp.mpf(float(value)) for value in point]
            got = float(function(*point))
            if not math.isfinite(got):
                return math.inf
            error = abs(mp.mpf(got) - exact(*values))
            # Two subnormal spacings: below them no double is nearer.
            if error > 1e-323:
                size = EPS * scale(*values)
                worst = max(worst, float(error / size) if size else math.inf)
    return worst


def test_every_quantity_has_points() -> None:
    assert set(QUANTITIES) == set(POINTS)


@pytest.mark.slow
@pytest.mark.parametrize("name", POINTS)
def test_accuracy(name: str) -> None:
    assert measure(name, getattr(kernels, name)) <= accuracy_of(name).ulp


def test_the_measure_rejects_the_direct_formula_and_nan() -> None:
    direct = forms.height_change_distances
    assert measure("height_change", direct) > 1000 * accuracy_of("height_change").ulp
    assert measure("constant_chord", lambda m, alpha: math.nan) == math.inf
    assert measure("constant_chord", lambda m, alpha: math.pi * m / 2 * math.cos(alpha)) > 1e6


def on_involute(tilt: float, m: float, z: int, alpha: float) -> tuple[Any, Any]:
    """Return the changes of height and thickness from the polar equation of the involute."""
    base, start = mp.mpf(m) * z * mp.cos(alpha) / 2, mp.pi / (2 * z) + mp.tan(alpha) - alpha
    roll = alpha + mp.mpf(tilt) + start
    radius, angle = base * mp.sqrt(1 + roll**2), start - (roll - mp.atan(roll))
    nominal = mp.mpf(m) * (mp.mpf(z) / 2 + mp.pi * mp.sin(2 * mp.mpf(alpha)) / 8)
    chord = mp.pi * m * mp.cos(alpha) ** 2 / 2
    return nominal - radius * mp.cos(angle), 2 * radius * mp.sin(angle) - chord


@pytest.mark.parametrize("z", TEETH[:4])
def test_flank_is_the_polar_involute(z: int) -> None:
    with mp.workdps(40):
        for tilt in (-0.3, -0.01, 0.0, 0.02, 0.2):
            point = tilt, 3.0, z, math.pi / 9
            height, thickness = on_involute(*point)
            # The bounds, 15 and 29 eps of r_b*|tilt|*(1 + t_c + |tilt|) <= 71*0.3*2.1.
            assert abs(height - float(kernels.height_change(*point))) < 15 * EPS * 45
            assert abs(thickness - float(kernels.thickness_change(*point))) < 29 * EPS * 45


def test_bound_of_the_linear_model_holds_and_is_tight() -> None:
    """Without rounding: 0 <= linear - exact <= bound, for every size of wheel."""
    bound = oracle(QUANTITIES["linearisation_bound"], mechanics.linearisation_bound)
    height = oracle(QUANTITIES["height_change"], mechanics.height_change)
    thickness = oracle(QUANTITIES["height_change"], mechanics.thickness_change)
    ratios = []
    with mp.workdps(60):
        for z, alpha in product(TEETH, (0.1, 0.25, mp.pi / 9, 0.5, 0.7)):
            deepest = height(-mp.mpf(alpha), 1, z, mp.mpf(alpha))
            tip = 1 - mp.pi / 8 * mp.sin(2 * mp.mpf(alpha))
            chord = mp.pi / 2 * mp.cos(alpha) ** 2
            for part in (*(k / 10 for k in range(-10, 21)), 1e-6, -1e-6):
                point = mp.mpf(part) * alpha, mp.mpf(1), z, mp.mpf(alpha)
                dh, change = height(*point), thickness(*point)
                inside = -tip <= dh and abs(dh) <= deepest and chord + change >= 0
                if part == 0 or not inside:
                    continue
                excess = 2 * mp.tan(point[3]) * dh - change
                ratios.append(excess / bound(dh, *point[1:]))
    assert len(ratios) > 300
    assert min(ratios) > 0
    assert max(ratios) <= 1
    # Near the constant chord the bound is off by (y_c cos(alpha)/r_b)^3 only.
    assert max(ratios) > 0.95


@pytest.mark.parametrize("name", ["constant_chord", "chord_height", "thickness_change"])
def test_outside_the_domain_is_nan_and_float32_stays(name: str) -> None:
    arguments = {"m": 3.0, "alpha": 0.3}
    if name == "thickness_change":
        arguments = {"tilt": 0.1, "m": 3.0, "z": 50, "alpha": 0.3}
    kernel = getattr(kernels, name)
    assert np.isnan(kernel(**{**arguments, "alpha": np.array([0.0, -0.1, 0.8, np.nan])})).all()
    assert kernel(**{k: np.float32(v) for k, v in arguments.items()}).dtype == np.float32
    assert isinstance(kernel(**arguments), np.float64)
    with pytest.raises(TypeError, match="m: expected real numbers"):
        kernel(**{**arguments, "m": 1j})


@pytest.mark.parametrize(
    ("quantity", "key"),
    [
        ("height_change", "first_order"),
        ("thickness_change", "first_order"),
        ("thickness_change", "by_height"),
    ],
)
def test_the_bound_of_an_approximation_holds_and_is_met(quantity: str, key: str) -> None:
    """Without rounding the error stays within the bound, and somewhere uses a quarter of it."""
    (form,) = (f for f in QUANTITIES[quantity].rivals if f.key == key)
    assert form.bound is not None
    exact = oracle(QUANTITIES[quantity], QUANTITIES[quantity].definition)
    approximate = oracle(QUANTITIES[quantity], form.expression)
    bound = oracle(QUANTITIES[quantity], form.bound)
    used = []
    with mp.workdps(60):
        for z, alpha, tilt in product(TEETH, ANGLES[1:], (-0.2, -1e-6, 1e-3, 0.1, 0.4)):
            point = [mp.mpf(v) for v in (tilt, 3, z, alpha)]
            used.append(abs(approximate(*point) - exact(*point)) / bound(*point))
    assert 0.25 < max(used) <= 1
