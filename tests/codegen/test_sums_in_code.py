"""Sums over indices: the order of their factors, quadratic forms, and sums that are none."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import sympy as sp
from derived import paper_of

from mechproof.codegen.backends.numpy import render_modules
from mechproof.codegen.kernel_reading import check_module
from mechproof.codegen.languages import NUMPY
from mechproof.codegen.source_reading import TranslationError
from mechproof.codegen.syntax import write_program
from mechproof.programs.kernel import Kernel, list_functions
from mechproof.programs.lowering import lower_steps
from mechproof.programs.program import Program, spell_out_forms
from mechproof.programs.raising import WrittenForm
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import Claim
from mechproof.roundoff.running import IN_EXTENDED, run

i, j, n = sp.symbols("i j n", integer=True, positive=True)
u, v, m = (sp.IndexedBase(name, real=True) for name in "uvm")
FIRST, LAST = "[..., :, _np.newaxis]", "[..., _np.newaxis, :]"


def lower(term: sp.Expr, *indices: sp.Symbol) -> Program:
    total = sp.Sum(term, *((index, 1, n) for index in reversed(indices)))
    return lower_steps({u: "u", v: "v", m: "m"}, frozenset(), ("u", "v", "m"), (), (total,))


@pytest.mark.parametrize(
    ("term", "indices", "text"),
    [
        ((u[i] * v[i]) ** 2, (i,), "_add_up(_square(u * v), axis=-1)"),
        (u[i] ** 2 * v[i], (i,), "_add_up(_square(u) * v, axis=-1)"),
        (-(u[i] ** 2) * v[i] ** 2, (i,), "_add_up(-_square(u) * _square(v), axis=-1)"),
        (u[i] * u[j] * m[i, j], (i, j), "_quadratic_form(u, m)"),
        (u[i] * v[i] * u[j] * v[j] * m[i, j], (i, j), "_quadratic_form(u * v, m)"),
        (u[i] * u[j] * m[j, i], (i, j), "_quadratic_form(u, _np.swapaxes(m, -1, -2))"),
        (u[i] * v[j] * m[i, j], (i, j), f"_add_up(u{FIRST} * v{LAST} * m, axis=(-2, -1))"),
        (2 * u[i] * u[j] * m[i, j], (i, j), f"_add_up(2 * u{FIRST} * u{LAST} * m, axis=(-2, -1))"),
        (u[i] * u[j], (i, j), f"_add_up(u{FIRST} * u{LAST}, axis=(-2, -1))"),
    ],
)  # fmt: skip
def test_the_text_of_a_sum(term: sp.Expr, indices: tuple[sp.Symbol, ...], text: str) -> None:
    assert write_program(lower(term, *indices), NUMPY).outputs == (text,)


def test_under_a_root_a_quadratic_form_is_not_negative() -> None:
    total = sp.Sum(u[i] * u[j] * m[j, i], (j, 1, n), (i, 1, n))
    names = {u: "u", m: "m"}
    program = lower_steps(names, frozenset(), ("u", "m"), (), (sp.sqrt(total),))
    text = "_np.sqrt(_nonnegative_form(u, _np.swapaxes(m, -1, -2)))"
    assert write_program(program, NUMPY).outputs == (text,)


def test_a_quadratic_form_is_the_sum_it_is_spelled_out_to() -> None:
    program = lower(u[i] * v[i] * u[j] * v[j] * m[i, j], i, j)
    rng = np.random.default_rng(3)
    values = {"u": rng.normal(size=(3, 5)), "v": rng.normal(size=(3, 5))}
    values["m"] = rng.normal(size=(3, 3, 5))
    spelled = spell_out_forms(program)
    assert program.count_operations() == spelled.count_operations() == 4
    short, long = (run(p, values, IN_EXTENDED)[0] for p in (program, spelled))
    x = values["u"] * values["v"]
    np.testing.assert_allclose(short, np.einsum("ip,ijp,jp->p", x, values["m"], x), rtol=1e-13)
    assert np.array_equal(short, long)


@cache
def correlated() -> Kernel:
    kernels = list_functions(paper_of("track_wheel"))
    return next(kernel for kernel in kernels if kernel.name == "error_sum_correlated")


@pytest.mark.slow
@pytest.mark.parametrize(("factor", "proved"), [("scatters", True), ("sensitivities", False)])
def test_the_proof_sees_what_a_quadratic_form_is_of(factor: str, proved: bool) -> None:
    kernel = correlated()
    (stage,) = kernel.code.stages
    assert stage.evaluate is not None
    steps = tuple(
        replace(step, operands=tuple(factor if o == "scatters" else o for o in step.operands))
        for step in stage.evaluate.operations
    )
    wrong = replace(stage, evaluate=replace(stage.evaluate, operations=steps))
    states = kernel.forms[0].states
    assert states is not None
    statement = states(WrittenForm(kernel.quantity, kernel.code, wrong))
    claim = Claim("1", r"\text{computes its definition}", statement, on=kernel.quantity.on)
    assert (judge(claim, paper_of("track_wheel")).verdict is Verdict.PROVED) == proved


@cache
def shipped() -> tuple[Kernel, ...]:
    return tuple(k for k in list_functions(paper_of("track_wheel")) if k.is_shipped)


@cache
def source() -> str:
    return render_modules(paper_of("track_wheel"))["track_wheel.py"]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("form(sensitivities * scatters * tolerances", "form(sensitivities * tolerances"),
        ("tolerances, correlation)", "tolerances, _np.swapaxes(correlation, -1, -2))"),
        ("nonnegative_form", "product_rest"),
        ("nonnegative_form", "quadratic_form"),
        ("_every(_is_positive(scatters)", "_every(_is_nonnegative(scatters)"),
    ],
)
def test_a_wrong_text_of_a_sum_is_caught(old: str, new: str) -> None:
    kernel = correlated()
    check_module(source(), shipped())
    assert old in source()
    with pytest.raises(TranslationError, match=kernel.name):
        check_module(source().replace(old, new), shipped())
