"""Compiled kernels: the bounds, shapes, NaN, errors and threads of the NumPy kernels."""

from __future__ import annotations

from dataclasses import replace
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from compiled import grouped
from derived import SYSTEMS, paper_of

from mechproof.codegen.backends.numba import render_compiled
from mechproof.compiled_support import loops
from mechproof.kernels import elliptic_planetary as plain
from mechproof.kernels.compiled import elliptic_planetary, oval_planetary, track_wheel
from mechproof.lab.search import find_worst
from mechproof.lab.subject import Subject, find_subjects
from mechproof.record import Together

SUBJECTS = {s.name: s for s in find_subjects(()) if s.quantity.forms}
BOUNDED = [name for name, s in SUBJECTS.items() if s.quantity.accuracy is not None]
EPS = float(np.finfo(float).eps)


def compiled(subject: Subject) -> Any:
    system, _, name = subject.name.partition(".")
    return getattr(import_module(f"mechproof.kernels.compiled.{system}"), name)


@pytest.mark.parametrize("name", grouped(BOUNDED))
def test_the_bound_of_the_kernel_holds(name: str) -> None:
    """The same points and bounds as the NumPy kernel's; a search with a fixed seed."""
    subject = SUBJECTS[name]
    assert subject.quantity.accuracy is not None
    found = find_worst(subject, compiled(subject), rounds=2, seed=20261, share=0.1, most=40)
    assert found.tried > 20
    assert found.scaled <= subject.quantity.accuracy.ulp


PHI = np.linspace(-40, 40, 4000)
SIZES = (66.0, 16.0, 0.475)


def test_shapes_broadcast_as_in_numpy() -> None:
    e = np.array([0.1, 0.475, 0.7])
    for phi, sizes in (
        (PHI[:7, None], (66.0, 16.0, e)),
        (PHI[:40], (66.0, 16.0, e[:, None])),
        (PHI[:8].reshape(2, 4), (np.full((2, 1), 66.0), 16, 0.3)),
        (1.0, (66.0, 16.0, e)),
        (1, (66, 16, 0)),
        (PHI[:0], SIZES),
        (PHI[::3], SIZES),
        (np.float32(PHI[:9]), SIZES),
        (PHI[:9].astype(int), SIZES),
    ):
        wanted, found = plain.position(phi, *sizes), elliptic_planetary.position(phi, *sizes)
        assert (np.shape(found), found.dtype) == (np.shape(wanted), wanted.dtype)
        np.testing.assert_allclose(found, wanted, rtol=6 * np.finfo(wanted.dtype).eps)


def test_results_with_components() -> None:
    from mechproof.kernels import track_wheel as plain_wheel

    points = np.arange(30.0).reshape(2, 5, 3)
    angles, shift = np.array([1e-3, -2e-3, 3e-3]), np.array([0.1, 0.2, 0.3])
    for arguments in (
        (points, angles, shift),
        (points[:, ::2], angles, shift),
        (points, np.outer([1, 2, 3, 4, 5], angles), shift),
        (points[0, 0], angles, shift),
    ):
        wanted = plain_wheel.displacement(*arguments)
        found = track_wheel.displacement(*arguments)
        assert found.shape == wanted.shape
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-14)
    alpha = np.linspace(-1, 1, 50)
    wanted = plain_wheel.rotation(alpha, 0.2, 0.3)
    np.testing.assert_allclose(track_wheel.rotation(alpha, 0.2, 0.3), wanted, rtol=0, atol=1e-15)
    assert track_wheel.rotation(0.1, 0.2, 0.3).shape == (3, 3)


SEVEN = np.random.default_rng(20265).uniform(0.5, 2, (3, 4, 7))
MATRIX = np.where(np.eye(7), 1, 0.25)


