"""What the conclusions of paper 2 say beyond its formulas, and its acceleration by the model."""

import sympy as sp

from mechproof.record import Equality, NotCheckable, Row, all_of, ours

from .mechanics import COS_4, ratio_of_one, ratio_with_cylinders_45
from .symbols import PRINT, R4, R5, e, e2, phi1

DOUBLE = 2 * R4 / R5 * phi1

CONCLUSION_ROWS: tuple[Row, ...] = (
    PRINT.claim(
        "conclusion 2, acceleration",
        NotCheckable(
            "the text at hand has no formula, graph or value of an acceleration; its abstract "
            "names only the analogue of the speed and the position function"
        ),
    ),
    PRINT.claim(
        "conclusion 2, required transfer functions",
        NotCheckable("the text at hand does not say which transfer functions are required"),
    ),
    PRINT.claim(
        "conclusion 1, compactness",
        NotCheckable("the text at hand has no size, mass or force of either mechanism"),
    ),
    ours(
        "acceleration by the model",
        r"\varphi_3''=\frac{4E(1-E^2)\sin2\varphi_1}{(1+E^2-2E\cos2\varphi_1)^2},\quad "
        r"E=\frac{e_1+e_2}{1+e_1e_2},\quad\varphi_3''=\frac{R_4^2}{R_5^2}\cdot"
        r"\frac{4e_2(1-e_2^2)\sin x}{(1+e_2^2-2e_2\cos x)^2},\ x=2\frac{R_4}{R_5}\varphi_1",
        all_of(
            Equality(
                4 * e * (1 - e**2) * sp.sin(2 * phi1) / (1 + e**2 - 2 * e * COS_4) ** 2,
                sp.diff(ratio_of_one(e), phi1),
            ),
            Equality(
                (R4 / R5) ** 2
                * 4
                * e2
                * (1 - e2**2)
                * sp.sin(DOUBLE)
                / (1 + e2**2 - 2 * e2 * sp.cos(DOUBLE)) ** 2,
                sp.diff(ratio_with_cylinders_45, phi1),
            ),
        ),
        note="First for two oval pairs, then for a cylindrical pair 4-5. The output is counted "
        "with the carrier.",
        marks=("inferred",),
    ),
)
