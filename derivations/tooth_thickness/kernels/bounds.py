"""Accuracy of the kernels of paper 3, and bounds of what approximations leave out."""

from collections.abc import Callable

import sympy as sp

from mechproof.record import *

from ..mechanics import *

ROLLING = Scale("the way that the chord's end rolls", r_b * sp.Abs(tilt) * (1 + t_c + sp.Abs(tilt)))
# Below that, subnormal numbers have fewer digits.
NORMAL_TILT = (
    sp.Or(sp.Eq(tilt, 0), sp.Ge(sp.Abs(tilt), sp.Rational(1, 10**250))),
    sp.Ge(m, sp.Rational(1, 10**30)),
    sp.Le(m * z, 10**300),
)
value, radicand = sp.symbols("value radicand", positive=True)
CANCELLING = Scale(
    "the value times what its root's difference loses",
    value * (1 + (r_b * t_c) ** 2 / radicand),
    ((value, linearisation_bound), (radicand, linearisation_root.subs(dh, sp.Abs(dh)))),
)
# No square, cube or product of them leaves the range of a double.
SQUARES_IN_RANGE = (
    sp.Or(sp.Eq(dh, 0), sp.Ge(sp.Abs(dh), sp.Rational(1, 10**100))),
    sp.Ge(m, sp.Rational(1, 10**30)),
    sp.Le(m * z, 10**50),
)

# In eps, from 1/2 for an arithmetic operation, 1 for sin and cos, 4 for tan.
ACCURACY = {
    # The cosine squared 2.5, two products, the double pi 1/2.
    "constant_chord": Accuracy(4),
    # Sine 1, pi 1/2, two products 1, at most pi/8 of m, the value at least 0.6 m: 1.7; difference
    # and product 1.
    "chord_height": Accuracy(3),
    # In units of r_b |tilt| (1 + t_c + |tilt|), the terms with t_c being the largest; t = |tilt|:
    # t_c 4.5, cos(alpha) 1.54, r_b 2.54. `along` 7 of t_c |sin(tilt)| and 3.5 of t**2, `across` 8
    # of t_c (1 - cos(tilt)), 2 of t and 2.3 of t**2. For the products, with sin(alpha) 1.5 and with
    # cos(alpha) 2.04, the sum and r_b 3.54 more. The height: at most 12.6 sin(t)/t + 9.2 (1 -
    # cos(t))/t <= 15 for t_c; the thickness twice 8.5 sin(t)/t + 13.6 (1 - cos(t))/t <= 14.2.
    # Searches find a tenth of it: roundings do not add up, and no tangent was found that loses 4
    # eps.
    "height_change": Accuracy(15, ROLLING, NORMAL_TILT),
    "thickness_change": Accuracy(29, ROLLING, NORMAL_TILT),
    # Tangent 4, two products.
    "thickness_change_linear": Accuracy(5),
    # In units of value * (1 + (r_b t_c)**2/radicand): under the root (r_b t_c)**2 with 2 * 8.5 and
    # at most as much of |dh| (2 y_c - |dh|) with 5, halved; cubes 3 * 3 and 3 * 3; squares,
    # products and quotient 4.
    "linearisation_bound": Accuracy(32, CANCELLING, SQUARES_IN_RANGE),
    # As to first order, and a difference of terms on its scale.
    "thickness_error": Accuracy(
        6,
        Scale(
            "the sum of its terms' sizes",
            2 * sp.tan(alpha) * (sp.Abs(dh_gauge) + sp.Abs(e_tip) / 2),
        ),
    ),
}

# First order in the tilt. Taylor: |change - slope*tilt| <= max |curvature| tilt**2/2, and with
# |sin|, |cos| <= 1 the curvature of the height is below r_b (1 + t_c + |tilt|), that of the
# thickness below twice as much. The bound is that with r_b (1 + t_c) <= m (z + pi/4), which is
# proved along with it, and r_b = m z cos(alpha)/2 <= m z/2.
HEIGHT_BOUND = m * tilt**2 * (z * (2 + sp.Abs(tilt)) + sp.pi / 2) / 4
HEIGHT_CURVATURE = -r_b * (sp.cos(alpha + tilt) - (t_c + tilt) * sp.sin(alpha + tilt))
THICKNESS_CURVATURE = -2 * r_b * (sp.sin(alpha + tilt) + (t_c + tilt) * sp.cos(alpha + tilt))
TAYLOR = "Taylor's remainder with |sin|, |cos| <= 1"


def first_order(change: sp.Expr, curvature: sp.Expr) -> Callable[[EmittedForm], Statement]:
    """Return the statement that a form is the tangent at tilt 0, and of the omitted curvature."""

    def states(code: EmittedForm) -> Statement:
        slope = sp.diff(change, tilt)
        return all_of(
            Equality(change.subs(tilt, 0), sp.S.Zero),
            Equality(code.output(), slope.subs(tilt, 0) * tilt),
            Equality(sp.diff(slope, tilt), curvature),
            Holds(sp.Le(r_b * (1 + t_c), m * (2 * z + sp.pi / 2) / 2)),
        )

    return states


# Equation (1) with the exact derivative: the missing part grows by -m z (t_c + tilt) sin(tilt), and
# |sin(tilt)| <= |tilt|, tan(alpha) < 1, integrated, give the bound.
MODEL_BOUND = m * tilt**2 * (sp.pi / 4 + z / 2 + z * sp.Abs(tilt) / 3)


def by_height(code: EmittedForm) -> Statement:
    """State which part of the thickness the product with the height leaves out."""
    missing = thickness_change - code.output()
    return all_of(
        Equality(missing.subs(tilt, 0), sp.S.Zero),
        Equality(sp.diff(missing, tilt), -m * z * (t_c + tilt) * sp.sin(tilt)),
    )


TWENTY_DEGREES = Part(
    "profile angles about 20°, tan(alpha) from 0.363 to 0.365",
    {incline: sp.Interval(sp.Rational("0.363"), sp.Rational("0.365"))},
)


def within_a_hundredth(code: EmittedForm) -> Statement:
    """State that a form is off by at most a hundredth of the height.

    Its error is a line through 0, so that a height of 1 decides.
    """
    off = (code.output() - 2 * dh * sp.tan(alpha)).subs(alpha, sp.atan(incline))
    return all_of(
        Equality(off, off.subs(dh, 1) * dh),
        not_above(off.subs(dh, 1), sp.Rational(1, 100)),
        Holds(sp.Ge(off.subs(dh, 1), -sp.Rational(1, 100), evaluate=False)),
    )
