"""Compiled sources read back as their programs, and sources that compute otherwise are caught."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from trial import load_paper, load_source, paper_of, quantity_of
from weights import first_of

from mechproof.codegen.backends.numba import (
    check_elementary,
    check_translation,
    render_compiled,
    render_elementary,
)
from mechproof.codegen.source_reading import TranslationError
from mechproof.programs.scalar import list_scalars


@pytest.mark.slow
@pytest.mark.parametrize(
    ("right", "wrong"),
    first_of(
        [
            ("k_low * phi1 + _elementary.product_rest", "_elementary.product_rest"),
            ("t + t_low * t_below", "t - t_low * t_below"),
            ("if e <= 12 / 25:", "if e < 12 / 25:"),
            ("& (e < 1) & (R2 < R1)", "& (e < 1)"),
        ]
    ),
)
def test_a_compiled_source_that_computes_something_else_is_caught(right: str, wrong: str) -> None:
    from mechproof.derivations.elliptic_planetary import PAPER

    (source,) = render_compiled(PAPER).values()
    kernels = list_scalars(PAPER)
    check_translation(source, kernels, PAPER.one_pass)
    assert right in source
    with pytest.raises(TranslationError, match="not as meant"):
        check_translation(source.replace(right, wrong, 1), kernels, PAPER.one_pass)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("_fma(a, b, -p)", "_fma(a, b, p)"),
        ("_choose(v7, v4, -v5)", "_choose(v7, -v5, v4)"),
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
    with pytest.raises(TranslationError, match="not as meant"):
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
    first_of(
        [
            ("_elementary.total_rest", "_elementary.product_rest"),
            ("_element(correlation, _at, _j, _i)", "_element(correlation, _at, _i, _j)"),
            ("_element(correlation, _at, _i, _i)", "_element(correlation, _at, _i, _j)"),
            ("_element(tolerances, _at, _j)", "_element(tolerances, _at, _i)"),
            ("_element(tolerances, _at, _j)", "_element(scatters, _at, _j)"),
            ("_element(tolerances, _at, _j)", "tolerances[_j]"),
            ("scatters_i > 0", "scatters_i >= 0"),
            (
                "(sensitivities_i * scatters_i * tolerances_i) ** 2",
                "(scatters_i * tolerances_i) ** 2",
            ),
            ("scatters_i * tolerances_i) ** 2", "scatters_i * tolerances_i)"),
            ("* (sensitivities_j * scatters_j", "* (sensitivities_j * scatters_i"),
            ("_every(_every_3_term, ", "_every(_every_4_term, "),
            ("_add_up(\n            _sum_11_term", "_add_up(\n            _sum_2_term"),
            ("_every_4_term, _at, 1, ", "_every_4_term, _at, 0, "),
            ("(_terms, _terms), (correlation,)", "(_terms,), (correlation,)"),
            ("(_terms,), (scatters,)", "(_terms,), (tolerances,)"),
            ("(sensitivities, scatters, tolerances),", "(scatters, sensitivities, tolerances),"),
            (
                "(tolerances, sensitivities, scatters, total_scatter),",
                "(sensitivities, tolerances, scatters, total_scatter),",
            ),
            ("(_terms, _terms, _terms, 1)", "(_terms, _terms, 1, 1)"),
            ("_element(total_scatter, _at)", "total_scatter"),
            ('_take_terms("scatters", scatters', '_take_terms("scatters", tolerances'),
            ("_take_square(", "_take_terms("),
            ("    5,\n        _out,", "    4,\n        _out,"),
            (
                "*_sums_of_error_sum(None, _terms, tolerances",
                "*_sums_of_error_sum(None, 1, tolerances",
            ),
            ("(1, 1, 1, 0)", "(1, 1, 0, 0)"),
        ]
    ),
)
def test_a_compiled_sum_that_adds_something_else_is_caught(right: str, wrong: str) -> None:
    from mechproof.derivations.track_wheel import PAPER

    (source,) = render_compiled(PAPER).values()
    kernels = list_scalars(PAPER)
    check_translation(source, kernels, PAPER.one_pass)
    assert right in source
    told = r"(the module|_(sum|every)_\d+_term|(sums|fill|point)_of_error_sum\w*) is not as"
    with pytest.raises(TranslationError, match=told):
        check_translation(source.replace(right, wrong, 1), kernels, PAPER.one_pass)


@pytest.mark.slow
def test_any_sum_is_compiled(tmp_path: Path) -> None:
    """The arguments have names that loops use, and a term has a function of large angles."""
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
