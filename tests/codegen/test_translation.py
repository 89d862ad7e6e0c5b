"""The text of a kernel reads back as its program, and a wrong text is caught."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
import sympy as sp
from trial import a, b, load_source, paper_of, quantity_of, x

from mechproof.codegen import syntax
from mechproof.codegen.backends.numpy import render_modules
from mechproof.codegen.form_rows import form_rows, read_back
from mechproof.codegen.kernel_reading import read_module
from mechproof.codegen.source_reading import SourceError, TranslationError
from mechproof.programs.kernel import list_functions
from mechproof.programs.program import Operation, Program
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import Form, Paper, Variable

MECHANISM = (x, a, b)
POSITIVE = Variable(a, "a number", within=sp.Interval.open(0, sp.oo))
TRIALS = {
    "quotient": quantity_of(a / (1 + b * sp.cos(x)) ** 3, *MECHANISM),
    "name in the midst": quantity_of(x**2 * (a + x) ** 3 / b, *MECHANISM),
    "difference": quantity_of((a - b) * x - sp.sin(a * x), *MECHANISM),
    "prepared": quantity_of(a * b + x * sp.sin(a * b), *MECHANISM),
    "matrix": quantity_of(sp.ImmutableDenseMatrix([[a * x, a], [x - a, a * b]]), *MECHANISM),
}


@pytest.mark.parametrize("name", TRIALS)
def test_the_source_reads_back_as_the_program(name: str) -> None:
    paper = paper_of(TRIALS[name], POSITIVE)
    kernels = list_functions(paper)
    read_back(paper, kernels)
    read = read_module(render_modules(paper)["system.py"])
    for code in (kernel.code for kernel in kernels):
        (stage,) = code.stages
        assert stage.evaluate is not None
        programs = {f"_form_of_{code.name}": stage.evaluate}
        assert stage.prepares is (name == "prepared")
        programs |= {f"_prepare_of_{code.name}": stage.prepare} if stage.prepares else {}
        for function, program in programs.items():
            assert [spread(way) for way in read[function].ways] == [program]
        if code.inside is not None:
            assert read[f"_check_of_{code.name}"].ways == (
                replace(code.inside, inputs=code.masked),
            )


def spread(way: Program) -> Program:
    """Return the program that was read, with a separate output for each of several results."""
    (outputs,) = way.outputs
    several = outputs if isinstance(outputs, tuple) else (outputs,)
    return replace(way, outputs=several).normal_form()


def sources_with(*changes: tuple[str, str]) -> Callable[[Paper], dict[str, str]]:
    def render(paper: Paper) -> dict[str, str]:
        changed = dict(render_modules(paper))
        for old, new in changes:
            before = dict(changed)
            changed = {name: text.replace(old, new) for name, text in before.items()}
            assert changed != before
        return changed

    return render


@pytest.mark.parametrize(
    ("old", "new", "seen"),
    [
        ("(base * _square(base))", "base * _square(base)", "_form_of_f"),
        ("1.0 + b * _np.cos(x)", "b * _np.cos(x)", "_form_of_f"),
        ("1.0 + b * _np.cos(x)", "1.0 - b * _np.cos(x)", "_form_of_f"),
        ("_np.cos(x)", "_np.sin(x)", "_form_of_f"),
        ("parameters=(a, b)", "parameters=(b, a)", "f"),
        ("parameters=(a, b)", "parameters=(a, b, a)", "f"),
        ("return (_is_positive(a),)", "return (a > 0.0,)", "_check_of_f"),
        ("return (_is_positive(a),)", "return (a >= 0.0,)", "_check_of_f"),
    ],
)
def test_a_text_that_is_not_the_program_is_caught(
    old: str, new: str, seen: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    quantity = quantity_of(a / (1 + b * sp.cos(x)) ** 3, *MECHANISM)
    paper = paper_of(quantity, POSITIVE)
    old = old.replace("base", "one_plus_b_cos_x") if "base" in old else old
    new = new.replace("base", "one_plus_b_cos_x") if "base" in new else new
    monkeypatch.setattr("mechproof.codegen.form_rows.render_modules", sources_with((old, new)))
    with pytest.raises(TranslationError, match=rf"system\.{seen} is not as meant: .*, read"):
        form_rows(paper)


@pytest.mark.parametrize(
    ("old", "new", "seen"),
    [
        ("_prepare_of_f, (a, b)", "_prepare_of_f, (b, a)", "f"),
        ("_prepare_of_f, (a, b)", "parameters=(a, b)", "f"),
        ("def _prepare_of_f(a: Any, b: Any)", "def _prepare_of_f(b: Any, a: Any)", "_prepare_of_f"),
        ("a_b = a * b", "a_b = a + b", "_prepare_of_f"),
        ("return (a_b,)", "return (a,)", "_prepare_of_f"),
    ],
)
def test_what_is_not_prepared_as_meant_is_caught(
    old: str, new: str, seen: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("mechproof.codegen.form_rows.render_modules", sources_with((old, new)))
    with pytest.raises(TranslationError, match=rf"system\.{seen} is not as meant: .*, read"):
        form_rows(paper_of(TRIALS["prepared"], POSITIVE))


def test_what_several_kernels_have_in_common_is_written_once(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Only identical functions are shared: a call of one that does something else is caught."""
    made = {"f": x * sp.sin(a * b) + a * b, "g": x**2 * sp.cos(a * b) + a * b}
    made["h"] = x * sp.sin(a / b) + a / b
    quantities = tuple(replace(quantity_of(e, *MECHANISM), name=n) for n, e in made.items())
    paper = replace(paper_of(quantities[0], POSITIVE), quantities=quantities)
    text = render_modules(paper)["system.py"]
    kernels = list_functions(paper)
    written = " ".join(re.findall(r"^def _(\w+_of_\w)\(", text, re.MULTILINE))
    assert written == "check_of_f prepare_of_f form_of_f form_of_g prepare_of_h form_of_h"
    read_back(paper, kernels)
    old = "_in_blocks(_form_of_g, (x,), _prepare_of_f, "
    calls = old, old.replace("_prepare_of_f", "_prepare_of_h")
    monkeypatch.setattr("mechproof.codegen.form_rows.render_modules", sources_with(calls))
    with pytest.raises(TranslationError, match=r"system\.g is not as meant"):
        read_back(paper, kernels)


