"""Climbs of matrices find badly rounded ones, and points that these move far."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from derived import paper_of

from mechproof.arithmetic.intervals import Array
from mechproof.programs.kernel import list_functions
from mechproof.roundoff import matrix_climbs, worst
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.kernel_stages import list_computed_stages
from mechproof.roundoff.matrix_climbs import list_starts
from mechproof.roundoff.regions import list_regions
from mechproof.roundoff.worst import draw, estimate

pytestmark = pytest.mark.skipif(
    not worst.IS_LONGER, reason="long doubles have the digits of doubles here"
)


@cache
def displacement() -> ComputedStage:
    paper = paper_of("track_wheel")
    kernel = next(k for k in list_functions(paper) if k.name == "displacement")
    return next(list_computed_stages(kernel, paper))


def draw_some() -> dict[str, Array]:
    subject = displacement()
    region = next(list_regions(subject.form.charts[0]))
    return dict(draw(subject, region, region.box, 500, np.random.default_rng(3)))


@pytest.fixture(autouse=True)
def few_climbs(monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in {"CLIMBS": 6, "ROUNDS": 20, "KEPT": 2, "DRAWN": 400}.items():
        monkeypatch.setattr(matrix_climbs, name, value)


def test_points_for_the_worst_matrices_are_off_by_more() -> None:
    drawn = draw_some()
    starts = list_starts(displacement(), drawn, np.random.default_rng(5))
    assert [len(start["alpha"]) for start in starts] == [400, 400]
    plain, found = estimate(displacement(), drawn), estimate(displacement(), starts[0])
    assert np.median(found) > 1.5 * np.median(plain)
    assert found.max() > 1.2 * plain.max()


def test_a_direction_across_the_worst_is_off_by_less(monkeypatch: pytest.MonkeyPatch) -> None:
    along = list_starts(displacement(), draw_some(), np.random.default_rng(5))[0]
    solve = np.linalg.svd

    def turn(matrix: Array, *given: object) -> tuple[Array, ...]:
        left, sizes, right = solve(matrix, *given)
        return left, sizes, right[::-1]

    monkeypatch.setattr(np.linalg, "svd", turn)
    across = list_starts(displacement(), draw_some(), np.random.default_rng(5))[0]
    assert np.median(estimate(displacement(), across)) < np.median(estimate(displacement(), along))
