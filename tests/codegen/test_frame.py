"""The frame of emitted modules: what no formula tells of, and the twins that it refuses."""

from __future__ import annotations

from functools import cache

import pytest

from mechproof.codegen.backends.numba import (
    check_elementary,
    check_translation,
    render_compiled,
    render_elementary,
)
from mechproof.codegen.backends.numpy import render_modules
from mechproof.codegen.backends.scalar import list_scalars
from mechproof.codegen.frame import COMPILED, check_frame
from mechproof.codegen.kernel_reading import read_module
from mechproof.codegen.reading import ReadingError
from mechproof.derivations.elliptic_planetary import PAPER


@cache
def numpy_source() -> str:
    return render_modules(PAPER)["elliptic_planetary.py"]


@cache
def compiled_source() -> str:
    (source,) = render_compiled(PAPER).values()
    return source


@pytest.mark.parametrize(
    ("right", "wrong", "told"),
    [
        ("is_positive as _is_positive", "is_finite as _is_positive", "is_finite is called"),
        ("product_rest as _product_rest", "quotient_rest as _product_rest", "quotient_rest is"),
        ("import numpy as _np", "import math as _np", "math is called _np"),
        ("def ratio(", "@_square\ndef ratio(", "ratio is decorated by _square"),
    ],
)
def test_a_numpy_module_whose_names_are_others_is_refused(
    right: str, wrong: str, told: str
) -> None:
    source = numpy_source()
    read_module(source)
    assert right in source
    with pytest.raises(ReadingError, match=told):
        read_module(source.replace(right, wrong, 1))


@pytest.mark.parametrize(
    ("right", "wrong", "told"),
    [
        ("    widen as _widen,", "    has_nan as _widen,", "has_nan is called _widen"),
        ("@_loop\n", "", "is decorated by nothing"),
        ("@_scalar\ndef _value_of", "@_loop\ndef _value_of", "is decorated by _loop"),
        ("@_overload(ratio)", "@_overload(position)", r"by _overload\(position\)"),
        ("_form_of_ratio(phi1, *_prepared", "_form_of_ratio(e, *_prepared", "calls _form_of_ratio"),
        ("return _value_of_ratio(phi1, R1, ", "return _value_of_ratio(R1, phi1, ", "calls _value_"),
        ("return _value_of_ratio(phi1, ", "return _value_of_ratio(-phi1, ", "calls _value_"),
        ("return _math.nan", "return 0.0", "outside its domain"),
    ],
)  # fmt: skip
def test_a_compiled_module_whose_parts_do_not_meet_is_refused(
    right: str, wrong: str, told: str
) -> None:
    source, kernels = compiled_source(), list_scalars(PAPER)
    check_translation(source, kernels)
    assert right in source
    with pytest.raises(ReadingError, match=told):
        check_translation(source.replace(right, wrong, 1), kernels)


@pytest.mark.parametrize("name", ["short_term", "row_of_x", "sum_1", "value"])
def test_a_kernel_may_be_called_like_parts_of_the_machinery(name: str) -> None:
    parts = {"_loop": f"_row_of_{name}", "_scalar": f"_point_of_{name}"}
    parts[f"_overload({name})"] = f"_offer_of_{name}"
    functions = [
        f"@{decorator}\ndef {part}(x):\n    return x\n" for decorator, part in parts.items()
    ]
    check_frame("\n".join(functions), COMPILED)


def test_an_elementary_function_that_numba_does_not_compile_is_refused() -> None:
    source = render_elementary()
    check_elementary(source)
    with pytest.raises(ReadingError, match="is decorated by nothing"):
        check_elementary(source.replace("@_scalar\n", "", 1))
