"""The frame of emitted modules, the code that no formula determines: wrong twins are refused."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest
import sympy as sp
from derived import declared_paper_of
from trial import paper_of, quantity_of, x

from mechproof.codegen.backends.numba import (
    check_elementary,
    check_translation,
    render_compiled,
    render_elementary,
)
from mechproof.codegen.backends.numpy import render_modules
from mechproof.codegen.form_rows import form_rows
from mechproof.codegen.kernel_reading import read_module
from mechproof.codegen.source_reading import SourceError
from mechproof.programs.scalar import list_scalars


@cache
def numpy_source() -> str:
    return render_modules(declared_paper_of("elliptic_planetary"))["elliptic_planetary.py"]


@cache
def compiled_source() -> str:
    (source,) = render_compiled(declared_paper_of("elliptic_planetary")).values()
    return source


@pytest.mark.parametrize(
    ("right", "wrong", "told"),
    [
        ("is_positive as _is_positive", "is_finite as _is_positive", "is_finite is imported as"),
        ("product_rest as _product_rest", "quotient_rest as _product_rest", "quotient_rest is"),
        ("import numpy as _np", "import math as _np", "math is imported as _np"),
        ("def ratio(", "@_square\ndef ratio(", "ratio is decorated by _square"),
    ],
)
def test_a_numpy_module_whose_names_are_others_is_refused(
    right: str, wrong: str, told: str
) -> None:
    source = numpy_source()
    read_module(source)
    assert right in source
    with pytest.raises(SourceError, match=told):
        read_module(source.replace(right, wrong, 1))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("right", "wrong", "told"),
    [
        ("    fill as _fill,", "    fill_blocks as _fill,", "fill_blocks is imported as _fill"),
        ("@_loop\n", "", "read decorated by nothing"),
        ("@_scalar\ndef _value_of", "@_loop\ndef _value_of", "read decorated by _loop"),
        ("@_point_of(ratio, ", "@_point_of(position, ", "'position' is not defined"),
        ("@_point_of(position, ", "@_point_of(ratio, ", r"decorated by _point_of\(ratio, "),
        ("position, spread=True", "position", r"decorated by _point_of\(position\)"),
        ("_form_1_of_position(phi1, R1, ", "_form_1_of_position(phi1, e, ", "duplicate argument"),
        ("return _form_1_of_position(phi1", "return _form_1_of_position(e", "position is not"),
        ("return _form_1_of_position(", "return _value_of_ratio(", "_value_of_position is not"),
        ("return _math.nan", "return 0.0", "_value_of_ratio is not"),
        ("_float64(phi1), _float64(R1), ", "_float64(R1), _float64(phi1), ", "_point_of_ratio is"),
        ("_value_of_ratio(_float64(phi1)", "_value_of_ratio(-_float64(phi1)", "_point_of_ratio is"),
        ("_value_of_ratio(_float64(phi1)", "_value_of_ratio(phi1", "_point_of_ratio is not"),
        ("_fill_blocks(_value_of_ratio, ", "_fill(_value_of_ratio, ", "_fill_of_ratio is not"),
        ("ratio, _out, (phi1, R1", "ratio, _out, (R1, phi1", "_fill_of_ratio is not"),
        ("    _fill_blocks(", "    R1 = R2\n    _fill_blocks(", "_fill_of_ratio is not"),
        ("_fill_of_ratio)\n", "_fill_of_position)\n", "'_fill_of_position' is not defined"),
        ("_fill_of_position)\n", "_fill_of_ratio)\n", "the module is not as meant.*_loops_of_posi"),
        ("_loops_of_ratio = ", "ratio = position\n_loops_of_ratio = ", "'position' is not defined"),
        ("_loops_of_position = ", "position = ratio\n_loops_of_position = ", "the module is not"),
        ("fill(_row, phi1, R1, R2", "fill(_row, phi1, R2, R1", "ratio is not"),
        ("(_loops_of_ratio, (phi1, R1, R2", "(_loops_of_ratio, (phi1, R2, R1", "ratio is not"),
        ("  _value_of_position(phi1, ", "  _value_of_ratio(phi1, ", "_value_of_motion is not"),
    ],
)  # fmt: skip
def test_a_compiled_module_whose_parts_do_not_meet_is_refused(
    right: str, wrong: str, told: str
) -> None:
    paper = declared_paper_of("elliptic_planetary")
    source, kernels = compiled_source(), list_scalars(paper)
    check_translation(source, kernels, paper.one_pass)
    assert right in source
    with pytest.raises(SourceError, match=told):
        check_translation(source.replace(right, wrong, 1), kernels, paper.one_pass)


@pytest.mark.parametrize("name", ["short_term", "row_of_x", "sum_1", "value"])
def test_a_kernel_may_be_called_like_parts_of_the_machinery(name: str) -> None:
    paper = paper_of(replace(quantity_of(sp.sin(x), x), name=name))
    form_rows(paper)
    assert f"def _point_of_{name}(x):" in "".join(render_compiled(paper).values())


def test_an_elementary_function_that_numba_does_not_compile_is_refused() -> None:
    source = render_elementary()
    check_elementary(source)
    with pytest.raises(SourceError, match="read decorated by nothing"):
        check_elementary(source.replace("@_scalar\n", "", 1))
