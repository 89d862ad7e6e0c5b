"""Sizes of paper 4, legible and reconstructed, and the rows on its table of sizes."""

from collections.abc import Iterator, Mapping

import sympy as sp
from sympy import Rational, pi

from mechproof.record import *

from ..mechanics import *

Signs = Mapping[sp.Symbol, int]

# Upper and lower limit deviation (mm, degrees) as far as they are legible.
DEVIATIONS = {
    l_BC: ("", "-1.22"),
    l_CD: ("", "-2.06"),
    l_DE: ("0.92", "-1.05"),
    l_EF: ("0.3", "-0.3"),
    l_GH: ("1.03", "-0.72"),
    l_IK: ("", "-0.3"),
    l_KL: ("0.2", "-0.2"),
    l_LM: ("0.1", "-0.1"),
    l_MN: ("0.00", "-0.17"),
    alpha_DE: ("0.62", "-1.10"),
    alpha_KL: ("0.24", "-0.25"),
}


def with_deviations(size: sp.Symbol, nominal: str, if_lost: str = "") -> tuple[str, str, str]:
    """Return nominal, upper and lower deviation; `if_lost` replaces a lost upper one."""
    upper, lower = DEVIATIONS[size]
    return nominal, upper or if_lost, lower


# Nominal, upper and lower limit deviation (mm, degrees). Three reconstructions of the illegible
# entries, fitted to the printed crossing of two boundary curves at x1 = -29.4 mm, which therefore
# confirms none of them; lost upper deviations are +1.22 (BC) and, except in the second, 0 (CD).
FIRST_SIZES = {
    l_AB: ("6.25", "0", "0"),
    l_BC: with_deviations(l_BC, "49.75", "1.22"),
    l_CD: with_deviations(l_CD, "38", "0"),
    l_DE: with_deviations(l_DE, "83"),
    l_GH: with_deviations(l_GH, "2"),
    l_KL: with_deviations(l_KL, "60"),
    l_LM: with_deviations(l_LM, "145"),
    alpha_DE: with_deviations(alpha_DE, "283.06"),
    alpha_KL: with_deviations(alpha_KL, "65"),
    alpha_LM: ("123.48", "0", "0"),
}
SECOND_SIZES = {
    **FIRST_SIZES,
    l_BC: with_deviations(l_BC, "39.75", "1.22"),
    l_CD: with_deviations(l_CD, "28", "1.19"),
    l_DE: with_deviations(l_DE, "70.83"),
}
THIRD_SIZES = {
    **FIRST_SIZES,
    l_BC: with_deviations(l_BC, "45.75", "1.22"),
    l_CD: with_deviations(l_CD, "28", "0"),
}
ANGLES = (alpha_DE, alpha_KL, alpha_LM)


def unit(size: sp.Symbol) -> sp.Expr:
    """Return the factor for a number in the table of sizes: mm are kept, degrees are converted."""
    return pi / 180 if size in ANGLES else sp.S.One


def reconstruct(table: Mapping[sp.Symbol, tuple[str, str, str]]) -> PublishedSizes:
    """Return a reconstruction of the sizes, named by its BC, CD and DE."""
    chosen = ", ".join(f"{size} = {table[size][0]}" for size in (l_BC, l_CD, l_DE))
    sizes = {
        size: Toleranced(*(Rational(text) * unit(size) for text in texts))
        for size, texts in table.items()
    }
    return PublishedSizes(
        f"the set reconstructed with {chosen}", sizes, ("calibrated", "fitted", "uncertain")
    )


SETS = tuple(map(reconstruct, (FIRST_SIZES, SECOND_SIZES, THIRD_SIZES)))
FIRST_SET, SECOND_SET, _ = SETS


def limits(table: PublishedSizes, signs: Signs) -> dict[sp.Symbol, sp.Expr]:
    """Return the exact sizes of a combination: nominal, or at the limit that the sign names."""
    sizes = {}
    for size, value in table.sizes.items():
        assert isinstance(value, Toleranced)
        deviation = {1: value.upper, -1: value.lower}.get(signs.get(size, 0), sp.S.Zero)
        sizes[size] = value.nominal + deviation
    return sizes


def radicand_of(displacement: int | str, guide: str) -> sp.Expr:
    """Return the radicand of Q over l_BC**2 at the legible sizes and the length `guide` of BC."""
    sizes = {**limits(FIRST_SET, {}), l_BC: Rational(guide), x1: Rational(displacement)}
    return radicand.subs(sizes)


DEVIATION_SYMBOLS = {size: sp.symbols(f"ES_{size} EI_{size}", real=True) for size in DEVIATIONS}
VARIABLES = tuple(
    Variable(symbol, f"{which} limit deviation of {size}", ANGLE if size in ANGLES else LENGTH)
    for size, pair in DEVIATION_SYMBOLS.items()
    for which, symbol in zip(("upper", "lower"), pair, strict=True)
)

# The legible digits of each size, and what is said of those that are not all legible.
LEGIBLE = {
    **{l_AB: "6.25", l_BC: "19.75", l_CD: "38", l_DE: "70.833", l_EF: "4", l_GH: "2"},
    **{l_KL: "60", l_LM: "145", alpha_DE: "283.06", alpha_KL: "65", alpha_LM: "123.48"},
}
REMARKS = {
    l_BC: "Digits uncertain, upper deviation lost.",
    l_CD: "Upper deviation lost.",
    l_DE: "The text layer has two strings, 70,833 and 83; the latter may be the tail of 70,83.",
    l_EF: "Digits uncertain; without influence.",
    l_GH: "The primes vary from place to place.",
    l_LM: "The sign of the lower deviation is lost; it is read as -0.1.",
    l_IK: "Digits and upper deviation lost; without influence.",
    l_MN: "Digits lost; without influence.",
}


def measured(size: sp.Symbol, text: str) -> sp.Expr:
    """Return a number of the table with its unit."""
    return Rational(text) * (unit(size) if size in ANGLES else millimetre)


def define(size: sp.Symbol) -> Iterator[Definition]:
    """Introduce a size and its limit deviations, as far as they are legible."""
    symbols = (size, *DEVIATION_SYMBOLS.get(size, ()))
    texts = (LEGIBLE.get(size, ""), *DEVIATIONS.get(size, ()))
    for symbol, text in zip(symbols, texts, strict=True):
        if text:
            yield Definition(symbol, measured(size, text))


ROWS = (
    *(
        PRINT.datum(
            f"sizes, {size}",
            all_of(*define(size)),
            note=REMARKS.get(size, "A datum."),
            marks=("uncertain",) if size in REMARKS else (),
        )
        for size in (*LEGIBLE, l_IK, l_MN)
    ),
    ours(
        "sizes, end of the legible ones",
        r"Q\text{ of the legible sizes ends between }x_1=-4.66\text{ and }-4.65",
        all_of(
            less(radicand_of("-4.66", "19.75"), sp.S.Zero),
            Holds(sp.Gt(radicand_of("-4.65", "19.75"), 0, evaluate=False)),
        ),
        note="A remark on the transcription, not on the print: as the curve of Fig. 4 goes on to "
        "-40 mm, some digit of the table must have been misread.",
        marks=("uncertain",),
    ),
)
