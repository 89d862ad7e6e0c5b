"""Formulas as plain text: argument names, brackets, powers, and lines that are not too long."""

from __future__ import annotations

import pytest
import sympy as sp
from derived import paper_of

from mechproof.codegen.docstrings import WIDTH, describe_accuracy, describe_kernel
from mechproof.codegen.form_rows import form_rows
from mechproof.codegen.formula_text import join_equal_limits, write_formula
from mechproof.programs.kernel import list_functions
from mechproof.record import Accuracy

a, b = sp.symbols("a b", real=True)
i, j = sp.symbols("i j", integer=True, positive=True)
m = sp.IndexedBase("m", real=True)
SMALL = sp.Rational(1, 10**50)


@pytest.mark.parametrize(
    ("formula", "text"),
    [
        (m[i, j] * a, "length*matrix[i,j]"),
        (sp.And(a >= SMALL, a <= 10**50), "1e-50 <= length <= 1e50"),
        (sp.And(sp.Or(sp.Eq(a, 0), sp.Eq(b, 0)), a < b), "(length = 0 or b = 0) and length < b"),
        (a * 2**26 + 1000, "1000 + 2**26*length"),
        (a >= sp.Rational(1, 2**960), "2**-960 <= length"),
    ],
)
def test_formulas(formula: sp.Basic, text: str) -> None:
    assert write_formula(formula, {a: "length", m: "matrix"}) == text


def test_equal_limits_are_joined_and_no_others() -> None:
    limits = ["0 < a < oo", "0 <= b < oo", "0 < c < oo", "a < b", "a <= (1 - b)", "a <= (2 - b)"]
    joined = ["0 < a, c < oo", "0 <= b < oo", *limits[3:]]
    assert join_equal_limits(limits) == joined


def test_what_is_tested_of_arguments_alike_is_said_once() -> None:
    within = (a >= SMALL, a <= 10**50, b >= SMALL, b <= 10**50)
    told = describe_accuracy(Accuracy(4503.5996, within=within), {a: "length", b: "width"})
    assert told == "4504 eps of the value, where 1e-50 <= length, width <= 1e50"


def test_a_rival_computes_the_definition_of_its_quantity() -> None:
    said = {row.number: row.printed_latex for row in form_rows(paper_of("tooth_thickness"))}
    assert "computes its definition" in said["kernel chord_height"]
    rival = said["kernel chord_height_handbook"]
    assert r"handbook computes the definition of chord\_height}" in rival


def test_products_longer_than_a_line_are_broken() -> None:
    (kernel,) = (
        k for k in list_functions(paper_of("track_wheel")) if k.name == "error_sum_correlated"
    )
    lines = describe_kernel(kernel, paper_of("track_wheel"))
    assert max(map(len, lines)) <= WIDTH
    whole = "".join(line.strip() for line in lines)
    assert "sensitivities[i]*sensitivities[j]*tolerances[i]*tolerances[j]" in whole
