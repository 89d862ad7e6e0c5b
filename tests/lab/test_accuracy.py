"""Every accuracy bound holds for the worst inputs ever met, and a fresh search finds no excess.

The bounds are not proofs: they are argued next to the forms and tested by searches. Seeds are
fixed, so runs are reproducible; an error beyond a bound is a fault of the kernel or of the bound.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from compiled import grouped
from quantities import BOUNDED, GENERATED, KERNELS, find_subject

from mechproof.lab.subject import Subject, find_subjects
from mechproof.lab.ways import Arguments, Array, Compute
from mechproof.lab.worst_search import find_worst, scaled_errors
from mechproof.measured import read_record

# The worst inputs that searches met, as numbers that read back to the same doubles.
TABLE = json.loads(Path(__file__).with_name("worst_inputs.json").read_text(encoding="utf-8"))
COMPILED_WAY = "kernel, compiled"
# Another seed than that of the search that filled the table.
FRESH = 4711
# The share of every set, and the most points, that are tried; the ball of an integral takes a
# hundred times as long.
SHARE, MOST, MOST_INTEGRALS = 0.05, 20, 7


def bound_of(subject: Subject) -> float:
    assert subject.quantity.accuracy is not None
    return subject.quantity.accuracy.ulp


def as_points(row: dict[str, object]) -> Arguments:
    return tuple(np.array([value]) for value in row["at"])  # type: ignore[attr-defined]


@pytest.mark.slow
@pytest.mark.parametrize("name", BOUNDED)
def test_worst_inputs_stay_within_the_bound(name: str) -> None:
    subject = find_subject(name)
    rows = [row for row in TABLE if row["quantity"] == name]
    assert rows
    for row in rows:
        (error,) = scaled_errors(subject, one_mechanism(subject), as_points(row))
        # -1 would mean an undecided point, or one where no bound is stated: the table has none.
        assert 0 <= error <= bound_of(subject), row


def test_quantities_are_listed_as_the_papers_have_them() -> None:
    subjects = find_subjects()
    stated = {s.name: s.quantity.accuracy.ulp for s in subjects if s.quantity.accuracy}
    assert {name: float(bound) for name, bound in stated.items()} == BOUNDED
    assert sorted(s.name for s in subjects if s.quantity.forms) == sorted(KERNELS)


def test_rows_are_of_quantities_with_a_bound() -> None:
    assert {row["quantity"] for row in TABLE} <= set(BOUNDED)


def one_mechanism(subject: Subject) -> Compute:
    """Return the kernel for one mechanism, run on two equal points so that it uses polynomials."""

    def compute(running: Array, *sizes: Array) -> Array:
        twice = np.repeat(running, 2, axis=0)
        found: Array = subject.kernel(twice, *(size[0] for size in sizes))[:1]
        return found

    return compute


@pytest.mark.parametrize("name", grouped(n for n in BOUNDED if n in KERNELS))
def test_worst_inputs_stay_within_the_bound_compiled(name: str) -> None:
    subject = find_subject(name)
    compute = getattr(subject.load_compiled(), subject.quantity.name)
    rows = [row for row in TABLE if row["quantity"] == name]
    assert rows
    # The record covers these inputs: compiled kernels have the same bits on every host.
    (found,) = (
        f
        for f in read_record(GENERATED / "measured" / f"{name}.json").searched
        if f.way == COMPILED_WAY
    )
    assert found.scaled <= bound_of(subject)

    def alone(*points: Array) -> Array:
        # A single point gives the same bits without the loops, which take twice as long to compile.
        return np.array([compute(*(column[0] for column in points))])

    for row in rows:
        (error,) = scaled_errors(subject, alone, as_points(row))
        assert 0 <= error <= found.scaled, row


@pytest.mark.thorough
@pytest.mark.parametrize("name", BOUNDED)
def test_a_fresh_search_stays_within_the_bound(name: str) -> None:
    subject = find_subject(name)
    rounds, most = (1, MOST_INTEGRALS) if subject.exact.has(sp.Integral) else (1, MOST)
    found = find_worst(subject, subject.kernel, rounds, FRESH, SHARE, most)
    assert found.tried > 50
    assert 0 < found.scaled <= bound_of(subject)
