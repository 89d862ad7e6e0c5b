"""Bad records are refused, templates hold layout only, and the formula decides the file."""

from __future__ import annotations

import dataclasses
import inspect
import itertools
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from trial import a, b, load_paper, paper_of, quantity_of, x

import mechproof.kernels.elliptic_planetary as shipped
from mechproof.codegen.backends.numpy import (
    TEMPLATES,
    format_source,
    render_modules,
    render_template,
)
from mechproof.codegen.kernel_reading import check_module
from mechproof.derivations import elliptic_planetary
from mechproof.derivations.elliptic_planetary.mechanics import k
from mechproof.programs.argument_conditions import set_relations
from mechproof.programs.kernel import list_functions
from mechproof.record import Accuracy, Form, Part, Quantity, Scale, Variable


@pytest.mark.parametrize(
    ("quantity", "message"),
    [
        (quantity_of(a + b, a), r"symbols without a value: \['b'\]"),
        (quantity_of(sp.sin(a), a, b), r"arguments that do not occur: \['b'\]"),
        (quantity_of(a + b, a, b, names="a lambda"), "'lambda' cannot name a variable"),
        (quantity_of(a + b, a, b, names="a _b"), "'_b' cannot name a variable"),
        (quantity_of(a + b, a, b, names="a out"), "'out' cannot name a variable"),
        (quantity_of(a + b, a, b, names="a b+c"), r"'b\+c' cannot name a variable"),
    ],
)
def test_bad_quantities_are_refused(quantity: Quantity, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        render_modules(paper_of(quantity, Variable(b, "a number")))


def test_outside_the_domain_every_entry_is_nan(tmp_path: Path) -> None:
    quantity = quantity_of(sp.Matrix([a, b, 1]), a, b)
    positive = sp.Interval.open(0, sp.oo)
    kernels = load_paper(paper_of(quantity, Variable(b, "a number", within=positive)), tmp_path)
    assert kernels.f([3.0, 4.0], 2.0).tolist() == [[3.0, 2.0, 1.0], [4.0, 2.0, 1.0]]
    assert np.isnan(kernels.f(3.0, [-2.0, 0.0, np.nan, np.inf])).all()


def test_sets_without_relations_are_refused() -> None:
    with pytest.raises(ValueError, match="Interval, FiniteSet, Naturals or Reals"):
        set_relations(x, sp.S.Integers)


def test_template_keys_are_the_data_keys(tmp_path: Path) -> None:
    (tmp_path / "t.jinja").write_text("{{ one }} {{ two }}")
    assert render_template("t.jinja", {"one": 1, "two": 2}, tmp_path) == "1 2"
    for data in ({"one": 1}, {"one": 1, "two": 2, "three": 3}):
        with pytest.raises(ValueError, match=r"asks for \['one', 'two'\]"):
            render_template("t.jinja", data, tmp_path)


def test_templates_hold_layout_only() -> None:
    """No call of NumPy and no long stretch without a placeholder."""
    for template in TEMPLATES.glob("*.jinja"):
        text = template.read_text(encoding="utf-8")
        # A formula in Python stands alone: it must spell out what kernels call in their support.
        assert "np." not in text or template.name == "python.py.jinja"
        plain = [len(part.splitlines()) for part in text.replace("{%", "{{").split("{{")]
        assert max(plain) <= 20, template.name


def test_source_that_is_not_python_is_refused() -> None:
    with pytest.raises(ValueError, match="formatter rejects"):
        format_source("def f(:\n")


def test_a_changed_coefficient_changes_the_kernel(tmp_path: Path) -> None:
    paper = elliptic_planetary.PAPER
    ratio = paper.quantities[0]
    arguments = (0.3, 66, 16, 0.475)

    def compute(factor: sp.Expr) -> float:
        form = dataclasses.replace(
            ratio.forms[0], expression=ratio.forms[0].expression.subs(k, factor)
        )
        changed = dataclasses.replace(ratio, forms=(form,))
        module = load_paper(
            dataclasses.replace(paper, quantities=(changed,), one_pass=()), tmp_path
        )
        return float(module.ratio(*arguments))

    assert compute(k) == shipped.ratio(*arguments)
    deviation = (compute(sp.Rational(11, 10) * k) - 1) / (compute(k) - 1)
    assert deviation == pytest.approx(1.1, rel=1e-14)


def test_signatures_and_names_are_readable() -> None:
    assert dir(shipped) == sorted(shipped.__all__)
    text = str(inspect.signature(shipped.position))
    assert text == (
        "(phi1: 'ArrayLike', R1: 'ArrayLike', R2: 'ArrayLike', e: 'ArrayLike', "
        "*, out: 'NDArray[Any] | None' = None) -> 'Any'"
    )


def test_published_sizes_and_the_domain_are_plain_data() -> None:
    sizes = [dict(row.sizes) for row in shipped.PUBLISHED]
    assert sizes[1] == {"R1": 66.0, "R2": 16.0, "e": 0.475}
    told = {c.text: c.holds for c in shipped.DOMAIN}
    of_sizes = [c.text for c in shipped.DOMAIN if {*c.names} <= {"R1", "R2", "e"}]
    assert of_sizes == ["0 < R1 < oo", "0 < R2 < oo", "0 <= e < 1", "R2 < R1"]
    assert told["0 <= e < 1"](0.0)
    assert not told["0 <= e < 1"](1.0)
    assert not told["R2 < R1"](1.0, 2.0)


@pytest.mark.thorough
def test_rendering_does_not_depend_on_the_hash_seed() -> None:
    script = (
        "import hashlib; from mechproof.codegen.backends.numpy import render_modules;"
        "from mechproof.derivations import elliptic_planetary as e, track_wheel as t;"
        "texts = {**render_modules(e.PAPER), **render_modules(t.PAPER)};"
        "print(hashlib.sha256(repr(texts).encode()).hexdigest())"
    )
    digests = {
        subprocess.run(
            [sys.executable, "-c", script],
            env={**os.environ, "PYTHONHASHSEED": seed},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "4242")
    }
    assert len(digests) == 1


def test_alternatives_among_the_conditions_of_the_accuracy_stand_in_brackets() -> None:
    either, small = sp.Or(sp.Eq(a, 0), sp.Eq(b, 0)), sp.Abs(a) <= 4
    told = {
        (either,): "where (a = 0 or b = 0).",
        (small, either): "where |a| <= 4 and (a = 0 or b = 0).",
    }
    for within, text in told.items():
        quantity = dataclasses.replace(quantity_of(a + b, a, b), accuracy=Accuracy(1, None, within))
        (source,) = render_modules(paper_of(quantity)).values()
        assert f"Accuracy, tested: 1 eps of the value, {text}" in source


def test_a_scale_of_errors_is_defined_by_its_module_with_its_steps() -> None:
    steps = sp.symbols("s0:12", real=True)
    where = [(steps[0], a), *((s, before + b) for before, s in itertools.pairwise(steps))]
    scales = {
        "long, by steps": (sp.Abs(steps[-1]), tuple(where)),
        "what its name says": (sum(sp.sin(a) ** n * sp.cos(n * b) for n in range(3, 70)), ()),
    }
    for name, (expression, given) in scales.items():
        scale = Scale(name, expression, given)
        quantity = dataclasses.replace(quantity_of(a + b, a, b), accuracy=Accuracy(1, scale))
        (source,) = render_modules(paper_of(quantity)).values()
        assert f"Accuracy, tested: 1 eps of {name}." in source
        assert (f"{name} (f) =" in source) == bool(given)
        assert source.count("s5 = b + s4") == bool(given)
        both = (quantity, dataclasses.replace(quantity, name="g"))
        paper = dataclasses.replace(paper_of(quantity), quantities=both)
        (source,) = render_modules(paper).values()
        assert source.count("s5 = b + s4") == bool(given)


def test_what_is_proved_and_what_is_tested_are_told_apart() -> None:
    form = Form("sum", a + b, proved="Proved, where all is: at most 1 eps, found 0.5.")
    quantity = quantity_of(a + b, a, b)
    for accuracy, forms in ((Accuracy(1), quantity.forms), (None, (form,)), (Accuracy(1), (form,))):
        changed = dataclasses.replace(quantity, accuracy=accuracy, forms=forms)
        (source,) = render_modules(paper_of(changed)).values()
        assert ("Accuracy is tested:" in source) == bool(accuracy)
        assert ("Accuracy, tested:" in source) == bool(accuracy)
        assert ("A proved bound holds" in source) == (forms == (form,))


def test_alternatives_among_the_conditions_of_the_domain_are_checked(tmp_path: Path) -> None:
    outside_or_between = sp.Or(a < -1, sp.And(a > 1, a < b))
    part = Part("two pieces", where=(outside_or_between, b < 9))
    paper = paper_of(dataclasses.replace(quantity_of(a + b, a, b), on=part))
    (source,) = render_modules(paper).values()
    check_module(source, list_functions(paper))
    found = load_paper(paper, tmp_path).f([-2.0, 0.0, 2.0, 6.0, np.nan], [5.0, 5.0, 5.0, 5.0, 5.0])
    assert np.isnan(found).tolist() == [False, True, False, True, True]
    assert np.isnan(load_paper(paper, tmp_path).f(-2.0, 9.0))
