"""Maps of points: the norm of their error, its scale, and what both refuse."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import cache
from operator import mul

import numpy as np
import pytest
import sympy as sp
from derived import paper_of
from weights import first_of

from mechproof.arithmetic.intervals import EPS, Array, exactly
from mechproof.derivations.track_wheel.kernels.poses import ROTATION
from mechproof.derivations.track_wheel.mechanics import ANGLES, UNIT_QUATERNION, alpha
from mechproof.programs.kernel import input_names, list_functions
from mechproof.roundoff.affine import AffineMap, find_size
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.kernel_stages import list_computed_stages
from mechproof.roundoff.moved_matrices import bound_stretch, sort_moves
from mechproof.roundoff.regions import list_regions
from mechproof.roundoff.running import fma
from mechproof.roundoff.steps import EXACT, HALF, Step, StraightLineProgram
from mechproof.roundoff.symmetry import check_signs
from mechproof.roundoff.worst import measure
from mechproof.roundoff.written_scales import share_equal_steps

DRAWN = sp.symbols("drawn:3")
P, T, D = sp.symbols("p:3"), sp.symbols("t:3"), sp.Symbol("D")
ENDLESS = (-np.inf, np.inf)


@cache
def displacements() -> Mapping[str, ComputedStage]:
    paper = paper_of("track_wheel")
    kernel = next(k for k in list_functions(paper) if k.name == "displacement")
    return {subject.way: subject for subject in list_computed_stages(kernel, paper)}


def displacement(way: str = "NumPy's functions") -> ComputedStage:
    return displacements()[way]


def length(symbols: tuple[sp.Symbol, ...]) -> sp.Expr:
    return sp.sqrt(sum(s**2 for s in symbols))


def bound_at(subject: ComputedStage, *angles: float) -> float:
    region = next(list_regions(subject.form.charts[0]))
    box = [*((a, a) for a in angles), *[ENDLESS] * 6]
    return float(subject.bound(region, np.array([box]))[0])


def test_a_scale_of_point_and_shift_has_a_size() -> None:
    assert find_size(D * length(P) + length(T), P, T) == D


@pytest.mark.parametrize(
    "scale",
    [D * length(P), D * length(P) + 2 * length(T), D * P[0] + length(T), D**2 * sum(P)],
)
def test_another_scale_is_refused(scale: sp.Expr) -> None:
    with pytest.raises(ValueError, match="is not a multiple"):
        find_size(scale, P, T)


def test_the_scale_is_the_norm_of_the_matrix() -> None:
    """The spectral norm of a rotation minus the identity is sqrt(3 - trace of the rotation)."""
    squares = 4 * sum(part**2 for part in UNIT_QUATERNION.args[1:]) - (3 - ROTATION.trace())
    halved = sp.expand_trig(squares.subs({angle: 2 * angle for angle in ANGLES}))
    for angle in ANGLES:
        halved = sp.expand(halved).subs(sp.sin(angle) ** 2, 1 - sp.cos(angle) ** 2)
    assert sp.simplify(sp.expand(halved)) == 0


@pytest.mark.slow
@pytest.mark.parametrize("way", first_of(["NumPy's functions", "compiled"]))
def test_roundings_of_the_entries_and_of_the_sums_count(way: str) -> None:
    subject = displacement(way)
    assert subject.map is not None
    whole = bound_at(subject, 0.5, 0.4, 0.3)
    entries = subject.map.entries
    for i, step in enumerate(entries.steps):
        if step.ulps:
            steps = (*entries.steps[:i], replace(step, ulps=EXACT), *entries.steps[i + 1 :])
            changed = replace(subject.map, entries=replace(entries, steps=steps))
            assert bound_at(replace(subject, map=changed), 0.5, 0.4, 0.3) < whole
    exact = replace(entries, steps=tuple(replace(s, ulps=EXACT) for s in entries.steps))
    sums = bound_at(replace(subject, map=replace(subject.map, entries=exact)), 0.5, 0.4, 0.3)
    assert 1.5 <= sums < 3


def bound_sums(matrix: Array, *, is_fused: bool) -> float:
    """Bound the roundings of products and sums alone, in eps of |M|*|p|."""
    affine = AffineMap(StraightLineProgram((), (), ()), tuple("xyz"), tuple("abc"), is_fused)
    entries = [[exactly(np.array([entry])) for entry in row] for row in matrix]
    moves = [[affine.list_sums(i, j, e) for j, e in enumerate(r)] for i, r in enumerate(entries)]
    return float(bound_stretch(sort_moves(moves))[0]) / float(np.linalg.norm(matrix, 2))


def add_in_some_order(row: Array, point: Array, rng: np.random.Generator) -> float:
    one, two, three = rng.permutation(row * point)
    return float((one + two) + three)


def fuse(row: Array, point: Array, rng: np.random.Generator) -> float:
    total = np.float64(0.0)
    for entry, part in zip(row[::-1], point[::-1], strict=True):
        total = fma(entry, part, total)
    return float(total)


@pytest.mark.parametrize(("add", "is_fused"), [(add_in_some_order, False), (fuse, True)])
def test_products_and_sums_are_off_by_less_than_their_bound(
    add: Callable[[Array, Array, np.random.Generator], float], is_fused: bool
) -> None:
    """Fused, they are off by less than two thirds of what sums in any order may be."""
    rng = np.random.default_rng(4)
    highest = 0.0
    for matrix in rng.normal(size=(12, 3, 3)):
        size, bound = np.linalg.norm(matrix, 2), bound_sums(matrix, is_fused=is_fused)
        for point in rng.normal(size=(200, 3)):
            exact = [sum(map(mul, map(Fraction, row), map(Fraction, point))) for row in matrix]
            off = [
                float(Fraction(add(row, point, rng)) - e)
                for row, e in zip(matrix, exact, strict=True)
            ]
            share = np.linalg.norm(off) / (size * np.linalg.norm(point)) / EPS / bound
            highest = max(highest, float(share))
    assert 0.3 < highest <= 1
    fused, whole = (bound_sums(matrix, is_fused=is_fused) for is_fused in (True, False))
    assert fused < 0.67 * whole


def test_equal_steps_of_different_angles_stay_apart() -> None:
    """Both parts are modelled as 1, but their unknown factors differ."""
    parts = (Step("p", "copy", (1.0,), EXACT, scaled="a"), Step("q", "copy", (1.0,), EXACT))
    products = [
        Step(name, "multiply", ("x", part), HALF) for name, part in zip("uvw", "pqp", strict=True)
    ]
    apart = (parts[0], replace(parts[1], scaled="b"), *products)
    shared = share_equal_steps(StraightLineProgram(("a", "b", "x"), apart, ("u", "v", "w")))
    assert shared.outputs == ("u", "v", "u")
    alike = (parts[0], replace(parts[1], scaled="a"), *products)
    merged = share_equal_steps(StraightLineProgram(("a", "b", "x"), alike, ("u", "v", "w")))
    assert merged.outputs == ("u", "u", "u")


def test_steps_with_different_errors_stay_apart() -> None:
    exact, rounded = (
        Step(name, "divide", ("a", "b"), u) for name, u in (("w", EXACT), ("z", HALF))
    )
    steps = (exact, Step("q", "arctan", ("w",), HALF), rounded)
    shared = share_equal_steps(StraightLineProgram(("a", "b"), steps, ("q", "z")))
    assert shared.outputs == ("q", "z")


def test_a_lost_operation_is_off_by_more() -> None:
    """With a wrong operation for w the entries are wrong, and the measured error shows it."""
    subject = displacement()
    steps = tuple(
        replace(s, kind="add") if s.result == "prepared.w" else s for s in subject.straight.steps
    )
    wrong = replace(subject, straight=replace(subject.straight, steps=steps))
    names = input_names(subject.kernel.quantity).values()
    points = {name: np.array([0.5]) for name in names}
    assert 0 <= measure(subject, points)[0] < 5
    assert measure(wrong, points)[0] > 1e10
    assert wrong.digest != subject.digest


def test_one_angle_alone_is_no_mirror() -> None:
    subject = displacement()
    assert subject.map is not None
    names = input_names(subject.kernel.quantity)
    check_signs(subject.map.entries, subject.form, names)
    alone = replace(subject.form, mirrors=((alpha,),))
    with pytest.raises(ValueError, match="odd"):
        check_signs(subject.map.entries, alone, names)


@pytest.mark.parametrize("quantity", ["displacement", "rotation"])
def test_mirrored_charts_cover_all_signs(quantity: str) -> None:
    """Every triple of angles lies in a chart after some mirroring change of signs."""
    paper = paper_of("track_wheel")
    kernel = next(k for k in list_functions(paper) if k.name == quantity)
    form = kernel.forms[0]
    reach = 11 / 7 if quantity == "displacement" else 22 / 7
    angles = np.random.default_rng(2).uniform(-reach, reach, (500, 3))
    signs = [np.ones(3)] + [np.where([a in m for a in ANGLES], -1.0, 1.0) for m in form.mirrors]
    covered = np.zeros(500, bool)
    for chart in form.charts:
        given = [chart.arguments[angle] for angle in ANGLES]
        unknown = sorted({s for g in given for s in g.free_symbols}, key=str)
        (solved,) = sp.solve([g - a for g, a in zip(given, DRAWN, strict=True)], unknown, dict=True)
        for sign in signs:
            inside = np.ones(500, bool)
            for symbol in unknown:
                value = sp.lambdify(DRAWN, solved[symbol])(*(angles * sign).T)
                side = chart.within[symbol]
                inside &= (value >= float(side.inf)) & (value <= float(side.sup))
            covered |= inside
    assert covered.all()
