"""Bounded stages of the linkage have the scales that the derivation states."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from certified import GROUP, subjects
from weights import first_of

from mechproof.programs.kernel import input_names
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.regions import list_regions
from mechproof.roundoff.running import IN_DOUBLES, run
from mechproof.roundoff.steps import HALF, Step
from mechproof.roundoff.worst import draw, measure

pytestmark = pytest.mark.xdist_group(GROUP)


def with_terms() -> list[ComputedStage]:
    found = subjects().values()
    return [s for s in found if s.scale and s.scale.terms]


@pytest.mark.slow
@pytest.mark.parametrize("name", first_of(["guide_radicand", "roller_offset", "lever_angle"]))
def test_the_terms_add_up_to_the_scale(name: str) -> None:
    subject = next(s for s in with_terms() if s.kernel.name == name)
    assert subject.scale is not None
    rng = np.random.default_rng(3)
    whole, parts = subject.scale.straights
    for chart in subject.form.charts:
        for region in list_regions(chart):
            points = draw(subject, region, region.box, 200, rng)
            (size, *rest) = run(whole, points, IN_DOUBLES)
            terms = run(parts, points, IN_DOUBLES)[: subject.scale.terms]
            value = run(subject.exact, points, IN_DOUBLES)[0] if rest else 0.0
            total = sum(map(np.abs, terms)) + np.abs(value)
            kept = np.isfinite(total) & (measure(subject, points) >= 0)
            np.testing.assert_allclose(total[kept], size[kept], rtol=1e-9)


@pytest.mark.slow
def test_waves_are_joined_without_a_change() -> None:
    """The arm's scale is written as products, and equals that of the paper's derivation."""
    subject = next(s for s in subjects().values() if s.kernel.name == "rod_displacement")
    accuracy = subject.kernel.quantity.accuracy
    assert subject.scale is not None
    assert accuracy is not None
    assert accuracy.scale is not None
    region = next(list_regions(subject.form.charts[0]))
    points = draw(subject, region, region.box, 200, np.random.default_rng(4))
    names = input_names(subject.kernel.quantity)
    compute = sp.lambdify([*names], accuracy.scale.written_out(), "numpy")
    wanted = compute(*(points[name] for name in names.values()))
    found = run(subject.scale.straights[0], points, IN_DOUBLES)[0]
    np.testing.assert_allclose(found, wanted, rtol=1e-6)


@pytest.mark.slow
def test_a_step_twice_is_one_more_rounding() -> None:
    """A lever angle that is rounded once more has a larger bound, in every stage."""
    for subject in (s for s in subjects().values() if s.kernel.name == "lever_angle"):
        region = next(list_regions(subject.form.charts[0]))
        boxes = np.array([[(0.3, 0.31) if side[1] <= 1 else side for side in region.box]])
        (output,) = subject.straight.outputs
        steps = (*subject.straight.steps, Step("again", "copy", (output,), HALF))
        worse = replace(subject.straight, steps=steps, outputs=("again",))
        more = replace(subject, straight=worse).bound(region, boxes)
        assert more > subject.bound(region, boxes) + 0.1
