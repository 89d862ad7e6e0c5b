"""What the errors of the kernels of paper 2 are relative to, and where their bounds hold."""

from __future__ import annotations

import sympy as sp

from mechproof.record import Scale

from .forms_of_ovals import POSITION_FORM, SPREAD_FORM, TILT
from .positions import ACCELERATION_CYLINDRICAL, GIVEN, RATIO_CYLINDRICAL, t
from .symbols import R4, R5, both, e1, e2, k, less, lever, mount, phi1, rise, shift, swing, x, y

# Accuracy. The terms of y = shift + rise*t are rounded, and where they cancel the value makes of
# that what no evaluation from a rounded tangent is spared: up to 1/(1 - e2), where the major axes
# of the pair 6-3 meet away from phi1 = 0. So the scales are the largest term, and added to it what
# the value makes of y with its terms changed against each other, 0 without a mount; at the peak of
# the ratio, where less + y vanishes, that is of second order in eps. The rest is some 20
# operations; the bounds lie above what long searches for the worst input find, compiled.
# At its peak the acceleration goes with the cube of (1 - e1)*(1 - e2), three roundings where both
# eccentricities are below 1/2: 4 eps that the rest of the product saves. Beside a mounted wheel two
# terms of like size meet, each with roundings of its own.
EPS = sp.Rational(1, 2**52)
T, R, S, W, Z, VALUE = sp.symbols("t R S W Z value", real=True)
OF_T = {t: T}
STEPS = (
    (T, t),
    *((step, GIVEN[step]) for step in (both, less, lever, rise, shift)),
    (y, GIVEN[y].xreplace(OF_T)),
    (S, SPREAD_FORM.xreplace(OF_T)),
)
WHEEL_3 = (W, both * (less + shift) * (1 + T**2) / S)
CHANGE = rise * T - shift
RATIO_SCALE = Scale(
    "the larger of 1 and W, and what the roundings of y make of it",
    sp.Max(1, W) + sp.Abs(W * (less + y) * CHANGE / S) + EPS * W * CHANGE**2 / S,
    (*STEPS, WHEEL_3),
)
POSITION_SCALE = Scale(
    "the value or its largest term, and what the roundings of y make of it",
    sp.Max(sp.Abs(VALUE), sp.Abs(y * sp.sin(phi1)) / R, swing * sp.Abs(sp.sin(phi1)) / R)
    + sp.Abs(both * T * CHANGE) / (2 * S),
    (*STEPS, (swing, GIVEN[swing]), (R, sp.sqrt(S)), (VALUE, POSITION_FORM.xreplace(OF_T))),
)
ACCELERATION_SCALE = Scale(
    "the value or its largest term, and what the roundings of y make of it",
    W
    / S
    * (
        2
        * sp.Max(
            sp.Abs(Z),
            sp.Abs(y * (rise - shift * T)),
            less * sp.Abs(rise) * (1 + T**2),
            swing * (less + both) * sp.Abs(T),
            2 * less * shift * sp.Abs(T),
            sp.Abs(y * (rise + shift * T)) / 2,
        )
        + sp.Abs((rise - shift * T - 4 * (less + y) * Z / S) * CHANGE)
    ),
    (*STEPS, WHEEL_3, (swing, GIVEN[swing]), (Z, sum(TILT).xreplace(OF_T))),
)

# Products with an eccentricity and the angle or the mount stay above the subnormals, with all
# their digits.
NO_UNDERFLOW = (
    sp.Or(
        sp.Eq(phi1, 0),
        sp.Eq(e1 + e2, 0),
        sp.Ge(sp.Abs(phi1) * (e1 + e2), sp.Rational(1, 2**960)),
    ),
    sp.Or(sp.Eq(mount, 0), sp.Eq(e2, 0), sp.Ge(sp.Abs(mount) * e2, sp.Rational(1, 2**830))),
)

# With the low word, x is known to eps**2 relative, and what is left are the roundings of some 20
# operations, tan and atan within an ulp; the bounds lie above what searches find, as before.
# What the error of x itself makes, eps**2*|x| times the slope, counts where the acceleration passes
# through zero, and beside it only far away near e2 = 1. The slope of the acceleration has the
# envelope of |sin x|, |cos x| <= 1.
LOW_WORD = (sp.Abs(x) <= 2**26,)
NO_UNDERFLOW_OF_LEAD = (
    sp.Or(sp.Eq(phi1, 0), sp.Eq(e2, 0), sp.Ge(sp.Abs(phi1) * e2, sp.Rational(1, 2**960))),
)

# Beside half turns of x the acceleration divides by a power of the tangent before it multiplies.
NO_UNDERFLOW_OF_QUOTIENT = (sp.Or(sp.Eq(e2, 0), sp.Ge(e2, sp.Rational(1, 2**330))),)
# k**2, times a tiny e2, and divided by what is tiny where e2 is next to 1.
SQUARE_OF_SPEED = (R4 >= R5 / 10**45, R4 <= 10**130 * R5)
EPS_X = EPS * sp.Abs(x)
OF_X = ((k, GIVEN[k]), (x, GIVEN[x]))
LEAD = sp.atan2(e2 * sp.sin(x), 1 - e2 * sp.cos(x))
RATIO_CYLINDRICAL_SCALE = Scale(
    "the larger of 1 and 1 - value, and what eps*x makes of it",
    sp.Max(1, 1 - RATIO_CYLINDRICAL) + EPS_X * sp.Abs(sp.diff(RATIO_CYLINDRICAL, x)),
    OF_X,
)
POSITION_CYLINDRICAL_SCALE = Scale(
    "the larger of both terms, and what eps*x makes of the second",
    sp.Max(sp.Abs((R5 - R4) / R5 * phi1), sp.Abs(LEAD)) + EPS_X * sp.Abs(sp.diff(LEAD, x)),
    OF_X,
)
ACCELERATION_CYLINDRICAL_SCALE = Scale(
    "the value and what eps*x makes of it",
    sp.Abs(ACCELERATION_CYLINDRICAL)
    + EPS_X * 4 * e2 * k**2 * (1 - e2**2) / (1 + e2**2 - 2 * e2 * sp.cos(x)) ** 2,
    OF_X,
)
