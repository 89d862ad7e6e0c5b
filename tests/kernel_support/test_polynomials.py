"""Polynomials in place of tan and arctan: proved approximations, one bound, the same arrays."""

from __future__ import annotations

from collections.abc import Iterator

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from flint import arb, arb_series, ctx

from mechproof.codegen.polynomials import (
    LARGEST_SQUARE,
    MARGIN,
    Rational,
    fit_arctangent,
    fit_tangent,
)
from mechproof.derivations.elliptic_planetary.kernels import PLAIN_PRODUCT
from mechproof.derivations.elliptic_planetary.symbols import e
from mechproof.kernel_support import polynomials
from mechproof.kernels import elliptic_planetary as kernels
from mechproof.kernels.elliptic_planetary import position
from mechproof.lab.search import find_worst
from mechproof.lab.subject import find_subjects
from mechproof.lab.ways import Array

EPS = float(np.finfo(float).eps)
RADII = (66.0, 16.0)
PIECES, ORDER = 64, 24


@pytest.fixture(autouse=True)
def always(monkeypatch: pytest.MonkeyPatch) -> None:
    """Use the polynomials on every host and for arrays of every length."""
    monkeypatch.setattr(polynomials, "IS_WORTH_IT", True)
    monkeypatch.setattr(polynomials, "LONG", 1)


@pytest.fixture
def many_digits() -> Iterator[None]:
    precision, length = ctx.prec, ctx.cap
    ctx.prec, ctx.cap = 400, ORDER + 2
    yield
    ctx.prec, ctx.cap = precision, length


def evaluate(coefficients: tuple[float, ...], z: arb_series) -> arb_series:
    value = arb_series([0])
    for number in reversed(coefficients):
        value = value * z + arb(number)
    return value


def tangent_sides(fit: Rational, r: arb_series) -> tuple[arb_series, arb_series]:
    """Fit and tan(r/2), both times the fit's denominator and cos(r/2)."""
    half = r / 2
    below = evaluate(fit.below, r * r)
    return r * evaluate(fit.above, r * r) * half.cos(), below * half.sin()


def arctangent_sides(fit: Rational, y: arb_series) -> tuple[arb_series, arb_series]:
    """Fit and atan(y), both times the fit's denominator."""
    z = y * y
    below = evaluate(fit.below, z)
    return y * below + y * z * evaluate(fit.above, z), below * y.atan()


CASES = {
    "tangent": (tangent_sides, fit_tangent(), (1 + MARGIN) * np.pi / 2, 0.25),
    "arctangent": (arctangent_sides, fit_arctangent(), np.sqrt(LARGEST_SQUARE * (1 + MARGIN)), 0.6),
}


def enclose(name: str, fit: Rational) -> float:
    """Bound the relative error from 0 to the end: Taylor polynomials, remainders from balls."""
    sides, _, end, _ = CASES[name]
    worst = 0.0
    half = arb(end) / (2 * PIECES)
    for i in range(PIECES):
        # The first piece is expanded at 0, where both sides vanish with their argument.
        middle, reach, lowest = (half * (2 * i + 1), half, 0) if i else (arb(0), 2 * half, 1)
        ball = arb(middle.mid(), reach)
        found, true = sides(fit, arb_series([middle, 1]))
        near = (found - true).coeffs()
        found, true = sides(fit, arb_series([ball, 1]))
        terms = [abs(c) * reach ** (k - lowest) for k, c in enumerate(near[:ORDER]) if k >= lowest]
        rest = abs((found - true).coeffs()[ORDER]) * reach ** (ORDER - lowest)
        worst = max(worst, float((sum(terms, rest) / true.coeffs()[lowest].abs_lower()).upper()))
    return worst


@pytest.mark.usefixtures("many_digits")
@pytest.mark.parametrize("name", CASES)
def test_the_approximation_is_proved(name: str) -> None:
    _, fit, _, bound = CASES[name]
    assert enclose(name, fit) <= bound * EPS
    changed = Rational((*fit.above[:-1], fit.above[-1] * (1 + 2.0**-20)), fit.below)
    assert enclose(name, changed) > bound * EPS


def test_the_shipped_coefficients_are_the_fitted() -> None:
    assert (fit_tangent().above, fit_tangent().below) == kernels.TANGENT
    assert (fit_arctangent().above, fit_arctangent().below) == kernels.ARCTANGENT


def test_pi_is_split_into_28_bits_and_the_double_next_to_the_rest() -> None:
    with mp.workdps(60):
        high = mp.floor(mp.pi * 2**26) / 2**26
        assert (float(high), float(mp.pi - high)) == (polynomials.PI, polynomials.PI_LOW)


def test_the_arc_stays_small_where_the_plain_product_is_taken() -> None:
    """|c| <= 2*sqrt(a*b/3) for c = 2*e, a = 1 - e, b = 1 + e is e <= 1/2, both sides squared."""
    legal = sp.Le((2 * e) ** 2, 4 * (1 - e) * (1 + e) / 3)
    domain = sp.Interval.Ropen(0, 1)
    assert legal.as_set().intersect(domain) == PLAIN_PRODUCT.as_set().intersect(domain)


def one_by_one(*arguments: Array) -> Array:
    """Compute each point by itself: one mechanism, an array of one angle."""
    phi, *parameters = np.broadcast_arrays(*map(np.atleast_1d, arguments))
    points = zip(phi.ravel(), *(p.ravel() for p in parameters), strict=True)
    return np.array([position([p], *rest)[0] for p, *rest in points]).reshape(phi.shape)


def test_the_bound_of_the_position_holds() -> None:
    (subject,) = find_subjects(("elliptic_planetary.position",))
    assert subject.quantity.accuracy is not None
    found = find_worst(subject, one_by_one, rounds=6, seed=4711, share=0.2, most=60)
    assert found.tried > 400
    assert 0.5 < found.scaled <= subject.quantity.accuracy.ulp


def test_the_bound_sees_a_wrong_coefficient(monkeypatch: pytest.MonkeyPatch) -> None:
    (subject,) = find_subjects(("elliptic_planetary.position",))
    (first, *others), below = kernels.ARCTANGENT
    monkeypatch.setattr(kernels, "ARCTANGENT", ((first * (1 + 2.0**-40), *others), below))
    found = find_worst(subject, one_by_one, rounds=0, seed=4711, share=0.2, most=60)
    assert subject.quantity.accuracy is not None
    assert found.scaled > subject.quantity.accuracy.ulp


Y = np.concatenate([np.linspace(-9, 9, 37), 10.0 ** np.arange(-300, 7, 17), [np.pi / 2, 3e7]])


@pytest.mark.parametrize(("a", "b"), [(1.0, 1.0), (0.5, 1.5), (1.5, 0.5), (1e-3, 1.0)])
def test_the_quotient_is_off_by_a_few_eps_of_its_largest_value(a: float, b: float) -> None:
    found = polynomials.tangent_quotient(Y, np.float64(a), np.float64(b), kernels.TANGENT)
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
    polynomials.tangent_quotient(y, np.float64(1), np.float64(1), kernels.TANGENT)
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
