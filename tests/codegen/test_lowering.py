"""A form is lowered to one program, and the program to a text that computes the form."""

from __future__ import annotations

from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from trial import a, b, load_paper, load_source, paper_of, quantity_of, x

from mechproof.codegen.backends.numpy import render_modules
from mechproof.codegen.form_rows import form_rows
from mechproof.codegen.languages import C99, NUMBA, NUMPY
from mechproof.codegen.syntax import write_program
from mechproof.programs.kernel import list_functions
from mechproof.programs.lowering import FUNCTIONS, KNOWN, lower_steps
from mechproof.programs.operations import KINDS
from mechproof.programs.program import Program
from mechproof.programs.raising import WrittenForm
from mechproof.programs.rounding_functions import WholeTurnsOff
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import Form, Variable
from mechproof.record.substitution import STEPS

LARGE = frozenset({x})


def lower(expression: sp.Expr) -> Program:
    return lower_steps({}, LARGE, ("a", "b", "x"), (), (expression,))


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        (x / 2, "x / 2"),
        (-2 * a * x, "-2 * a * x"),
        (1 - a, "1 - a"),
        ((1 - a) / (1 + a), "(1 - a) / (1 + a)"),
        (1 / (a * x), "1 / (a * x)"),
        (a * x / b, "a / b * x"),
        (x * (a - b), "(a - b) * x"),
        (a / x**3, "a / (x * _square(x))"),
        (x**4, "_square(_square(x))"),
        (x**5, "x * _square(_square(x))"),
        ((-a) ** 2 * x, "_square(a) * x"),
        (sp.sqrt(sp.Rational(1, 3)) * x, "_np.sqrt(3) / 3 * x"),
        (-(a + b) * x, "(-a - b) * x"),
        (a - (b - x), "a + x - b"),
        (sp.Rational(1, 2) + sp.Rational(1, 3) * x, "0.5 + x / 3"),
        (sp.sin(x) ** 2, "_square(_np.sin(x))"),
        (sp.pi * sp.Max(a, x), "_np.pi * _maximum(a, x)"),
        (sp.Piecewise((x, x >= 0), (a, True)), "_choose_where(x >= 0, x, a)"),
        (sp.Piecewise((x, sp.Ne(x, 0)), (a, True)), "_choose_where(x == 0, a, x)"),
    ],
)
def test_the_text_of_an_expression(expression: sp.Expr, text: str) -> None:
    assert write_program(lower(expression), NUMPY).outputs == (text,)


def test_a_cube_of_a_sum_computes_the_sum_once() -> None:
    written = write_program(lower(1 / (1 + x) ** 3), NUMPY)
    assert written.steps == (("one_plus_x", "1 + x"),)
    assert written.outputs == ("1 / (one_plus_x * _square(one_plus_x))",)


def test_every_operation_has_a_meaning_and_a_text() -> None:
    numpy, numba, c99 = (
        {*language.infix, *language.calls, *language.patterns} for language in (NUMPY, NUMBA, C99)
    )
    composed = {kind for kind, row in KINDS.items() if row.is_composed}
    assert set(FUNCTIONS.values()) - composed <= numpy
    # Functions that papers may use; other heads come from rewrites.
    written_out = {*(kind.__name__ for kind in STEPS), "Root"}
    assert {FUNCTIONS[name] for name in {*KNOWN.split(", ")} - written_out} - composed <= numba
    # Except a kind known only to the prover of bounds, and copies, which have no text of their own.
    assert {*KINDS} - {"copy", "approximate"} - composed == numpy | numba
    assert numba == c99


def test_what_has_no_operation_is_refused() -> None:
    n = sp.Symbol("n", integer=True)
    with pytest.raises(NotImplementedError, match="no operation for zeta"):
        lower(sp.zeta(x))
    with pytest.raises(
        NotImplementedError, match="sums must run over axes of arguments or have up to 64 terms"
    ):
        lower(sp.Sum(x**n, (n, 1, sp.Symbol("m", integer=True))))


def test_a_constant_is_not_an_input_of_its_name(tmp_path: Path) -> None:
    e = sp.Symbol("e", real=True)
    module = load_paper(paper_of(quantity_of(e * x + sp.E, x, e)), tmp_path)
    assert module.f(2.0, 3.0) == 6.0 + np.e


def test_a_trial_quantity_is_what_it_is_proved_to_be(tmp_path: Path) -> None:
    """A cube in a denominator: without its brackets the value would be 340.4 instead of 94.2."""
    jerk = a / (1 + b * sp.cos(x)) ** 3
    paper = paper_of(quantity_of(jerk, x, a, b))
    (row,) = form_rows(paper)
    assert judge(row, paper).verdict is Verdict.PROVED
    expected = float(jerk.subs({x: 0.3, a: 1.7, b: 0.9}))
    assert load_paper(paper, tmp_path).f(0.3, 1.7, 0.9) == pytest.approx(expected, rel=1e-14)


def test_a_rival_may_leave_an_argument_out(tmp_path: Path) -> None:
    """The argument still contributes its shape and NaN; the proof sees only the value."""
    whole = quantity_of(a + x, x, a)
    paper = paper_of(replace(whole, forms=(*whole.forms, Form("short", x, key="short"))))
    _, rival = list_functions(paper)
    assert WrittenForm(rival.quantity, rival.code, rival.code.stages[0]).output() == x
    module = load_source(render_modules(paper)["forms/system.py"], tmp_path)
    assert np.array_equal(module.f_short(2.0, np.zeros(3)), np.full(3, 2.0))
    assert np.isnan(module.f_short(2.0, np.nan))


@pytest.mark.slow
def test_illegal_rewrites_are_refuted() -> None:
    """atan2(y, x) = atan(y/x) needs x > 0; the precondition is a row of its own."""
    value = sp.atan2(sp.sin(x), 2 - b * sp.cos(x))
    quantity = quantity_of(value, x, b, rewrites=("positive_atan2",))
    small = Variable(b, "a number", within=sp.Interval(0, 1))
    large = Variable(b, "a number", within=sp.Interval(0, 3))
    found = {}
    for variable in (small, large):
        paper = paper_of(quantity, variable)
        rows = {row.number: judge(row, paper).verdict for row in form_rows(paper)}
        found[variable.within.end] = rows["kernel f, legal"]
    assert found == {1: Verdict.PROVED, 3: Verdict.REFUTED}


@pytest.mark.parametrize("legal", [True, False])
def test_turns_off_an_angle_are_for_sines_only(legal: bool) -> None:
    value = sp.sin(WholeTurnsOff(x)) if legal else WholeTurnsOff(x)
    (kernel,) = list_functions(paper_of(quantity_of(value + a, x, a)))
    expected = nullcontext() if legal else pytest.raises(ValueError, match="whole turns")
    with expected:
        WrittenForm(kernel.quantity, kernel.code, kernel.code.stages[0])
