"""Formulas for the array API: compiled and differentiated by JAX, refused where that costs digits.

That every formula keeps its bound on the strict library is tested with the other languages.
"""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import array_api_strict as standard
import by_jax
import numpy as np
import pytest
import sympy as sp
from derived import paper_of
from quantities import GENERATED, KERNELS
from test_formula_languages import SYSTEMS, bound_of, points_of, worst
from trial import a, load_source, paper_of as make_paper, quantity_of, x

import mechproof
from mechproof.codegen.backends import standalone_functions
from mechproof.codegen.backends.standalone_functions import render_scripts
from mechproof.programs.kernel import list_functions
from mechproof.record import Paper

# The truth at the points is found once for all languages.
pytestmark = pytest.mark.xdist_group("codegen/test_formula_languages.py")

RESTS, SUM_RESTS = "quotient_rest, product_rest, small_tangent", "sum_rest, product_rest"
AXES = "axes of arbitrary length"
# Why a quantity has no such formula, and which of its forms are offered instead.
REFUSED = {
    "elliptic_planetary.acceleration": (RESTS, "acceleration_direct acceleration_half_angle"),
    "elliptic_planetary.jerk": (RESTS, "jerk_direct"),
    "elliptic_planetary.position": (
        RESTS,
        "position_atan2 position_atan2_stable position_tan_half",
    ),
    "elliptic_planetary.ratio": (RESTS, "ratio_half_angle"),
    "oval_planetary.acceleration": (SUM_RESTS, "acceleration_direct"),
    "oval_planetary.acceleration_cylindrical": (RESTS, "acceleration_cylindrical_direct"),
    "oval_planetary.jerk": (SUM_RESTS, "jerk_direct"),
    "oval_planetary.jerk_cylindrical": (RESTS, "jerk_cylindrical_direct"),
    "oval_planetary.position_cylindrical": (
        RESTS,
        "position_cylindrical_atan2 position_cylindrical_atan2_stable",
    ),
    "oval_planetary.ratio_cylindrical": (RESTS, "ratio_cylindrical_half_angle"),
    "track_wheel.error_sum": (AXES, ""),
    "track_wheel.error_sum_correlated": (AXES, ""),
    "track_wheel.error_sum_thermal": (AXES, ""),
}
# The others are compiled in the thorough tests.
ALWAYS = ("elliptic_planetary", "wedge_linkage")
# Not JAX's default: rearrange sums and products as if they were exact.
FAST = {"xla_cpu_enable_fast_math": True}


def write(paper: Paper) -> str:
    (text,) = render_scripts(paper, "array_api")[0].values()
    return text


def compute(text: str, name: str, **how: Any) -> Any:
    """Compute the formula of a quantity by JAX at its points."""
    return by_jax.compute(text, name.replace(".", "_"), points_of(name), **how)


# All of them keep the bounds on the strict library.
@pytest.mark.slow
@pytest.mark.parametrize(
    "system",
    [
        pytest.param(system, marks=[] if system in ALWAYS else pytest.mark.thorough)
        for system in SYSTEMS
    ],
)
def test_compiled_formulas_keep_the_bounds_of_the_kernels(system: str) -> None:
    text = write(paper_of(system))
    for name in KERNELS:
        if name.startswith(f"{system}.") and name not in REFUSED:
            assert worst(name, compute(text, name)) <= bound_of(name), name


@pytest.mark.slow
@pytest.mark.parametrize("system", SYSTEMS)
def test_what_is_refused_says_why_and_what_else_there_is(system: str) -> None:
    _, refused = render_scripts(paper_of(system), "array_api")
    said = dict(reason.split(" in array_api: ") for reason in refused)
    assert said.keys() == {name for name in REFUSED if name.startswith(f"{system}.")}
    for name, reason in said.items():
        why, offered = REFUSED[name]
        assert why in reason
        others = [f"{system}.{other}" for other in offered.split()]
        assert ("; " in reason) == bool(others)
        assert not others or f"; {' or '.join(others)} does without" in reason
        for other in others:
            assert f"def {other.replace('.', '_')}(" in mechproof.formula(other).array_api


def test_forms_that_are_offered_are_proved_to_be_equal() -> None:
    rows = json.loads((GENERATED / "ledger.json").read_text(encoding="utf-8"))["rows"]
    verdicts = {row["id"]: row["verdict"] for row in rows}
    for system in SYSTEMS:
        for kernel in list_functions(paper_of(system)):
            if kernel.is_alternative:
                key = f"{system}/row-kernel-{kernel.name.replace('_', '-')}"
                assert verdicts[key] == "PROVED", key


