"""Kernels in C compile without a warning, keep the bounds, and have the bits of numba's."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Callable
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from c_libraries import (
    COMPILER,
    POINTER,
    PORTABLE,
    STRICT,
    WARNED,
    assert_same_bits,
    compile_files,
    find_kernel,
    needs_compiler,
    render,
)
from compiled import grouped
from derived import declared_paper_of
from quantities import KERNELS, find_subject
from typer.testing import CliRunner
from weights import first_of

from mechproof.cli.commands import app
from mechproof.codegen.backends.c99 import BLOCK, render_c
from mechproof.kernels.derivatives import track_wheel as of_wheel
from mechproof.lab.sampling.named_sets import choose_evenly, join
from mechproof.lab.single_precision_errors import WIDER, Singles, mark_judged, narrow, round_singly
from mechproof.lab.worst_search import draw_sets, find_worst, mark_accuracy_domain, scaled_errors
from mechproof.programs.kernel import Kernel

pytestmark = needs_compiler
# Reductions with low words and without, and a radius of sines.
FIRST = ("elliptic_planetary.position", "oval_planetary.acceleration", "track_wheel.radius")
# Flags with which compilers contract products and sums on processors that have fma.
CONTRACTED = ("-std=c99", *WARNED, "-march=native", "-ffp-contract=fast")


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


@pytest.mark.slow
@pytest.mark.parametrize("name", grouped(KERNELS, 1))
def test_bounds_and_the_bits_of_numba(name: str, libraries: Callable[..., ctypes.CDLL]) -> None:
    """Both compute the same operations, each rounded once, so all bits agree."""
    system, _, quantity = name.partition(".")
    call = point_function(libraries(system, False), system, find_kernel(name), False)
    compiled = getattr(import_module(f"mechproof.kernels.compiled.{system}"), quantity)
    met: list[tuple[Any, ...]] = []

    def both(*arguments: Any) -> Any:
        met.append(arguments)
        return call(*arguments)

    subject = find_subject(name)
    assert subject.quantity.accuracy is not None
    found = find_worst(subject, both, rounds=0, seed=20262, share=0.05, most=20)
    assert found.tried > 10
    assert found.scaled <= subject.quantity.accuracy.ulp
    for arguments in met:
        ours, numbas = call(*arguments), np.asarray(compiled(*arguments))
        assert np.array_equal(ours.view(np.int64), numbas.view(np.int64)) or np.array_equal(
            ours[~np.isnan(ours)], numbas[~np.isnan(ours)]
        )


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", first_of(["elliptic_planetary.position", "oval_planetary.acceleration"])
)
def test_bounds_hold_where_a_compiler_contracts(
    name: str, libraries: Callable[..., ctypes.CDLL]
) -> None:
    """An unrounded product is no worse, and rests of products are computed by fma anyway."""
    system, _, _ = name.partition(".")
    contracted, strict = (
        point_function(libraries(system, False, *flags), system, find_kernel(name), False)
        for flags in ((CONTRACTED,), ())
    )
    differ: list[bool] = []

    def call(*arguments: Any) -> Any:
        found = contracted(*arguments)
        differ.append(not np.array_equal(found, strict(*arguments), equal_nan=True))
        return found

    subject = find_subject(name)
    assert subject.quantity.accuracy is not None
    found = find_worst(subject, call, rounds=0, seed=20262, share=0.2, most=5)
    assert found.scaled <= subject.quantity.accuracy.ulp
    processor = Path("/proc/cpuinfo")
    if processor.is_file() and "fma" in processor.read_text(encoding="utf-8"):
        assert any(differ)


@pytest.mark.slow
@pytest.mark.parametrize("name", first_of(sorted(KERNELS, key=lambda n: n not in FIRST), 3))
@pytest.mark.parametrize("single", [False, True])
def test_bounds_hold_without_a_fused_multiply_add(
    name: str, single: bool, libraries: Callable[..., ctypes.CDLL]
) -> None:
    """Products that have to be exact are split; others are rounded, and the bounds leave room."""
    system, _, _ = name.partition(".")
    subject = find_subject(name)
    subject = narrow(subject) if single else subject
    file = f"{system}_single" if single else system
    portable = libraries(system, single, PORTABLE)
    call = point_function(portable, file, find_kernel(name), single)
    kernel = Singles(find_kernel(name))
    drawn = draw_sets(subject, 20265, 0.05)
    points = join(*(tuple(c[choose_evenly(len(c), 10)] for c in part) for part in drawn))
    if single:
        points = round_singly(points)
        judged = mark_judged(subject, kernel, points)
        points = tuple(column[judged] for column in points)
    heights = scaled_errors(subject, call, points) / (WIDER if single else 1.0)
    assert subject.quantity.accuracy is not None
    assert 0 <= heights.max() <= subject.quantity.accuracy.ulp


@pytest.mark.slow
@pytest.mark.parametrize("name", grouped(KERNELS, 1))
def test_floats_keep_the_bounds_and_are_what_is_searched(
    name: str, libraries: Callable[..., ctypes.CDLL]
) -> None:
    """The bounds hold in eps of floats, and C has the bits of the programs that are searched."""
    system, subject, kernel = name.partition(".")[0], narrow(find_subject(name)), find_kernel(name)
    call = point_function(libraries(system, True), f"{system}_single", kernel, True)
    singles = Singles(kernel)
    drawn = draw_sets(subject, 20262, 0.05)
    few = join(*(tuple(c[choose_evenly(len(c), 20)] for c in part) for part in drawn))
    points = round_singly(few)
    judged = mark_judged(subject, singles, points)
    kept = tuple(column[judged] for column in points)
    assert len(kept[0]) > 10
    found = call(*kept)
    reduced = mark_accuracy_domain(subject, kept)
    assert_same_bits(found[reduced], singles(*kept).astype(float)[reduced])
    assert subject.quantity.accuracy is not None
    heights = scaled_errors(subject, lambda *_: found, kept) / WIDER
    assert heights.max() <= subject.quantity.accuracy.ulp


@pytest.mark.slow
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


@pytest.mark.slow
@pytest.mark.xdist_group("compiled track_wheel")
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
    size, real = ctypes.c_size_t, ctypes.c_double
    library = libraries("track_wheel", False)
    for name, rest in (("error_sum", (1.1,)), ("error_sum_correlated", (matrix, 1.1))):
        function = getattr(library, f"track_wheel_{name}_array")
        function.argtypes = [size, size, *[POINTER] * (len(rest) + 2), real, POINTER]
        function.restype = None
        out = np.empty(points)
        function(points, terms, tolerances, influences, scatters, *rest, out)
        compiled = getattr(track_wheel, name)(tolerances, influences, scatters, *rest)
        assert np.array_equal(out, compiled)
    cancelling = (np.full(terms, 0.1), np.array([1, 2, 3, -5, -1.0]), scatters / scatters)
    whole = (np.ones((terms, terms)), 1.1)
    function(1, terms, *cancelling, *whole, out)
    assert out[0] == track_wheel.error_sum_correlated(*cancelling, *whole)
    one = library.track_wheel_error_sum
    one.argtypes, one.restype = [size, *[POINTER] * 3, real], real
    assert one(0, tolerances, influences, scatters, 1.1) == 0.0
    assert np.isnan(one(terms, -tolerances, influences, scatters, 1.1))


def test_a_header_of_c_is_no_name() -> None:
    with pytest.raises(ValueError, match=r"^Math: C has a header math\.h; choose"):
        render_c(replace(declared_paper_of("elliptic_planetary"), system="Math"))


@pytest.mark.parametrize("single", [False, True])
def test_the_header_names_the_system_and_its_precision(single: bool) -> None:
    text = "\n".join(render("elliptic_planetary", single).values())
    precision = "single precision (float)" if single else "double precision (double)"
    assert f"Kernels of the system elliptic_planetary in C99, in {precision}.\n" in text
    assert "elliptic_planetary_single in" not in text


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "points", "parameters"),
    [
        ("elliptic_planetary.position", np.linspace(-9, 9, 50), (66.0, 16.0, 0.475)),
        ("track_wheel.displacement", np.ones((50, 3)), ([0.1, 0.2, 0.3], [1.0, 2.0, 3.0])),
    ],
)
def test_results_may_take_the_place_of_points(
    name: str, points: Any, parameters: tuple[Any, ...], libraries: Callable[..., ctypes.CDLL]
) -> None:
    system, _, quantity = name.partition(".")
    function = getattr(libraries(system, False), f"{system}_{quantity}_array")
    sizes = [np.array(p) if isinstance(p, list) else p for p in parameters]
    kinds = [POINTER if isinstance(s, np.ndarray) else ctypes.c_double for s in sizes]
    function.argtypes, function.restype = [ctypes.c_size_t, POINTER, *kinds, POINTER], None
    apart = np.empty_like(points)
    function(len(points), points, *sizes, apart)
    function(len(points), points, *sizes, points)
    assert np.array_equal(points, apart)


@pytest.mark.slow
def test_the_command_writes_what_a_program_includes(tmp_path: Path) -> None:
    runner = CliRunner()
    done = runner.invoke(app, ["emit", "c", "track_wheel", "--out", str(tmp_path)])
    assert done.exit_code == 0, done.output
    (tmp_path / "main.c").write_text(
        '#include <stdio.h>\n#include "track_wheel.h"\n'
        'int main(void) { printf("%.17g", track_wheel_radius(0.5, 66, 0.3, 3)); }\n'
    )
    assert COMPILER is not None
    command = [COMPILER, *STRICT, "main.c", "track_wheel.c", "-o", "main", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    printed = subprocess.run([str(tmp_path / "main")], capture_output=True, text=True, check=True)
    from mechproof.kernels import track_wheel

    wanted = track_wheel.radius(0.5, 66, 0.3, 3)
    assert float(printed.stdout) == pytest.approx(wanted, rel=6 * 2.0**-52)
    makefile = (tmp_path / "Makefile").read_text()
    flags = "-ffp-contract=off -fno-math-errno -fno-trapping-math"
    assert f"CFLAGS = -std=c99 -O3 -march=native {flags}\n" in makefile
    (tmp_path / "Makefile").write_text("all:\n")
    runner.invoke(app, ["emit", "c", "track_wheel", "--out", str(tmp_path)])
    assert (tmp_path / "Makefile").read_text() == "all:\n"
    assert runner.invoke(app, ["emit", "c", "conformity", "--out", str(tmp_path)]).exit_code == 1


@pytest.mark.slow
def test_derivatives_are_written_where_they_are_asked_for(tmp_path: Path) -> None:
    command = ["emit", "c", "--derivatives", "--out", str(tmp_path)]
    done = CliRunner().invoke(app, [*command, "track_wheel"])
    assert done.exit_code == 0, done.output
    name = "track_wheel_derivatives"
    assert sorted(f.name for f in tmp_path.iterdir()) == ["Makefile", f"{name}.c", f"{name}.h"]
    header = (tmp_path / f"{name}.h").read_text()
    assert " * Result: mm per unit of each argument, 4 numbers\n" in header
    assert "the derivation track_wheel by" in header
    files = {f"{name}.{end}": (tmp_path / f"{name}.{end}").read_text() for end in "hc"}
    function = compile_files(tmp_path, files, STRICT).track_wheel_derivatives_radius
    function.argtypes, function.restype = [*[ctypes.c_double] * 4, POINTER], None
    found = np.empty(4)
    function(0.5, 66.0, 0.3, 3.0, found)
    wanted = of_wheel.radius(0.5, 66.0, 0.3, 3.0)
    np.testing.assert_allclose(found, wanted, rtol=1e-14)
    done = CliRunner().invoke(app, [*command, "conformity"])
    assert (done.exit_code, "no kernel whose derivatives" in done.output) == (1, True)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["elliptic_planetary.position", "track_wheel.radius"])
@pytest.mark.parametrize("e", [0.3, 0.75])
def test_blocks_with_angles_far_out_have_the_bits_of_points(
    name: str, e: float, libraries: Callable[..., ctypes.CDLL]
) -> None:
    system, _, quantity = name.partition(".")
    sizes = (66.0, 16.0, e) if system == "elliptic_planetary" else (66.0, e, 3.0)
    points = np.linspace(-9, 9, 3 * BLOCK + 7)
    points[[BLOCK + 3, 2 * BLOCK - 1]] = 1e9, np.nan
    points[-1] = np.inf
    library, real = libraries(system, False), ctypes.c_double
    function = getattr(library, f"{name.replace('.', '_')}_array")
    function.argtypes = [ctypes.c_size_t, POINTER, *[real] * 3, POINTER]
    function.restype = None
    found = np.empty_like(points)
    function(points.size, points, *sizes, found)
    each = point_function(library, system, find_kernel(name), False)(points, *sizes)
    compiled = getattr(import_module(f"mechproof.kernels.compiled.{system}"), quantity)
    assert_same_bits(found, each)
    assert_same_bits(found, compiled(points, *sizes))
    assert np.isnan(found[[2 * BLOCK - 1, -1]]).all()
    assert np.isfinite(found[BLOCK + 3])
