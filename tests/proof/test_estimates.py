"""SymPy's numerical estimates of integrals and sums are refused in proofs, and only there."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from threading import Barrier

import pytest
import sympy as sp

from mechproof.record.estimates import without_estimates

x = sp.Symbol("x", real=True)
n = sp.Symbol("n", integer=True)


@pytest.mark.parametrize(
    "estimated",
    [
        sp.Integral(sp.exp(-(x**2)), (x, 0, 1)),
        sp.Sum(1 / (n**3 + 1), (n, 1, sp.oo)),
        sp.Product(1 + 2**-n, (n, 1, 4)),
    ],
)
def test_what_is_estimated_is_refused_within_and_nowhere_else(estimated: sp.Expr) -> None:
    known = estimated.evalf(15)
    assert known.is_Float
    with without_estimates():
        assert not estimated.evalf(14).is_Float
        assert (1 + sp.sqrt(2)).evalf(14).is_Float
    assert estimated.evalf(15) == known


def test_a_thread_refuses_for_itself() -> None:
    integral, meeting = sp.Integral(sp.exp(-(x**2)), (x, 0, 1)), Barrier(2, timeout=30)

    def refuse() -> bool:
        with without_estimates():
            meeting.wait()
            meeting.wait()
            return not integral.evalf(13).is_Float

    def estimate() -> bool:
        meeting.wait()
        found = integral.evalf(13).is_Float
        meeting.wait()
        return bool(found)

    with ThreadPoolExecutor(2) as threads:
        done = [threads.submit(one) for one in (refuse, estimate)]
        assert [one.result() for one in done] == [True, True]
    assert integral.evalf(13).is_Float
