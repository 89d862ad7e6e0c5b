"""Enclosures of shares by rigorous integrals, and errors relative to them."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np
from cases import BAR, Case, four
from flint import acb, arb, ctx


def enclose(case: Case, precision: int, sizes: list[Any]) -> list[arb]:
    """Return balls around the four shares, from rigorous integrals over the true deviation.

    `sizes`, estimates of the shares, only determine how small the radii should be.
    """
    with_precision, ctx.prec = ctx.prec, precision
    try:
        return _enclose(case, [arb(float(size)) * 2**-58 for size in sizes])
    finally:
        ctx.prec = with_precision


def _enclose(case: Case, radii: list[arb]) -> list[arb]:
    mu, sigma, bias, s = (arb(v) for v in (case.mu, case.sigma, case.bias, case.s))
    far = 45 * sigma  # beyond lies less than 1e-440
    ends = [mu - far, *(arb(t) for t in case.tolerance if np.isfinite(t)), mu + far]
    ends.sort(key=float)
    root, norm = arb(2).sqrt(), 1 / (sigma * (2 * arb.pi()).sqrt())
    low, high = (None if np.isinf(a) else arb(a) - bias for a in case.acceptance)

    def beyond(z: acb) -> acb:
        return (z / root).erfc() / 2

    def density(y: acb) -> acb:
        return norm * (-(((y - mu) / sigma) ** 2) / 2).exp()

    def under(y: acb) -> acb:
        return y * 0 if low is None else beyond((y - low) / s)

    def over(y: acb) -> acb:
        return y * 0 if high is None else beyond((high - y) / s)

    def accepted(y: acb) -> acb:
        above_low = 1 if low is None else beyond((low - y) / s)
        return density(y) * (above_low - over(y))

    def rejected(y: acb) -> acb:
        return density(y) * (under(y) + over(y))

    def integrate(f: Callable[[acb], acb], conforming: bool, radius: arb) -> arb:
        total = arb(0)
        for start, end in pairwise(ends):
            middle = float((start + end) / 2)
            if (case.tolerance[0] < middle < case.tolerance[1]) == conforming:
                kinks = [k + n * s for k in (low, high) if k is not None for n in (-8, 0, 8)]
                inner = [k for k in (*kinks, mu) if float(start) < float(k) < float(end)]
                for p, q in pairwise(sorted([start, *inner, end], key=float)):
                    total += acb.integral(
                        lambda y, _: f(y),
                        acb(p),
                        acb(q),
                        rel_tol=arb(2) ** -56,
                        abs_tol=radius,
                    ).real
        return total

    kinds = ((accepted, True), (accepted, False), (rejected, False), (rejected, True))
    return [integrate(*kind, radius) for kind, radius in zip(kinds, radii, strict=True)]


def relative_errors(got: list[Any], case: Case) -> list[float]:
    """Return errors relative to balls whose relative radius is below a thousandth of the bound."""
    for precision in (160, 480, 1500):
        balls = enclose(case, precision, four(case.shares()))
        if all(float(abs(b.mid())) * BAR / 1000 >= float(b.rad()) for b in balls):
            return [
                float(abs((arb(float(g)) - b.mid()) / b.mid()))
                for g, b in zip(got, balls, strict=True)
            ]
    raise AssertionError(f"no narrow ball for {case}")
