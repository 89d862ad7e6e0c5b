"""Compiled kernels: the bounds, shapes, NaN, errors and threads of the NumPy kernels."""

from __future__ import annotations

import math
import re
from importlib import import_module
from typing import Any

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from compiled import PHI, SIZES, grouped
from quantities import KERNELS, find_subject
from weights import first_of

from mechproof.compiled_support import loops
from mechproof.kernels import elliptic_planetary as plain
from mechproof.kernels.compiled import elementary, elliptic_planetary, oval_planetary, track_wheel
from mechproof.lab.subject import Subject
from mechproof.lab.worst_search import find_worst

FIELDS = ("names", "at", "rows", "widths", "shape")
EPS = float(np.finfo(float).eps)


def compiled(subject: Subject) -> Any:
    system, _, name = subject.name.partition(".")
    return getattr(import_module(f"mechproof.kernels.compiled.{system}"), name)


def search(name: str, rounds: int, off: float = 0.0) -> tuple[float, float]:
    """Return the worst error found for a kernel times 1 + `off`, and the kernel's bound."""
    subject = find_subject(name)
    compute = compiled(subject)

    def faulty(*arguments: Any) -> Any:
        return compute(*arguments) * (1 + off)

    found = find_worst(subject, faulty, rounds=rounds, seed=20261, share=0.1, most=40)
    assert subject.quantity.accuracy is not None
    assert found.tried > 20
    return found.scaled, subject.quantity.accuracy.ulp


@pytest.mark.parametrize("rounds", first_of([0, 2]))
@pytest.mark.parametrize("name", grouped(KERNELS, 1))
def test_the_bound_of_the_kernel_holds(name: str, rounds: int) -> None:
    """The same points and bounds as the NumPy kernel's; a search with a fixed seed."""
    found, bound = search(name, rounds)
    assert found <= bound


@pytest.mark.slow
def test_a_kernel_that_is_off_by_more_than_its_bound_is_seen() -> None:
    found, bound = search("elliptic_planetary.ratio", 0, 2.0**-48)
    assert found > bound


@pytest.mark.slow
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


def test_nan_beside_infinity_is_nan() -> None:
    from mechproof.kernels import track_wheel as plain_wheel

    points = [[np.inf, np.nan, 0.0], [np.nan, -np.inf, 0.0], [-np.inf, 2.0, 0.0], [3.0, -4.0, 0.0]]
    expected = [np.nan, np.nan, np.inf, 5.0]
    for module in (plain_wheel, track_wheel):
        for function in (module.planar_error, module.spatial_error):
            np.testing.assert_equal(function(np.array(points)), expected)
            np.testing.assert_equal([function(point) for point in points], expected)
    np.testing.assert_equal(plain_wheel.spatial_error([np.inf, 0.0, np.nan]), np.nan)


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


def test_nan_where_the_domain_ends_and_large_angles_take_the_exact_way() -> None:
    phi = np.array([1.0, np.nan, np.inf, 1e9, -3e15, 2.0])
    with np.errstate(invalid="ignore"):
        wanted = plain.ratio(phi, *SIZES)
    found = elliptic_planetary.ratio(phi, *SIZES)
    np.testing.assert_allclose(found, wanted, rtol=1e-9)
    assert np.isnan(elliptic_planetary.position(PHI, 66.0, 16.0, 1.0)).all()
    assert np.isnan(elliptic_planetary.position(1.0, 66.0, 70.0, 0.1))
    assert np.isnan(elliptic_planetary.position(PHI[:2, None], 66.0, 16.0, [0.1, 2.0])[:, 1]).all()


@pytest.mark.parametrize("kernels", [elliptic_planetary, plain])
def test_out_of_another_kind_is_filled_and_nothing_beside_it(kernels: Any) -> None:
    phi = PHI[:8].reshape(2, 4)
    memory = np.zeros((50, 4))
    for out in (
        memory[:2].view(np.matrix),
        np.ma.masked_array(np.empty((2, 4)), mask=np.eye(2, 4)),
        np.zeros((2, 4)).view(type("Own", (np.ndarray,), {})),
    ):
        for sizes in (SIZES, (66.0, 16.0, np.full((2, 1), 0.3)), (*SIZES[:2], np.full(4, 0.3))):
            assert kernels.position(phi, *sizes, out=out) is out
            assert np.array_equal(out, kernels.position(phi, *sizes))
            assert not np.ma.getmaskarray(out).any()
    assert not memory[2:].any()


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


@pytest.mark.slow
def test_arrays_of_float32_are_computed_in_doubles() -> None:
    sizes = (np.linspace(0, 100, 500), *(np.full(500, size) for size in (41.5, 3.75, 7)))
    single = tuple(np.float32(size) for size in sizes)
    found = track_wheel.radius(*single)
    wanted = track_wheel.radius(*(size.astype(float) for size in single))
    assert np.array_equal(found, np.float32(wanted))


@pytest.mark.slow
def test_dead_centres_are_reached_as_in_numpy() -> None:
    """Where both products of a radicand are equal, their difference must vanish."""
    from mechproof.kernels import wedge_linkage as plain_linkage
    from mechproof.kernels.compiled import wedge_linkage

    rod = np.arange(1, 1000) / 10
    for arguments in ((-rod, rod / 2, rod, rod / 2), (-0.7, 0.35, 0.7, 0.35)):
        assert np.all(wedge_linkage.guide_radicand(*arguments) == 0)
        wanted = plain_linkage.lever_angle(*arguments)
        assert np.array_equal(wedge_linkage.lever_angle(*arguments), wanted)
    end = -8.999999999999998, 9.0, np.pi / 2
    assert wedge_linkage.roller_lever_angle(*end) == plain_linkage.roller_lever_angle(*end)