def test_another_masked_parameter_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    paper = paper_of(quantity_of(a / (1 + b * sp.cos(x)) ** 3, *MECHANISM), POSITIVE)
    change = sources_with(
        ("(a,) = _nan_outside(_check_of_f, a)", "(b,) = _nan_outside(_check_of_f, b)"),
        ("def _check_of_f(a: Any)", "def _check_of_f(b: Any)"),
        ("return (_is_positive(a),)", "return (_is_positive(b),)"),
    )
    monkeypatch.setattr("mechproof.codegen.form_rows.render_modules", change)
    with pytest.raises(TranslationError, match=r"system\.f is not as meant: .*, read"):
        form_rows(paper)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("x, a, b)", "a, x, b)"),
        ("x a b", "a x b"),
        ("_nan_outside(_check_of_f, a)", "_nan_outside(_check_of_f, b)"),
        ("_nan_outside(_check_of_f, a)", "_nan_outside(_check_of_f, a, also=b)"),
        (
            "    (a,) = _nan_outside(_check_of_f, a)\n",
            "    a = b\n    (a,) = _nan_outside(_check_of_f, a)\n",
        ),
        (
            "    (a,) = _nan_outside(_check_of_f, a)\n",
            2 * "    (a,) = _nan_outside(_check_of_f, a)\n",
        ),
        ("return (_is_positive(a),)", "return _is_positive(a)"),
        ("return (_is_positive(a),)", "return (_is_positive(b),)"),
        ("return (_is_positive(a),)", "return (_is_nonnegative(a),)"),
        ("return (_is_positive(a),)", "return (True,)"),
        ("return (_is_positive(a),)", "return ()"),
        ("def _check_of_f(a: Any)", "@cache\ndef _check_of_f(a: Any)"),
        ("def _check_of_f(a: Any)", "def _check_of_f(a: Any, *, b: Any = 1.0)"),
        ("    return _in_blocks(_form_of_f", "    a = b\n    return _in_blocks(_form_of_f"),
        ("_np.cos(x)", "_np.cosh(x)"),
        ("out=out)", "out=None)"),
        ("_np.cos(x)", "(lambda t: t)(x)"),
    ],
)
def test_a_text_that_no_kernel_has_is_refused(
    old: str, new: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    paper = paper_of(quantity_of(a / (1 + b * sp.cos(x)) ** 3, *MECHANISM), POSITIVE)
    monkeypatch.setattr("mechproof.codegen.form_rows.render_modules", sources_with((old, new)))
    with pytest.raises((SourceError, TranslationError)):
        form_rows(paper)


def test_a_printer_that_forgets_a_bracket_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    paper = paper_of(quantity_of(a * (b + x), *MECHANISM))
    form_rows(paper)
    monkeypatch.setattr(syntax._Writer, "enclose", lambda self, o, level: self.show(o)[0])
    with pytest.raises(TranslationError, match=r"_form_of_f is not as meant"):
        form_rows(paper)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("k_low * phi1 + _product_rest", "_product_rest"),
        ("x_low / 2.0", "x_low"),
        ("+ t_low", "- t_low"),
    ],
)
def test_a_low_word_that_is_dropped_doubled_or_turned_is_caught(
    right: str, wrong: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    from mechproof.derivations.elliptic_planetary import PAPER

    monkeypatch.setattr("mechproof.codegen.form_rows.render_modules", sources_with((right, wrong)))
    with pytest.raises(TranslationError):
        form_rows(PAPER)


def test_what_is_proved_is_what_was_emitted(tmp_path: Path) -> None:
    """A form that differs from its definition is refuted from its emitted source."""
    right = quantity_of(sp.sin(x) ** 2, x)
    forms = (Form("wrong by a digit", 1 - sp.cos(x) ** 2 * sp.Rational(1001, 1000)),)
    wrong = type(right)(**{**vars(right), "forms": forms})
    verdicts = [judge(form_rows(paper_of(q))[0], paper_of(q)).verdict for q in (right, wrong)]
    assert verdicts == [Verdict.PROVED, Verdict.REFUTED]


def test_temporaries_do_not_matter_and_named_results_do() -> None:
    one = Program(("a",), (Operation("_7", "sin", ("a",)),), ("_7",)).normal_form()
    other = Program(("a",), (Operation("_3", "sin", ("a",)),), ("_3",)).normal_form()
    named = Program(("a",), (Operation("s", "sin", ("a",)),), ("s",)).normal_form()
    assert one == other != named


def test_reading_knows_public_functions_only(tmp_path: Path) -> None:
    source = render_modules(paper_of(TRIALS["difference"]))["system.py"]
    assert {name for name in read_module(source) if not name.startswith("_")} == {"f"}
    assert load_source(source, tmp_path).__all__ == ["f"]
