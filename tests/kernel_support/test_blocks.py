"""Blocks and `out=`: the size of a block changes no digit, and results go where they should."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from calls import CALLS, RADII, SHARED_SHIFT, spread

from mechproof.kernel_support import error_free
from mechproof.kernel_support.blocks import in_blocks
from mechproof.kernels import elliptic_planetary, track_wheel, wedge_linkage


@pytest.mark.parametrize("name", CALLS)
def test_blocks_change_no_digit(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    function, arguments = CALLS[name]
    whole = function(*arguments)
    monkeypatch.setattr("mechproof.kernel_support.blocks.BLOCK", 6)
    in_blocks = function(*arguments)
    # A matrix product may sum in another order: an ulp of each of four terms below 20.
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
    if expected.ndim == 2:
        matrix = np.full(expected.shape, np.nan).view(np.matrix)
        assert function(*arguments, out=matrix) is matrix
        assert np.array_equal(matrix, expected)


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


@pytest.mark.parametrize("shape", [(), (1,), (1, 1)])
def test_one_point_is_computed_in_numbers_with_out_too(shape: tuple[int, ...]) -> None:
    """Arrays take five times as long."""

    def evaluate(x: Any) -> Any:
        assert isinstance(x, float)
        return x * x

    point = 3.0 if shape == () else np.full(shape, 3.0)
    out = np.empty(shape)
    assert in_blocks(evaluate, (point,), out=out) is out
    assert out == in_blocks(evaluate, (point,)) == 9.0


def test_scalar_out_and_empty_arrays() -> None:
    out = np.empty(())
    assert elliptic_planetary.position(0.3, *RADII, 0.475, out=out) is out
    assert out == elliptic_planetary.position(0.3, *RADII, 0.475)
    assert elliptic_planetary.position([], *RADII, 0.475).shape == (0,)
    for points, angles in (((0, 3), (3,)), ((3,), (0, 3))):
        moved = track_wheel.displacement(np.empty(points), np.empty(angles), SHARED_SHIFT)
        assert moved.shape == (0, 3)


@pytest.mark.parametrize("count", [10, 40_000])
def test_single_parameters_are_computed_in_double_in_calls_of_any_size(count: int) -> None:
    e = np.full(count, 0.9, np.float32)
    singles = np.float32(1000.3), np.float32(80), np.float32(30)
    doubles = elliptic_planetary.ratio(*map(float, singles), float(e[0]))
    assert np.array_equal(
        elliptic_planetary.ratio(*singles, e), np.full(count, np.float32(doubles))
    )


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


@pytest.mark.parametrize("shape", [(200, 100), (3, 5, 80), (2, 1, 70)])
def test_outer_products_keep_what_depends_on_few_arguments_short(
    shape: tuple[int, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Arrays along separate axes, taken in slices, give the same as when fully broadcast."""
    monkeypatch.setattr("mechproof.kernel_support.blocks.BLOCK", 256)
    x1 = np.linspace(-40, 0, shape[-1])
    l_de = np.linspace(82, 84, shape[0]).reshape(-1, *[1] * (len(shape) - 1))
    l_kl = np.linspace(59.8, 60.2, shape[-2])[:, np.newaxis]
    seen: list[tuple[int, ...]] = []
    evaluate = wedge_linkage._form_of_position

    def watched(x1: Any, l_bc: Any, l_de: Any, *rest: Any) -> Any:
        seen.append(np.shape(x1))
        return evaluate(x1, l_bc, l_de, *rest)

    monkeypatch.setattr(wedge_linkage, "_form_of_position", watched)
    arguments = (x1, 6.25, 49.75, 38.0, l_de, 2.0, l_kl, 145.0, 4.94, 1.13, 2.155)
    found = wedge_linkage.position(*arguments)
    assert found.shape == shape
    assert all(np.prod(part) <= shape[-1] for part in seen)
    whole = [np.broadcast_to(a, shape).ravel() for a in arguments]
    np.testing.assert_allclose(found.ravel(), wedge_linkage.position(*whole), rtol=1e-13)
    out = np.empty(shape)
    assert wedge_linkage.position(*arguments, out=out) is out
    np.testing.assert_array_equal(out, found)
