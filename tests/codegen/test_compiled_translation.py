"""Compiled sources read back as their programs, and what computes something else is caught."""

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
from mechproof.codegen.backends.scalar import list_scalars
from mechproof.codegen.reading import TranslationError


@pytest.mark.parametrize(
    ("right", "wrong"),
    first_of(
        [
            ("k_low * phi1 + _elementary.product_rest", "_elementary.product_rest"),
            ("t + t_low * t_below", "t - t_low * t_below"),
            ("if e <= 0.5:", "if e < 0.5:"),
            ("& (e < 1) & (R2 < R1)", "& (e < 1)"),
        ]
    ),
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
    first_of(
        [
            ("_low += _elementary.total_rest", "_low -= _elementary.total_rest"),
            ("_total = _high + _term", "_total = _high - _term"),
            ("_choose(_is_finite(_low), _high + _low, _high)", "_high"),
            ("_float64(correlation[_j, _i])", "_float64(correlation[_i, _j])"),
            ("_float64(tolerances[_j])", "_float64(tolerances[_i])"),
            ("_holds = _holds & ", "_holds = "),
            ("for _j in _range(_len(", "for _j in _range(1, _len("),
            ("_every_3(scatters)", "_every_4(scatters)"),
            ("scatters_i > 0", "scatters_i >= 0"),
            (
                "(sensitivities_i * scatters_i * tolerances_i) ** 2",
                "(scatters_i * tolerances_i) ** 2",
            ),
            ("scatters_i * tolerances_i) ** 2", "scatters_i * tolerances_i)"),
            ("* (sensitivities_j * scatters_j", "* (sensitivities_j * scatters_i"),
            ("_low[_s] += _elementary.total_rest", "_low[_s] -= _elementary.total_rest"),
            ("_total = _high[_s] + _term", "_total = _high[_s] - _term"),
            ("_high[_s] + _low[_s], _high[_s])", "_high[_s], _high[_s])"),
            ("correlation[_j, _i, _s]", "correlation[_i, _j, _s]"),
            ("tolerances[_j, _s]", "tolerances[_i, _s]"),
            ("correlation[_i, _i, _s]", "correlation[_i, _i, 0]"),
            (
                "_holds[_s] = _choose(_every_3_term(scatters[_i, _s]), _holds[_s]",
                "_holds[_s] = _choose(_every_3_term(scatters[_i, _s]), 1.0",
            ),
            (
                "_sum_11(sensitivities, scatters, tolerances),",
                "_sum_11(scatters, sensitivities, tolerances),",
            ),
            (
                "_put_sets(_sets_of_scatters, _values_of_scatters",
                "_put_sets(_sets_of_scatters, _values_of_tolerances",
            ),
            (
                "_every_3_sets(_sets_of_every_3, _sets_of_scatters)",
                "_every_3_sets(_sets_of_every_4, _sets_of_scatters)",
            ),
            (
                "_every_3_sets(_sets_of_every_3, _sets_of_scatters)",
                "_every_4_sets(_sets_of_every_4, _sets_of_scatters)",
            ),
            ("_sets_of_every_4[_s] > 0", "_sets_of_every_3[_s] > 0"),
            ("_sets_of_total_scatter[0, _s]", "_sets_of_total_scatter[0, 0]"),
        ]
    ),
)
def test_a_compiled_sum_that_adds_something_else_is_caught(right: str, wrong: str) -> None:
    from mechproof.derivations.track_wheel import PAPER

    (source,) = render_compiled(PAPER).values()
    kernels = list_scalars(PAPER)
    check_translation(source, kernels)
    assert right in source
    with pytest.raises(
        ValueError, match=r"meant|calls|no loop over terms|are put into|of a set|not put|before"
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
