"""The linkage at run time: kernels against balls, shapes, reach, sets, corner ranges."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
import sympy as sp
from weights import first_of

from mechproof import WedgeLinkage
from mechproof.arithmetic import balls
from mechproof.derivations.wedge_linkage import PAPER
from mechproof.derivations.wedge_linkage.kernels import chain
from mechproof.derivations.wedge_linkage.kernels.inputs import condition
from mechproof.derivations.wedge_linkage.mechanics import x1 as pusher
from mechproof.derivations.wedge_linkage.rows import boundaries
from mechproof.kernels import wedge_linkage as kernels
from mechproof.mechanisms.wedge_linkage import PusherReachError, RollerLeverReachError
from mechproof.record import Accuracy, Quantity, Scale, Toleranced
from mechproof.tolerance import corner_range

EPS = float(np.finfo(float).eps)
BARRED = [q for q in PAPER.quantities if not isinstance(q.definition, sp.MatrixBase)]
(SENSITIVITIES,) = (q for q in PAPER.quantities if q not in BARRED)
FIRST = WedgeLinkage.published(1)
X1 = np.linspace(-40, 0, 81)


def points(quantity: Quantity, count: int = 250) -> Iterator[list[float]]:
    """Yield points with the first set's sizes, off by 2 % or more, and large or tiny motions."""
    random = np.random.default_rng(20215)
    nominal = np.array(dataclasses.astuple(FIRST))
    for number in range(count):
        wide = number % 2
        sizes = nominal * random.uniform(0.5 if wide else 0.98, 1.6 if wide else 1.02, 10)
        tiny = 10 ** random.uniform(-12, 0)
        values = {
            **dict(zip(map(str, chain.SIZES), sizes, strict=True)),
            "x1": random.choice([random.uniform(-60, 40), -tiny]),
            "x5": random.choice([random.uniform(-60, 100), tiny]),
            "phi3": random.choice([random.uniform(-3, 3), tiny]),
            "phi7": random.choice([random.uniform(-3, 3), tiny]),
        }
        yield [float(values[a.name]) for a in quantity.arguments]


def exact(quantity: Quantity, point: list[float]) -> tuple[Any, Any]:
    """Return balls of the definition and of the scale of its accuracy bound."""
    values: dict[sp.Basic, Any] = dict(
        zip((a.symbols[0] for a in quantity.arguments), point, strict=True)
    )
    for symbol, given in chain.LINKS.items():
        if given.free_symbols <= values.keys():
            values[symbol] = balls.evaluate(given, values, 200)
    value = balls.evaluate(quantity.definition, values, 200)
    scale = quantity.accuracy.scale if quantity.accuracy else None
    size = balls.evaluate(scale.written_out(), values, 200) if scale else abs(value)
    return value, size


def worst_error(quantity: Quantity, function: Callable[..., Any]) -> float:
    """Return the worst error in eps * scale inside the domain; infinity for a wrong NaN."""
    worst = 0.0
    for point in points(quantity):
        value, scale = exact(quantity, point)
        with np.errstate(invalid="ignore"):
            got = float(function(*point))
        if not value.is_finite():
            continue
        if not math.isfinite(got):
            return math.inf
        error = float(abs(balls.to_ball(got) - value).upper())
        # Below, the position before contact is exactly 0 and so is its error.
        worst = max(worst, error / (EPS * float(scale.mid())) if error else 0.0)
    return worst


@pytest.mark.slow
@pytest.mark.parametrize("quantity", BARRED, ids=lambda q: q.name)
def test_bars(quantity: Quantity) -> None:
    assert quantity.accuracy is not None
    assert worst_error(quantity, getattr(kernels, quantity.name)) <= quantity.accuracy.ulp


@pytest.mark.parametrize("index", first_of(range(10)), ids=map(str, chain.SIZES))
def test_every_sensitivity_keeps_the_bar(index: int) -> None:
    assert SENSITIVITIES.accuracy is not None
    entry, ulp = SENSITIVITIES.definition[index], SENSITIVITIES.accuracy.ulp
    scale = condition(entry, (pusher, *chain.SIZES)).subs(chain.MEANT.engaged, 1)
    accuracy = Accuracy(ulp, Scale("its own conditioning", scale))
    quantity = dataclasses.replace(SENSITIVITIES, definition=entry, accuracy=accuracy)
    assert worst_error(quantity, lambda *p: kernels.sensitivities(*p)[index]) <= ulp


