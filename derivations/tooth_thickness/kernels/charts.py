"""Coordinates over which the rounding errors of paper 3 are bounded."""

import sympy as sp

from mechproof.record import Chart

from ..mechanics import *

# A profile angle is less than pi/4.
UP_TO = sp.Rational(11, 14)
WHERE = f"alpha <= {UP_TO}"
ANGLES, LENGTHS, SIGNED = (
    {alpha: sp.Interval(0, UP_TO)},
    sp.Interval(0, sp.oo),
    sp.Interval(-sp.oo, sp.oo),
)
RACK = (Chart(WHERE, {m: m, alpha: alpha}, {m: LENGTHS, **ANGLES}),)
DEPTHS = (Chart(WHERE, {dh: dh, alpha: alpha}, {dh: SIGNED, **ANGLES}),)

# Of two errors of which either is larger one is a share of the other; the larger one is not
# negative, but for the signs of both.
SHARE = sp.Symbol("share")


def by_larger(larger: sp.Symbol, smaller: sp.Symbol, most: sp.Expr) -> Chart:
    """Make the chart of two errors, one at most so many times the other."""
    arguments = {larger: larger, smaller: most * larger * SHARE, alpha: alpha}
    return Chart(WHERE, arguments, {larger: LENGTHS, SHARE: sp.Interval(-1, 1), **ANGLES})


ERRORS_NEGATED = ((e_tip, dh_gauge),)
ERRORS = (by_larger(dh_gauge, e_tip, 2), by_larger(e_tip, dh_gauge, sp.Rational(1, 2)))

# Wheels with many teeth are those with a small inverse of their number.
INVERSE = sp.Symbol("1/z", positive=True)


def tilt_chart(side: sp.Expr) -> Chart:
    """Make the chart of tilts to one side."""
    arguments = {tilt: side, m: m, z: 1 / INVERSE, alpha: alpha}
    within = {m: LENGTHS, INVERSE: sp.Interval(0, 1), **ANGLES, tilt: sp.Interval(0, 1)}
    return Chart(f"|tilt| <= 1 and {WHERE}", arguments, within)


FLANK_CHARTS = (tilt_chart(tilt), tilt_chart(-tilt))

# A depth may be this share of the module at least before the chord is at the base circle.
DEPTH = sp.Symbol("|dh|/m")
SHALLOW = Chart(
    f"1/4 <= {WHERE} and |dh| <= 3/16*m",
    {dh: m * DEPTH, m: m, z: 1 / INVERSE, alpha: alpha},
    {
        m: LENGTHS,
        INVERSE: sp.Interval(0, 1),
        alpha: sp.Interval(sp.Rational(1, 4), UP_TO),
        DEPTH: sp.Interval(0, sp.Rational(3, 16)),
    },
)
DEPTH_NEGATED = ((dh,),)
