"""What can be computed of paper 3: chords, their changes along the flank, errors of thickness."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from sympy import Abs, Eq, Expr, Ge, Le, Or, Rational, S, cos, diff, pi, sin, symbols, tan

from mechproof.record import (
    Accuracy,
    Argument,
    Conjunction,
    Equality,
    Form,
    Holds,
    Part,
    Quantity,
    Scale,
    Singular,
    Statement,
    Written,
)

from .paper import (
    PRINTED_INFLUENCE,
    K_m,
    alpha,
    chord,
    chord_distance,
    chord_half,
    chord_height,
    dh,
    dh_gauge,
    e_tip,
    half_tooth,
    height_change,
    linearisation_bound,
    linearisation_root,
    m,
    r_b,
    t_c,
    thickness_change,
    tilt,
    y_c,
    z,
)

MODULE = Argument("m", (m,), "module", "mm", usual=(0, 10))
TEETH = Argument("z", (z,), "number of teeth, a natural number", usual=(4, 100, 1000))
ANGLE = Argument("alpha", (alpha,), "profile angle of the basic rack", "rad", usual=(0, 0.35, 0.7))
HEIGHT = Argument("dh", (dh,), "how much deeper than nominal the chord lies", "mm", usual=(0, 0.1))
TILT = Argument(
    "tilt",
    (tilt,),
    "angle of the flank's tangent with its tangent at the constant chord",
    "rad",
    usual=(0, 1e-4, 1e-3, 1e-2, 1e-1, 0.5),
)
TIP = Argument("e_tip", (e_tip,), "deviation of the tip diameter", "mm", usual=(0, 0.1))
GAUGE = Argument(
    "height_error",
    (dh_gauge,),
    "error of the gauge's height, positive if set too deep",
    "mm",
    usual=(0, 0.1),
)
FLANK = (TILT, MODULE, TEETH, ANGLE)
ABOVE_BASE_CIRCLE = Part(
    "the chord lies no deeper than the base circle and no higher than the tip",
    where=(Abs(dh) <= y_c - r_b,),
)
ALONG_THE_FLANK = (
    Singular(Eq(tilt, 0)),
    Singular(Eq(alpha + tilt, 0)),
    Singular(Eq(alpha + tilt, pi / 2)),
)
ONE_WHEEL = (("N tilts, one wheel", ("tilt",)),)

# Accuracy, in eps, from 1/2 for an arithmetic operation, 1 for sin and cos, 4 for tan.
# constant_chord: the cosine squared 2.5, two products, the double pi 1/2.
CHORD_ULP = 4
# chord_height: sine 1, pi 1/2, two products 1, at most pi/8 of m, the value at least 0.6 m: 1.7;
# difference and product 1.
HEIGHT_ULP = 3
# thickness_change_linear: tangent 4, two products.
LINEAR_ULP = 5
# thickness_error: the same and a difference of terms on its scale.
ERROR_ULP = 6
# height_change, thickness_change, in units of r_b |tilt| (1 + t_c + |tilt|), the terms with t_c
# being the largest; t = |tilt|: t_c 4.5, cos(alpha) 1.54, r_b 2.54. `along` 7 of t_c |sin(tilt)|
# and 3.5 of t**2, `across` 8 of t_c (1 - cos(tilt)), 2 of t and 2.3 of t**2. Of the products with
# sin(alpha) 1.5 and with cos(alpha) 2.04, the sum and r_b 3.54 more. The height: at most
# 12.6 sin(t)/t + 9.2 (1 - cos(t))/t <= 15 for t_c; the thickness twice
# 8.5 sin(t)/t + 13.6 (1 - cos(t))/t <= 14.2. Searches find a tenth of it: roundings do not add
# up, and no tangent was met that loses 4 eps.
HEIGHT_CHANGE_ULP, THICKNESS_CHANGE_ULP = 15, 29
ROLLING = Scale("the way that the chord's end rolls", r_b * Abs(tilt) * (1 + t_c + Abs(tilt)))
# Below that, subnormal numbers have fewer digits.
NORMAL_TILT = (Or(Eq(tilt, 0), Ge(Abs(tilt), Rational(1, 10**250))), Ge(m, Rational(1, 10**30)))
# linearisation_bound, in units of value * (1 + (r_b t_c)**2/radicand): under the root (r_b t_c)**2
# with 2 * 8.5 and as much at most of |dh| (2 y_c - |dh|) with 5, halved; cubes 3 * 3 and 3 * 3;
# squares, products and quotient 4.
BOUND_ULP = 32
value, radicand = symbols("value radicand", positive=True)
CANCELLING = Scale(
    "the value times what its root's difference loses",
    value * (1 + (r_b * t_c) ** 2 / radicand),
    ((value, linearisation_bound), (radicand, linearisation_root.subs(dh, Abs(dh)))),
)
# No square and no cube leaves the range of a double.
SQUARES_IN_RANGE = (
    Or(Eq(dh, 0), Ge(Abs(dh), Rational(1, 10**100))),
    Ge(m, Rational(1, 10**30)),
    Le(m, 10**50),
)

# First order in the tilt. Taylor: |change - slope*tilt| <= max |curvature| tilt**2/2, and with
# |sin|, |cos| <= 1 the curvature of the height is below r_b (1 + t_c + |tilt|), that of the
# thickness below twice as much. The bound is that with r_b (1 + t_c) <= m (z + pi/4), which is
# proved along with it, and r_b = m z cos(alpha)/2 <= m z/2.
HEIGHT_BOUND = m * tilt**2 * (z * (2 + Abs(tilt)) + pi / 2) / 4
HEIGHT_CURVATURE = -r_b * (cos(alpha + tilt) - (t_c + tilt) * sin(alpha + tilt))
THICKNESS_CURVATURE = -2 * r_b * (sin(alpha + tilt) + (t_c + tilt) * cos(alpha + tilt))
TAYLOR = "Taylor's remainder with |sin|, |cos| <= 1"


def first_order(change: Expr, curvature: Expr) -> Callable[[Written], Statement]:
    """Make the statement that a form is the tangent at tilt 0, with the curvature it leaves out."""

    def states(code: Written) -> Statement:
        slope = diff(change, tilt)
        return Conjunction(
            (
                Equality(change.subs(tilt, 0), S.Zero),
                Equality(code.output(), slope.subs(tilt, 0) * tilt),
                Equality(diff(slope, tilt), curvature),
                Holds(Le(r_b * (1 + t_c), m * (2 * z + pi / 2) / 2)),
            )
        )

    return states


# Equation (1) with the exact derivative: what is missing grows by -m z (t_c + tilt) sin(tilt), and
# |sin(tilt)| <= |tilt|, tan(alpha) < 1, integrated, give the bound.
MODEL_BOUND = m * tilt**2 * (pi / 4 + z / 2 + z * Abs(tilt) / 3)


def by_height(code: Written) -> Statement:
    """State how much of the thickness the product with the height leaves out."""
    missing = thickness_change - code.output()
    return Conjunction(
        (
            Equality(missing.subs(tilt, 0), S.Zero),
            Equality(diff(missing, tilt), -m * z * (t_c + tilt) * sin(tilt)),
        )
    )


def distance(slope: Expr) -> Expr:
    """Distance of a chord from the wheel's centre in units of the base radius."""
    return chord_distance(slope, half_tooth, S.One)


