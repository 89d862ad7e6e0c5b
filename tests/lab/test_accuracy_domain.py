"""Domains of stated bounds: points of any shape are marked, and records stay within them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from quantities import BOUNDED, find_subject

from mechproof.lab.subject import Subject
from mechproof.lab.ways import Array
from mechproof.lab.worst_search import mark_accuracy_domain
from mechproof.measured import read_record
from mechproof.record import Accuracy, Argument, Form, Paper, Quantity, Variable

a, b = sp.symbols("a b", real=True)
MEASURED = Path(__file__).parents[2] / "generated" / "measured"


def test_alternatives_of_arguments_of_several_shapes() -> None:
    arguments = Argument("a", (a,), "a number"), Argument("b", (b,), "a number")
    accuracy = Accuracy(1, within=(sp.Or(sp.Eq(a, 0), sp.Eq(b, 0), sp.Abs(a * b) > 4),))
    quantity = Quantity(
        "f", "Multiply.", arguments, a * b, (Form("product", a * b),), "here", accuracy=accuracy
    )
    variables = (Variable(a, "a number"), Variable(b, "a number"))
    paper = Paper("system", "citation", variables, (), quantities=(quantity,))
    subject = Subject(paper, quantity, (), (None, None))
    points = np.array([0.0, 1.0, 5.0])
    assert mark_accuracy_domain(subject, (points, np.float64(2.0))).tolist() == [True, False, True]
    assert mark_accuracy_domain(subject, (points, np.float64(0.0))).tolist() == [True, True, True]


def mark_point(subject: Subject, point: tuple[object, ...]) -> Array:
    return mark_accuracy_domain(subject, tuple(np.array([value]) for value in point))


@pytest.mark.slow
@pytest.mark.parametrize("name", BOUNDED)
def test_worst_points_of_records_lie_where_the_bound_is_stated(name: str) -> None:
    record = read_record(MEASURED / f"{name}.json")
    assert all(mark_point(find_subject(name), found.at).all() for found in record.searched)


def test_a_worst_point_beyond_the_statement_is_seen() -> None:
    """The bound of a track's radius is stated up to z*|phi| = 2**26."""
    subject = find_subject("track_wheel.radius")
    (found, *_) = read_record(MEASURED / "track_wheel.radius.json").searched
    _, *others, z = found.at
    assert isinstance(z, float)
    assert not mark_point(subject, (2.0**27 / z, *others, z)).any()
