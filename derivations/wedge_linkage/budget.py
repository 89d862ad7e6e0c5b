"""Which tolerances of paper 4 make the deviation of the wedge at -40 mm, by reconstructed sizes."""

from __future__ import annotations

import sympy as sp

from mechproof.record import Claim, Conjunction, PrintedNumber, PublishedSizes, Statement

from .boundaries import BOUNDARY_II, START, position_of
from .sizes import SETS
from .symbols import alpha_DE, alpha_KL, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM

# Half the change (mm) of y9 between the limits of each size, of the three sets.
PARTS = {
    l_BC: ("3.5", "1.8", "2.8"),
    l_GH: ("2.5", "2.3", "2.5"),
    alpha_DE: ("2.3", "2.3", "2.1"),
    l_DE: ("2.0", "2.0", "2.0"),
    l_CD: ("1.5", "1.6", "1.2"),
    l_KL: ("0.5", "0.5", "0.5"),
    l_LM: ("0.1", "0.1", "0.1"),
    alpha_KL: ("0.0", "0.0", "0.0"),
}
# Per cent of the nominal position: all at their worst together, and the root of the squares.
TOTALS = (("10.2", "4.5"), ("9.8", "4.2"), ("9.3", "4.1"))


def part(table: PublishedSizes, size: sp.Symbol) -> sp.Expr:
    """Return half the change of the position at the start between the limits of a size, mm."""
    high, low = (position_of(table, {size: sign}, START) for sign in (1, -1))
    return sp.Mul(sp.S.Half, sp.Abs(high - low, evaluate=False), evaluate=False)


def totals(table: PublishedSizes, printed: tuple[str, str]) -> Statement:
    """State the sum of the parts and the root of the sum of their squares, % of the position."""
    parts = [part(table, size) for size in BOUNDARY_II]
    nominal = position_of(table, {}, START)
    with sp.evaluate(False):
        sums = (sp.Add(*parts), sp.sqrt(sp.Add(*(p**2 for p in parts))))
        shares = tuple(100 * s / sp.Abs(nominal) for s in sums)
    return Conjunction(tuple(map(PrintedNumber, printed, shares)))


def write(size: sp.Symbol, numbers: tuple[str, ...]) -> str:
    """Write the parts of a size."""
    first, *others = numbers
    between = r";\ "
    return rf"{sp.latex(size)}\colon {first}\ ({between.join(others)})"


BUDGET_ROWS = (
    Claim(
        "budget at -40",
        r",\ ".join(write(size, numbers) for size, numbers in PARTS.items()) + r"~\mathrm{mm}",
        Conjunction(
            tuple(
                PrintedNumber(number, part(table, size))
                for size, numbers in PARTS.items()
                for number, table in zip(numbers, SETS, strict=True)
            )
        ),
        note="Half the change of y9 between the limits of each size alone, first set (second; "
        "third). Five sizes, those of the lever and the clearance, make 94 to 95 % of it; those "
        "of the roller lever may be three times as wide for a tenth more.",
        marks=("ours", "consequence", "calibrated"),
    ),
    Claim(
        "budget at -40, worst case and root sum of squares",
        r"\pm10.2\ (9.8;\ 9.3)~\%\text{ at worst},\quad\pm4.5\ (4.2;\ 4.1)~\%\text{ by the root of "
        r"the sum of squares}",
        Conjunction(tuple(map(totals, SETS, TOTALS))),
        note="Per cent of the nominal position, first set (second; third). The printed 10 % needs "
        "eight sizes at their worst limits together; of independent deviations, a tolerance being "
        "the same number of standard deviations for each, less than half is left.",
        marks=("ours", "consequence", "calibrated"),
    ),
)