def test_low_words_are_lost_where_compilers_do_what_they_may(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Fast math breaks the bound of a refused formula, which NumPy keeps, but not of another."""
    name, other = "elliptic_planetary.ratio", "elliptic_planetary.largest_acceleration"
    monkeypatch.setattr(standalone_functions, "_refuse_rests", lambda *_: None)
    text = write(paper_of("elliptic_planetary"))
    forced = load_source(text, tmp_path).elliptic_planetary_ratio
    with np.errstate(all="ignore"):
        slowly = forced(*map(standard.asarray, points_of(name)), xp=standard)
    assert worst(name, np.asarray(slowly)) <= bound_of(name)
    assert worst(name, compute(text, name, options=FAST)) > 10 * bound_of(name)
    assert worst(other, compute(text, other, options=FAST)) <= bound_of(other)


ROOT = sp.Piecewise((a * x, x < 0), (sp.sqrt(x) + a, True))
INNER = sp.Piecewise((sp.log(x) * a, x < 1), (1 / (x - 1) + sp.exp(a), True))


def differentiate(expression: sp.Basic, *points: tuple[float, float]) -> list[list[float]]:
    text = write(make_paper(quantity_of(expression, x, a)))
    found: list[list[float]] = by_jax.compute(text, "system_f", np.array(points).T, slopes=True)
    return np.asarray(found).tolist()


def test_a_branch_that_is_not_taken_spoils_no_derivative(monkeypatch: pytest.MonkeyPatch) -> None:
    points = (-4.0, 3.0), (4.0, 3.0)
    assert differentiate(ROOT, *points) == [[3.0, -4.0], [0.25, 1.0]]
    monkeypatch.setattr(standalone_functions, "block_branches", lambda program: program)
    (spoiled, _), after = differentiate(ROOT, *points)
    assert math.isnan(spoiled)
    assert after == [0.25, 1.0]


def test_a_branch_within_a_branch_is_blocked_too() -> None:
    expression = sp.Piecewise((a, x < 0), (INNER, True))
    found = differentiate(expression, (-1.0, 2.0), (0.5, 2.0), (3.0, 2.0))
    assert found[0] == [0.0, 1.0]
    assert found[1] == pytest.approx([4.0, math.log(0.5)], rel=1e-15)
    assert found[2] == pytest.approx([-0.25, math.exp(2)], rel=1e-15)


def test_results_have_the_type_of_the_arrays(tmp_path: Path) -> None:
    text, name = write(paper_of("wedge_linkage")), "wedge_linkage_rod_displacement"
    rod = load_source(text, tmp_path).wedge_linkage_rod_displacement
    single = np.array([0.25, 0.5], np.float32)
    assert rod(standard.asarray(single), 20, 0.3, xp=standard).dtype == standard.float32
    assert rod(1, 20, 0.3, xp=standard).dtype == standard.float64
    for compiled in (True, False):
        for given, kind in (((single, 20, 0.3), "f4"), ((1, single, 0.3), "f4"), ((1, 2, 3), "f8")):
            assert by_jax.compute(text, name, given, compiled=compiled).dtype == kind


def test_rows_of_numbers_are_vectors(tmp_path: Path) -> None:
    turn = load_source(write(paper_of("track_wheel")), tmp_path).track_wheel_displacement
    points = standard.ones((2, 1, 3), dtype=standard.float32)
    found = turn(points, [0.1, 0, 0], (0, 0, 1), xp=standard)
    assert (found.shape, found.dtype) == (points.shape, standard.float32)


def test_whole_numbers_are_no_type_of_a_result(tmp_path: Path) -> None:
    text, name = write(paper_of("elliptic_planetary")), "elliptic_planetary_largest_ratio"
    wanted = by_jax.compute(text, name, (60.0, 20.0, 0.3))
    for compiled in (True, False):
        assert by_jax.compute(text, name, (np.array(60), 20, 0.3), compiled=compiled) == wanted
    with pytest.raises(TypeError, match="floating"):
        load_source(text, tmp_path).elliptic_planetary_largest_ratio(
            standard.asarray(60), 20, 0.3, xp=standard
        )


def test_outside_the_domain_is_nan() -> None:
    text, name = write(paper_of("elliptic_planetary")), "elliptic_planetary_largest_ratio"
    found = by_jax.compute(text, name, (60.0, np.array([20.0, 20, -20]), np.array([0.3, 1, 0.3])))
    assert np.isnan(found).tolist() == [False, True, True]


@pytest.mark.parametrize(
    "expression",
    [
        sp.Max(x, 0) * a,
        sp.Min(a, x),
        sp.Max(x, a, 1),
        a + sp.Mod(x, 3),
        sp.Piecewise((sp.sqrt(3) * x, x < a), (sp.Rational(1, 10), 4 * x < 3), (1, True)),
        x**a + sp.cbrt(sp.Abs(a)),
        sp.asin(x) * sp.atan2(a, x),
    ],
)
def test_what_is_spelled_otherwise_means_the_same(expression: sp.Basic, tmp_path: Path) -> None:
    text = write(make_paper(quantity_of(expression, x, a)))
    function = load_source(text, tmp_path).system_f
    points = np.array([0.25, 0.625, 0.75]), np.array(0.5)
    wanted = [float(expression.subs({x: sp.Rational(p), a: sp.S.Half})) for p in points[0]]
    found = function(*map(standard.asarray, points), xp=standard)
    np.testing.assert_allclose(np.asarray(found), wanted, rtol=1e-15)
    np.testing.assert_allclose(by_jax.compute(text, "system_f", points), wanted, rtol=1e-15)
    if expression.has(sp.Max, sp.Min):
        assert math.isnan(by_jax.compute(text, "system_f", (math.nan, 0.5)))
