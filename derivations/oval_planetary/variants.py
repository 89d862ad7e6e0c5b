"""The variants of paper 2, the motions they make, and what is said of motions."""

from __future__ import annotations

import sympy as sp

from mechproof.record import (
    Claim,
    Completion,
    Completions,
    Correction,
    Datum,
    Definition,
    Distinct,
    Equality,
    Holds,
    Part,
    Reading,
    Row,
)

from .._readings import millimetre
from .._relations import all_of, less
from .equations import RATIO_OF_10, print_5, print_10
from .mechanics import (
    ACCELERATION_CYLINDRICAL,
    AXES_45,
    COS_4,
    E_ALIGNED,
    E_SERIES,
    OVAL,
    R4,
    R5,
    acceleration_symbol,
    e,
    e1,
    e2,
    explicit,
    integrate,
    mount,
    oval_radius,
    pair_ratio,
    phi1,
    phi6,
    position_45,
    position_of_one,
    ratio_45,
    ratio_by_plan,
    ratio_of_one,
    ratio_with_cylinders_45,
    rho3,
    rho6,
    satellite_against_carrier,
    span,
    wheel_3_rate,
)
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


def drawn_by_11(angle_of_6: sp.Expr) -> sp.Integral:
    """Integrate (10) with numbers for pair 4-5 and any angle of wheel 6, as (11) says."""
    radius = oval_radius(e2, sp.cos(2 * angle_of_6)).subs(AXES_45)
    return integrate(print_10.subs(AXES_45).subs(rho6, radius))


def reverses(ratio: sp.Expr, backward: sp.Expr, forward: sp.Expr) -> tuple[Holds, Holds]:
    """State that the ratio is negative at one carrier angle and positive at another."""
    return less(ratio.subs(phi1, backward), sp.S.Zero), less(sp.S.Zero, ratio.subs(phi1, forward))


def variant_row(number: int, printed: str, pair_45: dict[sp.Symbol, sp.Expr]) -> Datum:
    """List the sizes of a variant as printed."""
    sizes = (Definition(s, v if s == e1 else v * millimetre) for s, v in pair_45.items())
    return Datum(
        f"variant {number}, sizes",
        rf"{printed},\ e_2=0.2",
        all_of(*sizes, Definition(e2, VARIANTS[number][e2])),
        note="The pair 3-6 is oval with e = 0.2 in every variant.",
    )


