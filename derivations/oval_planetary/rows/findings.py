"""What is wrong in paper 2, what it costs, and how to see it."""

import sympy as sp

from mechproof.record import Check, Cost, Finding, Weight

from ..._readings import ADEQUACY, DEGREE, costs_of_mean, interval_finding
from ..mechanics import *
from .equations import print_10
from .readings import READINGS
from .variants import VARIANTS, ratio_1

WITH_THE_CARRIER = position_of_one(E_SERIES)
HALF_DEGREE = DEGREE / 2
SECANT = ratio_1.subs(phi1, sp.pi / 4 + HALF_DEGREE) - ratio_1.subs(phi1, sp.pi / 4 - HALF_DEGREE)
# The output if (5) turns wheel 6 as far as the carrier, with the sign of the mechanics.
AS_PRINTED = -integrate(
    print_10.subs(AXES_45).subs(rho6, oval_radius(e2, sp.cos(2 * phi1)).subs(AXES_45))
)


def place(variant: int, degrees: int) -> dict[sp.Symbol, sp.Expr]:
    """Return the sizes of a variant and an angle of the carrier."""
    return {**VARIANTS[variant], phi1: degrees * DEGREE}


FINDINGS = (
    interval_finding(
        READINGS, "(14)", "(15)", called='of the errors, or of "the measured quantities"'
    ),
    Finding(
        ADEQUACY,
        "The text at hand gives neither a criterion of adequacy nor the readings. By the paper's "
        "own numbers the intervals of variants 1, 3 and 4 exclude a mean error of zero.",
        costs=costs_of_mean(READINGS, (1, 3, 4)),
        weight=Weight.CONCLUSION,
        check=Check(
            "Mean error over u in variants 1, 3 and 4: 0.777/0.18 = {0}, 1.280/0.11 = {1}, "
            "0.540/0.15 = {2}, all more than 2.",
            tuple(abs(READINGS[v].mean) / READINGS[v].uncertainty for v in (1, 3, 4)),
            1,
        ),
    ),
    Finding(
        "conclusion 2, acceleration",
        "Conclusion 2 lists the analogue of the acceleration among the results, but the text at "
        "hand has no formula, graph or value of it, and its abstract names only speed and "
        "position.",
        weight=Weight.CONCLUSION,
        mend="acceleration by the model",
        check=Check(
            "Variant 1, 45° of the carrier: with E = 5/13 the acceleration by the model is 4 E (1 "
            "- E²)/(1 + E²)² = {0}; between 44.5° and 45.5° the ratio 1 - (1 - E²)/(1 + E² - 2 E "
            "cos 2 φ_1) changes by {1}, which is {2} per radian.",
            (sp.diff(ratio_1, phi1).subs(phi1, 45 * DEGREE), SECANT, SECANT / DEGREE),
            6,
        ),
    ),
    Finding(
        "special case, angle of wheel 6",
        "For a cylindrical pair 4-5 the text at hand replaces only the radii by numbers. If (5) "
        "is left as printed, with e_1 = 0, φ_6 equals φ_1; without slip φ_6 is R_4/R_5 times as "
        "large, and variant 3 comes to rest three times in a turn, not twice.",
        costs=tuple(
            Cost(
                f"output of variant {variant}, 60° of the carrier",
                "°",
                printed=AS_PRINTED,
                right=position_45,
                at=place(variant, 60),
            )
            for variant in (3, 4)
        ),
        weight=Weight.NUMBER,
        check=Check(
            "Seen from the carrier, a wheel of R_5 = 20 mm on a sun of R_4 = 30 mm turns {0} "
            "times as far as the sun, one of 18 mm on 32 mm {1} times; by (5) with e_1 = 0 it "
            "would be {2}.",
            ((R4 / R5).subs(VARIANTS[3]), (R4 / R5).subs(VARIANTS[4]), sp.S.One),
        ),
    ),
    Finding(
        "(10)",
        "(7) and (10) count the output positive against the carrier's rotation, which the text at "
        "hand does not say. If both angles are counted in the same sense, the output turns the "
        "wrong way.",
        costs=tuple(
            Cost(
                f"variant 1, {degrees}° of the carrier",
                "°",
                printed=-WITH_THE_CARRIER,
                right=WITH_THE_CARRIER,
                at=place(1, degrees),
            )
            for degrees in (30, 60)
        ),
        weight=Weight.WORDING,
        check=Check(
            "In variant 1 at φ_1 = 0, CD = 1.2 a and BC = 0.8 a, so (10) gives {0}; with the "
            "carrier held, wheel 3 turns (1.2/0.8)² = 2.25 times as far as the sun, and with the "
            "sun held 1 - 2.25 = {1} times as far as the carrier.",
            (
                print_10.subs({rho6: sp.Rational("1.2") * a, rho5: sp.Rational("0.8") * a}),
                ratio_1.subs(phi1, 0),
            ),
            2,
        ),
        figure="fig-2",
    ),
)
