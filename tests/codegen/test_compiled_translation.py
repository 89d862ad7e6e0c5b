"""Compiled sources read back as their programs, and what computes something else is caught."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from trial import load_paper, load_source, paper_of, quantity_of

from mechproof.codegen.backends.numba import (
    check_elementary,
    check_translation,
    render_compiled,
    render_elementary,
)
from mechproof.codegen.backends.scalar import list_scalars
from mechproof.codegen.reading import TranslationError


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
        ("choose(v7, v4, -v5)", "choose(v7, -v5, v4)"),
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
        ("float64(correlation[j, i])", "float64(correlation[i, j])"),
        ("float64(tolerances[j])", "float64(tolerances[i])"),
        ("holds = holds & ", "holds = "),
        ("for j in range(len(", "for j in range(1, len("),
        ("_every_3(scatters)", "_every_4(scatters)"),
        ("scatters_i > 0", "scatters_i >= 0"),
        ("(sensitivities_i * scatters_i * tolerances_i) ** 2", "(scatters_i * tolerances_i) ** 2"),
        ("scatters_i * tolerances_i) ** 2", "scatters_i * tolerances_i)"),
        ("* (sensitivities_j * scatters_j", "* (sensitivities_j * scatters_i"),
        ("low[s] += elementary.total_rest", "low[s] -= elementary.total_rest"),
        ("total = high[s] + term", "total = high[s] - term"),
        ("high[s] + low[s], high[s])", "high[s], high[s])"),
        ("correlation[j, i, s]", "correlation[i, j, s]"),
        ("tolerances[j, s]", "tolerances[i, s]"),
        ("correlation[i, i, s]", "correlation[i, i, 0]"),
        (
            "holds[s] = choose(_every_3_term(scatters[i, s]), holds[s]",
            "holds[s] = choose(_every_3_term(scatters[i, s]), 1.0",
        ),
        (
            "_sum_11(sensitivities, scatters, tolerances),",
            "_sum_11(scatters, sensitivities, tolerances),",
        ),
        ("put_sets(scatters_sets, scatters_values", "put_sets(scatters_sets, tolerances_values"),
        (
            "_every_3_sets(every_3_sets, scatters_sets)",
            "_every_3_sets(every_4_sets, scatters_sets)",
        ),
        (
            "_every_3_sets(every_3_sets, scatters_sets)",
            "_every_4_sets(every_4_sets, scatters_sets)",
        ),
        ("every_4_sets[s] > 0", "every_3_sets[s] > 0"),
        ("total_scatter_sets[0, s]", "total_scatter_sets[0, 0]"),
    ],
)
def test_a_compiled_sum_that_adds_something_else_is_caught(right: str, wrong: str) -> None:
    from mechproof.derivations.track_wheel import PAPER

    (source,) = render_compiled(PAPER).values()
    kernels = list_scalars(PAPER)
    check_translation(source, kernels)
    assert right in source
    with pytest.raises(
        ValueError, match=r"meant|no loop over terms|are put into|of a set|not put|before"
    ):
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
