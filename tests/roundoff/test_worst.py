"""The search for the worst input is led by long doubles, judged by balls, and leaves no chart."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from certified import GROUP, claims, name_claim, subject_of, subjects
from weights import first_of

from mechproof.arithmetic.cover import WHOLE, Box, Cover
from mechproof.arithmetic.intervals import Array
from mechproof.record import Chart, Form
from mechproof.roundoff import certificate, worst
from mechproof.roundoff.certificate import RoundingClaim
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.regions import ChartRegion, find_membership, list_regions
from mechproof.roundoff.running import IN_DOUBLES
from mechproof.roundoff.worst import WorstRounding, draw, estimate, find_worst, judge, measure

pytestmark = pytest.mark.xdist_group(GROUP)
needs_long_doubles = pytest.mark.skipif(
    not worst.IS_LONGER, reason="long doubles have the digits of doubles here"
)


def find_subject(quantity: str, form: str = "", way: str = "NumPy's functions") -> ComputedStage:
    return next(
        s
        for s in subjects().values()
        if s.kernel.name == quantity and s.form.name.endswith(form) and s.way == way
    )


def list_boxes(subject: ComputedStage) -> Iterator[tuple[ChartRegion, Box]]:
    for chart in subject.form.charts:
        for region in list_regions(chart):
            yield region, region.box


def draw_all(subject: ComputedStage, count: int, seed: int) -> dict[str, Array]:
    rng = np.random.default_rng(seed)
    drawn = [draw(subject, region, box, count, rng) for region, box in list_boxes(subject)]
    return {name: np.concatenate([points[name] for points in drawn]) for name in drawn[0]}


@needs_long_doubles
@pytest.mark.parametrize("claim", first_of(claims()), ids=name_claim)
def test_long_doubles_tell_what_balls_tell(claim: RoundingClaim) -> None:
    subject = subject_of(claim)
    points = draw_all(subject, 12, 3)
    roughly, exactly = estimate(subject, points), judge(subject, points)
    assert np.array_equal(roughly < 0, exactly < 0)
    # Exact results have no error, and one of two charts may lie outside the domain.
    assert np.mean(exactly >= 0) >= 0.5
    np.testing.assert_allclose(roughly, exactly, rtol=0, atol=0.01)


@pytest.mark.slow
@needs_long_doubles
@pytest.mark.parametrize("quantity", ["position", "displacement"])
def test_a_search_climbs_and_leaves_no_chart(
    quantity: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    subject = find_subject(quantity)
    boxes = list(list_boxes(subject))
    monkeypatch.setattr(worst, "CLIMBS", 1)
    monkeypatch.setattr(worst, "list_starts", lambda *_: [])
    errors = []
    for rounds in (0, 30):
        monkeypatch.setattr(worst, "ROUNDS", rounds)
        found = find_worst(subject, boxes, 5)
        at = {name: np.array([value]) for name, value in found.at.items()}
        assert judge(subject, at)[0] == found.eps
        errors.append(found.eps)
    assert errors[1] > 1.1 * errors[0]


@needs_long_doubles
def test_a_search_finds_a_planted_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    """The fault affects only the largest eccentricities."""
    subject = find_subject("position", "half-angle atan")
    compute = ComputedStage.compute

    def fail(self: ComputedStage, points: dict[str, Array]) -> Array:
        found = compute(self, points)
        return np.where(np.asarray(points["e"]) > 0.479, found * (1 + 2.0**-48), found)

    monkeypatch.setattr(ComputedStage, "compute", fail)
    monkeypatch.setattr(worst, "CLIMBS", 1)
    monkeypatch.setattr(worst, "ROUNDS", 5)
    found = find_worst(subject, list(list_boxes(subject)), 5)
    assert found.eps > 14
    assert 0.479 < found.at["e"] <= 0.48


def test_without_long_doubles_balls_are_all_there_is(monkeypatch: pytest.MonkeyPatch) -> None:
    subject = find_subject("rotation")
    monkeypatch.setattr(worst, "IS_LONGER", False)
    monkeypatch.setattr(worst, "estimate", None)
    monkeypatch.setattr(worst, "DRAWN", 40)
    monkeypatch.setattr(worst, "ROUNDS", 5)
    assert 0.5 < find_worst(subject, list(list_boxes(subject)), 5).eps < 3


# Radii that double an angle, and an angle of many turns.
TWICE, AT_PEAK = (2.0, 1.0), 16 * np.pi + 0.001


@pytest.mark.parametrize(
    ("quantity", "form", "inside", "outside"),
    [
        ("position", "half-angle atan", (2.0**25, *TWICE, 0.48), (2.0**25 + 1, *TWICE, 0.48)),
        ("ratio", "", (AT_PEAK, *TWICE, 1 - 2.0**-10), (AT_PEAK, *TWICE, 1 - 2.0**-11)),
        ("ratio", "", (1.57, *TWICE, 1 - 2.0**-40), (AT_PEAK, *TWICE, 1 - 2.0**-40)),
        ("acceleration", "", (1.57, *TWICE, 0.25), (np.pi / 2, *TWICE, 0.25)),
        ("acceleration", "", (1.571, *TWICE, 0.75), (1.572, *TWICE, 0.75)),
        ("rotation", "", (3.1, 3.1, 3.1), (3.1, 3.1, 3.15)),
        ("rotation", "", (3.1, -3.1, 3.1), (3.15, -3.1, 3.1)),
    ],
)
def test_what_no_chart_has_does_not_count(
    quantity: str, form: str, inside: tuple[float, ...], outside: tuple[float, ...]
) -> None:
    """Mirrored signs make no difference."""
    subject = find_subject(quantity, form)
    for sign in (1, -1):
        first, *others = zip(inside, outside, strict=True)
        columns = [sign * np.array(first), *map(np.array, others)]
        points = dict(zip(subject.exact.inputs, columns, strict=True))
        assert np.all(measure(subject, points) >= 0)
        assert (judge(subject, points) >= 0).tolist() == [True, False]
        assert (estimate(subject, points) >= 0).tolist() == [True, False]


def test_arguments_that_do_not_tell_their_coordinates_are_refused() -> None:
    x, y, a = sp.symbols("x y a")
    sides = dict.fromkeys((x, y), sp.Interval(0, 1))
    charts = [Chart("", {a: value}, sides) for value in (x + y, x)]
    charts.append(Chart("", {a: x**2}, {x: sp.Interval(-1, 1)}))
    for chart in charts:
        with pytest.raises(ValueError, match="do not determine"):
            find_membership(Form("", a, charts=(chart,)), {a: "a"})


def test_of_a_mirror_all_signs_change() -> None:
    a, b = sp.symbols("a b")
    chart = Chart("", {a: a, b: b}, dict.fromkeys((a, b), sp.Interval(0, 1)))
    form = Form("", a, charts=(chart,), mirrors=((a, b),))
    points = {"a": np.array([1.0, -1.0, 1.0]), "b": np.array([1.0, -1.0, -1.0])}
    for some, held in (
        (form, [True, True, False]),
        (replace(form, mirrors=()), [True, False, False]),
    ):
        inside = find_membership(some, {a: "a", b: "b"})
        assert inside.holds(points, IN_DOUBLES).tolist() == held


def test_an_input_beyond_what_is_proved_refutes_the_proof(monkeypatch: pytest.MonkeyPatch) -> None:
    claim = claims()[0]
    subject = subject_of(claim)
    at = {name: float.fromhex(text) for name, text in claim.at.items()}
    monkeypatch.setattr(certificate, "_lower_bound", lambda subject, low: claim.proved)
    region = next(list_regions(subject.form.charts[0]))
    cover = Cover(1, ((claim.proved, region.box),), None, np.array([WHOLE], np.int8))
    monkeypatch.setattr(certificate, "cover_all", lambda subject, aim, most: [(region, cover)])
    found = WorstRounding(claim.proved * 1.001, at)
    monkeypatch.setattr(certificate, "_search", lambda subject, covers: found)
    with pytest.raises(ArithmeticError, match=f"^{claim.quantity}\\..* at most {claim.proved}"):
        certificate.make_claim(subject)
