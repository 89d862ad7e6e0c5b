"""C kernels in one pass have the bits of each function and of numba, and share common steps."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from c_libraries import (
    ELLIPTIC,
    STRICT,
    assert_same_bits,
    compile_files,
    find_kernel,
    needs_compiler,
)
from compiled import TOGETHER, grouped
from derived import paper_of

from mechproof.codegen.backends.c99 import render_c_kernels
from mechproof.codegen.backends.one_pass import join_kernels
from mechproof.programs.kernel import Kernel
from mechproof.programs.program import NOTHING, Operation, Program
from mechproof.record import OnePass

pytestmark = needs_compiler
# Sizes on both sides of a change of form, beyond the domain, and with a NaN.
SIZES = {
    "R1": (66.0, 66.0, 16.0, np.nan),
    "R2": (16.0, 16.0, 66.0, 16.0),
    "e": (0.3, 0.75, 0.3, 0.3),
    "e1": (0.2, 0.0, 1.0, 0.2),
    "mount": (0.1, 2.0, 0.1, np.nan),
    "R4": (20.0, 20.0, -20.0, np.nan),
    "R5": (40.0, 21.0, 40.0, 40.0),
    "e2": (0.2, 0.9, 0.2, 0.2),
}


def call_all(function: Any, points: Any, sizes: list[float], results: int) -> Any:
    """Call a C function of an array of points; return its arrays, one for each of `results`."""
    real = ctypes.c_float if points.dtype == np.float32 else ctypes.c_double
    pointer = np.ctypeslib.ndpointer(points.dtype)
    function.argtypes = [ctypes.c_size_t, pointer, *[real] * len(sizes), *[pointer] * results]
    function.restype = None
    out = [np.empty_like(points) for _ in range(results)]
    function(points.size, points, *sizes, *out)
    return np.array(out)


@pytest.mark.parametrize("single", [False, True])
@pytest.mark.parametrize("name", grouped(TOGETHER))
def test_one_pass_has_the_bits_of_each_function_and_of_numba(
    name: str, single: bool, libraries: Callable[..., ctypes.CDLL]
) -> None:
    system, _, of = name.partition(".")
    (together,) = (t for t in paper_of(system).one_pass if t.name == of)
    library = libraries(system, single)
    compiled = import_module(f"mechproof.kernels.compiled.{system}")
    prefix = f"{system}_single" if single else system
    points = np.concatenate([np.linspace(-9, 9, 2001), [0, -0.0, np.nan, np.inf, 1e9, 1e-300]])
    points = points.astype(np.float32 if single else float)
    names = find_kernel(f"{system}.{together.quantities[0]}").code.arguments[1:]
    for sizes in map(list, zip(*(SIZES[name] for name in names), strict=True)):
        function = getattr(library, f"{prefix}_{together.name}_array")
        found = call_all(function, points, sizes, len(together.quantities))
        each = (getattr(library, f"{prefix}_{name}_array") for name in together.quantities)
        wanted = np.concatenate([call_all(one, points, sizes, 1) for one in each])
        assert_same_bits(found, wanted)
        if not single:
            assert_same_bits(found, getattr(compiled, together.name)(points, *sizes))


def test_one_pass_computes_what_is_common_once() -> None:
    kernels = [find_kernel(f"elliptic_planetary.{name}") for name in ELLIPTIC]
    joined = join_kernels("motion", kernels).code
    apart = [kernel.code.count_operations() for kernel in kernels]
    # The position has a form of its own where eccentricities are small.
    for number, count in enumerate(joined.count_operations()):
        alone = sum(counts[min(number, len(counts) - 1)] for counts in apart)
        assert max(map(max, apart)) < count < 0.7 * alone


def test_one_point_in_one_pass_is_stored_by_pointers(
    libraries: Callable[..., ctypes.CDLL],
) -> None:
    from mechproof.kernels.compiled import elliptic_planetary

    function, real = (
        libraries("elliptic_planetary", False).elliptic_planetary_motion,
        ctypes.c_double,
    )
    function.argtypes, function.restype = [real] * 4 + [ctypes.POINTER(real)] * 3, None
    out = [real() for _ in ELLIPTIC]
    function(0.3, 66, 16, 0.475, *map(ctypes.byref, out))
    wanted = elliptic_planetary.motion(0.3, 66.0, 16.0, 0.475)
    assert [number.value for number in out] == list(wanted)


def test_members_of_unlike_domains_are_called_one_by_one(tmp_path: Path) -> None:
    names = ("position", "ratio")
    position, ratio = (find_kernel(f"elliptic_planetary.{name}") for name in names)
    everywhere = replace(ratio, code=replace(ratio.code, inside=None))
    with pytest.raises(
        NotImplementedError, match=r"both: \['ratio'\] have another domain than 'pos"
    ):
        join_kernels("both", [position, everywhere])
    together = [OnePass("both", names)]
    files = render_c_kernels("pair", [position, everywhere], ("", "", "pair"), {}, together)
    library = compile_files(tmp_path, files, STRICT)
    points = np.array([-4.0, 0.0, 0.3, 1e9, np.nan])
    for sizes in ([66.0, 16.0, 0.3], [16.0, 66.0, 0.3]):
        each = [call_all(getattr(library, f"pair_{n}_array"), points, sizes, 1) for n in names]
        found = call_all(library.pair_both_array, points, sizes, 2)
        assert_same_bits(found, np.concatenate(each))
    assert np.isnan(found[0]).all()
    assert np.isfinite(found[1, :3]).all()
    # The points are read before the first result overwrites them.
    own, last = points.copy(), np.empty_like(points)
    library.pair_both_array(points.size, own, *sizes, own, last)
    assert_same_bits(np.array([own, last]), found)


@pytest.mark.parametrize(
    ("kind", "first", "second"),
    [
        ("copysign", ("phi1", 0.0), ("phi1", -0.0)),
        ("subtract", ("phi1", 1.0), (1.0, "phi1")),
    ],
)
def test_unlike_values_are_not_taken_for_one(kind: str, first: Any, second: Any) -> None:
    position, ratio = (find_kernel(f"elliptic_planetary.{name}") for name in ELLIPTIC[:2])

    def compute(kernel: Kernel, operands: Any) -> Kernel:
        (*_, last) = kernel.code.stages
        program = Program(("phi1",), (Operation("_1", kind, operands),), ("_1",))
        stage = replace(last, parameters=(), prepare=NOTHING, evaluate=program)
        return replace(kernel, code=replace(kernel.code, stages=(stage,)))

    apart = join_kernels("both", [compute(position, first), compute(ratio, second)])
    assert apart.code.count_operations() == (2,)
    alike = join_kernels("both", [compute(position, first), compute(ratio, first)])
    assert alike.code.count_operations() == (1,)
