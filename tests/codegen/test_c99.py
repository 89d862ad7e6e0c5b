"""Kernels in C: compiled without a warning, within the bounds, with the bits of numba's."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from compiled import grouped
from derived import SYSTEMS, paper_of
from typer.testing import CliRunner

from mechproof.cli.commands import app
from mechproof.codegen.backends.c99 import render_c
from mechproof.codegen.backends.one_pass import join_kernels
from mechproof.codegen.backends.scalar import list_scalars
from mechproof.codegen.kernel import Kernel
from mechproof.codegen.program import NOTHING, Operation, Program
from mechproof.derivations.elliptic_planetary import PAPER
from mechproof.lab.search import find_worst
from mechproof.lab.subject import find_subjects

COMPILER = shutil.which("cc")
pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
WARNED = ("-O2", "-Wall", "-Wextra", "-Werror", "-pedantic")
STRICT = ("-std=c99", *WARNED, "-ffp-contract=off")
# What compilers make of products and sums where nothing forbids it, on processors that have fma.
CONTRACTED = ("-std=c99", *WARNED, "-march=native", "-ffp-contract=fast")
PAPERS = {system: paper_of(system) for system in SYSTEMS}
KERNELS = {f"{s}.{k.name}": k for s, p in PAPERS.items() for k in list_scalars(p)}
SUBJECTS = {s.name: s for s in find_subjects(()) if s.name in KERNELS}
EPS32 = float(np.finfo(np.float32).eps)


@pytest.fixture(scope="module")
def libraries(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., ctypes.CDLL]:
    folder = tmp_path_factory.mktemp("c")

    @cache
    def build(system: str, single: bool, flags: tuple[str, ...] = STRICT) -> ctypes.CDLL:
        files = render_c(PAPERS[system], single=single)
        for name, text in files.items():
            (folder / name).write_text(text)
        (source,) = (name for name in files if name.endswith(".c"))
        target = folder / f"{source}{flags[-1]}.so"
        assert COMPILER is not None
        command = [COMPILER, *flags, "-shared", "-fPIC", source, "-o", str(target), "-lm"]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return ctypes.CDLL(str(target))

    return build


def point_function(library: ctypes.CDLL, system: str, kernel: Kernel, single: bool) -> Any:
    """Return a function of broadcasting arrays that calls the C function of one point."""
    real = ctypes.c_float if single else ctypes.c_double
    axes, widths = dict(kernel.code.indexed), {name for name, _ in kernel.code.vectors}
    ranks = [axes.get(a, int(a in widths)) for a in kernel.code.arguments]
    count = int(np.prod(kernel.code.shape))
    function = getattr(library, f"{system}_{kernel.name}")
    function.restype = None if kernel.code.shape else real
    rows = [ctypes.POINTER(real) if rank else real for rank in ranks]
    rows += [real * count] if kernel.code.shape else []
    function.argtypes = [ctypes.c_size_t, *rows] if axes else rows

    def call(*arguments: Any) -> Any:
        arrays = [np.asarray(a, float) for a in arguments]
        shapes = [a.shape[: max(a.ndim - r, 0)] for a, r in zip(arrays, ranks, strict=True)]
        tails = [
            a.shape[a.ndim - r :] if a.ndim else () for a, r in zip(arrays, ranks, strict=True)
        ]
        points = np.broadcast_shapes(*shapes)
        terms = [max(n for tail in tails for n in tail)] if axes else []
        spread = [
            np.broadcast_to(a, points + (tuple(terms) * r or tail))
            for a, tail, r in zip(arrays, tails, ranks, strict=True)
        ]
        found = np.empty(points + kernel.code.shape)
        for index in np.ndindex(points):
            given = [
                (real * a[index].size)(*a[index].flat) if rank else real(a[index])
                for a, rank in zip(spread, ranks, strict=True)
            ]
            if kernel.code.shape:
                out = (real * count)()
                function(*given, out)
                found[index] = np.reshape(out, kernel.code.shape)
            else:
                found[index] = function(*terms, *given)
        return found

    return call


@pytest.mark.parametrize("name", grouped(n for n, s in SUBJECTS.items() if s.quantity.accuracy))
def test_bounds_and_the_bits_of_numba(name: str, libraries: Callable[..., ctypes.CDLL]) -> None:
    """Both compute the same operations, each rounded once: no bit may differ."""
    system, _, quantity = name.partition(".")
    call = point_function(libraries(system, False), system, KERNELS[name], False)
    compiled = getattr(import_module(f"mechproof.kernels.compiled.{system}"), quantity)
    met: list[tuple[Any, ...]] = []

    def both(*arguments: Any) -> Any:
        met.append(arguments)
        return call(*arguments)

    subject = SUBJECTS[name]
    assert subject.quantity.accuracy is not None
    found = find_worst(subject, both, rounds=0, seed=20262, share=0.05, most=20)
    assert found.tried > 10
    assert found.scaled <= subject.quantity.accuracy.ulp
    for arguments in met:
        ours, numbas = call(*arguments), np.asarray(compiled(*arguments))
        assert np.array_equal(ours.view(np.int64), numbas.view(np.int64)) or np.array_equal(
            ours[~np.isnan(ours)], numbas[~np.isnan(ours)]
        )


@pytest.mark.parametrize("name", ["elliptic_planetary.position", "oval_planetary.acceleration"])
def test_bounds_hold_where_a_compiler_contracts(
    name: str, libraries: Callable[..., ctypes.CDLL]
) -> None:
    """A product that is not rounded is no worse; the rests of products are taken by fma anyway."""
    system, _, _ = name.partition(".")
    contracted = point_function(libraries(system, False, CONTRACTED), system, KERNELS[name], False)
    strict = point_function(libraries(system, False), system, KERNELS[name], False)
    differ: list[bool] = []

    def call(*arguments: Any) -> Any:
        found = contracted(*arguments)
        differ.append(not np.array_equal(found, strict(*arguments), equal_nan=True))
        return found

    subject = SUBJECTS[name]
    assert subject.quantity.accuracy is not None
    found = find_worst(subject, call, rounds=0, seed=20262, share=0.2, most=5)
    assert found.scaled <= subject.quantity.accuracy.ulp
    processor = Path("/proc/cpuinfo")
    if processor.is_file() and "fma" in processor.read_text(encoding="utf-8"):
        assert any(differ)


ELLIPTIC = ("position", "ratio", "acceleration")


@pytest.mark.parametrize("name", ELLIPTIC)
def test_floats_keep_the_digits_of_floats(name: str, libraries: Callable[..., ctypes.CDLL]) -> None:
    from mechproof.kernels import elliptic_planetary as kernels

    kernel = KERNELS[f"elliptic_planetary.{name}"]
    call = point_function(
        libraries("elliptic_planetary", True), "elliptic_planetary_single", kernel, True
    )
    random = np.random.default_rng(20263)
    phi = np.float32(random.uniform(-6, 6, 500)).astype(float)
    for e in (np.float32(0.28), np.float32(0.475), np.float32(0.75)):
        sizes = (66.0, 16.0, float(e))
        wanted = getattr(kernels, name)(phi, *sizes)
        steepness = np.abs(kernels.acceleration(phi, *sizes)) * np.abs(phi)
        scale = np.abs(wanted) + (steepness if name == "ratio" else 0)
        if name == "acceleration":
            scale = np.full_like(phi, 2 * np.abs(kernels.acceleration(phi, *sizes)).max())
        assert np.max(np.abs(call(phi, *sizes) - wanted) / scale) <= 8 * EPS32


def test_many_points_and_the_ends_of_the_domain(libraries: Callable[..., ctypes.CDLL]) -> None:
    function = libraries("elliptic_planetary", False).elliptic_planetary_position_array
    real = ctypes.c_double
    function.argtypes = [ctypes.c_size_t, real * 4, real, real, real, real * 4]
    function.restype = None
    out = (real * 4)()
    function(4, (real * 4)(1.0, float("nan"), 1e9, -2.0), 66.0, 16.0, 0.3, out)
    from mechproof.kernels.compiled import elliptic_planetary

    wanted = elliptic_planetary.position(np.array([1.0, np.nan, 1e9, -2.0]), 66.0, 16.0, 0.3)
    assert np.array_equal(np.array(out), wanted, equal_nan=True)
    function(4, (real * 4)(1.0, 2.0, 3.0, 4.0), 66.0, 16.0, 1.0, out)
    assert np.isnan(out).all()


TOGETHER = {f"{s}.{t.name}": t for s, p in PAPERS.items() for t in p.together}
# On both sides of where another form is taken, beyond the domain, and a size that is NaN.
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
    """Call a function of an array of points that stores so many results for each."""
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
    together, system = TOGETHER[name], name.partition(".")[0]
    library = libraries(system, single)
    compiled = import_module(f"mechproof.kernels.compiled.{system}")
    prefix = f"{system}_single" if single else system
    points = np.concatenate([np.linspace(-9, 9, 2001), [0, -0.0, np.nan, np.inf, 1e9, 1e-300]])
    points = points.astype(np.float32 if single else float)
    names = KERNELS[f"{system}.{together.quantities[0]}"].code.arguments[1:]
    for sizes in map(list, zip(*(SIZES[name] for name in names), strict=True)):
        function = getattr(library, f"{prefix}_{together.name}_array")
        found = call_all(function, points, sizes, len(together.quantities))
        each = (getattr(library, f"{prefix}_{name}_array") for name in together.quantities)
        wanted = np.concatenate([call_all(one, points, sizes, 1) for one in each])
        assert_same_bits(found, wanted)
        if not single:
            assert_same_bits(found, getattr(compiled, together.name)(points, *sizes))


def assert_same_bits(found: Any, wanted: Any) -> None:
    assert np.array_equal(found, wanted, equal_nan=True)
    numbers = ~np.isnan(found)
    assert np.array_equal(np.signbit(found[numbers]), np.signbit(wanted[numbers]))


def test_one_pass_computes_what_is_common_once() -> None:
    kernels = [KERNELS[f"elliptic_planetary.{name}"] for name in ELLIPTIC]
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


def test_what_has_no_domain_in_common_is_refused() -> None:
    position, ratio = (KERNELS[f"elliptic_planetary.{name}"] for name in ELLIPTIC[:2])
    everywhere = replace(ratio, code=replace(ratio.code, inside=None))
    with pytest.raises(
        NotImplementedError, match=r"both: \['ratio'\] have another domain than 'pos"
    ):
        join_kernels("both", [position, everywhere])


@pytest.mark.parametrize(
    ("kind", "first", "second"),
    [
        ("copysign", ("phi1", 0.0), ("phi1", -0.0)),
        ("subtract", ("phi1", 1.0), (1.0, "phi1")),
    ],
)
def test_unlike_values_are_not_taken_for_one(kind: str, first: Any, second: Any) -> None:
    position, ratio = (KERNELS[f"elliptic_planetary.{name}"] for name in ELLIPTIC[:2])

    def compute(kernel: Kernel, operands: Any) -> Kernel:
        (*_, last) = kernel.code.stages
        program = Program(("phi1",), (Operation("_1", kind, operands),), ("_1",))
        stage = replace(last, parameters=(), prepare=NOTHING, evaluate=program)
        return replace(kernel, code=replace(kernel.code, stages=(stage,)))

    apart = join_kernels("both", [compute(position, first), compute(ratio, second)])
    assert apart.code.count_operations() == (2,)
    alike = join_kernels("both", [compute(position, first), compute(ratio, first)])
    assert alike.code.count_operations() == (1,)


def test_sums_take_pointers_and_the_number_of_terms(
    libraries: Callable[..., ctypes.CDLL],
) -> None:
    from mechproof.kernels.compiled import track_wheel

    random = np.random.default_rng(20264)
    points, terms = 3, 5
    tolerances = random.uniform(0.01, 0.1, (points, terms))
    influences, scatters = random.uniform(1, 2, (2, terms))
    matrix = np.where(np.eye(terms), 1, 0.25)
    matrix[0, 1] = matrix[1, 0] = -0.5
    pointer, size, real = np.ctypeslib.ndpointer(float), ctypes.c_size_t, ctypes.c_double
    library = libraries("track_wheel", False)
    for name, rest in (("error_sum", (1.1,)), ("error_sum_correlated", (matrix, 1.1))):
        function = getattr(library, f"track_wheel_{name}_array")
        function.argtypes = [size, size, *[pointer] * (len(rest) + 2), real, pointer]
        function.restype = None
        out = np.empty(points)
        function(points, terms, tolerances, influences, scatters, *rest, out)
        compiled = getattr(track_wheel, name)(tolerances, influences, scatters, *rest)
        assert np.array_equal(out, compiled)
    one = library.track_wheel_error_sum
    one.argtypes, one.restype = [size, *[pointer] * 3, real], real
    assert one(0, tolerances, influences, scatters, 1.1) == 0.0
    assert np.isnan(one(terms, -tolerances, influences, scatters, 1.1))


def test_a_name_that_c_keeps_for_itself_is_refused() -> None:
    argument = PAPER.quantities[0].arguments[0]
    quantity = replace(
        PAPER.quantities[0],
        arguments=(replace(argument, name="double"), *PAPER.quantities[0].arguments[1:]),
    )
    with pytest.raises(ValueError, match=r"\['double'\] mean something else in C"):
        render_c(replace(PAPER, quantities=(quantity,), together=()))


def test_the_command_writes_what_a_program_includes(tmp_path: Path) -> None:
    runner = CliRunner()
    done = runner.invoke(app, ["emit", "c", "elliptic_planetary", "--out", str(tmp_path)])
    assert done.exit_code == 0, done.output
    (tmp_path / "main.c").write_text(
        '#include <stdio.h>\n#include "elliptic_planetary.h"\n'
        'int main(void) { printf("%.17g", elliptic_planetary_position(0.5, 66, 16, 0.475)); }\n'
    )
    assert COMPILER is not None
    command = [COMPILER, *STRICT, "main.c", "elliptic_planetary.c", "-o", "main", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    printed = subprocess.run([str(tmp_path / "main")], capture_output=True, text=True, check=True)
    from mechproof.kernels import elliptic_planetary

    wanted = elliptic_planetary.position(0.5, 66, 16, 0.475)
    assert float(printed.stdout) == pytest.approx(wanted, rel=6 * 2.0**-52)
    assert runner.invoke(app, ["emit", "c", "conformity", "--out", str(tmp_path)]).exit_code == 1
