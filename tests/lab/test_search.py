"""A search climbs, and finds a planted fault."""

from __future__ import annotations

import numpy as np
import pytest
from ways import bound_of, find_subject

from mechproof.lab.worst_search import find_worst

FRESH = 4711


@pytest.mark.thorough
def test_the_search_climbs() -> None:
    """More rounds find at least as much; here they find more."""
    subject = find_subject("track_wheel.planar_error")
    start = find_worst(subject, subject.kernel, rounds=0, seed=FRESH)
    later = find_worst(subject, subject.kernel, rounds=8, seed=FRESH)
    assert later.scaled > start.scaled


@pytest.mark.slow
def test_the_search_finds_a_planted_fault() -> None:
    subject = find_subject("track_wheel.radius")

    def faulty(phi: np.ndarray, *rest: np.ndarray) -> np.ndarray:
        exact = np.asarray(subject.kernel(phi, *rest))
        return np.where((phi > 0.5) & (phi < 0.6), exact * (1 + 1e-12), exact)

    found = find_worst(subject, faulty, rounds=4, seed=FRESH, share=0.3)
    assert found.scaled > 100 * bound_of("track_wheel.radius")
    assert 0.5 < float(found.arguments[0]) < 0.6
