"""A form becomes one program, its text reads back as that program, and a wrong text is caught."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from trial import load_paper, load_source, paper_of, quantity_of

from mechproof.codegen import syntax
from mechproof.codegen.backends.numba import (
    check_elementary,
    check_translation,
    render_compiled,
    render_elementary,
)
from mechproof.codegen.backends.numpy import render_modules
from mechproof.codegen.backends.scalar import list_scalars
from mechproof.codegen.error_free import WholeTurnsOff
from mechproof.codegen.forms import form_rows, read_back
from mechproof.codegen.kernel import list_functions
from mechproof.codegen.kernel_reading import read_module
from mechproof.codegen.languages import C99, NUMBA, NUMPY
from mechproof.codegen.lowering import FUNCTIONS, lower_steps
from mechproof.codegen.program import MEANINGS, Operation, Program
from mechproof.codegen.raising import WrittenForm
from mechproof.codegen.reading import ReadingError, TranslationError
from mechproof.codegen.syntax import write_program
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import Form, Paper, Variable

a, b, x = sp.symbols("a b x", real=True)
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
        (a / x**3, "a / (x * x ** 2)"),
        (x**4, "(x ** 2) ** 2"),
        (x**5, "x * (x ** 2) ** 2"),
        ((-a) ** 2 * x, "a ** 2 * x"),
        (sp.sqrt(sp.Rational(1, 3)) * x, "np.sqrt(3) / 3 * x"),
        (-(a + b) * x, "(-a - b) * x"),
        (a - (b - x), "a + x - b"),
        (sp.Rational(1, 2) + sp.Rational(1, 3) * x, "0.5 + x / 3"),
        (sp.sin(x) ** 2, "np.sin(x) ** 2"),
        (sp.pi * sp.Max(a, x), "np.pi * maximum(a, x)"),
        (sp.Piecewise((x, x >= 0), (a, True)), "choose_where(x >= 0, x, a)"),
    ],
)
def test_the_text_of_an_expression(expression: sp.Expr, text: str) -> None:
    assert write_program(lower(expression), NUMPY).outputs == (text,)


def test_a_cube_of_a_sum_computes_the_sum_once() -> None:
    written = write_program(lower(1 / (1 + x) ** 3), NUMPY)
    assert written.steps == (("one_plus_x", "1 + x"),)
    assert written.outputs == ("1 / (one_plus_x * one_plus_x ** 2)",)


def test_every_operation_has_a_meaning_and_a_text() -> None:
    numpy, numba, c99 = (
        {*language.infix, *language.calls, *language.patterns, "copy"}
        for language in (NUMPY, NUMBA, C99)
    )
    assert set(FUNCTIONS.values()) <= set(MEANINGS) & numpy
    assert set(MEANINGS) <= numpy | numba
    assert numba == c99


def test_what_has_no_operation_is_refused() -> None:
    with pytest.raises(NotImplementedError, match="no operation for zeta"):
        lower(sp.zeta(x))
    with pytest.raises(NotImplementedError, match="without an otherwise"):
        lower(sp.Piecewise((x, x > 0)))


def test_a_constant_is_not_an_input_of_its_name(tmp_path: Path) -> None:
    e = sp.Symbol("e", real=True)
    module = load_paper(paper_of(quantity_of(e * x + sp.E, x, e)), tmp_path)
    assert module.f(2.0, 3.0) == 6.0 + np.e


def test_a_trial_quantity_is_what_it_is_proved_to_be(tmp_path: Path) -> None:
    """A cube under a fraction: without its brackets 340.4 instead of 94.2."""
    jerk = a / (1 + b * sp.cos(x)) ** 3
    paper = paper_of(quantity_of(jerk, x, a, b))
    (row,) = form_rows(paper)
    assert judge(row, paper).verdict is Verdict.PROVED
    expected = float(jerk.subs({x: 0.3, a: 1.7, b: 0.9}))
    assert load_paper(paper, tmp_path).f(0.3, 1.7, 0.9) == pytest.approx(expected, rel=1e-14)


def test_a_rival_may_leave_an_argument_out(tmp_path: Path) -> None:
    """The argument still gives its shape and its NaN; the proof sees the value alone."""
    whole = quantity_of(a + x, x, a)
    paper = paper_of(replace(whole, forms=(*whole.forms, Form("short", x, key="short"))))
    _, rival = list_functions(paper)
    assert WrittenForm(rival.quantity, rival.code, rival.code.stages[0]).output() == x
    module = load_source(render_modules(paper)["forms/system.py"], tmp_path)
    assert np.array_equal(module.f_short(2.0, np.zeros(3)), np.full(3, 2.0))
    assert np.isnan(module.f_short(2.0, np.nan))


MECHANISM = (x, a, b)
POSITIVE = Variable(a, "a number", within=sp.Interval.open(0, sp.oo))
TRIALS = {
    "quotient": quantity_of(a / (1 + b * sp.cos(x)) ** 3, *MECHANISM),
    "name in the midst": quantity_of(x**2 * (a + x) ** 3 / b, *MECHANISM),
    "difference": quantity_of((a - b) * x - sp.sin(a * x), *MECHANISM),
    "matrix": quantity_of(sp.ImmutableDenseMatrix([[a * x, a], [x - a, a * b]]), *MECHANISM),
}


@pytest.mark.parametrize("name", TRIALS)
def test_the_source_reads_back_as_the_program(name: str) -> None:
    paper = paper_of(TRIALS[name], POSITIVE)
    kernels = list_functions(paper)
    assert read_back(paper, kernels) == {kernel.name: kernel.code for kernel in kernels}


def sources_with(old: str, new: str) -> Callable[[Paper], dict[str, str]]:
    def render(paper: Paper) -> dict[str, str]:
        changed = {name: text.replace(old, new) for name, text in render_modules(paper).items()}
        assert changed != render_modules(paper)
        return changed

    return render


@pytest.mark.parametrize(
    ("old", "new", "seen"),
    [
        ("(base * base**2)", "base * base**2", "stages"),
        ("1.0 + b * np.cos(x)", "b * np.cos(x)", "stages"),
        ("1.0 + b * np.cos(x)", "1.0 - b * np.cos(x)", "stages"),
        ("np.cos(x)", "np.sin(x)", "stages"),
        (
            "in_blocks(_f, (x,), _prepare_f, (a, b)",
            "in_blocks(_f, (x,), _prepare_f, (b, a)",
            "stages",
        ),
        ("def _prepare_f(a: Any, b: Any)", "def _prepare_f(b: Any, a: Any)", "stages"),
        ("return (a, b)", "return (b, a)", "stages"),
        ("(a > 0) & is_finite(a)", "a > 0", "inside"),
        ("(a > 0)", "(a >= 0)", "inside"),
        ("(a,) = nan_outside(inside, a)", "(b,) = nan_outside(inside, b)", "masked"),
    ],
)
def test_a_text_that_is_not_the_program_is_caught(
    old: str, new: str, seen: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    quantity = quantity_of(a / (1 + b * sp.cos(x)) ** 3, *MECHANISM)
    paper = paper_of(quantity, POSITIVE)
    old = old.replace("base", "one_plus_b_cos_x") if "base" in old else old
    new = new.replace("base", "one_plus_b_cos_x") if "base" in new else new
    monkeypatch.setattr("mechproof.codegen.forms.render_modules", sources_with(old, new))
    with pytest.raises(TranslationError, match=rf"system\.f: {seen} meant"):
        form_rows(paper)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("x, a, b)", "a, x, b)"),
        ("x a b", "a x b"),
        ("if inside is not True", "if inside is True"),
        ("np.cos(x)", "np.cosh(x)"),
        ("out=out)", "out=None)"),
        ("np.cos(x)", "(lambda t: t)(x)"),
    ],
)
def test_a_text_that_no_kernel_has_is_refused(
    old: str, new: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    paper = paper_of(quantity_of(a / (1 + b * sp.cos(x)) ** 3, *MECHANISM), POSITIVE)
    monkeypatch.setattr("mechproof.codegen.forms.render_modules", sources_with(old, new))
    with pytest.raises((ReadingError, TranslationError)):
        form_rows(paper)


def test_a_printer_that_forgets_a_bracket_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    paper = paper_of(quantity_of(a * (b + x), *MECHANISM))
    form_rows(paper)
    monkeypatch.setattr(syntax._Writer, "enclose", lambda self, o, level: self.show(o)[0])
    with pytest.raises(TranslationError, match="stages"):
        form_rows(paper)


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("k_low * phi1 + product_rest", "product_rest"),
        ("x_low / 2.0", "x_low"),
        ("+ t_low", "- t_low"),
    ],
)
def test_a_low_word_that_is_dropped_doubled_or_turned_is_caught(
    right: str, wrong: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    from mechproof.derivations.elliptic_planetary import PAPER

    monkeypatch.setattr("mechproof.codegen.forms.render_modules", sources_with(right, wrong))
    with pytest.raises(TranslationError):
        form_rows(PAPER)


def test_what_is_proved_is_what_was_emitted(tmp_path: Path) -> None:
    """A form that is not its definition is refuted, by way of its source."""
    right = quantity_of(sp.sin(x) ** 2, x)
    forms = (Form("wrong by a digit", 1 - sp.cos(x) ** 2 * sp.Rational(1001, 1000)),)
    wrong = type(right)(**{**vars(right), "forms": forms})
    verdicts = [judge(form_rows(paper_of(q))[0], paper_of(q)).verdict for q in (right, wrong)]
    assert verdicts == [Verdict.PROVED, Verdict.REFUTED]


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


def test_temporaries_do_not_matter_and_named_results_do() -> None:
    one = Program(("a",), (Operation("_7", "sin", ("a",)),), ("_7",)).normal_form()
    other = Program(("a",), (Operation("_3", "sin", ("a",)),), ("_3",)).normal_form()
    named = Program(("a",), (Operation("s", "sin", ("a",)),), ("s",)).normal_form()
    assert one == other != named


def test_reading_knows_public_functions_only(tmp_path: Path) -> None:
    source = render_modules(paper_of(TRIALS["difference"]))["system.py"]
    assert set(read_module(source)) == {"f"}
    assert load_source(source, tmp_path).__all__ == ["f"]


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("k_low * phi1 + elementary.product_rest", "elementary.product_rest"),
        ("t + t_low * t_below", "t - t_low * t_below"),
        ("if e <= 0.5:", "if e < 0.5:"),
        ("& (e < 1) & (R2 < R1)", "& (e < 1)"),
    ],
)
def test_a_compiled_source_that_computes_something_else_is_caught(right: str, wrong: str) -> None:
    from mechproof.derivations.elliptic_planetary import PAPER

    (source,) = render_compiled(PAPER).values()
    kernels = list_scalars(PAPER)
    check_translation(source, kernels)
    assert right in source
    with pytest.raises(TranslationError, match="meant"):
        check_translation(source.replace(right, wrong, 1), kernels)


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("fma(a, b, -p)", "fma(a, b, p)"),
        ("choose(v9, v5, -v7)", "choose(v9, -v7, v5)"),
        ("-1.5707963267948966", "-1.5707963267948968"),
        ("def hypot(a, b)", "def hypot(b, a)"),
    ],
)
def test_an_elementary_function_that_computes_something_else_is_caught(
    right: str, wrong: str
) -> None:
    source = render_elementary()
    check_elementary(source)
    assert right in source
    with pytest.raises(TranslationError, match="meant"):
        check_elementary(source.replace(right, wrong, 1))


def test_modules_change_with_what_is_compiled_into_them(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    source = render_elementary()
    (tmp_path / "machine.py").write_text("another")
    monkeypatch.setattr("mechproof.codegen.backends.numba.SUPPORT_FOLDER", tmp_path)
    assert render_elementary.__wrapped__() != source


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("low += elementary.total_rest", "low -= elementary.total_rest"),
        ("total = high + term", "total = high - term"),
        ("choose(is_finite(low), high + low, high)", "high"),
        ("float(correlation[j, i])", "float(correlation[i, j])"),
        ("float(tolerances[j])", "float(tolerances[i])"),
        ("holds = holds & ", "holds = "),
        ("for j in range(len(", "for j in range(1, len("),
        ("_every_2(scatters)", "_every_3(scatters)"),
        ("scatters_i > 0", "scatters_i >= 0"),
        ("sensitivities_i**2 * scatters_i**2", "sensitivities_i**2 * scatters_i"),
    ],
)
def test_a_compiled_sum_that_adds_something_else_is_caught(right: str, wrong: str) -> None:
    from mechproof.derivations.track_wheel import PAPER

    (source,) = render_compiled(PAPER).values()
    kernels = list_scalars(PAPER)
    check_translation(source, kernels)
    assert right in source
    with pytest.raises(ValueError, match=r"meant|no loop over terms"):
        check_translation(source.replace(right, wrong, 1), kernels)


def test_any_sum_is_compiled(tmp_path: Path) -> None:
    """Names that the loops use themselves, numbers and functions of large angles in a term."""
    total, low = sp.IndexedBase("total", real=True), sp.IndexedBase("low", real=True)
    high, i, n = sp.Symbol("high", real=True), *sp.symbols("i n", integer=True)
    value = sp.Sum(total[i] * sp.cos(high * low[i]), (i, 1, n)) + high
    paper = paper_of(quantity_of(value, total, low, high))
    (source,) = render_compiled(paper).values()
    plain, compiled = load_paper(paper, tmp_path).f, load_source(source, tmp_path).f
    row = np.linspace(-3, 2e9, 7)
    # Both round the same products; the sum is larger than a hundredth of its terms.
    for arguments in ((row, row, 2.0), (row, np.outer([1, 2], row), 2.0)):
        np.testing.assert_allclose(compiled(*arguments), plain(*arguments), rtol=1e-12)
