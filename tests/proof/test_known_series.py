"""Each row of the table of series against its own partial sums."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from mechproof.proof import endless_sums
from mechproof.proof.endless_sums import SERIES

PLACE = 0.3
TERMS = 2000


def is_its_sum(series: endless_sums._Series) -> bool:
    """Return whether the first `TERMS` terms, computed from their quotients, add up to the value.

    The remainder of a sum of 1/n^p is at most (TERMS + 2) times the next term, by comparison with
    an integral, and that of the other series is less; each addition rounds a number below 3.
    """
    a, j = endless_sums._A, endless_sums._J
    quotient = sp.lambdify(j, series.quotient.subs(a, PLACE))
    term, total = float(series.first.subs(a, PLACE)), 0.0
    for number in range(TERMS):
        total += term
        term *= quotient(number)
    error = (TERMS + 2) * abs(term) + 3 * TERMS * 2**-53
    return abs(total - float(series.value.subs(a, PLACE))) <= error


@pytest.mark.parametrize("series", SERIES, ids=lambda series: str(series.value))
def test_a_row_is_the_sum_of_its_terms(series: endless_sums._Series) -> None:
    assert is_its_sum(series)
    assert not is_its_sum(replace(series, value=series.value * sp.Rational(101, 100)))
    assert not is_its_sum(replace(series, quotient=series.quotient * sp.Rational(9, 10)))
