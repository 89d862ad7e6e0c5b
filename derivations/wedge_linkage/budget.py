"""Which tolerances of paper 4 make the deviation of the wedge at -40 mm, by reconstructed sizes."""

import sympy as sp

from mechproof.record import PublishedSizes, Statement, all_of, ours, rounded

from .boundaries import BOUNDARY_II, START, angles_of, position_of
from .sizes import SETS, limits
from .symbols import *

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
# What lever and rod, and roller lever and wedge, make of a small displacement there.
STAGES = (("0.64", "2.86"), ("0.24", "2.68"), ("0.57", "2.82"))


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
    return all_of(*rounded(printed, shares))


def stage_ratios(table: PublishedSizes) -> tuple[sp.Expr, sp.Expr]:
    """Return |dx5/dx1| and |dy9/dx5'| at the start: see the row on the velocity of the chain."""
    sizes = limits(table, {})
    turned, direction = angles_of(table, {}, START)
    guide = sp.sqrt(radicand.xreplace({**sizes, x1: START}))
    with sp.evaluate(False):
        rod = sizes[l_DE] * sp.sin(sizes[alpha_DE] + turned) * sp.cos(turned) / guide
        wedge = sizes[l_LM] * sp.cos(sizes[alpha_LM] + direction - sizes[alpha_KL])
        return sp.Abs(rod), sp.Abs(wedge / (sizes[l_KL] * sp.sin(direction)))


def write(size: sp.Symbol, numbers: tuple[str, ...]) -> str:
    """Write the parts of a size."""
    first, *others = numbers
    between = r";\ "
    return rf"{NAMES[size]}\colon {first}\ ({between.join(others)})~\mathrm{{mm}}"


BUDGET_ROWS = (
    ours(
        "budget at -40",
        r",\quad ".join(write(size, numbers) for size, numbers in PARTS.items()),
        all_of(
            *(
                statement
                for size, numbers in PARTS.items()
                for statement in rounded(numbers, (part(table, size) for table in SETS))
            )
        ),
        note="Half the change of y9 between the limits of each size alone, with the first set of "
        "reconstructed sizes (second; third). Five of them, those of the accelerating lever and "
        "the clearance, make 94 to 95 % of the sum; tolerances of the roller lever three times as "
        "wide would add a tenth to it.",
        marks=("consequence", "calibrated"),
    ),
    ours(
        "budget at -40, worst case and root sum of squares",
        r"\pm10.2\ (9.8;\ 9.3)~\%\text{ at worst},\quad\pm4.5\ (4.2;\ 4.1)~\%\text{ by the root of "
        r"the sum of squares}",
        all_of(*map(totals, SETS, TOTALS)),
        note="Per cent of the nominal position, with the first set of reconstructed sizes "
        "(second; third). The printed 10 % takes all eight sizes at their worst limits at once; "
        "if the deviations are independent, each tolerance being the same number of standard "
        "deviations, less than half of it is left.",
        marks=("consequence", "calibrated"),
    ),
    ours(
        "ratios of the stages at -40",
        r"\left|\tfrac{dx_5}{dx_1}\right|=0.64\ (0.24;\ 0.57),\quad"
        r"\left|\tfrac{dy_9}{dx_{5'}}\right|=2.86\ (2.68;\ 2.82)",
        all_of(
            *(
                statement
                for table, numbers in zip(SETS, STAGES, strict=True)
                for statement in rounded(numbers, stage_ratios(table))
            )
        ),
        note="With the first set of reconstructed sizes (second; third). Lever and rod reduce an "
        "error of the pusher's position there, roller lever and wedge enlarge it.",
        marks=("consequence", "calibrated"),
    ),
)
