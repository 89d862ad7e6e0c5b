"""Functions that exist for their rounding or speed: exact in SymPy, operations in a backend.

The rests of a sum and a product are doubles themselves. Those of products are computed without a
fused multiply-add, by splitting each factor into halves whose products are exact (Veltkamp 1968,
Dekker 1971). A backend's result is off by no more than each function states.
"""

from __future__ import annotations

import sympy as sp


class ProductRest(sp.Function):  # type: ignore[misc]
    """ProductRest(a, b, p) = a*b - p, p being the rounded a*b. Exact in doubles.

    Below the normal range of the partial products, 2**-969, it is off by some subnormal spacings.
    """

    nargs = 3


class SumRest(sp.Function):  # type: ignore[misc]
    """SumRest(a, b, s) = a + b - s, s being the rounded a + b. Exact in doubles if |b| <= |a|."""

    nargs = 3


class QuotientRest(sp.Function):  # type: ignore[misc]
    """QuotientRest(a, b, q) = a/b - q, q being the rounded a/b. Relative error 2**-53."""

    nargs = 3


class SmallTangent(sp.Function):  # type: ignore[misc]
    """SmallTangent(y) = tan y, y being half of a low word; computed as y, limited to [-1, 1].

    0 <= tan(y)/y - 1 <= y**2 for |y| <= 1: the series of tan has positive coefficients, so the
    middle divided by y**2 grows with |y|, up to tan 1 - 1 < 1. As |y| <= 2**-52*|x|, the angle is
    off by at most 2**-156*|x|**3, which for |x| <= 2**26 is less than 2**-104*|x|, the rounding of
    the low word itself. Where |y| > 1, the double x no longer determines its own turn.
    """

    nargs = 1


class TangentQuotient(sp.Function):  # type: ignore[misc]
    """TangentQuotient(y, c, a, r, b) = c*t/(a + r + b*t**2), t = tan(y); without tan if faster.

    For a, b > 0; r is the rest of a. Off by a few eps of its largest value, and of itself where it
    is near 0 along with y; its other zeros, at multiples of pi/2, are as far off as y.
    """

    nargs = 5


class SmallArctan(sp.Function):  # type: ignore[misc]
    """SmallArctan(y) = atan y, for |y| <= 1/sqrt(3); without arctan where that is faster."""

    nargs = 1


class ArctanQuotient(sp.Function):  # type: ignore[misc]
    """ArctanQuotient(a, b) = atan(a/b), for b > 0; the quotient is not rounded."""

    nargs = 2


class Single(sp.Function):  # type: ignore[misc]
    """Single(a) = a, rounded to float32; results computed from it are float32 too."""

    nargs = 1


class WholeTurnsOff(sp.Function):  # type: ignore[misc]
    """WholeTurnsOff(x) = x less whole turns, which counts as x; only for sines and cosines."""

    nargs = 1
