"""Code that no emitted source has is refused before it runs or caught when it does; none hangs."""

from __future__ import annotations

from functools import cache

import pytest
import sympy as sp
from trial import a, b, paper_of, quantity_of, x
from weights import first_of

from mechproof.codegen.backends.numba import (
    check_elementary,
    check_translation,
    render_compiled,
    render_elementary,
)
from mechproof.codegen.backends.numpy import render_modules
from mechproof.codegen.kernel_reading import check_module
from mechproof.codegen.source_reading import SourceError
from mechproof.programs.kernel import Kernel, list_functions
from mechproof.programs.scalar import list_scalars

FORM = "    one_plus_b_cos_x = "
RETURN = "    return a / ("


@cache
def trial() -> tuple[str, tuple[Kernel, ...]]:
    paper = paper_of(quantity_of(a / (1 + b * sp.cos(x)) ** 3, x, a, b))
    (source,) = render_modules(paper).values()
    return source, tuple(list_functions(paper))


def ask(times: int) -> str:
    return "".join(f"    if x > {n}.0:\n        one = x\n" for n in range(times))


@pytest.mark.parametrize(
    ("right", "wrong", "told"),
    [
        (FORM, f"    while True:\n        pass\n{FORM}", "emitted code never contains 'while True"),
        (
            FORM,
            f"    for _ in (x, a):\n        x = a\n{FORM}",
            "emitted code never contains 'for _",
        ),
        (FORM, f"    t = [y for y in (x, a)]\n{FORM}", r"emitted code never contains '\[y for"),
        (FORM, f"    t = (y for y in (x, a))\n{FORM}", r"emitted code never contains '\(y for"),
        (FORM, f"    yield x\n{FORM}", "emitted code never contains"),
        (FORM, f"    x += a\n{FORM}", r"emitted code never contains 'x \+= a'"),
        (FORM, f"    t: Any = x\n{FORM}", "emitted code never contains 't: Any = x'"),
        (FORM, f"    return x\n{FORM}", "code after a return"),
        (RETURN, "    return x if x else a / (", "emitted code never contains"),
        (
            FORM,
            f"    if x > 0.0:\n        return x\n{FORM}",
            "_form_of_f is not as meant: ways through it: 1",
        ),
        (FORM, f"    y = x and a\n{FORM}", "_form_of_f is not as meant: ways through it: 1"),
        (FORM, f"{ask(7)}{FORM}", "more than 64 ways"),
        ("from mechproof.kernel_support.functions", "from mechproof.laws.kinds", "never imports"),
        (FORM, f"    spare = x\n{FORM}", "_form_of_f is not as meant"),
        (FORM, f"    x = x\n{FORM}", "_form_of_f is not as meant"),
        (FORM, f"    a * b\n{FORM}", "_form_of_f is not as meant"),
        (FORM, f"    one_plus_b_cos_x = x\n{FORM}", "_form_of_f is not as meant"),
        (FORM, f"    _np = x\n{FORM}", "_form_of_f is not as meant|'_np'"),
        (FORM, f"    _square = x\n{FORM}", "not callable"),
        ("def _form_of_f(", "_np = 1.0\n\n\ndef _form_of_f(", "a module must not contain _np"),
        ("def _form_of_f(", "_square(1.0)\n\n\ndef _form_of_f(", "a module must not contain _"),
        ("def _form_of_f(", "@_square\ndef _form_of_f(", "_form_of_f is decorated by _square"),
        ("def _form_of_f(", "@cache\ndef _form_of_f(", "'cache' is not defined"),
        ("_np.cos(x)", "cos(x)", "'cos' is not defined"),
        ("_np.cos(x)", "_np.log2(x)", "no operation is written as numpy.log2"),
        ("_np.cos(x)", "_np.cos(eval('x'))", "'eval' is not defined"),
        ("_np.cos(x)", "_np.cos(x.__class__)", "is not a value"),
        ("_np.cos(x)", "_np.cos(x, x)", "_form_of_f is not as meant"),
        ("_np.cos(x)", "_np.cos(True)", "_form_of_f is not as meant"),
        (RETURN, "    return _form_of_f(x, a, b) / (", "maximum recursion depth"),
        ("import numpy as _np", "import os as _os\nimport numpy as _np", "imports os"),
        ("import numpy as _np", "import numpy as _np, math as _np", "math is imported as _np"),
        ("_form_of_f(x: Any, a: Any, b: Any)", "_form_of_f(x: Any, a: Any, b=[])", "not as meant"),
        ("_form_of_f(x: Any, a: Any,", "_form_of_f(x: Any, a: print(1),", "type print"),
        ("-> Any:\n    one", "-> eval:\n    one", "uses the type eval"),
    ],
)
def test_a_hostile_source_is_refused(right: str, wrong: str, told: str) -> None:
    source, kernels = trial()
    check_module(source, kernels)
    assert right in source
    with pytest.raises(SourceError, match=told):
        check_module(source.replace(right, wrong, 1), kernels)


@pytest.mark.parametrize(
    ("right", "wrong"),
    first_of(
        [
            ("return _math.tan(y)", "return _math.sin(y)"),
            ("if _exact is None:", "if _exact is not None:"),
            ("if _abs(y) <= _LARGEST:", "if _abs(y) >= _LARGEST:"),
            ("_LARGEST = 67108864.0", "_LARGEST = 67108865.0"),
            ("    return 1.0\n", "    return 0.0\n"),
        ],
        5,
    ),
)
def test_where_an_elementary_function_is_taken_elsewhere_is_read(right: str, wrong: str) -> None:
    source = render_elementary()
    check_elementary(source)
    assert right in source
    with pytest.raises(SourceError, match="is not as meant"):
        check_elementary(source.replace(right, wrong, 1))


def test_a_compiled_function_says_whether_far_angles_count() -> None:
    paper = paper_of(quantity_of(sp.cos(x) / a, x, a))
    (source,) = render_compiled(paper).values()
    kernels = list_scalars(paper)
    check_translation(source, kernels, ())
    assert "_elementary.cos(x, _exact)" in source
    for wrong in ("None", "True", "x"):
        changed = source.replace("cos(x, _exact)", f"cos(x, {wrong})")
        with pytest.raises(SourceError, match="_value_of_f is not as meant"):
            check_translation(changed, kernels, ())
