"""Quantities of paper 3: chords, their changes along the flank, errors of thickness."""

from dataclasses import replace
from functools import partial

import sympy as sp
from sympy import Abs, Eq, Rational, S, cos, pi, sin, tan

from mechproof.record import Argument, Chart, Form, Part, Quantity, Singular

from ..mechanics import *
from . import bounds

MODULE_ARGUMENT = Argument("m", (m,), "module", "mm", usual=(0, 10))
TEETH_ARGUMENT = Argument("z", (z,), "number of teeth, a natural number", usual=(4, 100, 1000))
PROFILE = Argument(
    "alpha", (alpha,), "profile angle of the basic rack", "rad", usual=(0, 0.35, 0.7)
)
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
FLANK = (TILT, MODULE_ARGUMENT, TEETH_ARGUMENT, PROFILE)
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


# Of a chord given by its flank's tangent, in units of the base radius.
distance = partial(chord_distance, half_angle=half_tooth, radius=S.One)
half_chord = partial(chord_half, half_angle=half_tooth, radius=S.One)
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

# Of two errors, the smaller one is a share of the larger; the larger one is not negative, up to a
# change of both signs.
SHARE = sp.Symbol("share")


def by_larger(larger: sp.Symbol, smaller: sp.Symbol, most: sp.Expr) -> Chart:
    """Return the chart of two errors, the smaller at most `most` times the larger."""
    arguments = {larger: larger, smaller: most * larger * SHARE, alpha: alpha}
    return Chart(WHERE, arguments, {larger: LENGTHS, SHARE: sp.Interval(-1, 1), **ANGLES})


ERRORS_NEGATED = ((e_tip, dh_gauge),)
ERRORS = (by_larger(dh_gauge, e_tip, 2), by_larger(e_tip, dh_gauge, sp.Rational(1, 2)))

# Wheels with many teeth have a small inverse of their number.
INVERSE = sp.Symbol("1/z", positive=True)


def tilt_chart(side: sp.Expr) -> Chart:
    """Return the chart of tilts to one side."""
    arguments = {tilt: side, m: m, z: 1 / INVERSE, alpha: alpha}
    within = {m: LENGTHS, INVERSE: sp.Interval(0, 1), **ANGLES, tilt: sp.Interval(0, 1)}
    return Chart(f"|tilt| <= 1 and {WHERE}", arguments, within)


FLANK_CHARTS = (tilt_chart(tilt), tilt_chart(-tilt))

# A depth may be at least this share of the module before the chord reaches the base circle.
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