@pytest.mark.parametrize(
    ("name", "arguments"),
    [
        ("error_sum", (SEVEN, 1.0, [1.5], 1.1)),
        ("error_sum", (SEVEN[:, ::2], SEVEN[0, 0], np.full((3, 1, 1), 2.0), SEVEN[:, :2, 0])),
        ("error_sum", (np.asfortranarray(SEVEN), 1, 2, 3)),
        ("error_sum", (np.float32(SEVEN), np.float32(2), 1.0, 1.0)),
        ("error_sum", (0.5, 1.0, 2.0, SEVEN[..., 0])),
        ("error_sum", (SEVEN[..., :0], 1.0, 1.0, 1.0)),
        ("error_sum", (SEVEN[:0], 1.0, 1.0, 1.0)),
        ("error_sum", (SEVEN[0, 0], [1.0, -1, 2, -2, 3, -3, 0], 1.0, [1.0, np.nan, -1.0])),
        ("error_sum", (np.ones((2, 40_000)), 1.0, 1.0, 1.0)),
        ("error_sum", (1e200, 1.0, 1.0, 1.0)),
        ("error_sum_correlated", (SEVEN, 1.0, SEVEN[1, 0], MATRIX, 1.1)),
        ("error_sum_correlated", (SEVEN, 1.0, 1.0, np.stack([MATRIX, 2 * MATRIX] * 2), 1.1)),
        ("error_sum_correlated", (np.float32(SEVEN[0]), 1, 1, np.float32(MATRIX), 1)),
        ("error_sum_correlated", (0.5, 1.0, 1.0, [[1.0]], 1.0)),
        ("error_sum_thermal", (SEVEN, 1.0, 1.1, 1.2, [[0.15], [0.3], [2.0]], 1.3)),
    ],
)
def test_sums_broadcast_as_in_numpy(name: str, arguments: tuple[Any, ...]) -> None:
    from mechproof.kernels import track_wheel as plain_wheel

    with np.errstate(over="ignore"):
        wanted = getattr(plain_wheel, name)(*arguments)
    found = getattr(track_wheel, name)(*arguments)
    assert (np.shape(found), found.dtype, type(found)) == (
        np.shape(wanted),
        wanted.dtype,
        type(wanted),
    )
    # Terms of one sign: both are within 9 eps, of float32 where NumPy adds in it.
    np.testing.assert_allclose(found, wanted, rtol=18 * np.finfo(wanted.dtype).eps)


def test_sums_are_stored_in_out() -> None:
    from mechproof.kernels import track_wheel as plain_wheel

    wanted = track_wheel.error_sum(SEVEN, 1.0, 1.0, 1.1)
    source = SEVEN.copy()
    for out in (np.empty((3, 4)), np.empty((4, 3)).T, source[..., 0]):
        assert track_wheel.error_sum(source, 1.0, 1.0, 1.1, out=out) is out
        assert np.array_equal(out, wanted)
    for bad in (np.empty(3), np.empty((3, 4), np.float32)):
        with pytest.raises((TypeError, ValueError)) as plain:
            plain_wheel.error_sum(SEVEN, 1.0, 1.0, 1.1, out=bad)
        with pytest.raises(type(plain.value), match="out: expected") as compiled:
            track_wheel.error_sum(SEVEN, 1.0, 1.0, 1.1, out=bad)
        assert str(compiled.value) == str(plain.value)


def test_long_sums_lose_nothing() -> None:
    """One large term and a million that each round to nothing beside it."""
    tolerances = np.full(2**20 + 1, 2.0**-30)
    tolerances[0] = 2.0**-3
    exact = np.sqrt(2.0**-6 + 2.0**-40)
    # The sum once rounded and the root: 1/4 and 1/2, in eps.
    assert abs(track_wheel.error_sum(tolerances, 1.0, 1.0, 1.0) - exact) <= EPS * exact


def test_sums_are_called_inside_compiled_functions() -> None:
    import numba

    @numba.njit
    def call(tolerances: Any, influences: Any, scatters: Any, matrix: Any) -> Any:
        return (
            track_wheel.error_sum(tolerances, influences, scatters, 1.1),
            track_wheel.error_sum_thermal(tolerances, influences, scatters, 1, 0.1, 1.5),
            track_wheel.error_sum_correlated(tolerances, influences, scatters, matrix, 1.1),
        )

    def call_outside(*arguments: Any) -> Any:
        *rows, matrix = arguments
        return (
            track_wheel.error_sum(*rows, 1.1),
            track_wheel.error_sum_thermal(*rows, 1, 0.1, 1.5),
            track_wheel.error_sum_correlated(*rows, matrix, 1.1),
        )

    row = SEVEN[0, 0]
    for arguments in (
        (row, row, row, MATRIX),
        (row, 1.5, 2, MATRIX),
        (SEVEN[0, :, 0].repeat(2)[:7], np.array([1.5]), row[::-1], MATRIX),
    ):
        assert call(*arguments) == call_outside(*arguments)
    for wrong, message in (
        ((row, row[:3], 1.0, MATRIX), r"^sensitivities: last axis .*\(7,\), got shape \(3,\)$"),
        ((row, 1.0, 1.0, MATRIX[:3]), r"^correlation: last 2 axes .*\(7, 7\), got shape \(3, 7\)$"),
    ):
        with pytest.raises(ValueError, match=message):
            call(*wrong)
    with pytest.raises(numba.TypingError, match="takes an array of 1 axes"):
        call(SEVEN[0], 1.0, 1.0, MATRIX)


