"""Every public function and constructor of the runtime, called with values it must refuse.

Each parameter in turn is given every value that its kind does not allow, while the others are
right; the error must name that parameter.
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
    conformity,
    laws,
    measurement,
    mechanisms,
    plot,
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
AT = {"phi1": 1.0, "degrees": False}
MOTION = {"t": np.arange(6.0), "phi1": np.arange(6.0), "degrees": False}
INSTANT = {"phi1": 1.0, "speed": 2.0, "acceleration": 0.1, "jerk": 0.1, "degrees": True}
OF_DRIVES: dict[str, Any] = {
    **dict.fromkeys(("ratio", "position", "acceleration", "jerk"), AT),
    **{"at": INSTANT, "run": MOTION, "published": {"variant": 1}},
}
POSE = {"tilt": 0.1, "offset": 0.1, "degrees": False}
LAWS_OF_INSPECTION = dict.fromkeys(("true", "tip_diameter", "height", "thickness"), ONE)
ENDS = {"lower": 0.0, "upper": 3.0}
ANGLE, PUSHED, LIMITS = {"phi": 1.0, "degrees": False}, {"x1": -30.0}, {"acceptance": (-1, 1)}
# Right arguments of functions, constructors and methods: the prefix of their names, the object
# that holds them, and the arguments by name.
GIVEN: list[tuple[str, Any, dict[str, dict[str, Any]]]] = [
    (
        "",
        mechproof,
        {
            "EllipticPlanetary": {"R1": 66, "R2": 16, "e": 0.4},
            "OvalPair": {"e": 0.3, "mount": 0.1, "degrees": False},
            "CylindricalPair": {"R4": 20, "R5": 20},
            "OvalPlanetary": {"pair": OvalPair(0.3), "e2": 0.3},
            "ToothThickness": {"m": 3, "z": 50, "alpha": 0.3, "degrees": False},
            "WedgeLinkage": {**vars(WEDGE), "degrees": False},
            "TrackWheel": {"R": 41.5, "A": 3.75, "z": 6, "H": 20, "degrees": False}
            | {"angles": (0, 0, 0), "shift": (0, 0, 0)},
            "ThicknessInspection": LAWS_OF_INSPECTION
            | {"wheel": TEETH, "tolerance": (-1, 1), "steps_as_printed": False},
            "bound": {"source": "x^2+x", "where": ["1<=x<=2"], "ulps": 1.0, "tolerance": 0.5}
            | {"relative": False, "rounded_inputs": False, "parts": 9, "report": lambda text: None},
            "check": {"path": "paper.tex", "content": "$$a=1$$", "limit": 9.0}
            | {"report": lambda text: None},
            "judge_equation": {"latex": "a=a", "where": [], "values": [], "natural": []}
            | {"names": [], "factors": []},
            "choose": {"quantity": "displacement", "error": 1e-3, "size": 9, "measured": None}
            | {"angles": 0.1},
            "tailor": {"name": "elliptic_planetary.ratio", "error": 1.0, "R1": 66, "R2": 16}
            | {"e": 0.1, "phi1": (0.0, 1.0)},
            "formula": {"name": "track_wheel.radius", "derivations": packaged_directory()},
            "export": {"mechanism": OVAL, "path": Path(gettempdir()) / "mechproof-pair.csv"}
            | {"phi1": 0.1, "degrees": False, "tolerance": 0.1},
        },
    ),
    (
        "EllipticPlanetary.",
        ELLIPTIC,
        OF_DRIVES
        | {
            "carrier_angle": {"phi3": 1.0, "degrees": False},
            "design": {"largest_ratio": 5, "k": 3},
            "extremes": {"of": "jerk", "degrees": True},
        },
    ),
    (
        "OvalPlanetary.",
        OVAL,
        OF_DRIVES
        | {
            "classify": {"eta": 0.1, "degrees": True},
            "extremes": {"degrees": True},
            "longest_dwell": {"band": 0.01, "degrees": False},
            "find_dwells": {"width": 0.3, "eta": "0.1", "teeth": (18, 19), "largest_e": "0.3"}
            | {"rank": "width", "degrees": False},
            "of_dwell": {"dwell": DWELL, "e2": "0.1", "module": 2},
        },
    ),
    (
        "OvalPlanetary.",
        OvalPlanetary(CylindricalPair(1, 3), 0.1),
        {"carrier_angle": {"phi3": 1.0, "degrees": False}},
    ),
    (
        "ToothThickness.",
        TEETH,
        {
            "thickness_change": {"dh": 0.01},
            "thickness_change_linear": {"dh": 0.01},
            "linearisation_bound": {"dh": 0.01},
            "thickness_error": {"e_tip": 0.01, "height_error": 0.01},
        },
    ),
    (
        "WedgeLinkage.",
        WEDGE,
        {
            "published": {"set": 1},
            "published_sizes": {"set": 1},
            **dict.fromkeys(("position", "velocity", "sensitivities"), PUSHED),
            "tolerance_range": {"x1": -30.0, "deviations": {"l_AB": (0.1, -0.1)}}
            | {"executor": None},
        },
    ),
    (
        "TrackWheel.",
        WHEEL,
        {
            **dict.fromkeys(("radius", "track", "displacement"), ANGLE),
            **dict.fromkeys(("planar_error", "spatial_error", "normal_error"), ANGLE),
            "radius_extremes": {"degrees": True},
            "published": {"z": 6, "H": 20, "shift": (0, 0, 0)},
            "worst_pose": POSE,
            "largest_tilt": {"planar_error": 0.2, "offset": 0.1, "degrees": False},
            "largest_offset": {"spatial_error": 10, "tilt": 0.1, "degrees": False},
            "displacement_of": {"points": [1.0, 2.0, 3.0]},
        },
    ),
    (
        "ThicknessInspection.",
        INSPECTION,
        {
            "published": LAWS_OF_INSPECTION | {"steps_as_printed": False},
            **dict.fromkeys(("shares", "consumer_risk", "producer_risk"), LIMITS),
            "acceptance_limits": {"consumer_risk": 0.01},
            "scale_gauge": {"producer_risk": 0.95},
            "tip_grade": {"multiple": 6, "producer_risk": 0.95},
            "conformance_probability": {"measured": 0.0},
            "simulate": {"rng": RNG, "count": 9, "acceptance": (-1, 1), "chunk": 9, **MUCH},
        },
    ),
    (
        "",
        laws,
        {
            "Normal": {"mean": 0.0, "std": 1.0},
            "Uniform": {"lower": 0.0, "upper": 3.0},
            "TruncatedNormal": {"mean": 0.0, "std": 1.0, "lower": -1.0, "upper": 3.0},
        },
    ),
    ("Normal.", Normal, {"from_width": {"mean": 0.0, "width": 1.0, "multiple": 1.0}}),
    ("Uniform.", Uniform, {"from_width": {"mean": 0.0, "width": 1.0}}),
    *(
        (f"{k}.", one, {"pdf": {"x": 0.0}, "cdf": {"x": 0.0}, "probability": ENDS, "outside": ENDS})
        for k, one in LAWS.items()
    ),
    *(
        (
            f"{k}.",
            type(one)(*([v, v] for v in vars(one).values())),
            {"sample": {"rng": RNG, "size": (3, 2)}},
        )
        for k, one in LAWS.items()
    ),
    (
        "conformity.",
        conformity,
        {
            "shares": WINDOW,
            "conformance_probability": {"measured": 0.0, "true": ONE, "error": ONE}
            | {"tolerance": (-1, 1)},
            "simulate_shares": {**WINDOW, "rng": RNG, "count": 9, "chunk": 9, **MUCH},
        },
    ),
    ("conformity.compiled.", compiled, {"shares": WINDOW}),
    (
        "",
        tolerance,
        {
            "Size": {"nominal": 1.0, "upper": 1.0, "lower": -1.0},
            "corner_range": {**RANGE, "chunk": 9, **MUCH},
            "contributions": {**RANGE, "sensitivities": {"s": 1.0}},
            "root_sum_square": {"contributions": CONTRIBUTIONS},
            "monte_carlo_range": RANGE
            | {"laws": {"s": ONE}, "rng": RNG, "probability": 0.9, "count": 9, "chunk": 9}
            | MUCH,
            "certified_range": {"system": "tooth_thickness", "inputs": 0.1, "gap": 1e-3}
            | {"quantity": "thickness_change_linear", "sizes": {"alpha": Size(0.3)}, "budget": 9}
            | MUCH,
            "allocate_tolerances": {"system": "wedge_linkage", "quantity": "position"}
            | {"inputs": -37.1, "nominal": vars(WedgeLinkage.published(1)), "width": 1.0}
            | {"names": ["l_BC"], "costs": {"l_BC": 1.0}, "budget": 50, "executor": None},
        },
    ),
    ("CornerRange.", CORNERS, {"describe": {"signs": [1]}}),
    (
        "Size.",
        Size(1, 1, 0),
        {"normal": {"multiple": 6.0}, "truncated_normal": {"multiple": 6.0}},
    ),
    (
        "",
        measurement,
        {
            "Estimate": {"value": 1.0, "uncertainty": 1.0, "degrees_of_freedom": 3.0, "unit": "mm"},
            "CoverageInterval": {"value": 1.0, "expanded_uncertainty": 1.0, "k": 2.0, "unit": "mm"},
            "TypeA": {"mean": 1.0, "standard_deviation": 1.0, "count": 3},
            "TypeB": {"uncertainty": 1.0, "degrees_of_freedom": 3.0},
            "evaluate_type_a": {"readings": [1.0, 2.0]},
            "combine": {"type_a": TypeA(1.0, 0.1, 3), "unit": "mm"},
            "wrap_angle": {"angle": 1.0},
            "position_errors": {"mechanism": ELLIPTIC, "phi1": 1.0, "measured": 1.0},
            "evaluate_position_errors": {"mechanism": ELLIPTIC, "phi1": [1.0, 2.0]}
            | {"measured": [4.6, 6.7], "resolution": 0.1, "type_b": [TypeB(0.1)]},
            "propagate": {"function": lambda s: 2 * s, "inputs": {"s": Estimate(1, 0.1)}}
            | {"correlations": {}, "unit": "mm"},
            "to_ufloat": {"estimate": Estimate(1, 0.1)},
            "fit": {"position": elliptic_planetary.position, "phi1": READ}
            | {"measured": elliptic_planetary.position(READ, 3, 1, 0.3), "ratio": (2.0, 4.0)}
            | {"uncertainty": None, "zeros": False},
        },
    ),
    ("Estimate.", ESTIMATE, {"expand": {"k": 2.0}, "cover": {"probability": 0.9}}),
    (
        "TypeB.",
        TypeB,
        {"rectangular": {"half_width": 1.0}, "from_resolution": {"resolution": 1.0}},
    ),
    (
        "plot.",
        plot,
        {
            "motion": {"mechanism": OVAL, "axes": None, "eta": "0.1"},
            "pitch_curves": {"mechanism": ELLIPTIC, "phi1": 1.0, "ax": None, "degrees": False},
            "tolerance": {"inputs": [1.0, 2.0], "corners": CORNERS, "ax": None}
            | {"certified": None, "scatter": None, "labels": ("x", "y")},
            "shares": {"inputs": [1.0], "exact": SHARES, "ax": None, "label": "x"}
            | {"which": ["wrongly_rejected"], "simulated": None},
        },
    ),
]
CALLS: dict[str, tuple[Callable[..., Any], dict[str, Any]]] = {
    f"{start}{name}": (getattr(owner, name), given)
    for start, owner, calls in GIVEN
    for name, given in calls.items()
}

CASES = [(name, parameter) for name, (_, given) in CALLS.items() for parameter in given]
# Classes of results and errors, and of the figures stated by papers: users pass them no numbers.
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
    """Yield the public classes and functions of the runtime, and methods that take arguments."""
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
