"""Part three: Table 1 and the figures."""

from __future__ import annotations

import sympy as sp

from mechproof.record import (
    Claim,
    Completion,
    Completions,
    Conjunction,
    Definition,
    Distinct,
    Equality,
    Published,
    Row,
)

from .._relations import less, not_above
from .curve import (
    PRINTED_16,
    PRINTED_17,
    PRINTED_18,
    amplitude,
    ball_radius,
    error_x,
    error_y,
    error_z,
    millimetre,
    periods,
    phi,
    radius,
    thickness,
)
from .errors import (
    CORRECTED_6,
    FIVE_ERRORS,
    SUM_OF_SQUARES,
    elastic,
    form,
    kept,
    level,
    mounting,
    place,
    setting,
    share,
    spread,
    thermal,
    total,
    wear,
)
from .frame import (
    PRINTED_15,
    SHIFT,
    SURFACE_POINT,
    ZERO_ANGLES,
    alpha,
    beta,
    first_order_remainder,
    gamma,
)

PRINTED_VALUES = {
    symbol: sp.Rational(printed)
    for symbol, printed in {
        form: "0.016",
        mounting: "0.05",
        elastic: "0.042",
        setting: "0.01",
        wear: "0.021",
        radius: "41.5",
        amplitude: "3.75",
        ball_radius: "7.5",
        alpha: "0.00103",
        beta: "0.00103",
        gamma: "0",
        share: "0.15",
    }.items()
}
TABLE_1 = Published("Table 1", PRINTED_VALUES)
THERMAL_SHARE = PRINTED_VALUES[share]
SUM_OF_PRINTED_SQUARES = SUM_OF_SQUARES.subs(PRINTED_VALUES)


def crest_radius_of_curvature() -> sp.Expr:
    """Radius of curvature, in mm, of the printed track where it is farthest from the pole."""
    x, y = (c.subs(PRINTED_VALUES) for c in PRINTED_16[:2])
    (dx, dy), (ddx, ddy) = ([c.diff(phi, order).subs(phi, 0) for c in (x, y)] for order in (1, 2))
    return sp.sqrt(dx**2 + dy**2) ** 3 / (dx * ddy - dy * ddx)


# The radius of curvature at the crest exceeds the ball's radius.
FITTING_BALL = less(PRINTED_VALUES[ball_radius], crest_radius_of_curvature())


def position_error_at_crest(values: dict[sp.Symbol, sp.Expr]) -> sp.Expr:
    """Position error (15) along X_0, in mm, at varphi = 0 with the turns of Table 1."""
    point = dict(zip(SURFACE_POINT, PRINTED_16.subs(phi, 0), strict=True))
    return PRINTED_15[0].subs(point).subs({**PRINTED_VALUES, **values})


def total_by_corrected_sum(coefficient: sp.Expr) -> sp.Expr:
    """Solve the corrected (6), Delta_T being a share of the total: K = 1, equal K_i, one each."""
    return sp.sqrt(coefficient**2 * SUM_OF_SQUARES / (1 - (coefficient * share) ** 2))


def total_by_printed_sum(unit_of_length: sp.Expr) -> sp.Expr:
    """Solve (6) as printed, all coefficients 1: Delta_T unsquared, so the unit enters."""
    linear = THERMAL_SHARE * unit_of_length
    return (linear + sp.sqrt(linear**2 + 4 * SUM_OF_SQUARES.subs(PRINTED_VALUES))) / 2


SOLVED_TOTAL = total_by_corrected_sum(sp.Integer(1))


RADIAL_ERROR = error_x * sp.cos(phi) + error_y * sp.sin(phi)
TANGENTIAL_ERROR = error_y * sp.cos(phi) - error_x * sp.sin(phi)
ALONG_X_ONLY = {error_x: 1, error_y: 0}


