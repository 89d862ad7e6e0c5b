"""Blocks, `out=`, foreign arrays and error-free arithmetic of the kernels' shared file."""

from __future__ import annotations

import operator
import sys
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from mechproof.kernel_support import arrays, error_free
from mechproof.kernel_support.blocks import in_blocks
from mechproof.kernels import elliptic_planetary, oval_planetary, track_wheel, wedge_linkage

RADII = (66.0, 16.0)
SHARED_SHIFT = np.array([0.01, 0.02, 0.03])


def spread(*shape: int) -> np.ndarray:
    """Numbers between -3 and 3, no two equal."""
    return np.linspace(-3, 3, int(np.prod(shape))).reshape(shape)


# Calls of one point and of many: scalars and arrays, one pose and many, parameters of every size.
CALLS: dict[str, tuple[Callable[..., Any], tuple[Any, ...]]] = {
    "position": (elliptic_planetary.position, (spread(7), *RADII, 0.475)),
    "position with low word": (elliptic_planetary.position, (spread(7), *RADII, 0.9)),
    "one angle": (elliptic_planetary.position, (0.3, *RADII, np.linspace(0, 0.9, 7))),
    "as many parameters": (elliptic_planetary.ratio, (spread(7), *RADII, np.linspace(0, 0.9, 7))),
    "grid": (
        elliptic_planetary.ratio, (spread(1, 7), *RADII, np.linspace(0, 0.9, 3)[:, np.newaxis]),
    ),
    "strided": (elliptic_planetary.acceleration, (spread(7, 2)[:, 1], *RADII, 0.5)),
    "column-major": (elliptic_planetary.acceleration, (spread(3, 5).T, *RADII, 0.5)),
    "rotation": (track_wheel.rotation, (spread(7), 0.2, spread(7) ** 2)),
    "one pose": (track_wheel.displacement, (spread(7, 3), [0.1, 0.2, 3.0], SHARED_SHIFT)),
    "one point": (track_wheel.displacement, ([1.0, 2.0, 3.0], spread(7, 3), SHARED_SHIFT)),
    "poses and points": (
        track_wheel.displacement, (spread(7, 1, 3), spread(3, 3), SHARED_SHIFT),
    ),
    "track": (track_wheel.track, (spread(7), 41.5, 3.75, 6, 20.0)),
    "planar error": (track_wheel.planar_error, (spread(7, 3),)),
    "sum": (track_wheel.error_sum, (np.abs(spread(7, 3)), 1.0, 1.0, 1.2)),
}  # fmt: skip


@pytest.fixture
def small_blocks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mechproof.kernel_support.blocks.BLOCK", 6)


