"""Bounds over the whole box of sizes, certified by balls."""

from __future__ import annotations

import dataclasses
import math
import sys

import numpy as np
import pytest
import sympy as sp

from mechproof import WedgeLinkage
from mechproof.derivations import elliptic_planetary as elliptic
from mechproof.derivations.elliptic_planetary.mechanics import R1, R2, phi1, position_principal
from mechproof.kernels import wedge_linkage as kernels
from mechproof.record import Argument, Form, Paper, Part, Quantity, Variable
from mechproof.tolerance import Size, certified_range, corner_range

SIZES = WedgeLinkage.published_sizes(1)
IDLE = {"l_EF": Size(4, 0.3, -0.3), "l_IK": Size(21, 0, -0.3), "l_MN": Size(10, 0, -0.17)}
ELLIPTIC = {"R1": Size(66.0), "R2": Size(16.0), "e": Size(0.475)}
TOOTH = {"m": Size(3.0), "z": Size(50), "alpha": Size(0.35)}
WHEEL = {"R": Size(41.5), "A": Size(3.75), "z": Size(6)}
X1 = np.array([-40.0, -37.1, -30.0, -20.0, -2.0, -1.0, 0.0])

x, a, b = sp.symbols("x a b", real=True)


def toy(expression: sp.Expr, form: sp.Expr | None = None) -> Paper:
    arguments = tuple(Argument(str(s), (s,), str(s)) for s in (x, a, b))
    quantity = Quantity(
        "f", "Compute f.", arguments, expression, (Form("f", form or expression),), "here"
    )
    variables = tuple(Variable(s, str(s)) for s in (x, a, b))
    return Paper("toy", "", variables, (), quantities=(quantity,))


BOX = {"a": Size(0.0, 1.0, -1.0), "b": Size(2.0, 0.5, -0.5)}


@pytest.mark.thorough
def test_the_linkage_is_bounded_and_the_gap_is_closed() -> None:
    result = certified_range("wedge_linkage", "position", X1, SIZES | IDLE)
    assert (result.lower_gap >= 0).all()
    assert (result.upper_gap >= 0).all()
    assert max(result.lower_gap.max(), result.upper_gap.max()) <= 1e-9
    corners = corner_range(kernels.position, X1, SIZES)
    # The bound of the kernel, 22 eps on conditioned sums below 1e4 mm.
    rounding = 22 * 2.0**-52 * 1e4
    assert (corners.lower >= result.lower - rounding).all()
    assert (corners.upper <= result.upper + rounding).all()


def test_where_the_corner_range_is_no_bound() -> None:
    result = certified_range("wedge_linkage", "position", [-37.1, -20.0], SIZES)
    corners = corner_range(kernels.position, [-37.1, -20.0], SIZES)
    beyond = result.upper_attained - corners.upper
    # The position turns in alpha_KL where 2*l_KL*cos(alpha_KL) = x5', near -37.1 mm.
    assert beyond[0] == pytest.approx(0.00118, abs=1e-5)
    assert abs(beyond[1]) < 1e-10
    assert [n for n, turns in zip(result.names, result.turning[0], strict=True) if turns] == [
        "alpha_KL"
    ]
    assert not result.turning[1].any()


def test_a_turn_inside_costs_no_boxes() -> None:
    # The position has a turning point in alpha_KL at most inputs; halving alone needs 320 boxes.
    result = certified_range("wedge_linkage", "position", np.linspace(-37.8, -36.3, 10), SIZES)
    assert result.turning.any(axis=1).sum() >= 5
    assert result.boxes.sum() <= 40
    assert max(result.lower_gap.max(), result.upper_gap.max()) <= 1e-9


def test_random_sizes_stay_inside() -> None:
    result = certified_range("wedge_linkage", "position", X1, SIZES)
    random = np.random.default_rng(2021)
    sizes = {name: random.uniform(*size.limits, 2000)[:, None] for name, size in SIZES.items()}
    values = kernels.position(X1, **sizes)
    assert (values >= result.lower - 1e-10).all()
    assert (values <= result.upper + 1e-10).all()


@pytest.mark.slow
def test_sizes_without_influence_are_proved_so() -> None:
    result = certified_range("wedge_linkage", "position", -30.0, SIZES | IDLE)
    assert result.without_influence == ("l_EF", "l_IK", "l_MN")
    assert result.names[-3:] == result.without_influence
    hidden = toy(x + (a + b) ** 2 - a**2 - 2 * a * b)
    assert certified_range(hidden, "f", 0.0, BOX).without_influence == ("a",)


