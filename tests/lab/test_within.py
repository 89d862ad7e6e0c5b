"""The relations of an accuracy bound mark points whatever the shapes of the arguments are."""

from __future__ import annotations

import numpy as np
import sympy as sp

from mechproof.lab.subject import Subject
from mechproof.lab.within import mark_within
from mechproof.record import Accuracy, Argument, Form, Paper, Quantity, Variable

a, b = sp.symbols("a b", real=True)


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
    assert mark_within(subject, (points, np.float64(2.0))).tolist() == [True, False, True]
    assert mark_within(subject, (points, np.float64(0.0))).tolist() == [True, True, True]
