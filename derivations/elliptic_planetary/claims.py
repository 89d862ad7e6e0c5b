"""What paper 1 says of its position functions."""

from __future__ import annotations

from sympy import (
    Expr,
    Ge,
    Integral,
    atan,
    diff,
    oo,
    pi,
    sqrt,
    tan,
)

from mechproof.record import (
    Claim,
    Conjunction,
    Correction,
    Equality,
    Holds,
    PrintedNumber,
    Reading,
)

from .mechanics import position, position_closed, position_principal
from .position_rows import CORRECT_12, print_12
from .ratio_rows import print_8
from .symbols import BRANCH, R1, R2, VARIANTS, U, e, k, phi1, phi5, ratio_symbol, tau, x

# What (12) lacks on its first branch, by U = tg(x/2), and where that ends, in degrees.
ROOT = sqrt((1 - e) / (1 + e))
LACK = 2 * atan(U * (1 + e) / (1 - e)) - 2 * ROOT * atan(U / ROOT)
BRANCH_END = 180 * R2 / R1


def of_variant(expression: Expr, number: int) -> Expr:
    """Put the sizes of table 1 into an expression."""
    return expression.subs(k, R1 / R2).subs(dict(zip((R1, R2, e), VARIANTS[number], strict=True)))


def lack_at_branch_end(number: int) -> Expr:
    """Return by how many degrees (12) is too small as x nears half a turn."""
    # Arctangents are continuous at infinity: their values there are the limits.
    return of_variant(LACK, number).subs(U, oo) * 180 / pi


POSITION_CLAIMS = (
    Claim(
        "(12), first branch in degrees",
        r"|\varphi_1|<\pi\frac{R_2}{R_1}:\ 43.6^\circ,\ 67.5^\circ",
        Conjunction(
            (
                PrintedNumber("43.6", of_variant(BRANCH_END, 1)),
                PrintedNumber("67.5", of_variant(BRANCH_END, 3)),
            )
        ),
        note="Variants 1 and 2, variants 3 and 4: beyond it the arctangent of (12) falls back.",
        marks=("ours",),
    ),
    Claim(
        "(12), size of its error",
        r"0\le\varphi_3-(12)<\pi\left(1-\sqrt{\tfrac{1-e}{1+e}}\right),\ 0\le x<\pi:\ "
        r"45.0^\circ,\ 72.6^\circ",
        Conjunction(
            (
                Equality(LACK.subs(U, tan(x / 2)), position_principal - print_12),
                Holds(Ge(diff(LACK, U), 0)),
                PrintedNumber("45.0", lack_at_branch_end(1)),
                PrintedNumber("72.6", lack_at_branch_end(2)),
            )
        ),
        note="What (12) lacks grows with x over the first branch, up to 45.0 deg for e = 0.28 and "
        "72.6 deg for e = 0.475, whatever the radii.",
        on=BRANCH,
        marks=("ours",),
    ),
    Claim(
        "(12) gives the position function",
        r"\text{equation (12) gives the calculated position function}",
        Equality(print_12, position),
        note="Follows from (12); not a second error.",
        corrected=Correction(CORRECT_12, Equality(position_closed, position)),
    ),
    Claim(
        "Fig. 3, formula used",
        r"\text{using formula (8) we build the position functions}",
        Equality(print_8, position),
        readings=(
            Reading(
                "(8) is integrated from phi1 = 0, as in (9)",
                Equality(Integral(print_8.subs(phi5, -R1 / R2 * tau), (tau, 0, phi1)), position),
            ),
        ),
        note="(8) itself is the ratio. Read as a cross-reference to (12), which the text calls the "
        "position function, the figure shares the error of (12).",
    ),
    Claim(
        "extremes of the ratio",
        r"1+\frac{R_1}{R_2}\cdot\frac{1-e}{1+e}\le\varphi_3'\le"
        r"1+\frac{R_1}{R_2}\cdot\frac{1+e}{1-e}",
        derived={ratio_symbol: print_8},
        note="Reached at x = pi and x = 0 modulo 2 pi.",
        marks=("ours",),
    ),
)
