"""Rows of paper 4 on its table of sizes."""

from __future__ import annotations

import sympy as sp
from sympy import Rational

from mechproof.record import Claim, Completion, Completions, Conjunction, Definition, Holds

from .sizes import ANGLES, LEGIBLE, LEGIBLE_ANGLES, LOST, radicand_of, unit
from .symbols import millimetre


def datum_row(symbol: sp.Symbol, latex: str, value: str, note: str, uncertain: bool) -> Claim:
    """Record a size of the table, as far as it is legible."""
    scale = unit(symbol) if symbol in ANGLES else millimetre
    return Claim(
        f"sizes, {symbol}",
        latex,
        Definition(symbol, Rational(value) * scale),
        note=note or "A datum.",
        marks=("uncertain",) if uncertain else (),
    )


SIZE_ROWS = (
    *(datum_row(*row) for row in LEGIBLE),
    *(datum_row(*row, "", False) for row in LEGIBLE_ANGLES),
    *(
        Claim(
            f"sizes, {symbol}", latex, Definition(symbol, symbol), note=note, marks=("uncertain",)
        )
        for symbol, latex, note in LOST
    ),
    Claim(
        "sizes, domain of Fig. 4",
        r"Q\text{ is real on }x_1\in[-40,0]",
        Completions(
            Completion(
                "the legible digits l_BC = 19.75, l_CD = 38, at x1 = -40 mm",
                Holds(sp.Ge(radicand_of(-40, "19.75"), 0, evaluate=False)),
            ),
            Completion(
                "one digit changed, l_BC = 49.75, at x1 = -40 mm",
                Holds(sp.Ge(radicand_of(-40, "49.75"), 0, evaluate=False)),
            ),
        ),
        note="The curve of Fig. 4 cannot have been computed with the legible digits.",
        marks=("uncertain", "calibrated"),
    ),
    Claim(
        "sizes, end of the legible ones",
        r"Q\text{ of the legible sizes ends between }x_1=-4.66\text{ and }-4.65",
        Conjunction(
            (
                Holds(sp.Lt(radicand_of("-4.66", "19.75"), 0, evaluate=False)),
                Holds(sp.Gt(radicand_of("-4.65", "19.75"), 0, evaluate=False)),
            )
        ),
        marks=("ours", "uncertain"),
    ),
)