def unaligned(values: Any) -> Any:
    found = np.empty(8 * len(values) + 1, np.uint8)[1:].view(float)
    found[:] = values
    return found


@pytest.mark.parametrize("first", [0, 1, 2, 3])
def test_rows_of_every_kind_are_entered_alike(first: int) -> None:
    """Whatever kind comes first, a compiled loop is entered without checking types."""
    row, held = np.linspace(-3, 3, 12), np.linspace(-3, 3, 12)
    held.flags.writeable = False
    kinds = [row, held, unaligned(row), np.repeat(row, 2)[::2]]
    kinds = kinds[first:] + kinds[:first]
    made = loops.Loops(**{n: getattr(elliptic_planetary._loops_of_position, n) for n in FIELDS})
    wanted = plain.position(row, *SIZES)
    for given in kinds:
        found = loops.run(made, (given, *SIZES), None)
        np.testing.assert_allclose(found, wanted, rtol=0, atol=20 * EPS)
        for out in (np.empty(12), unaligned(row)):
            assert loops.run(made, (given, *SIZES), out) is out
            assert np.array_equal(out, found)
    assert np.array_equal(row, held)
    compiled = elliptic_planetary._fill_of_position.overloads
    assert made.fill in [kept.entry_point for kept in compiled.values()]
    assert all(kind.layout == "C" and kind.mutable and kind.aligned for _, kind, *_ in compiled)
    numbers = [loops.run(made, (x, *SIZES), None) for x in row.tolist()]
    assert np.array_equal(numbers, found)
    with pytest.raises(TypeError):
        made.fill(None, row, *SIZES)


def test_threads_change_no_bit(monkeypatch: pytest.MonkeyPatch) -> None:
    phi = np.linspace(-1e3, 1e3, 10_001)
    alone = elliptic_planetary.position(phi, *SIZES)
    monkeypatch.setattr(loops, "THREADED", 100)
    monkeypatch.setattr(loops, "count_processors", lambda: 3)
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


@pytest.mark.slow
def test_arrays_are_taken_inside_compiled_functions() -> None:
    import numba

    @numba.njit
    def travel(phi: np.ndarray, radius: np.ndarray) -> np.ndarray:
        position = elliptic_planetary.position(phi, radius, 16.0, e=0.475)
        return position + oval_planetary.position(phi1=phi, e2=0.3, e1=0.2)

    phi, radius = np.linspace(-30, 1e6, 24).reshape(4, 1, 6), np.array([[66.0], [70.0]])
    wanted = elliptic_planetary.position(phi, radius, 16, 0.475)
    found = travel(phi, radius)
    assert np.array_equal(found, wanted + oval_planetary.position(phi, 0.2, 0.3))
    # Whole numbers and single precision give doubles.
    assert np.array_equal(travel(np.arange(3), radius[0])[1:2], travel(np.array([1.0]), radius[0]))
    with pytest.raises(numba.TypingError, match="No implementation of function"):
        numba.njit(lambda points: track_wheel.planar_error(points, points))(phi)


def test_parameters_are_numbers_of_any_kind() -> None:
    """Each kind takes its own path but gives the bits of Python's floats."""
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


def test_loops_over_points_ask_for_the_widest_vectors() -> None:
    """The attributes are on the loop itself, which is never inlined into another function."""
    import numba

    filled = numba.njit(error_model="numpy")(elliptic_planetary._fill_of_ratio.py_func)
    filled(np.empty(3), np.ones(3), *SIZES)
    (text,) = filled.inspect_llvm().values()
    loops_of_points = re.findall(r"(?m)^define .*_fill_part.* (#\d+) \{$", text)
    assert len(loops_of_points) == 2
    for number in loops_of_points:
        (asked,) = re.findall(rf"(?m)^attributes {number} = (.*)$", text)
        assert '"prefer-vector-width"="512"' in asked
        assert "noinline" in asked


def test_what_is_compiled_for_compiled_functions_is_called_from_python_too() -> None:
    import numba

    inside = numba.njit(lambda x: elementary.cos(x, True))
    found = (elementary.cos(0.5, True), inside(0.5), elementary.cos(0.5, True))
    assert set(found) == {math.cos(0.5)}


@pytest.mark.parametrize("dtype", [float, np.float32, np.int64])
def test_labels_are_kept_as_by_the_kernels_of_numpy(dtype: Any) -> None:
    series = pd.Series(np.arange(4).astype(dtype), index=[*"abcd"], name="phi1")
    array = xr.DataArray(np.arange(6.0).reshape(2, 3), dims=("t", "u"), coords={"t": [3, 4]})
    for given in (series, pd.Index([1.0, np.nan]), array):
        ours = elliptic_planetary.position(given, 66, 16, 0.475)
        numpys = plain.position(given, 66, 16, 0.475)
        assert type(ours) is type(numpys) is type(given)
        assert ours.dtype == numpys.dtype
        values = elliptic_planetary.position(given.to_numpy(), 66, 16, 0.475)
        assert np.array_equal(ours.to_numpy(), values, equal_nan=True)
    assert elliptic_planetary.position(series, 66, 16, 0.475).index.equals(series.index)
    assert elliptic_planetary.position(array, 66, 16, 0.475).coords.equals(array.coords)
    # Labels of a parameter are kept as well.
    found = elliptic_planetary.largest_ratio(66, 16, array / 10)
    assert found.dims == ("t", "u")


def test_what_would_have_to_be_aligned_is_refused() -> None:
    series = pd.Series([1.0, 2.0])
    for given in ((series, series), (series, np.array([0.1, 0.2]))):
        with pytest.raises(TypeError, match=r"^phi1: compiled kernels take"):
            elliptic_planetary.position(given[0], 66, 16, given[1])