def naive_roller(x5: float, length: float, angle: float) -> Any:
    """Compute (7) and (8) as printed, which cancel at x5 = 0 and have no value at R = 0."""
    r = length * np.cos(angle) - x5
    return np.arctan(np.sqrt(length**2 - r**2) / r) - angle + (np.pi if r < 0 else 0)


def test_the_measure_rejects_the_printed_forms() -> None:
    quantity = next(q for q in PAPER.quantities if q.name == "roller_lever_angle")
    assert quantity.accuracy is not None

    def off(*point: float) -> Any:
        return kernels.roller_lever_angle(*point) * (1 + 1e-13)

    assert worst_error(quantity, off) > quantity.accuracy.ulp
    tiny = [1e-9, 60.0, math.radians(65)]
    value, _ = exact(quantity, tiny)
    assert abs(naive_roller(*tiny) / float(value.mid()) - 1) > 1e-8
    assert abs(kernels.roller_lever_angle(*tiny) / float(value.mid()) - 1) < 16 * EPS


def test_no_hole_at_r_zero() -> None:
    middle = 60 * math.cos(math.radians(65))
    near = kernels.roller_lever_angle(
        [middle - 1e-12, middle, middle + 1e-12], 60.0, np.radians(65)
    )
    # d phi7/d x5 = 1/60 there, and the value is pi/2 - alpha_KL.
    np.testing.assert_allclose(near, np.pi / 2 - np.radians(65), atol=1e-13)


# Central differences with step h are off by h^2/6 third derivatives (some 1e-3 per mm^2 or 1e2
# per rad^2) and by eps * 200 mm / h.
STEP = 1e-4


def difference(change: Callable[[float], Any]) -> Any:
    return (change(STEP) - change(-STEP)) / (2 * STEP)


def test_velocity_is_the_derivative() -> None:
    moved = X1[:-4]
    expected = difference(lambda h: FIRST.position(moved + h))
    np.testing.assert_allclose(FIRST.velocity(moved), expected, rtol=1e-7, atol=1e-7)


@pytest.mark.parametrize("name", [str(size) for size in chain.SIZES])
def test_sensitivities_are_the_derivatives(name: str) -> None:
    def change(h: float) -> Any:
        return dataclasses.replace(FIRST, **{name: getattr(FIRST, name) + h}).position(X1[:-4])

    expected = difference(change)
    np.testing.assert_allclose(FIRST.sensitivities(X1[:-4])[name], expected, rtol=1e-6, atol=1e-6)


def test_closed_forms_are_the_definitions() -> None:
    """Velocity and sensitivities, generated from half-angle forms, equal their definitions."""
    for name in ("velocity", "sensitivities"):
        quantity = next(q for q in PAPER.quantities if q.name == name)
        for x1 in (-40.0, -29.4, -10.0, -2.0):
            point = [x1, *dataclasses.astuple(FIRST)]
            got = np.ravel(getattr(kernels, name)(*point))
            entries = sp.Matrix([quantity.definition])
            for value, entry in zip(got, entries, strict=True):
                ball, _ = exact(dataclasses.replace(quantity, definition=entry), point)
                # Some 60 roundings on terms of at most 20 times the result at these points.
                assert abs(float(ball.mid()) - value) <= 600 * EPS * (1 + abs(value))


def test_before_contact_nothing_moves() -> None:
    assert FIRST.position(-0.5) == 0
    assert FIRST.velocity(-0.5) == 0
    assert not any(FIRST.sensitivities(-0.5).values())


def test_arrays_follow_numpy() -> None:
    arguments = dataclasses.astuple(FIRST)
    assert FIRST.position(np.zeros((2, 0, 3))).shape == (2, 0, 3)
    assert isinstance(FIRST.position(-3.0), np.float64)
    assert FIRST.position(np.float32(-3)).dtype == np.float32
    assert np.isnan(FIRST.position([np.nan, -1.0])).tolist() == [True, False]
    assert kernels.sensitivities(np.zeros((4, 1)), *arguments[:-1], np.ones(3)).shape == (4, 3, 10)
    for index in range(10):
        spoiled = [*arguments[:index], np.nan, *arguments[index + 1 :]]
        assert np.isnan(kernels.position(-3.0, *spoiled))
        outside = [*arguments[:index], -1.0, *arguments[index + 1 :]]
        assert np.isnan(kernels.position(-3.0, *outside)) == (index < 7 or index == 8)


def test_kernels_are_nan_out_of_reach() -> None:
    short = dataclasses.replace(FIRST, l_BC=19.75)
    with np.errstate(invalid="ignore"):
        assert np.isnan(kernels.position(-10.0, *dataclasses.astuple(short)))