def half_chord(slope: Expr) -> Expr:
    """Half a chord in units of the base radius."""
    return chord_half(slope, half_tooth, S.One)


versine = 2 * sin(tilt / 2) ** 2
HALF_ANGLES = (
    -2
    * r_b
    * (
        ((t_c + tilt) * sin(tilt) - versine) * sin(alpha)
        + (t_c * versine + sin(tilt) - tilt * cos(tilt)) * cos(alpha)
    )
)
LINEAR = 2 * dh * tan(alpha)
ERROR = 2 * tan(alpha) * (dh_gauge - e_tip / 2)
SHIPPED = "along and across the first tangent"
SOURCE = "paper on tooth thickness"


def handbook(factor: str) -> Form:
    """Make the form that handbooks print for 20 degrees."""
    return Form(
        f"{factor} m",
        Rational(factor) * m,
        key="handbook",
        note="printed for a profile angle of 20 deg, rounded; wrong for every other",
    )


QUANTITIES = (
    Quantity(
        "constant_chord",
        "Compute the constant chord, between the points where a rack touches both flanks.",
        (MODULE, ANGLE),
        chord,
        # 4.161 mm of the paper is for a module of 3 mm.
        (Form("squared cosine", chord), handbook("1.387")),
        f"{SOURCE}, design data; basic rack",
        unit="mm",
        accuracy=Accuracy(CHORD_ULP),
    ),
    Quantity(
        "chord_height",
        "Compute the height from the tip circle to the constant chord, addendum of one module.",
        (MODULE, ANGLE),
        chord_height,
        # So is 2.243 mm.
        (Form("double angle", chord_height), handbook("0.7476")),
        f"{SOURCE}, design data; basic rack",
        unit="mm",
        accuracy=Accuracy(HEIGHT_ULP),
    ),
    Quantity(
        "height_change",
        "Compute how much deeper than the constant chord the chord lies, by its flank's tangent.",
        FLANK,
        height_change,
        (
            Form(SHIPPED, height_change, ("cosine_minus_one",)),
            Form(
                "difference of two distances",
                r_b * (distance(alpha) - distance(alpha + tilt)),
                key="distances",
            ),
            Form(
                "first order in the tilt",
                -r_b * t_c * cos(alpha) * tilt,
                key="first_order",
                bound=HEIGHT_BOUND,
                states=first_order(height_change, HEIGHT_CURVATURE),
                note=TAYLOR,
            ),
        ),
        f"{SOURCE}, step 6, on the involute",
        unit="mm",
        accuracy=Accuracy(HEIGHT_CHANGE_ULP, ROLLING, NORMAL_TILT),
        singular=ALONG_THE_FLANK,
        workloads=ONE_WHEEL,
    ),
    Quantity(
        "thickness_change",
        "Compute how much thicker than the constant chord the chord is, by its flank's tangent.",
        FLANK,
        thickness_change,
        (
            Form(SHIPPED, thickness_change, ("cosine_minus_one",)),
            Form(
                "difference of two chords",
                2 * r_b * (half_chord(alpha + tilt) - half_chord(alpha)),
                key="chords",
            ),
            Form("half angles, by hand", HALF_ANGLES, key="half_angle"),
            Form(
                "first order in the tilt",
                -2 * r_b * t_c * sin(alpha) * tilt,
                key="first_order",
                bound=2 * HEIGHT_BOUND,
                states=first_order(thickness_change, THICKNESS_CURVATURE),
                note=TAYLOR,
            ),
            Form(
                "2 tan(alpha) times the height",
                K_m * height_change,
                ("cosine_minus_one",),
                key="by_height",
                bound=MODEL_BOUND,
                states=by_height,
                source=f"{SOURCE}, step 6 with the exact derivative",
                note="the derivative of what is missing is proved; |sin(tilt)| <= |tilt|, "
                "integrated",
            ),
        ),
        f"{SOURCE}, step 6, on the involute",
        unit="mm",
        accuracy=Accuracy(THICKNESS_CHANGE_ULP, ROLLING, NORMAL_TILT),
        singular=ALONG_THE_FLANK,
        workloads=ONE_WHEEL,
    ),
    Quantity(
        "thickness_change_linear",
        "Compute the change of thickness with the height to first order, on the rack exactly.",
        (replace(HEIGHT, usual=(0, 0.1, 10)), ANGLE),
        LINEAR,
        (
            Form("tangent", LINEAR),
            Form(
                "printed (1)",
                PRINTED_INFLUENCE * dh,
                key="printed",
                source=f"{SOURCE}, equation (1)",
                note="0.7284 is meant for 20 deg, where 2*tan(alpha) = 0.7279",
            ),
        ),
        f"{SOURCE}, equation (1) with the exact derivative",
        unit="mm",
        accuracy=Accuracy(LINEAR_ULP),
        singular=(Singular(Eq(dh, 0)),),
    ),
    Quantity(
        "linearisation_bound",
        "Bound the excess of the first order over the exact change of thickness; it is >= 0.",
        (HEIGHT, MODULE, TEETH, ANGLE),
        linearisation_bound,
        (Form("Taylor's remainder", linearisation_bound),),
        f"{SOURCE}, step 6, second derivative on the involute",
        unit="mm",
        accuracy=Accuracy(BOUND_ULP, CANCELLING, SQUARES_IN_RANGE),
        on=ABOVE_BASE_CIRCLE,
        singular=(Singular(Eq(dh, 0)),),
        workloads=(("N depths, one wheel", ("dh",)),),
    ),
    Quantity(
        "thickness_error",
        "Compute the error of thickness from the tip diameter and the gauge's height.",
        (TIP, GAUGE, ANGLE),
        ERROR,
        (
            Form("tangent", ERROR),
            Form(
                "printed (1), steps 5 and 6",
                PRINTED_INFLUENCE * (e_tip + dh_gauge),
                key="printed",
                source=f"{SOURCE}, equation (1) and step 5",
                note="takes the diameter for the radius and has the wrong sign for the tip; "
                "0.7284 is 2*tan(20 deg) = 0.7279",
            ),
        ),
        f"{SOURCE}, steps 5 and 6 corrected",
        unit="mm",
        accuracy=Accuracy(
            ERROR_ULP,
            Scale(
                "the sum of its terms' sizes",
                2 * tan(alpha) * (Abs(dh_gauge) + Abs(e_tip) / 2),
            ),
        ),
        singular=(Singular(Eq(dh_gauge, e_tip / 2)),),
        workloads=(("N errors, one wheel", ("e_tip", "height_error")),),
    ),
)
