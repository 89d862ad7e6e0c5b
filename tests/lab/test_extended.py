"""Long doubles give the errors that balls give, and a search led by them finds more."""

from __future__ import annotations

import numpy as np
import pytest
from quantities import KERNELS, find_subject
from weights import first_of

from mechproof.lab import extended_oracle, worst_search
from mechproof.lab.extended_oracle import extend
from mechproof.lab.oracle import Truth
from mechproof.lab.sampling.named_sets import choose_evenly
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Arguments, Array
from mechproof.lab.worst_search import find_worst, scaled_errors

SEED, SHARE, POINTS = 4711, 0.1, 3
pytestmark = pytest.mark.skipif(
    not extended_oracle.IS_LONGER, reason="long doubles have the digits of doubles here"
)
# Quantities whose scale cancels where an arm has hardly turned.
HARDLY_TURNED = {
    "wedge_linkage.rod_displacement",
    "wedge_linkage.wedge_displacement",
    "wedge_linkage.roller_lever_angle",
}


def draw(subject: Subject) -> list[Arguments]:
    drawn = [*worst_search.draw_sets(subject, SEED, SHARE)][::4]
    return [tuple(c[choose_evenly(len(c), POINTS)] for c in points) for points in drawn]


def estimate(subject: Subject, points: Arguments) -> tuple[Truth, Array]:
    oracle = extend(subject)
    assert oracle is not None
    truth = oracle.find_truth(points)
    return truth, worst_search.compare(subject.kernel, points, truth)


@pytest.mark.parametrize("name", first_of(sorted({*KERNELS} - HARDLY_TURNED)))
def test_long_doubles_tell_what_balls_tell(name: str) -> None:
    """64 bits give the error of 53 to 11 bits, or fewer where a scale cancels."""
    subject, compared = find_subject(name), 0
    for points in draw(subject):
        _, roughly = estimate(subject, points)
        exactly = scaled_errors(subject, subject.kernel, points)
        both = (roughly >= 0) & (exactly >= 0)
        compared += int(both.sum())
        np.testing.assert_allclose(roughly[both], exactly[both], rtol=0.02, atol=0.02)
    assert compared >= POINTS


@pytest.mark.slow
def test_a_search_led_by_long_doubles_finds_more(monkeypatch: pytest.MonkeyPatch) -> None:
    subject = find_subject("elliptic_planetary.acceleration")
    more = find_worst(subject, subject.kernel, rounds=1, seed=SEED, share=SHARE)
    monkeypatch.setattr(worst_search, "extend", lambda subject: None)
    less = find_worst(subject, subject.kernel, rounds=1, seed=SEED, share=SHARE)
    assert more.tried > 50 * less.tried
    assert more.scaled > 1.2 * less.scaled


def test_without_long_doubles_balls_are_all_there_is(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(extended_oracle, "IS_LONGER", False)
    assert extend(find_subject("track_wheel.radius")) is None


def test_a_point_beyond_the_domain_is_not_decided() -> None:
    subject = find_subject("elliptic_planetary.position")
    truth, errors = estimate(subject, tuple(np.array([v, v]) for v in (1.0, 66.0, 16.0, 1.5)))
    assert not truth.decided.any()
    assert (errors == -1).all()


def test_results_that_are_lost_inside_the_domain_are_seen() -> None:
    subject = find_subject("track_wheel.radius")
    points = draw(subject)[0]
    oracle = extend(subject)
    assert oracle is not None
    truth = oracle.find_truth(points)
    lost = worst_search.compare(lambda phi, *rest: phi * np.nan, points, truth)
    assert (lost[truth.decided] == np.inf).all()