TABLE_ROWS: tuple[Row, ...] = (
    *(
        Claim(
            f"Table 1, {what}",
            latex,
            Definition(symbol, PRINTED_VALUES[symbol] * unit_of_value),
            note=note,
            marks=marks,
        )
        for what, latex, symbol, unit_of_value, note, marks in (
            ("form error", r"\Delta_\phi=0.016~\mathrm{mm}", form, millimetre, "", ()),
            ("mounting error", r"\Delta_y=0.05~\mathrm{mm}", mounting, millimetre, "", ()),
            ("elastic error", r"\Delta_\delta=0.042~\mathrm{mm}", elastic, millimetre, "", ()),
            (
                "setting error",
                r"\Delta_u=0.01~\mathrm{mm}",
                setting,
                millimetre,
                "The symbol printed here is hard to read and is the one used for the wear in the "
                "next line; the words say machine setting, so Delta_n of (6) is taken.",
                ("uncertain",),
            ),
            ("tool wear", r"\Delta_u=0.021~\mathrm{mm}", wear, millimetre, "", ()),
            ("radius", r"R=41.5~\mathrm{mm}", radius, millimetre, "", ()),
            ("amplitude", r"A=3.75~\mathrm{mm}", amplitude, millimetre, "", ()),
            (
                "ball radius",
                r"7.5~\mathrm{mm}",
                ball_radius,
                millimetre,
                "It enters none of the printed formulas, so no printed result depends on it.",
                (),
            ),
            ("turn about X", r"\alpha=0.00103~\mathrm{rad}", alpha, sp.Integer(1), "", ()),
            ("turn about Y", r"\beta=0.00103~\mathrm{rad}", beta, sp.Integer(1), "", ()),
            ("turn about Z", r"\gamma=0", gamma, sp.Integer(1), "", ()),
        )
    ),
    Claim(
        "Table 1, temperature error",
        r"\Delta_T=0.15\,\Delta_\Sigma",
        Definition(thermal, THERMAL_SHARE * total),
        note="The error is given by the total of which it is a part: (6) becomes an equation.",
    ),
    Claim(
        "Table 1, shift within the circle",
        r"A\le R",
        not_above(PRINTED_VALUES[amplitude], PRINTED_VALUES[radius]),
        note="Needed for the square root in (16) to be real at every angle.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, total",
        r"\Delta_\Sigma^2=q+(\tau\Delta_\Sigma)^2\text{ has exactly one positive solution, }"
        r"q=\Delta_\phi^2+\Delta_y^2+\Delta_\delta^2+\Delta_n^2+\Delta_u^2",
        Conjunction(
            (
                Equality(
                    total**2 - (SUM_OF_SQUARES + (share * total) ** 2),
                    (1 - share**2) * (total - SOLVED_TOTAL) * (total + SOLVED_TOTAL),
                ),
                less(share**2, sp.Integer(1)),
                less(sp.Integer(0), SOLVED_TOTAL**2),
            )
        ),
        note="The corrected (6) with one error in each group and all coefficients 1. The other "
        "root is the negative of this one; Table 1 has the share 0.15.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, share of the temperature",
        r"1/\sqrt{1-0.15^2}<1.012",
        less(1 / sp.sqrt(1 - THERMAL_SHARE**2), sp.Rational("1.012")),
        note="A temperature error of 15 % of the total raises that total by less than 1.2 %.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, unit of length in (6)",
        r"\Delta_\Sigma\text{ by (6) as printed, in mm}\ne"
        r"\Delta_\Sigma\text{ by (6) as printed, in }\mu\mathrm{m}",
        Distinct(total_by_printed_sum(sp.Integer(1)), total_by_printed_sum(sp.Rational(1, 1000))),
        note="Both totals are given in mm. With Delta_T unsquared the result depends on the unit "
        "in which Table 1 is written.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, missing data",
        r"\text{not printed: }z,H_s,a,b,c,K,K_i,S_i,n",
        Completions(
            "the coefficients K_i",
            Completion(
                "all K_i = 1 (normal laws): the total is below twice the mounting error",
                less(
                    total_by_corrected_sum(sp.Integer(1)).subs(PRINTED_VALUES),
                    2 * PRINTED_VALUES[mounting],
                ),
            ),
            Completion(
                "all K_i = sqrt(3) (uniform laws): the same",
                less(
                    total_by_corrected_sum(sp.sqrt(3)).subs(PRINTED_VALUES),
                    2 * PRINTED_VALUES[mounting],
                ),
            ),
        ),
        note="Without the coefficients the total of Table 1 has no single value.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, ball in the track",
        r"\text{a ball of }7.5~\mathrm{mm}\text{ fits the curvature of the track}",
        Completions(
            periods,
            Completion("one period", FITTING_BALL, sp.Integer(1)),
            Completion("twelve periods", FITTING_BALL, sp.Integer(12)),
        ),
        note="The number of periods is not printed, so the ball's radius cannot be checked "
        "against the track.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, small turns",
        r"\tfrac12(R+A)(|\alpha|+|\beta|+|\gamma|)^2<\tfrac1{100}\Delta_n",
        less(
            first_order_remainder(radius + amplitude).subs(PRINTED_VALUES),
            PRINTED_VALUES[setting] / 100,
        ),
        note="For points with z_13 = 0, at most R + A from O_1, the first-order model of (15) "
        "leaves out less than a hundredth of the smallest error of Table 1. For other points the "
        "distance from O_1 grows with the thickness H_s, which is not printed.",
        marks=("ours",),
    ),
    Claim(
        "after roughing",
        r"\text{After roughing the form tolerance can exceed all other technological errors}",
        Completions(
            "the form error after roughing",
            Completion(
                "form error 0.1 mm after roughing, the other errors as in Table 1",
                Conjunction(
                    tuple(
                        less(PRINTED_VALUES[other], sp.Rational("0.1")) for other in FIVE_ERRORS[1:]
                    )
                ),
            ),
            Completion(
                "form error and the other errors as in Table 1 (finish milling)",
                Conjunction(
                    tuple(
                        less(PRINTED_VALUES[other], PRINTED_VALUES[form])
                        for other in FIVE_ERRORS[1:]
                    )
                ),
            ),
        ),
        note="No error after roughing is printed.",
    ),
    Claim(
        "Fig. 3, shift only",
        r"\alpha=\beta=\gamma=0:\ (\Delta x_0,\Delta y_0,\Delta z_0)=(a,b,c)",
        Equality(PRINTED_15.subs(ZERO_ANGLES), SHIFT),
        note="Without turns the error is the shift at every point, so the bars of the shift are "
        "|a|, |b|, |c|; their values are lost.",
        marks=("inferred",),
    ),
    Claim(
        "Fig. 3, axes, plane and space",
        r"|\Delta x_0|,|\Delta y_0|\le\Delta_\Sigma^{XY};\ "
        r"\Delta_\Sigma^{XY},|\Delta z_0|\le\Delta_\Sigma^{XYZ}",
        Conjunction(
            (
                not_above(error_x**2, PRINTED_17**2),
                not_above(error_y**2, PRINTED_17**2),
                not_above(PRINTED_17**2, PRINTED_18**2),
                not_above(error_z**2, PRINTED_18**2),
            )
        ),
        note="Stated by squares, as both sides are not negative. It holds point by point and "
        "therefore for the largest values.",
        marks=("ours",),
    ),
    Claim(
        "Fig. 3, shift and turns",
        r"\text{along }X_0\text{ the error from shift and turns exceeds that from the shift}",
        Completions(
            "the shift a",
            Completion(
                "a = 0.05 mm, H_s = 20 mm, turns of Table 1, at varphi = 0",
                less(
                    sp.Rational("0.05") ** 2,
                    position_error_at_crest(
                        {SHIFT[0]: sp.Rational("0.05"), thickness: sp.Integer(20)}
                    )
                    ** 2,
                ),
            ),
            Completion(
                "a = -0.05 mm, the rest as before",
                less(
                    sp.Rational("-0.05") ** 2,
                    position_error_at_crest(
                        {SHIFT[0]: sp.Rational("-0.05"), thickness: sp.Integer(20)}
                    )
                    ** 2,
                ),
            ),
        ),
        note="Shift and turn can add or cancel; neither the shift nor the thickness is printed.",
        marks=("ours",),
    ),
    Claim(
        "Fig. 4, both together",
        r"(\Delta x_0\cos\varphi+\Delta y_0\sin\varphi)^2"
        r"+(\Delta y_0\cos\varphi-\Delta x_0\sin\varphi)^2=(\Delta_\Sigma^{XY})^2",
        Conjunction(
            (
                Equality(RADIAL_ERROR**2 + TANGENTIAL_ERROR**2, PRINTED_17**2),
                not_above(RADIAL_ERROR**2, PRINTED_17**2),
                not_above(TANGENTIAL_ERROR**2, PRINTED_17**2),
            )
        ),
        note="Curve 3 (both together) is the hypotenuse of 1 (tangential) and 2 (radial) and lies "
        "above both.",
        marks=("inferred",),
    ),
    Claim(
        "Fig. 4, tangential and radial",
        r"\text{the radial error exceeds the tangential error}",
        Completions(
            "the place on the track",
            Completion(
                "error along X_0 only, at varphi = 0",
                less(
                    (TANGENTIAL_ERROR**2).subs({phi: 0, **ALONG_X_ONLY}),
                    (RADIAL_ERROR**2).subs({phi: 0, **ALONG_X_ONLY}),
                ),
            ),
            Completion(
                "error along X_0 only, at varphi = pi/2",
                less(
                    (TANGENTIAL_ERROR**2).subs({phi: sp.pi / 2, **ALONG_X_ONLY}),
                    (RADIAL_ERROR**2).subs({phi: sp.pi / 2, **ALONG_X_ONLY}),
                ),
            ),
        ),
        note="The order of curves 1 and 2 depends on the place on the track, which is not given.",
        marks=("ours",),
    ),
    Claim(
        "Fig. 4, growth with the form error",
        r"\frac{\partial}{\partial\Delta_\phi}\Delta_\Sigma^2>0",
        less(sp.Integer(0), (CORRECTED_6**2).diff(form)),
        note="By the corrected (6) the total grows with the form error. How the shift and the "
        "turns depend on it is not printed, so the curves themselves cannot be recomputed.",
        marks=("ours",),
    ),
    Claim(
        "Fig. 5, elastic deformations",
        r"\text{the elastic deformations change little, hence their error fell considerably}",
        Completions(
            "what the deformation is compared with",
            Completion(
                "change along the track: the range of the deformation falls with it",
                less(2 * kept * spread * level, 2 * spread * level),
            ),
            Completion(
                "change from the old cut to the new: the deformation itself becomes smaller",
                less(level * (1 + spread * place), level),
            ),
        ),
        note="What the deformation is compared with is not said; a small change from the old cut "
        "to the new would leave the error about as it was, and it may even grow.",
    ),
    Claim(
        "Fig. 5, total",
        r"\text{the total error fell against Fig. 3}",
        Completions(
            "what else the optimised cut changes",
            Completion(
                "only the elastic error falls",
                less(
                    SUM_OF_SQUARES.subs(elastic, kept * elastic) / (1 - share**2),
                    SUM_OF_SQUARES / (1 - share**2),
                ),
            ),
            Completion(
                "the elastic error halves and the wear rises to 0.05 mm, the rest as in Table 1",
                less(
                    SUM_OF_SQUARES.subs(
                        {elastic: PRINTED_VALUES[elastic] / 2, wear: sp.Rational("0.05")}
                    ).subs(PRINTED_VALUES),
                    SUM_OF_PRINTED_SQUARES,
                ),
            ),
        ),
        note="The values of both figures are lost, and what else the optimised cut changes is not "
        "said.",
    ),
    Claim(
        "Fig. 5, largest possible gain",
        r"\sqrt{(q-\Delta_\delta^2)/q}>0.8",
        less(
            sp.Rational("0.8"),
            sp.sqrt(
                (SUM_OF_PRINTED_SQUARES - PRINTED_VALUES[elastic] ** 2) / SUM_OF_PRINTED_SQUARES
            ),
        ),
        note="With the other errors of Table 1 unchanged and all coefficients 1, even a vanishing "
        "elastic error lowers the total by less than 20 %.",
        marks=("ours",),
    ),
)
