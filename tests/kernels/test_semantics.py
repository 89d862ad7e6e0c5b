"""How kernels treat types, shapes, NaN, their domain and bad arguments."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from functools import cache
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from compiled import grouped, is_shown
from quantities import KERNELS, find_subject
from units import list_with_units
from weights import first_of, make_thorough

from mechproof.kernel_support import arrays
from mechproof.kernels import elliptic_planetary, track_wheel
from mechproof.kernels.forms.elliptic_planetary import position_principal
from mechproof.lab.sampling.point_sets import list_workloads
from mechproof.lab.subject import Subject

OF_ANGLES = ("ratio", "position", "acceleration")
POINT, ANGLES, SHIFT = [1.0, 2.0, 3.0], [0.1, -0.2, 0.3], [0.01, 0.02, 0.03]
SUM = ([0.016, 0.05], [1.0, -1.0], [1.0, 1.2], 1.1)
COUNT = 7
COMPILED = "compiled."
for_each_kernel = pytest.mark.parametrize(
    "name", [*KERNELS, *grouped(f"{COMPILED}{name}" for name in KERNELS)]
)


def subject_of(name: str) -> Subject:
    return find_subject(name.removeprefix(COMPILED))


def usual_call(name: str) -> tuple[Any, ...]:
    return take_point(name.removeprefix(COMPILED))


@cache
def take_point(name: str) -> tuple[Any, ...]:
    """Return a point of the first workload where the kernel has a value, as Python numbers."""
    subject = subject_of(name)
    _, workload = list_workloads(subject)[0]
    arguments = workload(COUNT)
    for number in range(1, COUNT):
        point = tuple(a[number] if np.shape(a)[:1] == (COUNT,) else a for a in arguments)
        if np.isfinite(subject.kernel(*point)).all():
            return tuple(np.asarray(a).tolist() for a in point)
    raise AssertionError(f"{name}: no point with a value")


@pytest.fixture(autouse=True)
def _warnings_are_errors() -> Iterator[None]:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


def call(name: str, arguments: tuple[Any, ...], **options: Any) -> Any:
    module, _, short = name.rpartition(".")
    return getattr(import_module(f"mechproof.kernels.{module}"), short)(*arguments, **options)


def shape_of(name: str) -> tuple[int, ...]:
    """Return the shape of the result at one point; a column has one axis."""
    rows, *columns = getattr(subject_of(name).quantity.definition, "shape", ()) or (None,)
    return () if rows is None else (rows,) if columns == [1] else (rows, *columns)


@pytest.mark.slow
@for_each_kernel
def test_scalars_and_types(name: str) -> None:
    arguments, shape = usual_call(name), shape_of(name)
    result = call(name, arguments)
    assert np.shape(result) == shape
    assert result.dtype == np.float64
    assert isinstance(result, np.float64 if shape == () else np.ndarray)
    rounded = tuple(np.asarray(a, np.float32) for a in arguments)
    single, double = call(name, rounded), call(name, tuple(np.asarray(a, float) for a in rounded))
    assert single.dtype == np.float32
    # float32 has 24 bits; the kernels compute in doubles and round at the end.
    assert np.allclose(single, double, rtol=2**-23, atol=0, equal_nan=True)
    mixed = (np.asarray(arguments[0], np.float32), *arguments[1:])
    strong = any(isinstance(a, list) for a in arguments[1:])
    assert call(name, mixed).dtype == (np.float64 if strong else np.float32)


@pytest.mark.slow
@for_each_kernel
def test_broadcasting_equals_separate_calls(name: str) -> None:
    arguments, shape = usual_call(name), shape_of(name)
    first = np.stack([np.asarray(arguments[0]), 0.5 * np.asarray(arguments[0])])
    together = call(name, (first, *arguments[1:]))
    assert together.shape == (2, *shape)
    for row, value in zip(together, first, strict=True):
        np.testing.assert_array_max_ulp(row, np.asarray(call(name, (value, *arguments[1:]))), 4)
    if len(arguments) > 1:
        last = np.stack([np.asarray(arguments[-1])] * 3)[:, None]
        assert call(name, (first, *arguments[1:-1], last)).shape == (3, 2, *shape)


@pytest.mark.slow
@for_each_kernel
def test_nan_in_gives_nan_out(name: str) -> None:
    arguments = usual_call(name)
    for i, argument in enumerate(arguments):
        poisoned = np.full_like(np.asarray(argument, float), np.nan)
        result = call(name, (*arguments[:i], poisoned, *arguments[i + 1 :]))
        assert np.isnan(result).any()


@pytest.mark.slow
@for_each_kernel
def test_out_without_axes_is_returned(name: str) -> None:
    found = call(name, usual_call(name))
    out = np.empty(np.shape(found))
    assert call(name, usual_call(name), out=out) is out
    assert np.array_equal(out, found, equal_nan=True)


@for_each_kernel
def test_a_masked_number_is_nan(name: str) -> None:
    arguments = usual_call(name)
    for i, argument in enumerate(arguments):
        if np.shape(argument) == ():
            found = call(name, (*arguments[:i], np.ma.masked, *arguments[i + 1 :]))
            assert np.isnan(found).any()


@for_each_kernel
def test_shapes_that_do_not_broadcast_are_named(name: str) -> None:
    first, *others = usual_call(name)
    for i, argument in enumerate(others):
        wrong = [np.stack([np.asarray(a)] * n) for a, n in ((first, 3), (argument, 2))]
        named = subject_of(name).quantity.arguments[i + 1].name
        with pytest.raises(ValueError, match=rf"^{named}: .*must broadcast with \(3,\)"):
            call(name, (wrong[0], *others[:i], wrong[1], *others[i + 1 :]))


@for_each_kernel
def test_bad_types_are_named(name: str) -> None:
    arguments = usual_call(name)
    for bad in (1j, "1", None, np.longdouble(1)):
        with pytest.raises(TypeError, match="expected real numbers"):
            call(name, (*arguments[:-1], bad))


@for_each_kernel
def test_units_are_refused_by_name(name: str) -> None:
    arguments = usual_call(name)
    for i, argument in enumerate(arguments):
        named = subject_of(name).quantity.arguments[i].name
        for given in list_with_units(argument):
            with pytest.raises(TypeError, match=rf"^{named} = .*: carries a unit; give plain"):
                call(name, (*arguments[:i], given, *arguments[i + 1 :]))


NAN = float("nan")
OUTSIDE = [
    *(("elliptic_planetary", n, bad) for n in OF_ANGLES for bad in (
        (0.3, 66.0, 16.0, 1.0), (0.3, 66.0, 16.0, -0.1), (0.3, 16.0, 16.0, 0.1),
        (0.3, 16.0, 66.0, 0.1), (0.3, -1.0, -2.0, 0.1), (0.3, 66.0, 0.0, 0.1),
        (0.3, np.inf, 16.0, 0.1), (0.3, 66.0, 16.0, NAN),
    )),
    *(("elliptic_planetary", n, bad) for n in ("largest_ratio", "smallest_ratio") for bad in (
        (66.0, 16.0, 1.0), (66.0, 16.0, -0.1), (66.0, 0.0, 0.1), (66.0, 16.0, NAN),
        (16.0, 66.0, 0.1), (-66.0, 16.0, 0.1), (np.inf, 16.0, 0.1),
    )),
    *(("track_wheel", "radius", (0.3, *bad)) for bad in (
        (3.0, 3.1, 6), (3.0, -3.1, 6), (-3.0, 1.0, 6), (0.0, 0.0, 6), (3.0, 1.0, 0),
        (3.0, 1.0, 2.5), (np.inf, 1.0, 6), (3.0, 1.0, np.inf), (3.0, -np.inf, 6),
    )),
    *(("track_wheel", n, bad) for n in ("largest_radius", "smallest_radius") for bad in (
        (3.0, 3.1), (3.0, -3.1), (-3.0, 1.0), (np.inf, 1.0), (3.0, NAN),
    )),
    *(("tooth_thickness", n, bad) for n in ("constant_chord", "chord_height") for bad in (
        (-3.0, 0.3), (0.0, 0.3), (np.inf, 0.3), (3.0, 0.8), (NAN, 0.3),
    )),
    ("wedge_linkage", "roller_offset", (0.0, 60.0, np.pi)),
    ("track_wheel", "track", (0.3, 3.0, 1.0, 6, -1.0)),
    ("track_wheel", "track", (0.3, 3.0, 4.0, 6, 1.0)),
    ("track_wheel", "track", (0.3, 3.0, -np.inf, 6, 1.0)),
    ("track_wheel", "error_sum", ([-0.1, 0.1], 1.0, 1.0, 1.0)),
    ("track_wheel", "error_sum", ([0.1, 0.1], 1.0, [1.0, 0.0], 1.0)),
    ("track_wheel", "error_sum", ([0.1, 0.1], 1.0, 1.0, 0.0)),
    ("track_wheel", "error_sum_thermal", ([0.1], 1.0, 1.0, 1.0, 1.0, 1.0)),
    ("track_wheel", "error_sum_thermal", ([0.1], 1.0, 1.0, 1.0, 2.0, 0.6)),
    *(("track_wheel", "error_sum_correlated", ([0.1, 0.2], 1.0, 1.0, bad, 1.0)) for bad in (
        [[1, 0.5], [0.4, 1]], [[1, 2], [2, 1]], [[1, 0], [0, 0.9]],
    )),
]  # fmt: skip


def of_kernels() -> Iterator[Any]:
    """Yield each case for the NumPy kernel and, where there is one, for the compiled kernel."""
    for system, name, arguments in OUTSIDE:
        full = f"{system}.{name}"
        yield pytest.param(full, arguments)
        if full in KERNELS:
            group = pytest.mark.xdist_group(f"compiled {system}")
            case = pytest.param(f"{COMPILED}{full}", arguments, marks=[group])
            yield case if is_shown(full) else make_thorough(case)


@pytest.mark.parametrize(("name", "arguments"), [*of_kernels()])
def test_outside_the_domain_is_nan(name: str, arguments: tuple[Any, ...]) -> None:
    # Infinite or specimens' arguments may warn on the way; arguments inside the domain must not.
    with np.errstate(divide="ignore", invalid="ignore"):
        assert np.isnan(call(name, arguments)).all()


def test_only_the_element_outside_is_nan() -> None:
    result = elliptic_planetary.position(1.0, 66.0, 16.0, [0.1, 1.0, 0.2])
    assert np.isnan(result).tolist() == [False, True, False]


@pytest.mark.parametrize(
    ("function", "arguments", "message"),
    [
        (track_wheel.displacement, (np.ones((3, 2)), ANGLES, SHIFT), r"points.*\(3, 2\)"),
        (track_wheel.displacement, (POINT, 0.1, SHIFT), r"angles.*\(\)"),
        (track_wheel.planar_error, (np.ones(4),), r"displacement.*\(4,\)"),
        (track_wheel.error_sum, (np.ones(3), np.ones(2), 1.0, 1.0), r"sensitivities.*\(2,\)"),
        (
            track_wheel.error_sum_correlated,
            (np.ones(3), 1.0, 1.0, np.eye(2), 1.0),
            r"correlation.*\(3, 3\).*\(2, 2\)",
        ),
        (track_wheel.error_sum_correlated, (np.ones(3), 1.0, 1.0, 1.0, 1.0), r"correlation.*\(\)"),
        (track_wheel.rotation, (0.1, np.ones(3), np.ones(2)), r"^gamma: must .*\(3,\),.*\(2,\)$"),
        (track_wheel.rotation, ([[1, 2], [3]], 0, 0), r"^alpha: .* rows of one length.*\[3\]\]$"),
        (
            track_wheel.displacement,
            (np.ones((3, 3)), np.ones((2, 3)), SHIFT),
            r"^angles: axes before the last axis must .*\(3,\),.*\(2, 3\)$",
        ),
        (
            track_wheel.error_sum,
            (np.ones((3, 2)), 1.0, 1.0, np.ones(2)),
            r"^total_scatter: must .*\(3,\),.*\(2,\)$",
        ),
        (
            track_wheel.error_sum_correlated,
            (np.ones((2, 3, 3)), 1.0, 1.0, np.ones((4, 3, 3)), 1.0),
            r"^correlation: axes before the last 2 axes must .*\(2, 3\),.*\(4, 3, 3\)$",
        ),
    ],
)
def test_wrong_axes_are_named(function: Any, arguments: tuple[Any, ...], message: str) -> None:
    with pytest.raises(ValueError, match=message) as plain:
        function(*arguments)
    with pytest.raises(ValueError, match=message) as compiled:
        call(f"compiled.track_wheel.{function.__name__}", arguments)
    assert str(compiled.value) == str(plain.value)


def test_position_is_odd_and_continuous_across_turns() -> None:
    phi = np.linspace(-40, 40, 20001)
    position = elliptic_planetary.position(phi, 66, 16, 0.475)
    assert np.array_equal(position, -elliptic_planetary.position(-phi, 66, 16, 0.475))
    # The steps are at most max ratio * step, and the rounding 17 eps of about 500.
    assert np.diff(position).max() <= 12.59 * 0.004 * (1 + 1e-9)
    assert np.diff(position).min() > 0
    principal = position_principal(phi, 66, 16, 0.475)
    assert np.diff(principal).min() < -1


def test_circle_through_the_pole() -> None:
    assert track_wheel.radius(0.0, 3.0, 3.0, 1) == 6.0
    assert track_wheel.radius(np.pi, 3.0, 3.0, 1) == 0.0


def test_thermal_share_solves_its_own_equation() -> None:
    share, scatter, total = 0.15, 1.3, 1.2
    tolerances = [0.016, 0.05, 0.042, 0.01, 0.021]
    solved = track_wheel.error_sum_thermal(tolerances, 1.0, 1.1, total, share, scatter)
    scatters = [1.1] * 5 + [scatter]
    again = track_wheel.error_sum([*tolerances, share * solved], 1.0, scatters, total)
    # Two sums of 7 eps each, the first amplified by K/(K - K_T*share) = 1.2.
    assert abs(again - solved) <= 16 * np.finfo(float).eps * solved


def test_uncorrelated_is_the_plain_sum() -> None:
    plain = track_wheel.error_sum(*SUM)
    correlated = track_wheel.error_sum_correlated(*SUM[:3], np.eye(2), SUM[3])
    np.testing.assert_allclose(correlated, plain, rtol=15 * np.finfo(float).eps)
    full = track_wheel.error_sum_correlated([1.0, 2.0], 1.0, 1.0, np.ones((2, 2)), 1.0)
    assert full == 3.0


# Errors that cancel one by one, and errors correlated in a ring: the sums are 0.
SIGNED = np.array([0.1, 0.2, 0.3, 0.7, -0.6, -0.7])
RING = np.where(np.eye(3), 1.0, -0.5)


@pytest.mark.parametrize("system", ["track_wheel", "compiled.track_wheel"])
@pytest.mark.parametrize("dtype", first_of([float, np.float32]))
def test_errors_that_cancel_add_up_to_nothing(system: str, dtype: Any) -> None:
    random = np.random.default_rng(20266)
    scatters = random.uniform(0.5, 2, (400, 6))
    alike = SIGNED / scatters, np.ones((6, 6))
    turned = 0.1 / scatters[:, :3], RING
    for influences, matrix in (alike, turned):
        given = (0.03, influences, scatters[:, : len(matrix)], matrix, 1.0)
        arguments = tuple(np.asarray(a, dtype) for a in given)
        found = call(f"{system}.error_sum_correlated", arguments)
        assert not np.signbit(found).any()
        # The root of the rounding of six errors below 0.03 whose sum is 0, not NaN.
        assert np.all(found <= 0.1 * np.sqrt(20 * np.finfo(dtype).eps))


@pytest.mark.parametrize("system", ["track_wheel", "compiled.track_wheel"])
@pytest.mark.parametrize("beyond", [1e-13, 1e-9, 0.1])
def test_what_no_correlation_gives_is_nan(system: str, beyond: float) -> None:
    matrix = np.where(np.eye(3), 1.0, -0.5 - beyond)
    assert np.isnan(call(f"{system}.error_sum_correlated", (0.1, 1.0, 1.0, matrix, 1.0)))


def test_conversion_of_arguments() -> None:
    (weak,) = arrays.as_floats("a", 1)
    assert type(weak) is float
    single, mixed = arrays.as_floats("a b", np.float32(1), True)
    assert single.dtype == mixed.dtype == np.float32
    single, integer = arrays.as_floats("a b", np.float32(1), np.int64(2))
    assert type(single) is type(integer) is float
    with pytest.raises(TypeError, match="b: expected real numbers"):
        arrays.as_floats("a b", 1.0, [1j])