VARIANT_ROWS: tuple[Row, ...] = (
    *(
        variant_row(number, printed, {s: v for s, v in VARIANTS[number].items() if s != e2})
        for number, printed in (
            (1, r"e_1=0.2"),
            (2, r"R_5=R_4=25~\mathrm{mm}"),
            (3, r"R_5=20,\ R_4=30~\mathrm{mm}"),
            (4, r"R_5=18,\ R_4=32~\mathrm{mm}"),
        )
    ),
    Claim(
        "centre distance of the variants",
        r"R_4+R_5=50\text{ mm in variants 2, 3 and 4}",
        all_of(
            *(
                Holds(sp.Eq(with_cylinders(R4 + R5, v), with_cylinders(R4 + R5, 2), evaluate=False))
                for v in (3, 4)
            )
        ),
        note="With (8) a = 25 mm, which the paper does not print.",
        marks=("ours", "inferred"),
    ),
    Claim(
        "variant 1, reciprocating",
        r"\text{variant 1 gives reciprocating rotation of the output shaft}",
        all_of(
            Equality(position_1, integrate(1 - wheel_3_rate.subs(mount, 0)).subs(VARIANTS[1])),
            advances(position_1, sp.pi, sp.S.Zero),
            *reverses(ratio_1, sp.S.Zero, sp.pi / 2),
        ),
        note="E = 5/13: the output swings by 2 arcsin(5/13), twice for each turn of the carrier.",
        marks=("inferred",),
    ),
    Claim(
        "variant 2, reciprocating",
        r"\text{variant 2 gives reciprocating rotation of the output shaft}",
        all_of(
            advances(with_cylinders(position_45, 2), sp.pi, sp.S.Zero),
            *reverses(with_cylinders(ratio_45, 2), sp.S.Zero, sp.pi / 2),
        ),
        note="R4 = R5: no drift; the amplitude is arcsin(0.2).",
        marks=("inferred",),
    ),
    Claim(
        "variant 3, intermittent",
        r"\text{variant 3 gives intermittent rotation of the output shaft}",
        all_of(
            Holds(with_cylinders(ratio_45, 3) <= 0),
            Equality(with_cylinders(ratio_45, 3).subs(phi1, DWELL_3), sp.S.Zero),
            less(sp.diff(with_cylinders(ratio_45, 3), phi1, 2).subs(phi1, DWELL_3), sp.S.Zero),
            advances(with_cylinders(position_45, 3), 2 * DWELL_3, -DWELL_3),
        ),
        note="30/20 = (1 + 0.2)/(1 - 0.2) exactly: a double zero at every odd multiple of pi/3.",
        marks=("inferred",),
    ),
    Claim(
        "variant 4, one-way",
        r"\text{variant 4 gives one-way non-uniform rotation}",
        all_of(
            Holds(with_cylinders(ratio_45, 4) < 0),
            Distinct(with_cylinders(ratio_45, 4), with_cylinders(ratio_45, 4).subs(phi1, 0)),
        ),
        note="32/18 > 3/2; the output turns against the carrier.",
        marks=("inferred",),
    ),
    Claim(
        "special case, angle of wheel 6",
        r"\text{the radius functions of the cylindrical wheels are replaced by numbers}",
        Equality(print_5.subs(e1, 0), integrate(satellite_against_carrier.subs(AXES_45))),
        readings=(
            Reading(
                "the numbers also stand for the radii rho4 and rho5 whose quotient (5) integrates",
                Equality(R4 / R5 * phi1, integrate(satellite_against_carrier.subs(AXES_45))),
            ),
        ),
        corrected=Correction(
            r"\varphi_6=\frac{R_4}{R_5}\varphi_1",
            Equality(R4 / R5 * phi1, integrate(satellite_against_carrier.subs(AXES_45))),
        ),
        note="Nothing is said of (5). Left as printed, with e1 = 0, wheel 6 would turn by phi1; "
        "wheels that do not slip turn it by (R4/R5) phi1.",
        marks=("rebuilt", "inferred"),
    ),
    Claim(
        "special case, kinds of motion",
        r"\text{the kinds of variants 3 and 4 do not depend on how fast wheel 6 turns}",
        all_of(Holds(with_radii(3, phi6) <= 0), Holds(with_radii(4, phi6) < 0)),
        note="For every angle of wheel 6 the sign is that of rho5 - rho6.",
        marks=("ours", "inferred"),
    ),
    Claim(
        "position functions of Fig. 2",
        r"\text{with formula (11) the position functions were built}",
        Completions(
            "the curves of Fig. 2",
            Completion(
                "the curves of Fig. 2: those of (11) for wheels that do not slip, variant 1 with "
                "(5), a cylindrical pair 4-5 with wheel 6 turned by (R4/R5) phi1",
                all_of(
                    Equality(integrate(RATIO_OF_10), -position_of_one(E_SERIES)),
                    Equality(drawn_by_11(R4 / R5 * phi1), -position_45),
                ),
            ),
            Completion(
                "the curves of Fig. 2: those of (11) with (5) left as printed, e1 = 0, which turns "
                "wheel 6 by phi1",
                Equality(drawn_by_11(print_5.subs(e1, 0).doit()), -position_45),
            ),
        ),
        note="Of the figure only the axes in rad survive: whether its curves are those of the "
        "mechanism, the output counted against the carrier, cannot be seen.",
        marks=("rebuilt", "inferred"),
    ),
    Claim(
        "Fig. 5, tick labels",
        r"\varphi_3:\ 50^\circ",
        Completions(
            "which variant the figure shows",
            Completion(
                "the figure shows variant 1: its whole swing is within 50 deg",
                less(2 * sp.asin(E_SERIES.subs(VARIANTS[1])), 50 * sp.pi / 180),
            ),
            Completion(
                "the figure shows variant 4: its advance in one turn is within 50 deg",
                less(2 * sp.pi * (with_cylinders(R4 / R5, 4) - 1), 50 * sp.pi / 180),
            ),
        ),
        note="The labels 50, 20 and four times 240 are not attributed to a variant any more.",
    ),
    Claim(
        "fixed axes",
        r"\text{mechanisms with non-circular wheels on fixed axes give only one-way rotation}",
        Holds(-rho3 / (span - rho3) < 0),
        note="External mesh, any pitch curves with 0 < rho < L; a train of pairs is a product of "
        "factors of constant sign.",
        on=Part("the radius is shorter than the distance of the axes", where=(rho3 < span,)),
    ),
    Claim(
        "fixed axes, internal mesh",
        r"\text{mechanisms with non-circular wheels on fixed axes give only one-way rotation}",
        Holds(rho3 / (rho3 - span) > 0),
        note="The ring has the radius rho > L at the point of contact, its wheel rho - L; where "
        "the wheel drives, the ratio is the inverse.",
        on=Part("the radius exceeds the distance of the axes", where=(span < rho3,)),
    ),
    Claim(
        "fixed axes, non-uniform",
        r"\text{the rotation on fixed axes is non-uniform}",
        all_of(
            Equality(wheel_3_rate.subs(mount, sp.pi / 2), pair_ratio(E_ALIGNED, COS_4)),
            Holds(pair_ratio(e, sp.S.One) - pair_ratio(e, -sp.S.One) > 0),
        ),
        note="Two pairs of ovals in series, the major axes on the middle shaft parallel, act as "
        "one with E = (e1 - e2)/(1 - e1 e2), written e: equal ones, E = 0, turn uniformly again.",
        holds_on=Part("E > 0, one pair (e2 = 0 < e1) or two unequal ones in series", {e: OVAL}),
    ),
    Claim(
        "conclusion 2, acceleration",
        r"\text{the model gave the analogue of acceleration}",
        Definition(acceleration_symbol, -sp.diff(ratio_of_one(E_SERIES), phi1)),
        note="Only named: no formula of it is printed. Introduced here as the derivative of (10). "
        "The abstract is not at hand, so whether it says the same cannot be checked.",
        marks=("inferred",),
    ),
    Claim(
        "acceleration by the model",
        r"\varphi_3''=\frac{d\varphi_3'}{d\varphi_1}",
        all_of(
            Equality(
                sp.diff(ratio_of_one(e), phi1),
                4 * e * (1 - e**2) * sp.sin(2 * phi1) / (1 + e**2 - 2 * e * COS_4) ** 2,
            ),
            Equality(
                sp.diff(ratio_with_cylinders_45, phi1), ACCELERATION_CYLINDRICAL.subs(explicit)
            ),
        ),
        note="For two oval pairs (E written e) and for a cylindrical pair 4-5, the output counted "
        "with the carrier.",
        marks=("ours", "inferred"),
    ),
)