def test_out_takes_the_result_and_may_overlap() -> None:
    wanted = elliptic_planetary.position(PHI, *SIZES)
    out = np.empty_like(PHI)
    assert elliptic_planetary.position(PHI, *SIZES, out=out) is out
    assert np.array_equal(out, wanted)
    for target in (PHI.copy(), np.empty(2 * PHI.size)[::2]):
        source = target if target.flags.c_contiguous else PHI
        assert elliptic_planetary.position(source, *SIZES, out=target) is target
        assert np.array_equal(target, wanted)
    with pytest.raises(ValueError, match="out: expected shape"):
        elliptic_planetary.position(PHI, *SIZES, out=np.empty(3))
    with pytest.raises(TypeError, match="out: expected float64"):
        elliptic_planetary.position(PHI, *SIZES, out=np.empty(PHI.size, np.float32))


TOGETHER = {
    "elliptic_planetary.motion": ("position", "ratio", "acceleration"),
    "oval_planetary.motion": ("position", "ratio", "acceleration"),
    "oval_planetary.motion_cylindrical": tuple(
        f"{name}_cylindrical" for name in ("position", "ratio", "acceleration")
    ),
}
OF_SYSTEM = {
    "elliptic_planetary": [(66.0, 16.0, 0.475), (66.0, 16.0, np.array([[0.1], [0.9]])), (1, 2, 3)],
    "oval_planetary": [(0.2, 0.3), (0.2, np.array([[0.1], [0.3]])), (2.0, 0.1)],
}
CYLINDRICAL = [(20.0, 40.0, 0.2), (20.0, 40.0, np.array([[0.1], [0.9]])), (20.0, 40.0, 3.0)]


def test_all_that_is_computed_in_one_pass_is_tested_here() -> None:
    found = {
        f"{system}.{t.name}": t.quantities for system in SYSTEMS for t in paper_of(system).together
    }
    assert found == TOGETHER


@pytest.mark.parametrize("name", grouped(TOGETHER))
def test_one_pass_gives_the_bits_of_each_kernel(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    system, _, function = name.partition(".")
    module = import_module(f"mechproof.kernels.compiled.{system}")
    together = getattr(module, function)
    kernels = [getattr(module, name) for name in TOGETHER[name]]
    points = np.concatenate([PHI, [0.0, np.nan, np.inf, 1e9, 1e-300]])
    for number in (1, 100):
        # With and without threads.
        monkeypatch.setattr(loops, "THREADED", loops.THREADED // number**2)
        for sizes in CYLINDRICAL if name.endswith("cylindrical") else OF_SYSTEM[system]:
            for phi in (points, points[::3], np.float32(PHI[:9]), 0.3):
                wanted = np.array([kernel(phi, *sizes) for kernel in kernels])
                found = together(phi, *sizes)
                assert found.dtype == wanted.dtype
                assert np.array_equal(found, wanted, equal_nan=True)
                out = np.empty_like(wanted)
                assert together(phi, *sizes, out=out) is out
                assert np.array_equal(out, wanted, equal_nan=True)


def test_one_pass_inside_compiled_functions_and_its_errors() -> None:
    import numba

    @numba.njit
    def call(phi: float) -> Any:
        position, ratio, acceleration = elliptic_planetary.motion(phi, 66, 16, 0.475)
        return position + 10 * ratio + 100 * acceleration

    position, ratio, acceleration = elliptic_planetary.motion(0.3, *SIZES)
    assert call(0.3) == position + 10 * ratio + 100 * acceleration
    with pytest.raises(ValueError, match=r"out: expected shape \(3, 4000\)"):
        elliptic_planetary.motion(PHI, *SIZES, out=np.empty((4000, 3)))
    with pytest.raises(TypeError, match="R1: expected real numbers"):
        elliptic_planetary.motion(PHI, "x", 16.0, 0.5)


@pytest.mark.parametrize(
    ("system", "names", "message"),
    [
        ("elliptic_planetary", ("position", "speed"), r"no quantities with forms: \['speed'\]"),
        ("elliptic_planetary", ("position", "largest_ratio"), "quantities of different arguments"),
        ("track_wheel", ("rotation", "rotation"), r"\['rotation', 'rotation'\] are not computed"),
    ],
)
def test_what_has_no_pass_in_common_is_refused(
    system: str, names: tuple[str, ...], message: str
) -> None:
    with pytest.raises((ValueError, NotImplementedError), match=message):
        render_compiled(replace(paper_of(system), together=(Together("all", names),)))
    with pytest.raises(ValueError, match=r"quantities given twice: \['rotation'\]"):
        replace(paper_of("track_wheel"), together=(Together("rotation", ("rotation",)),))


def test_nan_where_the_domain_ends_and_large_angles_take_the_exact_way() -> None:
    phi = np.array([1.0, np.nan, np.inf, 1e9, -3e15, 2.0])
    with np.errstate(invalid="ignore"):
        wanted = plain.ratio(phi, *SIZES)
    found = elliptic_planetary.ratio(phi, *SIZES)
    np.testing.assert_allclose(found, wanted, rtol=1e-9)
    assert np.isnan(elliptic_planetary.position(PHI, 66.0, 16.0, 1.0)).all()
    assert np.isnan(elliptic_planetary.position(1.0, 66.0, 70.0, 0.1))
    assert np.isnan(elliptic_planetary.position(PHI[:2, None], 66.0, 16.0, [0.1, 2.0])[:, 1]).all()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((1j, 66.0, 16.0, 0.1), "phi1: expected real numbers"),
        ((1.0, "x", 16.0, 0.1), "R1: expected real numbers"),
        ((np.ma.masked_array([1.0]), 66.0, 16.0, 0.1), "phi1: compiled kernels take"),
    ],
)
def test_what_is_no_number_is_refused(arguments: tuple[Any, ...], message: str) -> None:
    with pytest.raises(TypeError, match=message):
        elliptic_planetary.position(*arguments)


