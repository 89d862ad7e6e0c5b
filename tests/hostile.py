"""The kind of each parameter, and the values that each kind must refuse."""

from __future__ import annotations

import random
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
from units import list_other_units, list_with_units

from mechproof import mechanisms
from mechproof.laws import Normal
from mechproof.tolerance import Size

UNITS = [*list_with_units(0.5), *list_with_units([0.5, 1.0])]
# Refused even by parameters that accept quantities of pint.
OTHER_UNITS = [*list_other_units(0.5), *list_other_units([0.5, 1.0])]
NO_NUMBERS = [
    *(None, "1", "x", b"1", {"a": 1.0}, {1.0}, object(), float, 1j),
    *([1j, 1.0], ["1"], [None], [[1.0, 2.0], [3.0]], [1.0, [2.0]], [{}]),
    *(np.array([1j]), np.array([None]), np.array(["1"]), np.array([1.0], object)),
    *UNITS,
]
NO_NUMBER = [*NO_NUMBERS, True, False, [], [1.0, 2.0], (1.0,), np.ones(2), np.ones((1, 1))]
MASKED = np.ma.masked_array([1.0, 2.0], [True, False])
NO_OBJECTS = [None, "x", 3, 1.5, [], {"a": 1.0}, object(), object]
# The values that each kind of parameter must refuse.
REFUSED: dict[str, list[Any]] = {
    "array": NO_NUMBERS,
    "strict array": [*NO_NUMBERS, True, [True], np.longdouble(1), np.ma.masked, MASKED],
    # A type is callable, so it passes as a function of samples.
    "samples": [bad for bad in NO_NUMBERS if bad is not float],
    "number": NO_NUMBER,
    "exact": [v for v in NO_NUMBER if not (v is None or isinstance(v, str))] + ["x", b"1"],
    "positive": [*NO_NUMBER, -1.0, 0.0],
    "not negative": [*NO_NUMBER, -1.0, -1e-300, np.inf],
    "width": [*NO_NUMBER, -1.0],
    "probability": [*NO_NUMBER, -1.0, 0.0, 1, 1.5, np.nan],
    "count": [*NO_NUMBER, 1.5, 2.0, 0, -1, np.nan],
    "pair": [
        *(bad for bad in NO_NUMBERS if not isinstance(bad, list)), 3, (), (1.0,), (1, 2, 3), "ab",
        (2.0, 1.0), (1.0, 1.0), {1.0, 2.0}, {1.0: 0, 2.0: 0}, (True, 5.0), np.ones((2, 3)),
        *((value, 5.0) for value in NO_NUMBERS),
    ],
    "deviations": [None, 3, "x", [], [("l_AB", (1, 2))], {"l_AB": 3}, {"l_AB": (1,)},
                   {"l_AB": (-1, 1)}, {"none": (1, 0)}, {1: (1, 0)}, {"l_AB": (None, 1)}, ],
    "triple": [*NO_NUMBERS, 3, (), (1, 2), (1, 2, "3"), (1, 2, None), (True, 1, 2), np.eye(3)],
    "mapping": [None, 3, "s", b"s", [], ["s"], ("s",), {"s": 1.0}, {1: Size(1)}, {"s": None},
                {"s"}, [("s", Size(1))], {"s": Size}],
    "laws": [None, 3, "s", [], [Normal(0, 1)], {}, {"s": None}, {"s": 3}, {"s": Normal}, {"t": 3},
             Normal(0, 1)],
    "sensitivities": [3, "s", [], [1.0], {}, {"s": None}, {"s": "x"}, {"t": 1.0}, {"s": [1, 2, 3]},
                      *({"s": value} for value in UNITS)],
    "law": [*NO_OBJECTS, Normal, (0, 1), Size(1)],
    "errors": [None, 3, "x", {"a": 1}, [3], [None], Normal, [Normal]],
    "source": [None, 3, "x", np.random, random.Random(1), np.random.RandomState(1)],
    "shape": [-1, 1.5, "x", True, (2, -1), (1.5,), [[1]], (None,), {}, object(), (2, 1), 3],
    "inputs": [None, 3, "s", b"s", [], {}, {"s"}, {"s": None}, {"s": "x"}, {"s": 1.0}],
    "correlations": [None, 3, "s", [], {"s": 1.0}, {("s", "s"): 1.0}, {("s", "t"): 0.1}],
    "nominal": [None, 3, "s", [], {"s"}, [("s", 1.0)]],
    "costs": [3, "s", [], {}, {"s": 1.0}, {"l_BC": 0.0}, {"l_BC": None}],
    "names": [3, "s", ["s"], [3], [None]],
    "kernel": [None, 3, "s", [], len, np.sin],
    "texts": [None, 3, "x<1", {"x<1"}, [3], [None]],
    "flag": [None, "no", "yes", 0, 1, 1.0, [], [True], np.array([True]), object()],
    "path": [None, 3, 1.5, b"x", [], {}, object(), True],
    "optional text": [3, 1.5, b"x", [], {}, object(), True],
    "executor": [3, "threads", [], object(), ThreadPoolExecutor, True],
    "function": [None, 3, "x", [], {}],
    "callback": [3, "x", [], {}],
    "text": [None, 3, 1.5, b"x", [], {}, object(), True],
    "which": [None, 3, "none", ["none"], [None], [3]],
    "simulated": [3, "x", (), (1.0,), (None, None), ([0.0], None), ([0.0], 3)],
    "parts": [None, 3, "x", [3], [None], {"a": 1}],
    "sizes": [*NO_NUMBER[:9], [1.0], (0.1, 0.0), (0.0, "x"), -np.inf, np.nan, 99.0, *UNITS],
    "folder": [3, 1.5, [], object(), "nowhere"],
    "labels": [None, 3, "x", ("x",), ("x", None), (3, "y"), {"x", "y"}],
    "optional pair": [],
    "number of": [*NO_NUMBER, 1.5, 0, -1, 100],
    "teeth": [*NO_NUMBER, 4.5, 3, 0, -5],
    "object": NO_OBJECTS,
    "optional object": NO_OBJECTS[1:],
}  # fmt: skip
REFUSED["optional not negative"] = [v for v in REFUSED["not negative"] if v is not None]
REFUSED["optional probability"] = [v for v in REFUSED["probability"] if v is not None]
REFUSED["optional pair"] = [bad for bad in REFUSED["pair"] if bad is not None]
# The kind of a parameter, by its name.
KINDS = {
    "number": "R1 R2 e m alpha l_AB l_BC l_CD l_DE l_GH l_KL l_LM alpha_DE alpha_KL alpha_LM R A H "
    "nominal gap value module tilt offset",
    "number of": "variant set",
    "array": "phi3 phi1 dh e_tip height_error x1 phi points angle speed acceleration jerk t",
    "strict array": "measured mean std width multiple lower upper x inputs signs readings",
    "exact": "mount R4 R5 e2 eta band largest_e largest_ratio planar_error spatial_error",
    "object": "pair dwell wheel contributions system type_a mechanism corners exact",
    "optional object": "axes ax certified scatter",
    "count": "z count chunk budget",
    "positive": "degrees_of_freedom k limit",
    "width": "expanded_uncertainty",
    "not negative": "uncertainty standard_deviation half_width resolution",
    "probability": "probability",
    "optional probability": "consumer_risk producer_risk",
    "text": "quantity unit name label of rank latex",
    "texts": "where values factors natural",
    "labels": "labels",
    "which": "which",
    "simulated": "simulated",
    "parts": "type_b",
    "folder": "folder",
    "flag": "steps_as_printed degrees",
    "pair": "tolerance teeth",
    "optional pair": "acceptance",
    "triple": "angles shift",
    "law": "true tip_diameter height thickness error",
    "source": "rng",
    "shape": "size",
    "function": "function",
    "callback": "progress report",
    "path": "path",
    "optional text": "content",
    "executor": "executor",
    "mapping": "sizes",
    "deviations": "deviations",
    "sensitivities": "sensitivities",
    "laws": "laws",
}
# The kind of a parameter in one call, where its name has another kind elsewhere.
ELSEWHERE = {
    "OvalPair.e": "exact",
    "ToothThickness.z": "teeth",
    "WedgeLinkage.tolerance_range.x1": "strict array",
    "conformity.simulate_shares.error": "errors",
    "Size.upper": "number",
    "Size.lower": "number",
    "TypeA.mean": "number",
    "position_errors.measured": "array",
    "evaluate_position_errors.measured": "array",
    "propagate.inputs": "inputs",
    "propagate.correlations": "correlations",
    "to_ufloat.estimate": "object",
    "fit.position": "kernel",
    "fit.phi1": "strict array",
    "fit.ratio": "pair",
    "fit.zeros": "flag",
    "fit.uncertainty": "optional not negative",
    "allocate_tolerances.system": "text",
    "allocate_tolerances.quantity": "text",
    "allocate_tolerances.nominal": "nominal",
    "allocate_tolerances.width": "positive",
    "allocate_tolerances.names": "names",
    "allocate_tolerances.costs": "costs",
    "bound.source": "text",
    "bound.where": "texts",
    "bound.relative": "flag",
    "bound.rounded_inputs": "flag",
    "bound.ulps": "positive",
    "bound.tolerance": "probability",
    "bound.parts": "count",
    "choose.error": "positive",
    "choose.size": "count",
    "choose.measured": "folder",
    "choose.angles": "sizes",
    "export.phi1": "number",
    "judge_equation.names": "texts",
    "export.tolerance": "positive",
    "ThicknessInspection.tip_grade.multiple": "number",
    "formula.name": "text",
    "formula.derivations": "folder",
    "tailor.error": "positive",
    "tailor.phi1": "pair",
    "plot.pitch_curves.phi1": "number",
    "EllipticPlanetary.design.k": "exact",
    "EllipticPlanetary.run.phi1": "samples",
    "OvalPlanetary.run.phi1": "samples",
    "OvalPlanetary.find_dwells.width": "exact",
}
KIND_OF = {name: kind for kind, names in KINDS.items() for name in names.split()} | ELSEWHERE


PLAIN_MECHANISMS = {*mechanisms.__all__} - {"ThicknessInspection"}


def list_refused(call: str, parameter: str) -> list[Any]:
    """List the values that a parameter of a call must refuse."""
    refused = REFUSED[find_kind(call, parameter)]
    if not takes_quantities(call, parameter):
        return refused
    return [v for v in refused if not any(v is known for known in UNITS)] + OTHER_UNITS


def find_kind(call: str, parameter: str) -> str:
    return KIND_OF.get(f"{call}.{parameter}") or KIND_OF[parameter]


def takes_quantities(call: str, parameter: str) -> bool:
    """Return whether a parameter of a mechanism's call accepts a number with a unit."""
    name, _, method = call.partition(".")
    is_plain = method in ("published", "published_sizes", "tolerance_range", "motion")
    numbers = ("number", "array", "exact", "triple")
    name = "EllipticPlanetary" if call in ("plot.pitch_curves", "export") else name
    return name in PLAIN_MECHANISMS and not is_plain and find_kind(call, parameter) in numbers
