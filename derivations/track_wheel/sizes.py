"""Part three: the data of Table 1."""

from __future__ import annotations

import sympy as sp

from mechproof.record import Datum, Definition, PublishedSizes, Row

from .mechanics import SUM_OF_SQUARES
from .symbols import (
    alpha,
    amplitude,
    ball_radius,
    beta,
    elastic,
    form,
    gamma,
    millimetre,
    mounting,
    radius,
    setting,
    share,
    thermal,
    total,
    wear,
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
TABLE_1 = PublishedSizes("Table 1", PRINTED_VALUES)
THERMAL_SHARE = PRINTED_VALUES[share]
SUM_OF_PRINTED_SQUARES = SUM_OF_SQUARES.subs(PRINTED_VALUES)


DATA_ROWS: tuple[Row, ...] = (
    *(
        Datum(
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
                "The symbol may be misread: as transcribed it is the one used for the wear in the "
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
    Datum(
        "Table 1, temperature error",
        r"\Delta_T=0.15\,\Delta_\Sigma",
        Definition(thermal, THERMAL_SHARE * total),
        note="The error is given by the total of which it is a part: (6) becomes an equation.",
    ),
)
