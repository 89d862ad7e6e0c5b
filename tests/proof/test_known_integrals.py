"""Every integral in the table converges and has the value found by numerical integration."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath
import pytest
import sympy as sp

from mechproof.proof.known_integrals import KNOWN, KnownIntegral, X

# With these letters all rows converge, except some that need `BETWEEN`.
LETTERS = {"a": sp.Rational(3, 2), "b": sp.Rational(4, 3), "n": sp.Integer(3)}
LETTERS |= {"c": sp.S.Half, "p": sp.Rational(1, 3), "q": sp.Rational(-1, 4), "m": sp.Rational(5, 2)}
BETWEEN = {**LETTERS, "a": sp.Rational(-1, 3)}
SWINGING = (sp.sin, sp.cos)
TOLERANCE = 1e-2
# A distance from the ends of an interval that rounding does not remove.
TINY = 1e-12


def put(row: KnownIntegral) -> KnownIntegral:
    for letters in (LETTERS, BETWEEN):
        values = {wild: letters[wild.name] for wild in row.integrand.atoms(sp.Wild)}
        if all(number.xreplace(values) > 0 for number in row.positive):
            value = row.value.xreplace(values).doit()
            return KnownIntegral(row.integrand.xreplace(values), row.limits, value)
    raise AssertionError(f"no letters for {row}")


@pytest.mark.slow
@pytest.mark.parametrize("row", KNOWN, ids=[str(row.integrand) for row in KNOWN])
def test_a_row_has_its_value(row: KnownIntegral) -> None:
    known = put(row)
    f = sp.lambdify(X, known.integrand, "mpmath")
    low, high = (sp.lambdify([], end, "mpmath")() for end in known.limits)
    value = sp.lambdify([], known.value, "mpmath")()
    with mpmath.workdps(40):
        if high < mpmath.inf:
            found = mpmath.quad(f, [low + TINY, high / 2, high - TINY])
        elif known.integrand.has(*SWINGING) and not known.integrand.has(sp.exp):
            found = integrate_waves(f)
        else:
            found = mpmath.quad(f, [low, 1, high])
    assert abs(found - value) < TOLERANCE


def integrate_waves(f: Callable[[Any], Any]) -> Any:
    """Extrapolate Abel means with a factor exp(-x²/rate); their limit is a convergent integral."""

    def mean(rate: int) -> Any:
        ends = [mpmath.sqrt(n * mpmath.pi) for n in range(4 * rate)]
        return mpmath.quad(lambda x: f(x) * mpmath.exp(-(x**2) / rate), ends, maxdegree=3)

    with mpmath.workdps(15):
        first, second, third = map(mean, (15, 30, 60))
    return (first - 6 * second + 8 * third) / 3
