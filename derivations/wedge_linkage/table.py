"""Rows of paper 4 on its table of sizes."""

from __future__ import annotations

import sympy as sp
from sympy import Rational

from mechproof.record import Claim, Completion, Completions, Conjunction, Datum, Definition, Holds

from .boundaries import radicand_of
from .sizes import ANGLES, DEVIATION_SYMBOLS, DEVIATIONS, LEGIBLE, LEGIBLE_ANGLES, LOST, unit
from .symbols import millimetre


def measured(size: sp.Symbol, text: str) -> sp.Expr:
    """Return a number of the table with its unit."""
    return Rational(text) * (unit(size) if size in ANGLES else millimetre)


def define_deviations(size: sp.Symbol) -> tuple[Definition, ...]:
    """Introduce the limit deviations of a size, as far as they are legible."""
    texts = zip(DEVIATION_SYMBOLS.get(size, ()), DEVIATIONS.get(size, ()), strict=True)
    return tuple(Definition(symbol, measured(size, text)) for symbol, text in texts if text)


def datum_row(symbol: sp.Symbol, latex: str, value: str, note: str, uncertain: bool) -> Datum:
    """Record a size of the table, as far as it is legible."""
    return Datum(
        f"sizes, {symbol}",
        latex,
        Conjunction((Definition(symbol, measured(symbol, value)), *define_deviations(symbol))),
        note=note or "A datum.",
        marks=("uncertain",) if uncertain else (),
    )


SIZE_ROWS = (
    *(datum_row(*row) for row in LEGIBLE),
    *(datum_row(*row, "", False) for row in LEGIBLE_ANGLES),
    *(
        Datum(
            f"sizes, {symbol}",
            latex,
            Conjunction(define_deviations(symbol)),
            note=note,
            marks=("uncertain",),
        )
        for symbol, latex, note in LOST
    ),
    Claim(
        "sizes, domain of Fig. 4",
        r"Q\text{ is real on }x_1\in[-40,0]",
        Completions(
            "digits of l_BC and l_CD",
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
        marks=("uncertain", "inferred", "calibrated"),
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