def test_dead_centres_are_reached_as_in_numpy() -> None:
    """Where both products of a radicand are equal, their difference has to vanish."""
    from mechproof.kernels import wedge_linkage as plain_linkage
    from mechproof.kernels.compiled import wedge_linkage

    rod = np.arange(1, 1000) / 10
    for arguments in ((-rod, rod / 2, rod, rod / 2), (-0.7, 0.35, 0.7, 0.35)):
        assert np.all(wedge_linkage.guide_radicand(*arguments) == 0)
        wanted = plain_linkage.lever_angle(*arguments)
        assert np.array_equal(wedge_linkage.lever_angle(*arguments), wanted)
    end = -8.999999999999998, 9.0, np.pi / 2
    assert wedge_linkage.roller_lever_angle(*end) == plain_linkage.roller_lever_angle(*end)


def test_threads_change_no_bit(monkeypatch: pytest.MonkeyPatch) -> None:
    phi = np.linspace(-1e3, 1e3, 10_001)
    alone = elliptic_planetary.position(phi, *SIZES)
    monkeypatch.setattr(loops, "THREADED", 100)
    monkeypatch.setattr(loops, "_count_processors", lambda: 3)
    assert np.array_equal(elliptic_planetary.position(phi, *SIZES), alone)


def test_four_threads_may_call_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    from concurrent.futures import ThreadPoolExecutor

    monkeypatch.setattr(loops, "THREADED", 1000)
    phi = np.linspace(-10, 10, 20_000)
    wanted = elliptic_planetary.acceleration(phi, *SIZES)
    with ThreadPoolExecutor(4) as pool:
        found = pool.map(lambda _: elliptic_planetary.acceleration(phi, *SIZES), range(24))
        assert all(np.array_equal(f, wanted) for f in found)


def test_kernels_are_called_inside_compiled_functions() -> None:
    import numba

    @numba.njit
    def travel(count: int) -> float:
        total = 0.0
        for i in range(count):
            total += elliptic_planetary.position(0.01 * i, 66, 16, 0.475)
            total += oval_planetary.position(0.01 * i, 0.2, 0.3)
            total += track_wheel.rotation(0.01, 0.02, 0.03)[1]
        return total

    wanted = sum(
        elliptic_planetary.position(0.01 * i, *SIZES)
        + oval_planetary.position(0.01 * i, 0.2, 0.3)
        + track_wheel.rotation(0.01, 0.02, 0.03)[0, 1]
        for i in range(10)
    )
    assert travel(10) == pytest.approx(wanted, rel=40 * EPS)


def test_parameters_are_numbers_of_any_kind() -> None:
    """Each kind gives the bits of Python's floats, by a way of its own."""
    wanted = elliptic_planetary.position(PHI, 66.0, 16.0, 0.5)
    for kind in (np.float64, np.array, lambda size: np.array([size]), np.float32, np.int64):
        sizes = (*map(kind, (66, 16)), 0.5)
        assert np.array_equal(elliptic_planetary.position(PHI, *sizes), wanted)
        out = np.empty_like(PHI)
        assert elliptic_planetary.position(PHI[::2], *sizes, out=out[::2]).base is out
        assert np.array_equal(out[::2], wanted[::2])
    assert np.array_equal(elliptic_planetary.position(PHI, 66, 16, 0.5), wanted)
    with pytest.raises(TypeError, match="R1: expected real numbers"):
        elliptic_planetary.position(PHI, 2**70, 16, 0.5)