@pytest.mark.parametrize(
    ("expression", "lower", "upper"),
    [
        (b - a**2, 0.5, 2.5),
        (sp.cos(a) * b, 1.5 * math.cos(1), 2.5),
        (b * a, -2.5, 2.5),
        (sp.Max(0, a) + b, 1.5, 3.5),
        (b - (a - sp.Rational(1, 3)) ** 4, 1.5 - 256 / 81, 2.5),
        (a * b - a**2, -3.5, 1.5),
        (sp.sin(3 * a) + b, 0.5, 3.5),
        (sp.Abs(a - sp.Rational(1, 4)), 0.0, 1.25),
    ],
)
def test_extremes_inside_the_box(expression: sp.Expr, lower: float, upper: float) -> None:
    result = certified_range(toy(expression), "f", 0.0, BOX, gap=1e-6)
    for bound, attained, expected in (
        (result.lower, result.lower_attained, lower),
        (result.upper, result.upper_attained, upper),
    ):
        assert abs(bound - attained) <= 1e-6
        assert abs(attained - expected) <= 1e-6
    # The last bits of the expected numbers.
    assert result.lower <= lower + 1e-15
    assert result.upper >= upper - 1e-15


def test_a_spent_budget_leaves_a_gap_and_still_a_bound() -> None:
    wavy = toy(sp.sin(40 * a) * sp.cos(31 * b))
    poor = certified_range(wavy, "f", 0.0, BOX, budget=3)
    assert poor.upper_gap > 0.01
    assert poor.upper >= 1
    rich = certified_range(wavy, "f", 0.0, BOX, budget=120, gap=1e-3)
    assert 0 <= rich.upper_gap < poor.upper_gap
    assert rich.boxes > poor.boxes


def test_undefined_in_the_box_is_no_bound() -> None:
    result = certified_range(toy(sp.sqrt(a)), "f", 0.0, BOX, budget=5)
    assert (result.lower, result.upper) == (-np.inf, np.inf)


def test_an_approximation_is_not_the_quantity() -> None:
    approximate = toy(b - a**2)
    quantity = approximate.quantities[0]
    forms = (Form("first order", b, bound=a**2),)
    changed = dataclasses.replace(quantity, forms=forms)
    other = dataclasses.replace(approximate, quantities=(changed,), one_pass=())
    assert certified_range(other, "f", 0.0, BOX).lower_attained == pytest.approx(0.5, abs=1e-9)


def test_shapes_and_nan() -> None:
    result = certified_range(toy(a + b), "f", [[np.nan, 1.0]], BOX)
    assert result.lower.shape == (1, 2)
    assert result.turning.shape == (1, 2, 2)
    assert np.isnan(result.lower[0, 0])
    assert result.upper[0, 1] == pytest.approx(3.5)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"system": "gearbox"}, "system = 'gearbox': must be one of"),
        ({"quantity": "g"}, r"quantity = 'g': must be one of"),
        ({"sizes": {"l_AB": Size(6.25)}}, r"sizes = \['l_AB'\]: missing .*'l_BC'"),
        ({"sizes": SIZES | {"l_XY": Size(1)}}, r"unknown \['l_XY'\]"),
        ({"gap": -1.0}, "gap = -1.0: must not be negative"),
        ({"budget": 0}, "budget = 0: must be at least 1"),
    ],
)
def test_bad_arguments_are_named(change: dict[str, object], message: str) -> None:
    arguments = {"system": "wedge_linkage", "quantity": "position", "sizes": SIZES, **change}
    with pytest.raises(ValueError, match=message):
        certified_range(inputs=0.0, **arguments)  # type: ignore[arg-type]


def test_branches_that_need_not_meet_are_rejected() -> None:
    broken = toy(sp.Piecewise((a, a < b), (b + 1, True)))
    with pytest.raises(ValueError, match="may jump between its branches"):
        certified_range(broken, "f", 0.0, BOX)


def test_a_missing_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "flint", None)
    with pytest.raises(ImportError, match="needs flint, the extra derive: pip install"):
        certified_range("wedge_linkage", "position", 0.0, SIZES)


