"""Compiled sums: shapes, digits and errors of the NumPy kernels, and compiled calls."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from weights import first_of, make_thorough

from mechproof.kernels.compiled import track_wheel

pytestmark = [
    pytest.mark.xdist_group("compiled track_wheel"),
    pytest.mark.slow(together=True),
]
EPS = float(np.finfo(float).eps)
SEVEN = np.random.default_rng(20265).uniform(0.5, 2, (3, 4, 7))
MATRIX = np.where(np.eye(7), 1, 0.25)


@pytest.mark.parametrize(
    ("name", "arguments"),
    [
        ("error_sum", (SEVEN, 1.0, [1.5], 1.1)),
        ("error_sum", (SEVEN[:, ::2], SEVEN[0, 0], np.full((3, 1, 1), 2.0), SEVEN[:, :2, 0])),
        ("error_sum", (np.asfortranarray(SEVEN), 1, 2, 3)),
        ("error_sum", (0.5, 1.0, 2.0, SEVEN[..., 0])),
        ("error_sum", (SEVEN[..., :0], 1.0, 1.0, 1.0)),
        ("error_sum", (SEVEN[:0], 1.0, 1.0, 1.0)),
        ("error_sum", (SEVEN[0, 0], [1.0, -1, 2, -2, 3, -3, 0], 1.0, [1.0, np.nan, -1.0])),
        ("error_sum", (1e200, 1.0, 1.0, 1.0)),
        ("error_sum", (*map(np.array, (0.5, 1.0, 2.0)), 1.1)),
        ("error_sum_correlated", (SEVEN, 1.0, SEVEN[1, 0], MATRIX, 1.1)),
        ("error_sum_correlated", (SEVEN, 1.0, 1.0, np.stack([MATRIX, 2 * MATRIX] * 2), 1.1)),
        ("error_sum_correlated", (0.5, 1.0, 1.0, [[1.0]], 1.0)),
        # These compile loops of their own, similar to those above or to those tested below.
        *map(
            make_thorough,
            (
                ("error_sum", (np.float32(SEVEN), np.float32(2), 1.0, 1.0)),
                ("error_sum", (np.ones((2, 40_000)), 1.0, 1.0, 1.0)),
                ("error_sum_correlated", (np.float32(SEVEN[0]), 1, 1, np.float32(MATRIX), 1)),
                ("error_sum_thermal", (SEVEN, 1.0, 1.1, 1.2, [[0.15], [0.3], [2.0]], 1.3)),
            ),
        ),
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
    # Terms of one sign: both are within 9 eps, those of float32 where NumPy adds in it.
    np.testing.assert_allclose(found, wanted, rtol=18 * np.finfo(wanted.dtype).eps)


def test_sums_are_stored_in_out() -> None:
    from mechproof.kernels import track_wheel as plain_wheel

    wanted = track_wheel.error_sum(SEVEN, 1.0, 1.0, 1.1)
    source = SEVEN.copy()
    memory = np.zeros((50, 4))
    masked = np.ma.masked_array(np.empty((3, 4)), mask=True)
    for out in (
        np.empty((3, 4)),
        np.empty((4, 3)).T,
        memory[:3].view(np.matrix),
        masked,
        source[..., 0],
    ):
        assert track_wheel.error_sum(source, 1.0, 1.0, 1.1, out=out) is out
        assert np.array_equal(out, wanted)
    assert not memory[3:].any()
    assert not masked.mask.any()
    for bad in (np.empty(3), np.empty((3, 4), np.float32)):
        with pytest.raises((TypeError, ValueError)) as plain:
            plain_wheel.error_sum(SEVEN, 1.0, 1.0, 1.1, out=bad)
        with pytest.raises(type(plain.value), match="out: expected") as compiled:
            track_wheel.error_sum(SEVEN, 1.0, 1.0, 1.1, out=bad)
        assert str(compiled.value) == str(plain.value)


def test_long_sums_lose_nothing() -> None:
    """One large term, and a million that would each be rounded away next to it."""
    tolerances = np.full(2**20 + 1, 2.0**-30)
    tolerances[0] = 2.0**-3
    exact = np.sqrt(2.0**-6 + 2.0**-40)
    # The sum once rounded and the root: 1/4 and 1/2, in eps.
    assert abs(track_wheel.error_sum(tolerances, 1.0, 1.0, 1.0) - exact) <= EPS * exact


SETS = 150


def draw_sets() -> dict[str, Any]:
    """Return arguments of many sets, some of them outside the domain."""
    random = np.random.default_rng(20266)
    tolerances, influences, scatters = random.uniform(0.5, 2, (3, SETS, 7))
    matrices = np.where(np.eye(7), 1, random.uniform(0, 0.25, (SETS, 1, 1)))
    totals = random.uniform(1, 2, SETS)
    tolerances[3, 4], scatters[70, 6], influences[5, 0] = -1, np.nan, np.inf
    matrices[60, 2, 1], totals[9] = 0.5, 0
    return {
        "tolerances": tolerances,
        "sensitivities": influences,
        "scatters": scatters,
        "correlation": matrices,
        "total_scatter": totals,
    }


@pytest.mark.parametrize(
    ("varied", "kind"),
    [
        *(((name,), float) for name in draw_sets()),
        *first_of((tuple(draw_sets()), kind) for kind in (float, "f")),
    ],
)
def test_a_set_among_others_has_the_bits_of_a_set_alone(varied: tuple[str, ...], kind: Any) -> None:
    from mechproof.kernels import track_wheel as plain_wheel

    given = {n: np.array(a if n in varied else a[0], kind) for n, a in draw_sets().items()}

    def compute(part: slice) -> Any:
        taken = {n: a[part] if n in varied else a for n, a in given.items()}
        return track_wheel.error_sum_correlated(**taken)

    whole = compute(slice(None))
    assert np.array_equal(np.isnan(whole), np.isnan(plain_wheel.error_sum_correlated(**given)))
    for part in (*(slice(i, i + 1) for i in range(SETS)), slice(60, 69), slice(2, 131)):
        assert np.array_equal(compute(part), whole[part], equal_nan=True)


@pytest.mark.parametrize(
    ("name", "terms", "rest"),
    first_of(
        [
            ("error_sum", [1e20, 2e20, 3e20], ()),
            ("error_sum_correlated", [0.3, 0.4, 0.7], (np.outer([1, 1, -1], [1, 1, -1]),)),
        ]
    ),
)
def test_sums_of_float32_are_computed_in_doubles(name: str, terms: Any, rest: Any) -> None:
    single = [np.float32(a) for a in (terms, 1, 1, *rest, 1.1)]
    wanted = np.float32(getattr(track_wheel, name)(*(a.astype(float) for a in single)))
    assert 0 < wanted < np.inf
    for sets in ((), (1,), (7,), (2, 1000)):
        rows = np.broadcast_to(single[0], (*sets, 3))
        found = getattr(track_wheel, name)(rows, *single[1:])
        assert found.dtype == np.float32
        assert np.all(found == wanted)


@pytest.mark.parametrize("kind", first_of([float, np.float32]))
def test_few_long_sums_have_the_bits_of_many(kind: Any) -> None:
    rows = np.random.default_rng(20267).uniform(0.5, 2, (5, 2000)).astype(kind)
    many = track_wheel.error_sum(rows, 1.0, rows[0], 1.1)
    few = [track_wheel.error_sum(rows[i : i + 2], 1.0, rows[0], 1.1) for i in (0, 3)]
    assert np.array_equal(many[[0, 1, 3, 4]], np.concatenate(few))


@pytest.mark.thorough
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
