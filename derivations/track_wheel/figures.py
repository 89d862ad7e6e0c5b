"""Part three: the figures."""

from __future__ import annotations

import sympy as sp

from mechproof.record import (
    Claim,
    Completion,
    Completions,
    Conjunction,
    Equality,
    PrintedNumber,
    Row,
)

from .._relations import less, not_above
from .mechanics import CORRECTED_6, SUM_OF_SQUARES, ZERO_ANGLES
from .symbols import (
    PRINTED_15,
    PRINTED_16,
    PRINTED_17,
    PRINTED_18,
    PRINTED_VALUES,
    SHIFT,
    SURFACE_POINT,
    elastic,
    error_x,
    error_y,
    error_z,
    form,
    kept,
    level,
    mounting,
    phi,
    place,
    share,
    spread,
    thickness,
    wear,
)
from .table import SUM_OF_PRINTED_SQUARES


def position_error_at_crest(values: dict[sp.Symbol, sp.Expr]) -> sp.Expr:
    """Position error (15) along X_0, in mm, at varphi = 0 with the turns of Table 1."""
    point = dict(zip(SURFACE_POINT, PRINTED_16.subs(phi, 0), strict=True))
    return PRINTED_15[0].subs(point).subs({**PRINTED_VALUES, **values})


RADIAL_ERROR = error_x * sp.cos(phi) + error_y * sp.sin(phi)
TANGENTIAL_ERROR = error_y * sp.cos(phi) - error_x * sp.sin(phi)
ALONG_X_ONLY = {error_x: 1, error_y: 0}

# The total without the elastic error, by the total of Table 1.
LEFT_WITHOUT_ELASTIC = sp.sqrt(
    (SUM_OF_PRINTED_SQUARES - PRINTED_VALUES[elastic] ** 2) / SUM_OF_PRINTED_SQUARES
)


FIGURE_ROWS: tuple[Row, ...] = (
    Claim(
        "Fig. 3, shift only",
        r"\alpha=\beta=\gamma=0:\ (\Delta x_0,\Delta y_0,\Delta z_0)=(a,b,c)",
        Equality(PRINTED_15.subs(ZERO_ANGLES), SHIFT),
        note="Without turns the error is the shift at every point, so the bars of the shift are "
        "|a|, |b|, |c|; their values are lost.",
        marks=("ours", "inferred"),
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
        marks=("ours", "inferred"),
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
        "Fig. 4, errors against the form error",
        r"\text{the errors depend on }\Delta_\phi\text{; curve 1: shift only}",
        Completions(
            "how the errors of (6) make a, b, c",
            Completion(
                "the link of a, b, c to (6): a is the form error. The planar error of the shift "
                "grows with it",
                less(sp.Integer(0), (form**2 + SHIFT[1] ** 2).diff(form)),
            ),
            Completion(
                "the link of a, b, c to (6): a and b are the mounting error, which does not know "
                "of the form error",
                less(sp.Integer(0), (2 * mounting**2).diff(form)),
            ),
        ),
        note="(6) adds the errors up to one scatter field; how they make the shift a, b, c and the "
        "turns of (15) is not printed. Stated by the square of (17), without turns.",
        marks=("inferred",),
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
        "Fig. 5, considerably",
        r"\text{the error }\Delta_\delta\text{ fell considerably}",
        Completions(
            "the elastic error of the optimised cut",
            Completion(
                "the elastic error of the optimised cut: 0.02 mm. It fell to less than a half",
                less(sp.Rational("0.02"), PRINTED_VALUES[elastic] / 2),
            ),
            Completion(
                "the elastic error of the optimised cut: 0.04 mm. It fell to less than a half",
                less(sp.Rational("0.04"), PRINTED_VALUES[elastic] / 2),
            ),
        ),
        note="Printed of the elastic error, whose new value is not; considerably is taken as to "
        "less than a half. What the total can gain by it is the next row.",
        marks=("inferred",),
    ),
    Claim(
        "Fig. 5, largest possible gain",
        r"1-\sqrt{(q-\Delta_\delta^2)/q}\approx19.3\,\%",
        PrintedNumber("19.3", 100 * (1 - LEFT_WITHOUT_ELASTIC)),
        note="With the other errors of Table 1 unchanged and all coefficients 1, even a vanishing "
        "elastic error lowers the total by no more.",
        marks=("ours",),
    ),
)
