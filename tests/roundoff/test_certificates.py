"""Certificates of rounding errors hold, are checked, and are refused when wrong."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import sympy as sp
from certified import GROUP, SYSTEMS, certificate, claims, name_claim, subject_of, subjects
from derived import paper_of
from weights import first_of

from mechproof.arithmetic.cover import WHOLE
from mechproof.kernel_support.functions import (
    arctan_quotient,
    small_arctan,
    tangent_quotient,
)
from mechproof.programs.kernel import input_names, list_functions
from mechproof.record import Paper
from mechproof.roundoff import computed_stages
from mechproof.roundoff.certificate import (
    RoundingClaim,
    describe_bound,
    describe_place,
    describe_proofs,
    holds,
    is_shown,
    list_stages,
    read_cuts,
    write_cuts,
)
from mechproof.roundoff.compensation import find_compensated
from mechproof.roundoff.compiled_kernels import WAY
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.regions import list_regions
from mechproof.roundoff.running import IN_DOUBLES, run
from mechproof.roundoff.steps import IN_NUMPY, NORMAL, Step
from mechproof.roundoff.symmetry import check_signs
from mechproof.roundoff.worst import draw, measure
from mechproof.roundoff.written_scales import WrittenScale

pytestmark = pytest.mark.xdist_group(GROUP)
# Found by a search along the boxes with the largest bounds, all roundings nearly aligned.
WORST = {
    "phi1": "0x1.fdd93da54f7fep+1",
    "R1": "0x1.1841b23f7e120p+15",
    "R2": "0x1.155351948ecc5p+7",
    "e": "0x1.eb7b42cff731ap-2",
}


def find_plain(way: str) -> tuple[RoundingClaim, ComputedStage]:
    told = "position", "half-angle atan", way
    (claim,) = (c for c in claims() if (c.quantity, c.form, c.way) == told)
    return claim, subject_of(claim)


def plain() -> tuple[RoundingClaim, ComputedStage]:
    return find_plain("NumPy's functions")


def compiled() -> tuple[RoundingClaim, ComputedStage]:
    return find_plain(WAY)


@pytest.mark.slow
@pytest.mark.parametrize(
    "claim", first_of(sorted(claims(), key=lambda c: c.way != "by polynomials")), ids=name_claim
)
def test_random_inputs_are_off_by_no_more_than_is_proved(claim: RoundingClaim) -> None:
    subject, rng = subject_of(claim), np.random.default_rng(4711)
    regions = [region for chart in subject.form.charts for region in list_regions(chart)]
    drawn = [measure(subject, draw(subject, one, one.box, 1000, rng)) for one in regions]
    # One of several similar regions may lie outside the domain, and another may round nothing.
    errors = np.concatenate(drawn)
    assert np.sum(errors >= 0) > 300
    assert 0 < errors.max() <= claim.proved


def test_the_known_worst_is_below_the_bound() -> None:
    claim, subject = compiled()
    points = {name: np.array([float.fromhex(text)]) for name, text in WORST.items()}
    assert 3.2 < measure(subject, points)[0] <= claim.proved


def test_a_bound_lowered_by_a_tenth_is_refused() -> None:
    claim, subject = plain()
    assert not holds(subject, replace(claim, proved=0.9 * claim.proved))


def test_intervals_alone_do_not_show_what_linear_forms_show(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    subject = next(s for (name, _, _), s in subjects().items() if name == "velocity")
    claim = next(c for c in claims() if c.quantity == "velocity" and c.way == subject.way)
    assert is_shown(subject, claim)
    monkeypatch.setattr(computed_stages, "LONG", math.inf)
    assert not is_shown(replace(subject), claim)
    assert not is_shown(replace(subject), replace(claim, proved=2 * claim.proved))


@pytest.mark.thorough
@pytest.mark.parametrize("claim", claims(), ids=name_claim)
def test_every_bound_lowered_by_a_tenth_is_refused(claim: RoundingClaim) -> None:
    assert not holds(subject_of(claim), replace(claim, proved=0.9 * claim.proved))


def test_an_endless_bound_is_refused() -> None:
    claim, subject = plain()
    assert not holds(subject, replace(claim, proved=math.inf))


def test_a_bound_that_is_not_the_least_is_refused() -> None:
    claim, subject = plain()
    assert holds(subject, claim)
    assert not holds(subject, replace(claim, proved=1.02 * claim.proved))


def test_another_number_of_boxes_is_refused() -> None:
    claim, subject = plain()
    assert not holds(subject, replace(claim, boxes=claim.boxes - 1))


def test_boxes_that_are_cut_less_are_refused() -> None:
    claim, subject = plain()
    cuts = read_cuts(claim.cuts).copy()
    assert (cuts == WHOLE).sum() == claim.boxes
    # Leave the box that is cut last whole, and drop its two parts.
    last = np.flatnonzero(cuts != WHOLE)[-1]
    cuts[last] = WHOLE
    fewer = replace(claim, cuts=write_cuts([cuts[:-2]]), boxes=claim.boxes - 1)
    assert not holds(subject, fewer)


@pytest.mark.parametrize(
    "cuts", ["", "no text of cuts", "AAAA", write_cuts([np.array([], np.int8)])]
)
def test_cuts_of_other_boxes_are_refused(cuts: str) -> None:
    claim, subject = plain()
    assert not holds(subject, replace(claim, cuts=cuts))


def test_cuts_that_are_left_over_are_refused() -> None:
    claim, subject = plain()
    more = np.array([WHOLE], np.int8)
    assert not holds(subject, replace(claim, cuts=write_cuts([read_cuts(claim.cuts), more])))


def test_a_bound_is_shown_once_for_ways_that_compute_the_same(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    known = certificate("track_wheel")
    covered = []

    def show(subject: ComputedStage, claim: RoundingClaim) -> bool:
        covered.append(subject.kernel.name)
        return is_shown(subject, claim)

    monkeypatch.setattr("mechproof.roundoff.certificate.is_shown", show)
    pair = [claim for claim in known.claims if claim.quantity == "largest_radius"]
    one, other = map(subject_of, pair)
    assert one.way != other.way
    rotation = next(claim for claim in known.claims if claim.quantity == "rotation")
    assert one.basis == other.basis != subject_of(rotation).basis
    assert holds(other, pair[1], [pair[0]])
    assert not covered
    wrong = replace(pair[1], boxes=pair[1].boxes - 1)
    assert not holds(other, wrong, [pair[0]])
    assert covered


def test_a_left_out_assumption_is_refused() -> None:
    claim, subject = plain()
    assert not holds(subject, replace(claim, assumptions=claim.assumptions[1:]))


@pytest.mark.parametrize("found", [0.0, -1.0, math.nan])
def test_another_error_than_that_of_the_input_is_refused(found: float) -> None:
    claim, subject = compiled()
    assert not holds(subject, replace(claim, found=found))


def list_digests(paper: Paper) -> list[str]:
    return [s.digest for kernel in list_functions(paper) for s in list_stages(kernel, paper)]


def test_what_errors_are_told_in_is_part_of_what_is_kept() -> None:
    paper = paper_of("track_wheel")
    (rotation,) = (q for q in paper.quantities if q.name == "rotation")
    assert rotation.accuracy is not None
    assert rotation.accuracy.scale is not None
    scale = replace(rotation.accuracy.scale, expression=sp.Integer(2))
    other = replace(rotation, accuracy=replace(rotation.accuracy, scale=scale))
    changed = tuple(other if q is rotation else q for q in paper.quantities)
    assert list_digests(replace(paper, quantities=changed)) != list_digests(paper)


def test_an_input_that_no_chart_has_is_refused() -> None:
    claim, subject = plain()
    at = {**claim.at, "phi1": (2.0**40).hex()}
    points = {name: np.array([float.fromhex(text)]) for name, text in at.items()}
    (error,) = measure(subject, points)
    assert 0 <= error <= claim.proved
    assert not holds(subject, replace(claim, at=at, found=math.floor(100 * error) / 100))


def test_a_changed_step_is_refused() -> None:
    claim, subject = plain()
    steps = subject.straight.steps
    rounded = next(i for i, step in enumerate(steps) if step.ulps)
    for changed in (
        steps[:-1],
        (*steps[:rounded], replace(steps[rounded], ulps=0.0), *steps[rounded + 1 :]),
    ):
        other = replace(subject, straight=replace(subject.straight, steps=changed))
        assert not holds(other, claim)


def test_all_that_a_bound_is_of_is_hashed() -> None:
    _, subject = plain()
    form, straight = subject.form, subject.straight
    (chart, *charts), (first, *steps) = form.charts, straight.steps
    told = (replace(first, proved="tan"), replace(first, scaled="y"))
    changed = [
        replace(subject, form=replace(form, charts=(replace(chart, rest=sp.S.One), *charts))),
        replace(subject, form=replace(form, mirrors=((sp.Symbol("e"),),))),
        *(replace(subject, straight=replace(straight, steps=(step, *steps))) for step in told),
        replace(subject, straight=replace(straight, held=("y",))),
        replace(subject, straight=replace(straight, scaled=("y",))),
        replace(subject, scale=WrittenScale((straight,), 0, ())),
        replace(subject, scale=WrittenScale((straight, straight), 1, (True,))),
        replace(subject, computed=straight),
    ]
    assert len({other.digest for other in (subject, *changed)}) == 1 + len(changed)


def test_a_wrong_number_is_refused_even_under_its_own_hash() -> None:
    claim, subject = plain()
    steps = tuple(
        replace(s, operands=tuple(2 + 2.0**-40 if o == 2 else o for o in s.operands))
        for s in subject.straight.steps
    )
    assert steps != subject.straight.steps
    wrong = replace(subject, straight=replace(subject.straight, steps=steps))
    forged = replace(claim, program=wrong.digest)
    region = next(list_regions(subject.form.charts[0]))
    points = draw(wrong, region, region.box, 300, np.random.default_rng(1))
    assert measure(wrong, points).max() > forged.proved


def test_every_rounding_counts() -> None:
    """Leaving out any one rounding of a program lowers its bound.

    That of a product with a rest is one of eps**2, which doubles do not tell from nothing.
    """
    _, subject = compiled()
    region = next(list_regions(subject.form.charts[0]))
    boxes = np.array([[(0.3, 0.31) if math.isfinite(side[1]) else side for side in region.box]])
    whole = subject.bound(region, boxes)
    tiny = [s for s in subject.straight.steps if "prepared.one_minus_e_low" in s.operands]
    assert [step.kind for step in tiny] == ["multiply"]
    rounded = [i for i, step in enumerate(subject.straight.steps) if step.ulps and step not in tiny]
    assert len(rounded) > 15
    for i in rounded:
        steps = list(subject.straight.steps)
        steps[i] = replace(steps[i], ulps=0.0)
        other = replace(subject, straight=replace(subject.straight, steps=tuple(steps)))
        assert other.bound(region, boxes) < whole


@pytest.mark.slow
@pytest.mark.parametrize("claim", claims(), ids=name_claim)
def test_no_part_of_a_box_has_a_larger_bound(claim: RoundingClaim) -> None:
    """A bound on a box holds on its parts, also at ends where something vanishes or has a pole."""
    subject, rng = subject_of(claim), np.random.default_rng(5)
    region = next(list_regions(subject.form.charts[0]))
    box, parts = np.array(region.box), []
    ends = np.where(np.isinf(box), 0.0, box)
    for _ in range(40):
        size = 2.0 ** -rng.integers(4, 12)
        side = (ends[:, 1] - ends[:, 0]) * size
        start = ends[:, 0] + rng.integers(0, 2, len(box)) * (ends[:, 1] - ends[:, 0] - side)
        large = np.stack([start, start + side], axis=1)
        large[np.isinf(box[:, 1])] = box[np.isinf(box[:, 1])]
        half = np.stack([start + side / 2, start + side], axis=1)
        half[np.isinf(box[:, 1])] = box[np.isinf(box[:, 1])]
        parts.append((large, half))
    whole, halves = (subject.bound(region, np.array(some)) for some in zip(*parts, strict=True))
    assert np.sum(np.isfinite(whole)) >= 10
    # Errors are assigned to a scale's terms differently for every box, which changes little.
    has_terms = subject.scale is not None and bool(subject.scale.terms)
    assert np.all(halves <= whole * (1 + (1e-3 if has_terms else 1e-9)))
    for limits, boxes in zip((whole, halves), zip(*parts, strict=True), strict=True):
        points = [draw(subject, region, sides, 1, rng) for sides in boxes]
        together = {name: np.concatenate([p[name] for p in points]) for name in points[0]}
        assert np.all(measure(subject, together) <= limits)


@pytest.mark.parametrize(
    ("kind", "compute", "limit"),
    [
        ("tangent_quotient", tangent_quotient, 1e5),
        ("small_arctan", small_arctan, 0.57),
        ("arctan_quotient", arctan_quotient, 1e5),
    ],
)
def test_expansions_are_what_the_support_computes(kind: str, compute: Any, limit: float) -> None:
    rng = np.random.default_rng(7)
    y = rng.uniform(-limit, limit, 5000) * 2.0 ** -rng.integers(0, 30, 5000)
    program = IN_NUMPY[kind].program
    given = dict(zip(program.inputs, (y, *map(np.float64, (0.9, 0.7, 1e-17, 1.3))), strict=False))
    (found,) = run(program, given, IN_DOUBLES)
    assert np.array_equal(found, compute(*given.values()))


@pytest.mark.parametrize("system", ["elliptic_planetary", "track_wheel"])
def test_bounds_are_near_the_worst_that_is_found(system: str) -> None:
    near = {"ratio", "acceleration", "displacement"}
    told = [claim for claim in certificate(system).claims if claim.quantity in near]
    assert len(told) == (4 if system == "elliptic_planetary" else 2)
    assert all(claim.proved <= 1.5 * claim.found for claim in told)


def test_certificates_are_what_the_derivations_say() -> None:
    told = {name: (c.program, c.where, c.open) for c in claims() for name in [name_claim(c)]}
    for subject in subjects().values():
        name = f"{subject.kernel.name}: {subject.form.name}, {subject.way}"
        assert told[name] == (subject.digest, subject.where, "")


@pytest.mark.parametrize("system", SYSTEMS)
def test_what_a_bound_rests_on_is_told_with_it(system: str) -> None:
    known = certificate(system)
    quantities = describe_proofs(paper_of(system), known).quantities
    told = {(q.name, f.name): f.proved for q in quantities for f in q.forms if f.proved}
    assert told.keys() == {(c.quantity, c.form) for c in known.claims}
    for claim in known.claims:
        text = told[claim.quantity, claim.form]
        assert f", as long as {NORMAL}: at most" in text
        assert f"at most {describe_bound(claim)} eps" in text
        assert all(assumption in text for assumption in claim.assumptions)


def test_a_bound_for_all_is_told_so() -> None:
    assert describe_place(()) == ""
    assert describe_place(("x < 1", "x > 2")) == ", where x < 1 or x > 2"


@pytest.mark.parametrize("way", ["NumPy's functions", "compiled"])
def test_a_rest_that_is_not_added_is_refused(way: str) -> None:
    """If the low word is not added, the angle's rounding moves the output and must not be held."""
    subject = subjects()["position", "half-angle atan with low word", way]
    free = replace(subject.straight, held=())
    assert find_compensated(free) == subject.straight
    steps = tuple(
        replace(step, kind="subtract") if step.result == "x_low" else step for step in free.steps
    )
    with pytest.raises(ValueError, match="depends on the rounding of"):
        find_compensated(replace(free, steps=steps))


def test_an_angle_without_symmetry_is_refused() -> None:
    _, subject = plain()
    first, *others = subject.straight.steps
    lopsided = Step("odd", "add", ("phi1", 1), 0.5)
    with pytest.raises(ValueError, match="an odd and an even term"):
        check_signs(
            replace(subject.straight, steps=(first, lopsided, *others)),
            subject.form,
            input_names(subject.kernel.quantity),
        )
