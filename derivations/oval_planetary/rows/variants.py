"""The variants of paper 2, the motions they make, and what is said of these."""

import sympy as sp

from mechproof.record import *

from ..._readings import millimetre
from ..mechanics import *
from .equations import print_5
from .pairs import advances

VARIANTS = {
    1: {e1: sp.Rational("0.2"), e2: sp.Rational("0.2")},
    2: {R4: sp.Integer(25), R5: sp.Integer(25), e2: sp.Rational("0.2")},
    3: {R4: sp.Integer(30), R5: sp.Integer(20), e2: sp.Rational("0.2")},
    4: {R4: sp.Integer(32), R5: sp.Integer(18), e2: sp.Rational("0.2")},
}


def with_cylinders(expression: sp.Expr, variant: int) -> sp.Expr:
    """Put the sizes of a variant with a cylindrical pair 4-5 into an expression."""
    return expression.subs(VARIANTS[variant])


def with_radii(variant: int, angle_of_6: sp.Expr) -> sp.Expr:
    """Ratio by the velocity plan with numbers for pair 4-5, any angle of wheel 6."""
    radius = oval_radius(e2, sp.cos(2 * angle_of_6)).subs(AXES_45)
    return with_cylinders(ratio_by_plan.subs(AXES_45).subs(rho6, radius), variant)


position_1 = position_of_one(E_SERIES).subs(VARIANTS[1])
ratio_1 = ratio_of_one(E_SERIES).subs(VARIANTS[1])
DWELL_3 = sp.pi / 3


def reverses(ratio: sp.Expr) -> tuple[Holds, Holds]:
    """State that the ratio is negative at the carrier angle 0 and positive at a right angle."""
    start, quarter = (ratio.subs(phi1, angle) for angle in (sp.S.Zero, sp.pi / 2))
    return less(start, sp.S.Zero), less(sp.S.Zero, quarter)


# The turn of wheel 6 with a cylindrical pair 4-5.
ROLLED_45 = integrate(satellite_against_carrier.subs(AXES_45))
WITHOUT_SLIP = Equality(R4 / R5 * phi1, ROLLED_45)
OF_PAIR_36 = sp.Rational("0.2")

ROWS = (
    *(
        PRINT.datum(
            f"variant {number}, sizes",
            all_of(
                *(Definition(s, v if s in (e1, e2) else v * millimetre) for s, v in sizes.items())
            ),
            note="The pair 3-6 is oval with e = 0.2 in every variant. The text at hand does not "
            "give a; by (8) it is 25 mm where wheels 4 and 5 are cylindrical.",
        )
        for number, sizes in VARIANTS.items()
    ),
    PRINT.claim(
        "variant 1, reciprocating",
        all_of(
            Equality(position_1, integrate(1 - wheel_3_rate.subs(mount, 0)).subs(VARIANTS[1])),
            advances(position_1, sp.pi, sp.S.Zero),
            *reverses(ratio_1),
        ),
        note="E = 5/13: the output swings through 2 arcsin(5/13), twice in each turn of the "
        "carrier.",
        marks=("inferred",),
    ),
    PRINT.claim(
        "variant 2, reciprocating",
        all_of(
            advances(with_cylinders(position_45, 2), sp.pi, sp.S.Zero),
            *reverses(with_cylinders(ratio_45, 2)),
        ),
        note="R4 = R5: no drift; the amplitude is arcsin(0.2).",
        marks=("inferred",),
    ),
    PRINT.claim(
        "variant 3, intermittent",
        all_of(
            Holds(with_cylinders(ratio_45, 3) <= 0),
            Equality(with_cylinders(ratio_45, 3).subs(phi1, DWELL_3), sp.S.Zero),
            less(sp.diff(with_cylinders(ratio_45, 3), phi1, 2).subs(phi1, DWELL_3), sp.S.Zero),
            advances(with_cylinders(position_45, 3), 2 * DWELL_3, -DWELL_3),
        ),
        note="30/20 = (1 + 0.2)/(1 - 0.2) exactly: a double zero at every odd multiple of pi/3.",
        marks=("inferred",),
    ),
    PRINT.claim(
        "variant 4, one-way",
        all_of(
            Holds(with_cylinders(ratio_45, 4) < 0),
            Distinct(with_cylinders(ratio_45, 4), with_cylinders(ratio_45, 4).subs(phi1, 0)),
        ),
        note="32/18 > 3/2; the output turns against the carrier.",
        marks=("inferred",),
    ),
    PRINT.claim(
        "special case, angle of wheel 6",
        Equality(print_5.subs(e1, 0), ROLLED_45),
        readings=(
            Reading(
                "the numbers also stand for the radii rho4 and rho5 whose quotient (5) integrates",
                WITHOUT_SLIP,
            ),
        ),
        corrected=Correction(r"\varphi_6=\frac{R_4}{R_5}\varphi_1", WITHOUT_SLIP),
        note="The text at hand says nothing about (5) in this case. Left as printed, with e1 = 0, "
        "it would turn wheel 6 by phi1; wheels that do not slip turn it by (R4/R5) phi1.",
        marks=("rebuilt", "inferred"),
    ),
    ours(
        "special case, kinds of motion",
        r"\text{the kinds of variants 3 and 4 do not depend on how fast wheel 6 turns}",
        all_of(
            Holds(with_radii(3, phi6) <= 0),
            Holds(with_radii(4, phi6) < 0),
            Equality(with_radii(3, sp.pi / 2), sp.S.Zero),
        ),
        note="The sign is that of rho5 - rho6, whatever the angle of wheel 6. But variant 3 rests "
        "where phi6 is an odd multiple of pi/2: three times in a turn of the carrier if wheel 6 "
        "turns by 1.5 phi1, twice if it turns by phi1.",
        marks=("inferred",),
    ),
    PRINT.claim(
        "fixed axes",
        Holds(-rho3 / (span - rho3) < 0),
        note="External mesh, any pitch curves with 0 < rho < L; the ratio of a train of pairs is "
        "a product of factors of constant sign.",
        on=Part("the radius is shorter than the distance of the axes", where=(rho3 < span,)),
    ),
    PRINT.claim(
        "fixed axes, internal mesh",
        Holds(rho3 / (rho3 - span) > 0),
        note="At the point of contact the ring has the radius rho > L and its wheel rho - L; "
        "where the wheel drives, the ratio is the inverse.",
        on=Part("the radius exceeds the distance of the axes", where=(span < rho3,)),
    ),
    PRINT.claim(
        "fixed axes, non-uniform",
        less(pair_ratio(OF_PAIR_36, -sp.S.One), pair_ratio(OF_PAIR_36, sp.S.One)),
        note="One pair of ovals with e = 0.2 gives it: its ratio ranges from 2/3 to 3/2.",
    ),
)