@pytest.mark.parametrize(
    ("changes", "x1", "error", "message"),
    [
        ({"l_BC": 19.75}, [-1, -4.66], PusherReachError, r"x1 = -4.66: the radicand of Q, .* = -"),
        ({"l_KL": 30.0}, [-1, -40], RollerLeverReachError, r"x1 = -40.0: \|R\| <= l_KL = 30.0"),
        ({"l_DE": 0.0}, [0], ValueError, "l_DE = 0.0: must satisfy 0 < l_DE < oo"),
        ({"alpha_KL": 3.2}, [0], ValueError, "alpha_KL = 3.2: must satisfy 0 < alpha_KL < pi"),
        ({"l_LM": math.nan}, [0], ValueError, "l_LM = nan: must be finite"),
    ],
)
def test_errors_name_the_condition(
    changes: dict[str, Any], x1: list[float], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        dataclasses.replace(FIRST, **changes).position(x1)


def test_published_sets_are_those_of_the_derivation() -> None:
    for number, table in enumerate(PAPER.published, start=1):
        found = WedgeLinkage.published_sizes(number)
        assert list(found) == [str(size) for size in table.sizes]
        for size, exact_size in table.sizes.items():
            assert isinstance(exact_size, Toleranced)
            expected = [float(v) for v in dataclasses.astuple(exact_size)]
            assert list(dataclasses.astuple(found[str(size)])) == expected
    with pytest.raises(ValueError, match="set = 3: must be 1 to 2"):
        WedgeLinkage.published(3)


def deviations(number: int) -> dict[str, tuple[float, float]]:
    sizes = WedgeLinkage.published_sizes(number)
    return {name: (size.upper, size.lower) for name, size in sizes.items()}


# The x1 from which II is the upper boundary, and the x1 at which the lower one changes from IV to
# III, over all 2^8 combinations.
BOUNDARIES = {1: (-37.0, -29.3), 2: (-40.0, -29.5)}


@pytest.mark.parametrize("number", BOUNDARIES)
def test_boundaries_of_all_combinations(number: int) -> None:
    begin, cross = BOUNDARIES[number]
    result = WedgeLinkage.published(number).tolerance_range(X1, deviations(number))
    assert not result.undefined.any()
    assert result.influential_combinations == 2**8
    in_contact = X1 < -3
    upper = result.upper_signs[in_contact & (begin <= X1)]
    signs = {str(size): sign for size, sign in boundaries.BOUNDARY_II.items()}
    assert (upper == [signs[name] for name in result.names]).all()
    for part, table in (
        (in_contact & (cross + 0.2 < X1), boundaries.BOUNDARY_III),
        (cross - 0.2 > X1, boundaries.BOUNDARY_IV),
    ):
        signs = {str(size): sign for size, sign in table.items()}
        assert (result.lower_signs[part] == [signs[name] for name in result.names]).all()


def test_where_the_reconstructions_differ() -> None:
    first, second = (WedgeLinkage.published(n).tolerance_range(X1, deviations(n)) for n in (1, 2))
    assert X1[np.argmax(first.spread)] == -40
    assert -33 < X1[np.argmax(second.spread)] < -31
    assert first.spread[0] == pytest.approx(24.796, abs=1e-3)
    signs = dict(zip(first.names, first.upper_signs[0], strict=True))
    assert signs["alpha_KL"] == -1


def test_tolerance_range_is_the_corner_range() -> None:
    result = FIRST.tolerance_range(-30.0, deviations(1))
    expected = corner_range(kernels.position, -30.0, WedgeLinkage.published_sizes(1))
    assert (result.lower, result.upper) == (expected.lower, expected.upper)
    with pytest.raises(ValueError, match=r"deviations = .*l_XY"):
        FIRST.tolerance_range(-30.0, {"l_XY": (1, 0)})


@pytest.mark.parametrize("pair", [0.05, (1, 2, 3), None])
def test_deviations_that_are_no_pair_are_named(pair: Any) -> None:
    with pytest.raises(TypeError, match=r"deviations\['l_BC'\] = .*: must be a pair, the upper"):
        FIRST.tolerance_range(-30.0, {"l_BC": pair})
    with pytest.raises(TypeError, match=r"deviations\['l_BC'\]\[1\] = '-1': must be a real"):
        FIRST.tolerance_range(-30.0, {"l_BC": (1, "-1")})  # type: ignore[dict-item]
