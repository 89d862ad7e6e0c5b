"""The worst inputs found stay within the bars, and a fresh search finds none beyond them."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from mechproof.lab.search import find_worst, scaled_errors
from mechproof.lab.subject import Subject, find_subjects

SUBJECTS = {subject.name: subject for subject in find_subjects()}
# The worst input of each long search: arguments as numbers that read back to the same doubles.
TABLE = json.loads(Path(__file__).with_name("worst_inputs.json").read_text(encoding="utf-8"))
# A seed of its own, so that the search is not the one that the table comes from.
FRESH = 4711
BARRED = {name for name, subject in SUBJECTS.items() if subject.quantity.bar}


def bar_of(subject: Subject) -> float:
    assert subject.quantity.bar is not None
    return subject.quantity.bar.ulp


@pytest.mark.parametrize("row", TABLE, ids=[row["quantity"] for row in TABLE])
def test_worst_inputs_stay_within_the_bar(row: dict[str, object]) -> None:
    subject = SUBJECTS[str(row["quantity"])]
    points = tuple(np.array([value]) for value in row["at"])  # type: ignore[attr-defined]
    (error,) = scaled_errors(subject, subject.kernel, points)
    # -1 would be a point that is undecided or beyond the bar: no row of this table.
    assert 0 <= error <= bar_of(subject)


def test_every_quantity_with_a_bar_has_a_worst_input() -> None:
    assert {row["quantity"] for row in TABLE} == BARRED


@pytest.mark.parametrize("name", sorted(BARRED))
def test_a_fresh_search_stays_within_the_bar(name: str) -> None:
    subject = SUBJECTS[name]
    found = find_worst(subject, subject.kernel, rounds=2, seed=FRESH, most=60)
    assert found.tried > 50
    assert 0 < found.scaled <= bar_of(subject)


def test_the_search_climbs() -> None:
    """More rounds find at least as much; here they find more."""
    subject = SUBJECTS["track_wheel.planar_error"]
    start = find_worst(subject, subject.kernel, rounds=0, seed=FRESH)
    later = find_worst(subject, subject.kernel, rounds=8, seed=FRESH)
    assert later.scaled > start.scaled


def test_the_search_finds_a_planted_fault() -> None:
    subject = SUBJECTS["track_wheel.radius"]

    def faulty(phi: np.ndarray, *rest: np.ndarray) -> np.ndarray:
        exact = np.asarray(subject.kernel(phi, *rest))
        return np.where((phi > 0.5) & (phi < 0.6), exact * (1 + 1e-12), exact)

    found = find_worst(subject, faulty, rounds=4, seed=FRESH)
    assert found.scaled > 100 * bar_of(subject)
    assert 0.5 < float(found.arguments[0]) < 0.6