@pytest.mark.parametrize("name", CALLS)
def test_blocks_change_no_digit(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    function, arguments = CALLS[name]
    whole = function(*arguments)
    monkeypatch.setattr("mechproof.kernel_support.blocks.BLOCK", 6)
    in_blocks = function(*arguments)
    # A matrix product may sum in another order: an ulp of the largest of four terms, below 20.
    tolerance = 4 * np.finfo(float).eps * 20 if name == "one pose" else 0
    np.testing.assert_allclose(in_blocks, whole, rtol=0, atol=tolerance)
    assert in_blocks.dtype == np.float64


@pytest.mark.parametrize("blocks", [6, 32768])
@pytest.mark.parametrize("name", CALLS)
def test_out_receives_the_result(name: str, blocks: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mechproof.kernel_support.blocks.BLOCK", blocks)
    function, arguments = CALLS[name]
    expected = function(*arguments)
    for order in ("C", "F"):
        out = np.full(expected.shape, np.nan, order=order)  # type: ignore[call-overload]
        assert function(*arguments, out=out) is out
        assert np.array_equal(out, expected)


@pytest.mark.parametrize("name", CALLS)
@pytest.mark.usefixtures("small_blocks")
def test_single_precision_is_the_rounded_double(name: str) -> None:
    function, arguments = CALLS[name]
    singles = tuple(np.asarray(a, np.float32) for a in arguments)
    result = function(*singles, out=np.empty(function(*arguments).shape, np.float32))
    assert result.dtype == np.float32
    if name == "sum":
        return  # summed in single precision
    doubles = function(*(a.astype(float) for a in singles)).astype(np.float32)
    np.testing.assert_array_max_ulp(result, doubles, 1)


@pytest.mark.parametrize("blocks", [6, 32768])
@pytest.mark.parametrize("e", [0.475, 0.9])
def test_out_may_overlap_an_argument(
    e: float, blocks: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("mechproof.kernel_support.blocks.BLOCK", blocks)
    phi = spread(40)
    expected = elliptic_planetary.position(phi[:30], *RADII, e)
    for start in (0, 7, 10):
        memory = phi.copy()
        out = memory[start : start + 30]
        assert elliptic_planetary.position(memory[:30], *RADII, e, out=out) is out
        assert np.array_equal(out, expected)
    points = spread(12, 3)
    expected = track_wheel.displacement(points, [0.1, 0.2, 0.3], SHARED_SHIFT)
    moved = track_wheel.displacement(points, [0.1, 0.2, 0.3], SHARED_SHIFT, out=points)
    assert moved is points
    assert np.array_equal(points, expected)


@pytest.mark.parametrize(
    ("out", "error", "message"),
    [
        (np.empty(6), ValueError, r"out: expected shape \(7,\).*got \(6,\)"),
        (np.empty((1, 7)), ValueError, r"out: expected shape \(7,\).*got \(1, 7\)"),
        (np.empty(7, np.float32), TypeError, "out: expected float64.*got float32"),
        (np.empty(7, int), TypeError, "out: expected float64.*got int64"),
        ([0.0] * 7, TypeError, "out: expected an array, got list"),
        (np.broadcast_to(0.0, 7), ValueError, "out: expected an array that can be written"),
    ],
)
def test_unfit_out_is_refused(out: Any, error: type[Exception], message: str) -> None:
    function, arguments = CALLS["position"]
    with pytest.raises(error, match=message):
        function(*arguments, out=out)
    with pytest.raises(error, match="out: expected"):
        track_wheel.error_sum(np.ones((7, 3)), 1.0, 1.0, 1.2, out=out)


def test_scalar_out_and_empty_arrays() -> None:
    out = np.empty(())
    assert elliptic_planetary.position(0.3, *RADII, 0.475, out=out) is out
    assert out == elliptic_planetary.position(0.3, *RADII, 0.475)
    assert elliptic_planetary.position([], *RADII, 0.475).shape == (0,)
    for points, angles in (((0, 3), (3,)), ((3,), (0, 3))):
        moved = track_wheel.displacement(np.empty(points), np.empty(angles), SHARED_SHIFT)
        assert moved.shape == (0, 3)


@pytest.mark.usefixtures("small_blocks")
def test_masks_survive() -> None:
    mask = np.arange(7) % 2 == 0
    masked = np.ma.masked_array(spread(7), mask)
    for e in (0.475, 0.9, np.ma.masked_array(np.full(7, 0.475), mask)):
        result = elliptic_planetary.position(masked, *RADII, e)
        assert np.array_equal(result.mask, mask)
        plain = elliptic_planetary.position(spread(7), *RADII, np.asarray(e))
        np.testing.assert_array_max_ulp(result.data[~mask], plain[~mask], 4)
    points = np.ma.masked_array(spread(7, 3), np.repeat(mask[:, None], 3, axis=1))
    moved = track_wheel.displacement(points, [0.1, 0.2, 0.3], SHARED_SHIFT)
    assert np.array_equal(moved.mask, points.mask)


def test_masks_survive_a_choice_of_branches() -> None:
    masked = np.ma.masked_array([0.3, 9.0], mask=[False, True])
    radius = track_wheel.radius(masked, 41.5, 3.75, 6)
    assert np.array_equal(radius.mask, masked.mask)
    np.testing.assert_array_max_ulp(radius.data[0], track_wheel.radius(0.3, 41.5, 3.75, 6), 4)
    amplitude = np.ma.masked_array([3.75, 1.0], mask=[False, True])
    points = track_wheel.track(0.3, 41.5, amplitude, 6, 20.0)
    assert points.shape == (2, 3)
    assert points.mask[1, :2].all()


def test_a_mask_is_not_written_into_a_plain_array() -> None:
    masked = np.ma.masked_array([0.3, 9.0], mask=[False, True])
    with pytest.raises(TypeError, match="out: expected a masked array"):
        elliptic_planetary.position(masked, *RADII, 0.4, out=np.empty(2))
    out = np.ma.empty(2)
    assert elliptic_planetary.position(masked, *RADII, 0.4, out=out) is out
    assert np.array_equal(out.mask, masked.mask)


@pytest.mark.parametrize("count", [10, 40_000])
def test_single_parameters_are_computed_in_double_in_calls_of_any_size(count: int) -> None:
    e = np.full(count, 0.9, np.float32)
    singles = np.float32(1000.3), np.float32(80), np.float32(30)
    doubles = elliptic_planetary.ratio(*map(float, singles), float(e[0]))
    assert np.array_equal(
        elliptic_planetary.ratio(*singles, e), np.full(count, np.float32(doubles))
    )


@pytest.mark.filterwarnings("ignore:the matrix subclass:PendingDeprecationWarning")
def test_matrices_and_memory_maps_are_plain_arrays(tmp_path: Any) -> None:
    expected = elliptic_planetary.position(spread(1, 7), *RADII, 0.475)
    mapped = np.memmap(tmp_path / "angles", float, "w+", shape=(1, 7))
    mapped[...] = spread(1, 7)
    for given in (np.matrix(spread(1, 7)), mapped):
        result = elliptic_planetary.position(given, *RADII, 0.475)
        assert type(result) is np.ndarray
        assert np.array_equal(result, expected)


class Lazy(np.lib.mixins.NDArrayOperatorsMixin):
    """An array that records ufuncs and computes nothing until asked."""

    def __init__(self, compute: Callable[[], Any], shape: tuple[int, ...]) -> None:
        self.compute, self.shape, self.dtype = compute, shape, np.dtype(float)

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        raise AssertionError("read too early")

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Lazy:
        assert method == "__call__"
        assert not options
        shapes = [i.shape if isinstance(i, Lazy) else np.shape(i) for i in inputs]

        def compute() -> Any:
            return ufunc(*(i.compute() if isinstance(i, Lazy) else i for i in inputs))

        return Lazy(compute, np.broadcast_shapes(*shapes))


@pytest.mark.parametrize("name", ["position", "position with low word"])
def test_lazy_arrays_stay_lazy(name: str) -> None:
    function, (phi, *parameters) = CALLS[name]
    result = function(Lazy(lambda: phi, phi.shape), *parameters)
    assert isinstance(result, Lazy)
    np.testing.assert_array_max_ulp(result.compute(), function(phi, *parameters), 4)


LARGEST = sys.float_info.max
HARD = (1.0, 1 / 3, np.pi, 1 + 2**-52, 2**27 + 1.0, 3e300, LARGEST / 8, 2.0**-960, 66 / 16, 80 / 30)


@pytest.mark.parametrize("a", HARD)
@pytest.mark.parametrize("b", [1.0, 0.1, -np.e, 1 - 2**-53, 7.0, 134217729.0 / 3])
def test_the_rest_of_a_product_is_exact(a: float, b: float) -> None:
    random = np.random.default_rng(33)
    for scale in (1.0, *random.uniform(0.5, 1, 20)):
        one, other = np.float64(a * scale), np.float64(b)
        with np.errstate(over="ignore"):
            product = one * other
        if not np.isfinite(product):
            continue
        with np.errstate(all="raise"):
            rest = error_free.product_rest(one, other, product)
        exact = Fraction(float(one)) * Fraction(float(other)) - Fraction(float(product))
        assert Fraction(float(rest)) == exact


def test_the_rest_of_a_sum_is_exact() -> None:
    random = np.random.default_rng(35)
    for a, b in random.uniform(-1, 1, (200, 2)) * 10 ** random.uniform(-9, 0, (200, 2)):
        small, large = sorted((np.float64(a), np.float64(b)), key=abs)
        total = large + small
        exact = Fraction(float(large)) + Fraction(float(small)) - Fraction(float(total))
        assert Fraction(float(error_free.sum_rest(large, small, total))) == exact
    # The order counts: here the larger comes second.
    assert error_free.sum_rest(1e-20, 1.0, 1.0) != 1e-20


def test_a_product_with_its_low_word_is_rounded_once() -> None:
    random = np.random.default_rng(36)
    naive = []
    for e1, e2 in (
        *random.uniform(0, 1, (200, 2)) ** 3,
        *1 - 10 ** random.uniform(-15, 0, (200, 2)),
    ):
        both, less, *_ = oval_planetary._prepare_acceleration(e1, e2, np.float64(0.0))
        one, other = Fraction(float(e1)), Fraction(float(e2))
        for value, exact in ((both, (1 + one) * (1 + other)), (less, (1 - one) * (1 - other))):
            half = Fraction(float(np.spacing(value))) / 2
            assert abs(Fraction(float(value)) - exact) <= half * (1 + Fraction(1, 2**50))
        naive.append(abs(Fraction(float((1 - e1) * (1 - e2))) - exact) > half)
    assert any(naive)


def test_the_rest_of_a_quotient_is_rounded_once() -> None:
    random = np.random.default_rng(34)
    for a, b in 10 ** random.uniform(-3, 3, (200, 2)):
        quotient = np.float64(a) / np.float64(b)
        exact = Fraction(float(a)) / Fraction(float(b)) - Fraction(float(quotient))
        rest = Fraction(float(error_free.quotient_rest(np.float64(a), np.float64(b), quotient)))
        assert abs(rest - exact) <= Fraction(1, 2**53) * abs(exact)


def test_the_small_tangent_keeps_to_one() -> None:
    values = np.array([-1e300, -1.0, -1e-300, 0.0, 1e-9, 2.0, np.nan])
    expected = [-1.0, -1.0, -1e-300, 0.0, 1e-9, 1.0, np.nan]
    assert np.array_equal(error_free.small_tangent(values), expected, equal_nan=True)


@pytest.mark.parametrize("name", ["position", "ratio", "acceleration"])
@pytest.mark.parametrize("e", [0.3, 0.9, 1 - 1e-12])
def test_the_whole_range_of_doubles(name: str, e: float) -> None:
    """No angle overflows on the way, up to where R1/R2*phi1 itself does."""
    kernel = getattr(elliptic_planetary, name)
    with np.errstate(all="raise", under="ignore"):
        for phi in (5e-324, 1e-310, 1e-300, 1e166, 1e200, 1e300, 3e307):
            assert np.isfinite(kernel(phi, *RADII, e))
    if name == "position":
        # The arctangent is at most pi: nothing beside an angle of 1e300.
        assert abs(kernel(1e300, *RADII, e) / (1e300 * (1 + 4.125)) - 1) <= np.finfo(float).eps


def test_what_the_plain_product_costs() -> None:
    """About half the bound of `position`, in eps of the value, where e <= 1/2, whatever R1/R2."""
    e = np.linspace(0, 0.5, 26)[:, np.newaxis]
    x = np.linspace(1e-6, 40 * np.pi, 20_001)
    turn = x + 2 * np.arctan2(e * np.sin(x), 1 - e * np.cos(x))
    slope = (1 - e**2) / (1 + e**2 - 2 * e * np.cos(x)) - 1
    # A finite R1/R2 adds phi1 to the value and lowers the cost.
    cost = (np.abs(x * slope) / turn).max(axis=1)
    assert (cost <= 1.01 * 2 * e[:, 0] / (1 - e[:, 0]) + 1e-300).all()
    assert cost.max() > 1.99


def test_the_low_word_is_paid_for_only_above_its_threshold(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def refuse(*words: Any) -> Any:
        raise AssertionError("low word asked for")

    monkeypatch.setattr(elliptic_planetary, "product_rest", refuse)
    assert elliptic_planetary.position(spread(2), *RADII, [0.0, 0.5]).shape == (2,)
    for e in (np.nextafter(0.5, 1), [0.1, 0.9]):
        with pytest.raises(AssertionError, match="low word asked for"):
            elliptic_planetary.position(spread(2), *RADII, e)


def random_doubles(count: int) -> np.ndarray:
    random = np.random.default_rng(37)
    return random.uniform(-2, 2, count) * 10.0 ** random.integers(-20, 20, count)


@pytest.mark.parametrize(
    "function",
    [
        lambda a, b: error_free.product_rest(a, b, a * b),
        lambda a, b: error_free.quotient_rest(a, b, a / b),
        lambda a, b: error_free.small_tangent(a),
    ],
)
def test_rests_have_the_same_bits_of_numbers_and_in_arrays(function: Any) -> None:
    a, b = random_doubles(500).reshape(2, -1)
    point = [function(np.float64(x), np.float64(y)) for x, y in zip(a, b, strict=True)]
    assert [function(float(x), float(y)) for x, y in zip(a, b, strict=True)] == point
    assert function(a, b).tolist() == point
    for x, y in ((float(a[0]), b), (a, float(b[0]))):
        wide = np.broadcast_to(x, 250), np.broadcast_to(y, 250)
        assert np.array_equal(function(x, y) + np.zeros(250), function(*wide))


@pytest.mark.parametrize("kind", [float, np.float64])
def test_functions_of_numbers_are_those_of_arrays(kind: Any) -> None:
    values = (-np.inf, -2.5, -1.0, -0.0, 0.0, 1.0, 2.5, np.inf, np.nan)
    for a in map(kind, values):
        assert np.array_equal(arrays.floor(a), np.floor(a), equal_nan=True)
        for b in map(kind, values):
            given, expected = arrays.maximum(a, b), np.maximum(a, b)
            assert np.array_equal(given, expected, equal_nan=True)
            assert np.signbit(given) == np.signbit(expected) or np.isnan(expected)
            given, expected = arrays.choose_where(a < b, a, b), np.where(a < b, a, b)
            assert np.array_equal(given, expected, equal_nan=True)


def test_every_condition_is_asked() -> None:
    for shape, axis in (((3,), -1), ((2, 3), -1), ((3, 3), (-2, -1)), ((2, 3, 3), (-2, -1))):
        condition = np.ones(shape, bool)
        assert arrays.every(condition, axis) is True
        condition[(-1,) * len(shape)] = False
        assert np.array_equal(arrays.every(condition, axis), np.all(condition, axis=axis))
    assert arrays.every(np.ones(0, bool), -1)


@pytest.mark.parametrize("name", CALLS)
def test_one_point_is_computed_as_among_others(name: str) -> None:
    function, arguments = CALLS[name]
    first, *parameters = arguments
    if np.ndim(first) != 1 or any(np.ndim(p) for p in parameters):
        return
    among = function(first, *parameters)
    for i in range(len(first)):
        assert np.array_equal(function(first[i : i + 1], *parameters), among[i : i + 1])


@pytest.mark.parametrize("running", [0.3, np.array([0.3, 0.4])])
@pytest.mark.parametrize(
    "evaluate", [lambda x, p: x / p, lambda x, p: x + 1e300 / (p + 1e-200) ** 2]
)
def test_what_python_refuses_is_computed_as_numpy_does(evaluate: Any, running: Any) -> None:
    """Python raises for a division by zero and for a power beyond the largest double."""
    with np.errstate(all="ignore"):
        found = in_blocks(evaluate, (running,), lambda p: (p,), (0.0,))
        expected = evaluate(running, np.float64(0.0))
    assert type(found) is (np.float64 if type(running) is float else np.ndarray)
    assert np.array_equal(found, expected)


def test_single_precision_is_not_widened_or_narrowed_by_numbers() -> None:
    def evaluate(x: Any, p: Any) -> Any:
        return error_free.single(x) + p

    found = in_blocks(evaluate, (0.1,), lambda p: (p,), (0.2,))
    assert found == np.float32(0.1) + np.float64(0.2)


def test_lazy_conditions_stay_unread() -> None:
    assert arrays.holds(np.array([True, True]))
    assert not arrays.holds(np.array([True, False]))
    assert arrays.holds(np.float64(1) > 0)
    assert not arrays.holds(operator.gt(Lazy(lambda: 1.0, ()), 0))


@pytest.mark.parametrize("shape", [(200, 100), (3, 5, 80), (2, 1, 70)])
def test_outer_products_keep_what_depends_on_few_arguments_short(
    shape: tuple[int, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Arrays along axes of their own, in slices: the same as all of them written out."""
    monkeypatch.setattr("mechproof.kernel_support.blocks.BLOCK", 256)
    x1 = np.linspace(-40, 0, shape[-1])
    l_de = np.linspace(82, 84, shape[0]).reshape(-1, *[1] * (len(shape) - 1))
    l_kl = np.linspace(59.8, 60.2, shape[-2])[:, np.newaxis]
    seen: list[tuple[int, ...]] = []
    evaluate = wedge_linkage._position

    def watched(x1: Any, l_bc: Any, l_de: Any, *rest: Any) -> Any:
        seen.append(np.shape(x1))
        return evaluate(x1, l_bc, l_de, *rest)

    monkeypatch.setattr(wedge_linkage, "_position", watched)
    arguments = (x1, 6.25, 49.75, 38.0, l_de, 2.0, l_kl, 145.0, 4.94, 1.13, 2.155)
    found = wedge_linkage.position(*arguments)
    assert found.shape == shape
    assert all(np.prod(part) <= shape[-1] for part in seen)
    whole = [np.broadcast_to(a, shape).ravel() for a in arguments]
    np.testing.assert_allclose(found.ravel(), wedge_linkage.position(*whole), rtol=1e-13)
    out = np.empty(shape)
    assert wedge_linkage.position(*arguments, out=out) is out
    np.testing.assert_array_equal(out, found)
