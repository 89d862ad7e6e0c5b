"""Fused products are rounded once, and bounded accordingly."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from mechproof.arithmetic.intervals import EPS, ONE, Interval, careful
from mechproof.roundoff.bound import ErrorAnalysis
from mechproof.roundoff.endpoint_rounding import AT_ENDPOINTS
from mechproof.roundoff.error_sums import ErrorScale
from mechproof.roundoff.interval_monomials import BoxVariables
from mechproof.roundoff.running import fma
from mechproof.roundoff.steps import Step, StraightLineProgram


def test_fused_ends_hold_what_is_fused_between_them() -> None:
    rng = np.random.default_rng(9)
    for signs in ((1, 1), (-1, 1), (1, -1), (-1, -1)):
        low = rng.uniform(0, 2, (3, 500))
        high = low * (1 + rng.uniform(0, 1, (3, 500)))
        a, b = (
            Interval(least, most) if sign > 0 else Interval(-most, -least)
            for sign, least, most in zip(signs, low, high, strict=False)
        )
        c = Interval(-high[2], -low[2])
        found = AT_ENDPOINTS["fma"](a, b, c)
        for share in np.linspace(0, 1, 9):
            x, y, z = (i.low + share * (i.high - i.low) for i in (a, b, c))
            inner = fma(*(np.clip(v, i.low, i.high) for v, i in ((x, a), (y, b), (z, c))))
            assert np.all((found.span.low <= inner) & (inner <= found.span.high))
    unknown = Interval(-low[0], high[0])
    assert not AT_ENDPOINTS["fma"](unknown, unknown, c).span.is_finite.any()


def test_fused_products_are_rounded_once() -> None:
    rng = np.random.default_rng(2)
    a, b = rng.normal(size=(2, 4000)) * 2.0 ** rng.integers(-40, 40, (2, 4000))
    near = -a * b * (1 + rng.integers(-2, 3, 4000) * EPS)
    c = np.where(rng.random(4000) < 0.6, near, rng.normal(size=4000) * 2.0 ** rng.integers(-60, 60))
    # Ties, except for the rest of the product.
    a[:3], b[:3], c[:3] = 1 + EPS, [1 - EPS, 1 + EPS, 0.5], [2.0**53, -(2.0**54), 2.0**52]
    exact = [Fraction(x) * Fraction(y) + Fraction(z) for x, y, z in zip(a, b, c, strict=True)]
    assert fma(a, b, c).tolist() == [float(value) for value in exact]


def test_a_fused_sum_that_cancels_leaves_its_terms_their_roundings() -> None:
    """The spacing of the small result bounds only the rounding of the sum."""
    steps = (
        Step("p", "multiply", ("a", "b"), 0.5),
        Step("n", "negate", ("p",), 0.0),
        Step("q", "fma", ("a", "b", "n"), 0.5),
    )
    side = Interval(np.array([1.0]), np.array([1.0 + 2.0**-20]))
    variables = BoxVariables([side, side], [True, True])
    given = {"a": variables.variable(0), "b": variables.variable(1)}
    with careful(moves=False):
        evaluation = ErrorAnalysis(
            StraightLineProgram(("a", "b"), steps, ("q",)), variables, given, {}, None
        )
        errors = evaluation.list_errors("q", ErrorScale(variables.constant(ONE), False))
    a, b = 1 + np.random.default_rng(3).integers(0, 2**32, (2, 10000)) * EPS
    off = np.max(np.abs(fma(a, b, -(a * b)))) / EPS
    assert 0.45 < off <= errors["p"] < 0.51
    assert errors["q"] < 2.0**-18
