"""Every public function and constructor of the runtime, called with what it cannot take.

Each parameter is given every value that its kind does not allow, while the others are right: the
error names the parameter.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from inspect import isclass, signature
from pathlib import Path
from tempfile import gettempdir
from typing import Any

import numpy as np
import pytest
from hostile import list_refused

import mechproof
from mechproof import (
    CylindricalPair,
    EllipticPlanetary,
    OvalPair,
    OvalPlanetary,
    ThicknessInspection,
    ToothThickness,
    TrackWheel,
    WedgeLinkage,
    bound,
    check,
    choose,
    conformity,
    export,
    formula,
    laws,
    measurement,
    mechanisms,
    plot,
    tailor,
    tolerance,
)
from mechproof.conformity import compiled
from mechproof.derivation import packaged_directory
from mechproof.kernels import elliptic_planetary
from mechproof.laws import Normal, TruncatedNormal, Uniform
from mechproof.measurement import Estimate, TypeA, TypeB
from mechproof.tolerance import Size

pytestmark = pytest.mark.filterwarnings("ignore::pint.UnitStrippedWarning")

ONE = Normal(0, 1)
ELLIPTIC, OVAL = EllipticPlanetary.published(2), OvalPlanetary.published(3)
DWELL = OvalPlanetary.find_dwells(0.3, eta="0.1", teeth=(18, 19)).candidates[0]
WEDGE, WHEEL, TEETH = (
    WedgeLinkage.published(1),
    TrackWheel(41.5, 3.75, 6, 20),
    ToothThickness(3, 50),
)
INSPECTION = ThicknessInspection.published(
    true=Normal(-0.03, 0.01), tip_diameter=ONE, height=ONE, thickness=ONE
)
SIZES = {"s": Size(1, 1, 0)}
RNG = np.random.default_rng(1)
ESTIMATE = Estimate(1.0, 0.1, unit="rad")


def scale(x: Any, s: Any) -> Any:
    return x * s


CORNERS = tolerance.corner_range(scale, [1.0, 2.0], SIZES)
CONTRIBUTIONS = tolerance.contributions(scale, [1.0, 2.0], SIZES)
SHARES = conformity.shares(Normal([0.0], 1), ONE, (-1, 1))
LAWS: dict[str, Any] = {
    "Normal": ONE,
    "Uniform": Uniform(-1, 1),
    "TruncatedNormal": TruncatedNormal(0, 1, -1, 1),
}
WINDOW = {"true": ONE, "error": ONE, "tolerance": (-1, 1), "acceptance": (-1, 1)}
MUCH = {"progress": None, "executor": None}
RANGE = {"function": scale, "inputs": [1.0, 2.0], "sizes": SIZES}

READ = np.sort(np.random.default_rng(3).uniform(0, 9, 20))
CALLS: dict[str, tuple[Callable[..., Any], dict[str, Any]]] = {
    "EllipticPlanetary": (EllipticPlanetary, {"R1": 66, "R2": 16, "e": 0.4}),
    "EllipticPlanetary.published": (EllipticPlanetary.published, {"variant": 1}),
    "EllipticPlanetary.carrier_angle": (ELLIPTIC.carrier_angle, {"phi3": 1.0, "degrees": False}),
    **{
        f"EllipticPlanetary.{n}": (getattr(ELLIPTIC, n), {"phi1": 1.0, "degrees": False})
        for n in ("ratio", "position", "acceleration", "jerk")
    },
    "EllipticPlanetary.design": (EllipticPlanetary.design, {"largest_ratio": 5, "k": 3}),
    "EllipticPlanetary.extremes": (ELLIPTIC.extremes, {"of": "jerk", "degrees": True}),
    "OvalPair": (OvalPair, {"e": 0.3, "mount": 0.1, "degrees": False}),
    "CylindricalPair": (CylindricalPair, {"R4": 20, "R5": 20}),
    "OvalPlanetary": (OvalPlanetary, {"pair": OvalPair(0.3), "e2": 0.3}),
    "OvalPlanetary.published": (OvalPlanetary.published, {"variant": 1}),
    "OvalPlanetary.classify": (OVAL.classify, {"eta": 0.1, "degrees": True}),
    "OvalPlanetary.extremes": (OVAL.extremes, {"degrees": True}),
    "OvalPlanetary.carrier_angle": (
        OvalPlanetary(CylindricalPair(1, 3), 0.1).carrier_angle,
        {"phi3": 1.0, "degrees": False},
    ),
    **{
        f"OvalPlanetary.{n}": (getattr(OVAL, n), {"phi1": 1.0, "degrees": False})
        for n in ("ratio", "position", "acceleration", "jerk")
    },
    "OvalPlanetary.longest_dwell": (OVAL.longest_dwell, {"band": 0.01, "degrees": False}),
    "OvalPlanetary.find_dwells": (
        OvalPlanetary.find_dwells,
        {"width": 0.3, "eta": "0.1", "teeth": (18, 19), "largest_e": "0.3", "rank": "width"}
        | {"degrees": False},
    ),
    "OvalPlanetary.of_dwell": (
        OvalPlanetary.of_dwell,
        {"dwell": DWELL, "e2": "0.1", "module": 2},
    ),
    **{
        f"{drive}.{name}": (getattr(moved, name), arguments)
        for drive, moved in (("EllipticPlanetary", ELLIPTIC), ("OvalPlanetary", OVAL))
        for name, arguments in (
            ("at", {"phi1": 1.0, "speed": 2.0, "acceleration": 0.1, "jerk": 0.1, "degrees": True}),
            ("run", {"t": np.arange(6.0), "phi1": np.arange(6.0), "degrees": False}),
        )
    },
    "ToothThickness": (ToothThickness, {"m": 3, "z": 50, "alpha": 0.3, "degrees": False}),
    **{
        f"ToothThickness.{n}": (getattr(TEETH, n), {"dh": 0.01})
        for n in ("thickness_change", "thickness_change_linear", "linearisation_bound")
    },
    "ToothThickness.thickness_error": (
        TEETH.thickness_error,
        {"e_tip": 0.01, "height_error": 0.01},
    ),
    "WedgeLinkage": (WedgeLinkage, {**vars(WEDGE), "degrees": False}),
    "WedgeLinkage.published": (WedgeLinkage.published, {"set": 1}),
    "WedgeLinkage.published_sizes": (WedgeLinkage.published_sizes, {"set": 1}),
    **{
        f"WedgeLinkage.{n}": (getattr(WEDGE, n), {"x1": -30.0})
        for n in ("position", "velocity", "sensitivities")
    },
    "WedgeLinkage.tolerance_range": (
        WEDGE.tolerance_range,
        {"x1": -30.0, "deviations": {"l_AB": (0.1, -0.1)}, "executor": None},
    ),
    "TrackWheel": (
        TrackWheel,
        {"R": 41.5, "A": 3.75, "z": 6, "H": 20, "angles": (0, 0, 0), "shift": (0, 0, 0)}
        | {"degrees": False},
    ),
    "TrackWheel.radius_extremes": (WHEEL.radius_extremes, {"degrees": True}),
    "TrackWheel.published": (TrackWheel.published, {"z": 6, "H": 20, "shift": (0, 0, 0)}),
    **{
        f"TrackWheel.{n}": (getattr(WHEEL, n), {"phi": 1.0, "degrees": False})
        for n in (
            "radius",
            "track",
            "displacement",
            "planar_error",
            "spatial_error",
            "normal_error",
        )
    },
    "TrackWheel.worst_pose": (
        WHEEL.worst_pose,
        {"tilt": 0.1, "offset": 0.1, "degrees": False},
    ),
    "TrackWheel.largest_tilt": (
        WHEEL.largest_tilt,
        {"planar_error": 0.2, "offset": 0.1, "degrees": False},
    ),
    "TrackWheel.largest_offset": (
        WHEEL.largest_offset,
        {"spatial_error": 10, "tilt": 0.1, "degrees": False},
    ),
    "TrackWheel.displacement_of": (WHEEL.displacement_of, {"points": [1.0, 2.0, 3.0]}),
    "ThicknessInspection": (
        ThicknessInspection,
        {
            "wheel": TEETH,
            "tolerance": (-1, 1),
            **dict.fromkeys(("true", "tip_diameter", "height", "thickness"), ONE),
            "steps_as_printed": False,
        },
    ),
    "ThicknessInspection.published": (
        ThicknessInspection.published,
        {
            **dict.fromkeys(("true", "tip_diameter", "height", "thickness"), ONE),
            "steps_as_printed": False,
        },
    ),
    **{
        f"ThicknessInspection.{n}": (getattr(INSPECTION, n), {"acceptance": (-1, 1)})
        for n in ("shares", "consumer_risk", "producer_risk")
    },
    **{
        f"ThicknessInspection.{n}": (getattr(INSPECTION, n), {risk: wanted})
        for n, risk, wanted in (
            ("acceptance_limits", "consumer_risk", 0.01),
            ("scale_gauge", "producer_risk", 0.95),
        )
    },
    "ThicknessInspection.tip_grade": (
        INSPECTION.tip_grade,
        {"multiple": 6, "producer_risk": 0.95},
    ),
    "ThicknessInspection.conformance_probability": (
        INSPECTION.conformance_probability,
        {"measured": 0.0},
    ),
    "ThicknessInspection.simulate": (
        INSPECTION.simulate,
        {"rng": RNG, "count": 9, "acceptance": (-1, 1), "chunk": 9, **MUCH},
    ),
    "Normal": (Normal, {"mean": 0.0, "std": 1.0}),
    "Normal.from_width": (Normal.from_width, {"mean": 0.0, "width": 1.0, "multiple": 1.0}),
    "Uniform": (Uniform, {"lower": 0.0, "upper": 3.0}),
    "Uniform.from_width": (Uniform.from_width, {"mean": 0.0, "width": 1.0}),
    "TruncatedNormal": (TruncatedNormal, {"mean": 0.0, "std": 1.0, "lower": -1.0, "upper": 3.0}),
    **{f"{k}.pdf": (one.pdf, {"x": 0.0}) for k, one in LAWS.items()},
    **{f"{k}.cdf": (one.cdf, {"x": 0.0}) for k, one in LAWS.items()},
    **{
        f"{k}.{n}": (getattr(one, n), {"lower": 0.0, "upper": 3.0})
        for k, one in LAWS.items()
        for n in ("probability", "outside")
    },
    **{
        f"{k}.sample": (
            type(one)(*([v, v] for v in vars(one).values())).sample,
            {"rng": RNG, "size": (3, 2)},
        )
        for k, one in LAWS.items()
    },
    "conformity.shares": (conformity.shares, WINDOW),
    "conformity.compiled.shares": (compiled.shares, WINDOW),
    "conformity.conformance_probability": (
        conformity.conformance_probability,
        {"measured": 0.0, "true": ONE, "error": ONE, "tolerance": (-1, 1)},
    ),
    "conformity.simulate_shares": (
        conformity.simulate_shares,
        {**WINDOW, "error": ONE, "rng": RNG, "count": 9, "chunk": 9, **MUCH},
    ),
    "Size": (Size, {"nominal": 1.0, "upper": 1.0, "lower": -1.0}),
    "Size.normal": (Size(1, 1, 0).normal, {"multiple": 6.0}),
    "Size.truncated_normal": (Size(1, 1, 0).truncated_normal, {"multiple": 6.0}),
    "corner_range": (tolerance.corner_range, {**RANGE, "chunk": 9, **MUCH}),
    "CornerRange.describe": (CORNERS.describe, {"signs": [1]}),
    "contributions": (tolerance.contributions, {**RANGE, "sensitivities": {"s": 1.0}}),
    "root_sum_square": (tolerance.root_sum_square, {"contributions": CONTRIBUTIONS}),
    "monte_carlo_range": (
        tolerance.monte_carlo_range,
        {
            **RANGE,
            "laws": {"s": ONE},
            "rng": RNG,
            "probability": 0.9,
            "count": 9,
            "chunk": 9,
            **MUCH,
        },
    ),
    "certified_range": (
        tolerance.certified_range,
        {
            "system": "tooth_thickness",
            "quantity": "thickness_change_linear",
            "inputs": 0.1,
            "sizes": {"alpha": Size(0.3)},
            "gap": 1e-3,
            "budget": 9,
            **MUCH,
        },
    ),
    "Estimate": (
        Estimate,
        {"value": 1.0, "uncertainty": 1.0, "degrees_of_freedom": 3.0, "unit": "mm"},
    ),
    "Estimate.expand": (ESTIMATE.expand, {"k": 2.0}),
    "Estimate.cover": (ESTIMATE.cover, {"probability": 0.9}),
    "CoverageInterval": (
        measurement.CoverageInterval,
        {"value": 1.0, "expanded_uncertainty": 1.0, "k": 2.0, "unit": "mm"},
    ),
    "TypeA": (TypeA, {"mean": 1.0, "standard_deviation": 1.0, "count": 3}),
    "TypeB": (TypeB, {"uncertainty": 1.0, "degrees_of_freedom": 3.0}),
    "TypeB.rectangular": (TypeB.rectangular, {"half_width": 1.0}),
    "TypeB.from_resolution": (TypeB.from_resolution, {"resolution": 1.0}),
    "evaluate_type_a": (measurement.evaluate_type_a, {"readings": [1.0, 2.0]}),
    "combine": (measurement.combine, {"type_a": TypeA(1.0, 0.1, 3), "unit": "mm"}),
    "wrap_angle": (measurement.wrap_angle, {"angle": 1.0}),
    "position_errors": (
        measurement.position_errors,
        {"mechanism": ELLIPTIC, "phi1": 1.0, "measured": 1.0},
    ),
    "evaluate_position_errors": (
        measurement.evaluate_position_errors,
        {
            "mechanism": ELLIPTIC,
            "phi1": [1.0, 2.0],
            "measured": [4.6, 6.7],
            "resolution": 0.1,
            "type_b": [TypeB(0.1)],
        },
    ),
    "propagate": (
        measurement.propagate,
        {
            "function": lambda s: 2 * s,
            "inputs": {"s": Estimate(1, 0.1)},
            "correlations": {},
            "unit": "mm",
        },
    ),
    "to_ufloat": (measurement.to_ufloat, {"estimate": Estimate(1, 0.1)}),
    "fit": (
        measurement.fit,
        {
            "position": elliptic_planetary.position,
            "phi1": READ,
            "measured": elliptic_planetary.position(READ, 3, 1, 0.3),
            "ratio": (2.0, 4.0),
            "uncertainty": None,
            "zeros": False,
        },
    ),
    "allocate_tolerances": (
        tolerance.allocate_tolerances,
        {
            "system": "wedge_linkage",
            "quantity": "position",
            "inputs": -37.1,
            "nominal": vars(WedgeLinkage.published(1)),
            "width": 1.0,
            "names": ["l_BC"],
            "costs": {"l_BC": 1.0},
            "budget": 50,
            "executor": None,
        },
    ),
    "bound": (
        bound,
        {
            "source": "x^2+x",
            "where": ["1<=x<=2"],
            "relative": False,
            "rounded_inputs": False,
            "ulps": 1.0,
            "tolerance": 0.5,
            "parts": 9,
            "report": lambda text: None,
        },
    ),
    "check": (
        check,
        {
            "path": "paper.tex",
            "content": "$$a=1$$",
            "limit": 9.0,
            "report": lambda text: None,
        },
    ),
    "choose": (
        choose,
        {"quantity": "displacement", "error": 1e-3, "size": 9, "measured": None, "angles": 0.1},
    ),
    "tailor": (
        tailor,
        {
            "name": "elliptic_planetary.ratio",
            "error": 1.0,
            "R1": 66,
            "R2": 16,
            "e": 0.1,
            "phi1": (0.0, 1.0),
        },
    ),
    "formula": (
        formula,
        {"name": "track_wheel.radius", "derivations": packaged_directory()},
    ),
    "export": (
        export,
        {
            "mechanism": OVAL,
            "path": Path(gettempdir()) / "mechproof-pair.csv",
            "phi1": 0.1,
            "degrees": False,
            "tolerance": 0.1,
        },
    ),
    "plot.motion": (plot.motion, {"mechanism": OVAL, "axes": None, "eta": "0.1"}),
    "plot.pitch_curves": (
        plot.pitch_curves,
        {"mechanism": ELLIPTIC, "phi1": 1.0, "ax": None, "degrees": False},
    ),
    "plot.tolerance": (
        plot.tolerance,
        {
            "inputs": [1.0, 2.0],
            "corners": CORNERS,
            "ax": None,
            "certified": None,
            "scatter": None,
            "labels": ("x", "y"),
        },
    ),
    "plot.shares": (
        plot.shares,
        {
            "inputs": [1.0],
            "exact": SHARES,
            "ax": None,
            "label": "x",
            "which": ["wrongly_rejected"],
            "simulated": None,
        },
    ),
}

CASES = [(name, parameter) for name, (_, given) in CALLS.items() for parameter in given]
# What is returned and raised, and what papers state of their figures: nobody gives it numbers.
RESULTS = {
    *("Law", "Shares", "SimulatedShares", "Figure", "PusherReachError", "RollerLeverReachError"),
    *("CertifiedRange", "Contributions", "CornerRange", "MonteCarloRange", "Range", "Motion"),
    *("Scatter", "Mechanism", "Formula", "Fit", "Propagation", "Allocation"),
}


def call(name: str, /, **changed: Any) -> Any:
    function, given = CALLS[name]
    return function(**given | changed)


@pytest.mark.parametrize("name", CALLS)
def test_what_is_right_is_taken(name: str) -> None:
    call(name)


@pytest.mark.parametrize(("name", "parameter"), CASES)
def test_what_a_parameter_does_not_take_is_named(name: str, parameter: str) -> None:
    for bad in list_refused(name, parameter):
        with pytest.raises((TypeError, ValueError), match=rf"^{parameter}\b"):
            call(name, **{parameter: bad})


def list_public() -> Iterator[str]:
    """List the functions, constructors and methods of the runtime that take anything."""
    packages = mechproof, conformity, laws, measurement, mechanisms, plot, tolerance
    for package in packages:
        for name in set(package.__all__) - RESULTS - {"__version__"}:
            public = getattr(package, name)
            yield name
            methods = vars(public) if isclass(public) else {}
            for method in methods:
                found = getattr(public, method)
                if (
                    method[0] != "_"
                    and callable(found)
                    and set(signature(found).parameters) - {"self"}
                ):
                    yield f"{name}.{method}"


def test_all_that_is_public_is_called() -> None:
    called = {name.removeprefix(f"{p}.") for name in CALLS for p in ("conformity", "plot")}
    assert set(list_public()) <= called
