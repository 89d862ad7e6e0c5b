"""Polynomials in place of tan and arctan: proved approximations, one bound, the same arrays."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from calls import RADII

from mechproof.derivations.elliptic_planetary.kernels import PLAIN_PRODUCT
from mechproof.derivations.elliptic_planetary.symbols import e
from mechproof.kernel_support import polynomials
from mechproof.kernels import elliptic_planetary as kernels
from mechproof.kernels.elliptic_planetary import position
from mechproof.lab.points import join
from mechproof.lab.search import draw_sets, find_worst
from mechproof.lab.subject import find_subjects
from mechproof.lab.ways import Array
from mechproof.programs.elementary.fits import HALF_TANGENT, SMALL_ARCTANGENT, fit

EPS = float(np.finfo(float).eps)


@pytest.fixture(autouse=True)
def always(monkeypatch: pytest.MonkeyPatch) -> None:
    """Use the polynomials on every host and for arrays of every length."""
    monkeypatch.setattr(polynomials, "IS_WORTH_IT", True)
    monkeypatch.setattr(polynomials, "LONG", 1)


def test_the_shipped_coefficients_are_the_fitted() -> None:
    for shipped, target, degrees in (
        (kernels._TANGENT, HALF_TANGENT, (3, 3)),
        (kernels._ARCTANGENT, SMALL_ARCTANGENT, (4, 4)),
    ):
        fitted = fit(target, *degrees)
        assert (fitted.above, fitted.below) == shipped


def test_pi_is_split_into_28_bits_and_the_double_next_to_the_rest() -> None:
    with mp.workdps(60):
        high = mp.floor(mp.pi * 2**26) / 2**26
        assert (float(high), float(mp.pi - high)) == (polynomials.PI, polynomials.PI_LOW)


def test_the_arc_stays_small_where_the_plain_product_is_taken() -> None:
    """|c| <= 2*sqrt(a*b/3) for c = 2*e, a = 1 - e, b = 1 + e is e <= 1/2, both sides squared."""
    legal = sp.Le((2 * e) ** 2, 4 * (1 - e) * (1 + e) / 3)
    domain = sp.Interval.Ropen(0, 1)
    assert legal.as_set().intersect(domain) == PLAIN_PRODUCT.as_set().intersect(domain)


def by_polynomials(y: Array, a: Array, b: Array, fit: polynomials.Fit) -> Array:
    """Compute the quotient as for one a and one b, but of many at once."""
    plain = np.tan(y) / (a + b * np.tan(y) ** 2)
    found = polynomials._in_blocks(polynomials._fill_tangent_quotient, y, fit, a, b)
    return np.where(np.abs(y) <= polynomials.LARGEST, found, plain)


def together(*arguments: Array) -> Array:
    """Compute all points as each is computed in an array of points with its own parameters."""
    columns = np.broadcast_arrays(*map(np.atleast_1d, arguments))
    found = np.empty(columns[0].shape)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(kernels, "_tangent_quotient", by_polynomials)
        for group in (columns[-1] <= 0.5, ~(columns[-1] <= 0.5)):
            if np.any(group):
                # One angle alone is computed in numbers.
                some = (np.append(c[group], c[group][0]) for c in columns)
                found[group] = position(*some)[:-1]
    return found


def test_many_parameters_at_once_are_computed_as_one_by_one() -> None:
    (subject,) = find_subjects(("elliptic_planetary.position",))
    points = join(*draw_sets(subject, 4711, 0.2))
    pairs = zip(*points, strict=True)
    each = [position(np.array([phi, phi]), *map(float, rest))[0] for phi, *rest in pairs]
    assert len(each) > 100
    assert np.array_equal(together(*points), each)


@pytest.mark.thorough
def test_the_bound_of_the_position_holds() -> None:
    (subject,) = find_subjects(("elliptic_planetary.position",))
    assert subject.quantity.accuracy is not None
    found = find_worst(subject, together, rounds=6, seed=4711, share=0.2, most=60)
    assert found.tried > 400
    assert 0.5 < found.scaled <= subject.quantity.accuracy.ulp


def test_the_bound_sees_a_wrong_coefficient(monkeypatch: pytest.MonkeyPatch) -> None:
    (subject,) = find_subjects(("elliptic_planetary.position",))
    (first, *others), below = kernels._ARCTANGENT
    monkeypatch.setattr(kernels, "_ARCTANGENT", ((first * (1 + 2.0**-40), *others), below))
    found = find_worst(subject, together, rounds=0, seed=4711, share=0.2, most=60)
    assert subject.quantity.accuracy is not None
    assert found.scaled > subject.quantity.accuracy.ulp


Y = np.concatenate([np.linspace(-9, 9, 37), 10.0 ** np.arange(-300, 7, 17), [np.pi / 2, 3e7]])


@pytest.mark.parametrize(("a", "b"), [(1.0, 1.0), (0.5, 1.5), (1.5, 0.5), (1e-3, 1.0)])
def test_the_quotient_is_off_by_a_few_eps_of_its_largest_value(a: float, b: float) -> None:
    found = polynomials.tangent_quotient(Y, np.float64(a), np.float64(b), kernels._TANGENT)
    with mp.workdps(60):
        for y, value in zip(Y, found, strict=True):
            t = mp.tan(mp.mpf(float(y)))
            true = t / (mp.mpf(a) + mp.mpf(b) * t**2)
            # Near the zero at 0 of itself; elsewhere of the largest value, 1/(2*sqrt(a*b)).
            scale = abs(true) if abs(y) < 0.1 else 1 / (2 * mp.sqrt(mp.mpf(a) * mp.mpf(b)))
            steep = 1 + mp.sqrt(max(a, b) / mp.mpf(min(a, b)))
            assert abs(float(value) - true) <= 4 * EPS * scale * steep


def test_blocks_shapes_and_strides(monkeypatch: pytest.MonkeyPatch) -> None:
    phi = np.linspace(-60, 60, 120)
    expected = position(phi, *RADII, 0.4)
    monkeypatch.setattr(polynomials, "BLOCK", 7)
    assert np.array_equal(position(phi, *RADII, 0.4), expected)
    grid = phi.reshape(8, 15)
    for view in (grid, np.asfortranarray(grid), grid[::-1, ::2]):
        assert np.array_equal(
            position(view, *RADII, 0.4), position(view.ravel(), *RADII, 0.4).reshape(view.shape)
        )


def test_the_argument_is_not_written_to() -> None:
    phi = np.linspace(-60, 60, 120)
    phi.flags.writeable = False
    position(phi, *RADII, 0.4)
    y = phi.copy()
    polynomials.tangent_quotient(y, np.float64(1), np.float64(1), kernels._TANGENT)
    assert np.array_equal(y, phi)


@pytest.mark.parametrize("odd", [np.nan, np.inf, -np.inf, 1e9, -1e300])
def test_what_the_reduction_cannot_take_goes_the_plain_way(odd: float) -> None:
    phi = np.array([0.3, odd, 2.0])
    with np.errstate(invalid="ignore"):
        plain = position(odd, *RADII, 0.4)
        assert np.array_equal(
            position(phi, *RADII, 0.4),
            [position(0.3, *RADII, 0.4), plain, position(2.0, *RADII, 0.4)],
            equal_nan=True,
        )


def test_a_vector_loop_is_preferred(monkeypatch: pytest.MonkeyPatch) -> None:
    def answer(current: str) -> None:
        loops = {"tan": {"dd": {"current": current, "available": "X86_V4 baseline(X86_V2)"}}}
        monkeypatch.setattr(np.lib.introspect, "opt_func_info", lambda **_: loops)

    for current, expected in (("X86_V4", True), ("AVX512_SKX", True), ("baseline(X86_V2)", False)):
        answer(current)
        assert polynomials._has_vector_loop("tan") is expected
    monkeypatch.setattr(np.lib.introspect, "opt_func_info", lambda **_: {})
    assert not polynomials._has_vector_loop("tan")
    monkeypatch.delattr(np.lib, "introspect")
    assert not polynomials._has_vector_loop("tan")