@pytest.mark.parametrize(
    ("system", "quantity", "sizes", "named"),
    [
        ("elliptic_planetary", "position", ELLIPTIC | {"e": Size(1.5, 0.01, -0.01)}, r"\['e'\]"),
        ("elliptic_planetary", "position", ELLIPTIC | {"e": Size(0.99, 0.01, -0.01)}, r"\['e'\]"),
        ("elliptic_planetary", "ratio", ELLIPTIC | {"e": Size(0.0, 0.1, -0.1)}, r"\['e'\]"),
        ("elliptic_planetary", "position", ELLIPTIC | {"R1": Size(-66.0)}, r"\['R1'\]"),
        ("elliptic_planetary", "position", ELLIPTIC | {"R2": Size(70.0, 1, -1)}, "R2 < R1"),
        ("elliptic_planetary", "position", ELLIPTIC | {"R2": Size(65.0, 1, -1)}, "R2 < R1"),
        ("elliptic_planetary", "position", ELLIPTIC | {"R2": Size(66.0)}, "R2 < R1"),
        ("wedge_linkage", "position", SIZES | {"l_GH": Size(0.5, 1, -1)}, r"\['l_GH'\]"),
        ("wedge_linkage", "position", SIZES | {"alpha_KL": Size(3.1, 0.1, 0)}, r"\['alpha_KL'\]"),
        ("tooth_thickness", "height_change", TOOTH | {"z": Size(50.5)}, r"\['z'\]"),
        ("tooth_thickness", "height_change", TOOTH | {"z": Size(50, 1, -1)}, r"\['z'\]"),
        ("track_wheel", "radius", WHEEL | {"A": Size(41.0, 1, -1)}, r"\['A'\].*must satisfy"),
    ],
)
def test_sizes_outside_the_domain_are_named(
    system: str, quantity: str, sizes: dict[str, Size], named: str
) -> None:
    with pytest.raises(ValueError, match=named):
        certified_range(system, quantity, 0.1, sizes)


@pytest.mark.parametrize(
    ("system", "quantity", "sizes"),
    [
        ("elliptic_planetary", "position", ELLIPTIC | {"e": Size(0.0, 0.1, 0)}),
        ("elliptic_planetary", "position", ELLIPTIC | {"R2": Size(65.0, 0.999, -1)}),
        ("track_wheel", "radius", WHEEL | {"A": Size(40.5, 1, -1)}),
        ("track_wheel", "radius", WHEEL | {"A": Size(-41.5, 1, 0)}),
    ],
)
def test_sizes_up_to_the_edge_of_the_domain_are_bounded(
    system: str, quantity: str, sizes: dict[str, Size]
) -> None:
    result = certified_range(system, quantity, 0.1, sizes)
    assert np.isfinite([result.lower, result.upper]).all()
    assert result.upper_gap <= 1e-9


def test_where_the_input_leaves_the_domain_there_is_no_bound() -> None:
    inputs = [0.1, 0.7, np.pi * 16 / 66, 2.0]
    sizes = ELLIPTIC | {"R2": Size(16.0, 0.5, -0.5)}
    (position,) = (q for q in elliptic.PAPER.quantities if q.name == "position")
    half_turn = Part("less than half a turn", where=(abs(phi1) < sp.pi * R2 / R1,))
    principal = dataclasses.replace(
        position, on=half_turn, forms=(Form("principal", position_principal),)
    )
    paper = dataclasses.replace(elliptic.PAPER, quantities=(principal,), one_pass=())
    result = certified_range(paper, "position", inputs, sizes)
    assert np.isfinite(result.lower).tolist() == [True, True, False, False]
    assert np.isfinite(result.upper).tolist() == [True, True, False, False]
    # For the third input some sizes lie inside the domain, where the quantity has values.
    assert np.isnan(result.upper_attained).tolist() == [False, False, False, True]
    assert result.boxes[3] == 2


def test_an_input_outside_its_own_set_has_no_bound() -> None:
    sizes = {"alpha": Size(0.35, 0.01, -0.01)}
    result = certified_range("tooth_thickness", "constant_chord", [-1.0, 0.0, 3.0, np.inf], sizes)
    assert np.isinf(result.lower).tolist() == [True, True, False, True]
    assert np.isinf(result.upper).tolist() == [True, True, False, True]
    assert np.isnan(result.lower_attained).tolist() == [True, True, False, True]
    assert result.turning.ravel().tolist() == [True, True, False, True]


def test_out_of_reach_of_the_linkage_there_is_no_bound() -> None:
    short = SIZES | {"l_BC": Size(49.75, 1.22, -6.0)}
    result = certified_range("wedge_linkage", "position", [-10.0, -44.25], short)
    # At x1 = -(l_AB + l_CD) the guide can follow if l_BC >= 44.25 and all else is nominal.
    assert np.isfinite([result.lower[0], result.upper[0]]).all()
    assert (result.lower[1], result.upper[1]) == (-np.inf, np.inf)
    assert np.isfinite([result.lower_attained[1], result.upper_attained[1]]).all()


def test_a_relation_that_balls_cannot_decide_gives_no_bound() -> None:
    paper = dataclasses.replace(toy(a + b), where=(sp.Ne(sp.sin(a), 3 * b),))
    result = certified_range(paper, "f", 0.0, BOX)
    assert (result.lower, result.upper) == (-np.inf, np.inf)


@pytest.mark.parametrize("quantity", ["displacement", "rotation", "error_sum"])
def test_quantities_with_components_are_refused(quantity: str) -> None:
    with pytest.raises(ValueError, match=f"quantity = '{quantity}': must be a scalar function"):
        certified_range("track_wheel", quantity, 0.0, {})
