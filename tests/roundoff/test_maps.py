"""Maps of points: the norm of their error, its scale, and what both refuse."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import sympy as sp
from derived import paper_of
from weights import first_of

from mechproof.derivations.track_wheel.kernels.poses import ROTATION
from mechproof.derivations.track_wheel.mechanics import ANGLES, UNIT_QUATERNION, alpha
from mechproof.programs.kernel import input_names, list_functions
from mechproof.roundoff.affine import find_size
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.kernel_stages import list_computed_stages
from mechproof.roundoff.regions import list_regions
from mechproof.roundoff.steps import EXACT
from mechproof.roundoff.symmetry import check_signs
from mechproof.roundoff.worst import measure

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