def handbook(factor: str) -> Form:
    """Return the form that handbooks print for 20 degrees."""
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
        (MODULE_ARGUMENT, PROFILE),
        chord,
        # The paper's 4.161 mm is for a module of 3 mm.
        (Form("squared cosine", chord, charts=RACK), handbook("1.387")),
        f"{SOURCE}, design data; basic rack",
        unit="mm",
        accuracy=bounds.ACCURACY["constant_chord"],
    ),
    Quantity(
        "chord_height",
        "Compute the height from the tip circle to the constant chord, addendum of one module.",
        (MODULE_ARGUMENT, PROFILE),
        chord_height,
        # So is 2.243 mm.
        (Form("double angle", chord_height, charts=RACK), handbook("0.7476")),
        f"{SOURCE}, design data; basic rack",
        unit="mm",
        accuracy=bounds.ACCURACY["chord_height"],
    ),
    Quantity(
        "height_change",
        "Compute how much deeper than the constant chord the chord lies, by its flank's tangent.",
        FLANK,
        height_change,
        (
            Form(SHIPPED, height_change, ("cosine_minus_one",), charts=FLANK_CHARTS),
            Form(
                "difference of two distances",
                r_b * (distance(alpha) - distance(alpha + tilt)),
                key="distances",
            ),
            Form(
                "first order in the tilt",
                -r_b * t_c * cos(alpha) * tilt,
                key="first_order",
                bound=bounds.HEIGHT_BOUND,
                states=bounds.first_order(height_change, bounds.HEIGHT_CURVATURE),
                note=bounds.TAYLOR,
            ),
        ),
        f"{SOURCE}, step 6, on the involute",
        unit="mm",
        accuracy=bounds.ACCURACY["height_change"],
        singular=ALONG_THE_FLANK,
        workloads=ONE_WHEEL,
    ),
    Quantity(
        "thickness_change",
        "Compute how much thicker than the constant chord the chord is, by its flank's tangent.",
        FLANK,
        thickness_change,
        (
            Form(SHIPPED, thickness_change, ("cosine_minus_one",), charts=FLANK_CHARTS),
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
                bound=2 * bounds.HEIGHT_BOUND,
                states=bounds.first_order(thickness_change, bounds.THICKNESS_CURVATURE),
                note=bounds.TAYLOR,
            ),
            Form(
                "2 tan(alpha) times the height",
                K_m * height_change,
                ("cosine_minus_one",),
                key="by_height",
                bound=bounds.MODEL_BOUND,
                states=bounds.by_height,
                source=f"{SOURCE}, step 6 with the exact derivative",
                note="the derivative of what is missing is proved; |sin(tilt)| <= |tilt|, "
                "integrated",
            ),
        ),
        f"{SOURCE}, step 6, on the involute",
        unit="mm",
        accuracy=bounds.ACCURACY["thickness_change"],
        singular=ALONG_THE_FLANK,
        workloads=ONE_WHEEL,
    ),
    Quantity(
        "thickness_change_linear",
        "Compute the change of thickness with the height to first order, on the rack exactly.",
        (replace(HEIGHT, usual=(0, 0.1, 10)), PROFILE),
        LINEAR,
        (
            Form("tangent", LINEAR, charts=DEPTHS),
            Form(
                "printed (1)",
                PRINTED_INFLUENCE * dh,
                key="printed",
                states=bounds.within_a_hundredth,
                holds_on=bounds.TWENTY_DEGREES,
                source=f"{SOURCE}, equation (1)",
                note="judged, as (1), to a hundredth of Delta_h; 2*tan(20 deg) = 0.7279, and it is "
                "not meant for other angles",
            ),
        ),
        f"{SOURCE}, equation (1) with the exact derivative",
        unit="mm",
        accuracy=bounds.ACCURACY["thickness_change_linear"],
        singular=(Singular(Eq(dh, 0)),),
    ),
    Quantity(
        "linearisation_bound",
        "Bound the excess of the first order over the exact change of thickness; it is >= 0.",
        (HEIGHT, MODULE_ARGUMENT, TEETH_ARGUMENT, PROFILE),
        linearisation_bound,
        (
            Form(
                "Taylor's remainder",
                linearisation_bound,
                charts=(SHALLOW,),
                mirrors=DEPTH_NEGATED,
            ),
        ),
        f"{SOURCE}, step 6, second derivative on the involute",
        unit="mm",
        accuracy=bounds.ACCURACY["linearisation_bound"],
        on=ABOVE_BASE_CIRCLE,
        singular=(Singular(Eq(dh, 0)),),
        workloads=(("N depths, one wheel", ("dh",)),),
    ),
    Quantity(
        "thickness_error",
        "Compute the error of thickness from the tip diameter and the gauge's height.",
        (TIP, GAUGE, PROFILE),
        ERROR,
        (
            Form("tangent", ERROR, charts=ERRORS, mirrors=ERRORS_NEGATED),
            Form(
                "printed (1), steps 5 and 6",
                PRINTED_INFLUENCE * (e_tip + dh_gauge),
                key="printed",
                source=f"{SOURCE}, equation (1) and step 5",
                note="takes the diameter for the radius and, as no sign is printed, the tip's part "
                "with the sign of the gauge's; 0.7284 approximates 2*tan(20 deg) = 0.7279",
            ),
        ),
        f"{SOURCE}, steps 5 and 6 corrected",
        unit="mm",
        accuracy=bounds.ACCURACY["thickness_error"],
        singular=(Singular(Eq(dh_gauge, e_tip / 2)),),
        workloads=(("N errors, one wheel", ("e_tip", "height_error")),),
    ),
)
