"""Boundary curves of the range of paper 4 by the printed chain, and their tolerances."""

from collections.abc import Callable, Mapping
from functools import cache, partial
from typing import TypeAlias

import sympy as sp
from sympy import Rational, pi, sqrt

from mechproof.record import *
from mechproof.record.memory import remember_last

from ..mechanics import *
from .sizes import SETS, Signs, limits

Displacement: TypeAlias = "sp.Rational | int | str"

# Printed in the figure: where it begins, where III and IV cross (mm), and the deviation there (%).
START, CROSSING, DEVIATION = Rational(-40), Rational("-29.4"), "10"

# 1 is the upper limit, -1 the lower; sizes that are not named have their nominal values.
BOUNDARY_II = {
    l_BC: 1, l_CD: -1, l_DE: -1, l_GH: 1, l_KL: 1, l_LM: -1, alpha_DE: 1, alpha_KL: 1,
}  # fmt: skip
BOUNDARY_III = {size: -sign for size, sign in BOUNDARY_II.items()}
BOUNDARY_IV = {**BOUNDARY_III, alpha_KL: 1}


# Unevaluated: SymPy would spend seconds on assumptions of numbers that balls decide. Evaluation is
# only switched here: each switch makes SymPy forget everything that it has computed.
with sp.evaluate(False):
    TURNED = print_1.xreplace({Q: PRINTED_Q})
    RUN = driven.xreplace({overlap: print_3 - l_GH})
    DIRECTION = sp.atan2(sqrt(l_KL**2 - PRINTED_R**2), PRINTED_R)
    WEDGE = print_10.xreplace({phi7: phi7 - alpha_KL})


def put(formula: sp.Expr, values: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """Return a formula with values put in for letters, without evaluating anything."""
    if formula in values or not formula.args:
        return values.get(formula, formula)
    return formula.func(*(put(part, values) for part in formula.args), evaluate=False)


def angles_of(
    table: PublishedSizes, signs: Signs, displacement: Displacement
) -> tuple[sp.Expr, sp.Expr]:
    """Compose (1), (3), (4) and (7)/(8) at exact sizes: varphi3 and the direction of KL."""
    sizes = limits(table, signs)
    turned = put(TURNED, {**sizes, x1: Rational(displacement)})
    return turned, put(DIRECTION, {**sizes, x5: put(RUN, {**sizes, phi3: turned})})


def position_of(table: PublishedSizes, signs: Signs, displacement: Displacement) -> sp.Expr:
    """Compose the chain with (10) at exact sizes: an exact number."""
    _, direction = angles_of(table, signs, displacement)
    return put(WEDGE, {**limits(table, signs), phi7: direction})


def upright_at(table: PublishedSizes) -> sp.Expr:
    """Return the displacement (mm) of the pusher at which KL is upright, R = 0, by (3) and (4).

    Group 1 is solved for x1: (l_AB + l_CD) (sec(varphi3) - 1) - l_BC tan(varphi3).
    """
    sizes = limits(table, {})
    run = sizes[l_KL] * sp.cos(sizes[alpha_KL]) + sizes[l_GH]
    start = sizes[alpha_DE]
    turned = 2 * pi - sp.acos(sp.cos(start) + run / sizes[l_DE]) - start
    arm = sizes[l_AB] + sizes[l_CD]
    return arm * (sp.sec(turned) - 1) - sizes[l_BC] * sp.tan(turned)


def upright_wedge(table: PublishedSizes) -> sp.Expr:
    """Return the position of the wedge there, by (10)."""
    sizes = limits(table, {})
    return print_10.subs(phi7, pi / 2 - alpha_KL).xreplace(sizes)


def deviations_round(
    table: PublishedSizes, displacement: Displacement, lower: Signs, printed: tuple[str, str]
) -> Conjunction:
    """State the rounded deviations of II and a lower boundary, in % of the nominal position."""
    nominal, high, low = (
        position_of(table, signs, displacement) for signs in ({}, BOUNDARY_II, lower)
    )
    # The position is negative, so the upper boundary has the smaller absolute value.
    with sp.evaluate(False):
        deviations = (100 * (1 - high / nominal), 100 * (low / nominal - 1))
    return all_of(*rounded(printed, deviations))


@remember_last(len(SETS))
def angles_in_range(table: PublishedSizes) -> Conjunction:
    """State the ranges of the directions DE, KL and LM, all sizes within limits, down to -40 mm.

    varphi3 is largest for the shortest BC and the longest CD, varphi7 for III or IV. An arctangent
    is below a right angle anyway: the sign of the denominator of (1) shows that it is varphi3.
    """
    turned, _ = angles_of(table, BOUNDARY_III, -40)
    farthest = {**limits(table, BOUNDARY_III), x1: sp.Integer(-40)}
    lowest, highest = (limits(table, dict.fromkeys((alpha_DE, alpha_KL), s)) for s in (-1, 1))
    lever = (
        less(sp.S.Zero, print_1_bottom.xreplace({Q: PRINTED_Q}).xreplace(farthest)),
        less(3 * pi / 2, lowest[alpha_DE]),
        less(highest[alpha_DE] + turned, 2 * pi),
        less(pi / 2, lowest[alpha_LM]),
        less(sp.S.Zero, lowest[alpha_KL]),
    )
    roller = []
    for signs in (BOUNDARY_III, BOUNDARY_IV):
        sizes, (_, direction) = limits(table, signs), angles_of(table, signs, -40)
        roller += [
            less(direction, pi),
            less(sizes[alpha_LM] + direction - sizes[alpha_KL], 3 * pi / 2),
        ]
    return all_of(*lever, *roller)


def extreme(
    table: PublishedSizes, boundary: Signs, displacement: int | str, neighbours_at: tuple[int, ...]
) -> Conjunction:
    """State what makes a curve a boundary from a displacement to x1 = 0 (or to -40).

    That is the direction in which each size moves y9 and, at the displacement, the order of both
    alpha_KL.
    """
    upper = boundary[l_BC] > 0
    own = cache(partial(position_of, table, boundary))

    def beyond(other: Signs, place: int | str) -> Holds:
        there = position_of(table, other, place)
        return less(there, own(place)) if upper else less(own(place), there)

    neighbours = (
        beyond({**boundary, size: -sign}, place)
        for size, sign in boundary.items()
        for place in neighbours_at
    )
    flipped = {**boundary, alpha_KL: -boundary[alpha_KL]}
    return all_of(angles_in_range(table), beyond(flipped, displacement), *neighbours)


def in_all(statement: Callable[[PublishedSizes], Statement]) -> Conjunction:
    """State the same for all reconstructions."""
    return all_of(*map(statement, SETS))


def influence(size: sp.Symbol) -> Conjunction:
    """State that the position at -40 mm differs between the limits of the size, in all sets."""
    return in_all(
        lambda table: Holds(
            sp.Ne(
                position_of(table, {size: 1}, -40),
                position_of(table, {size: -1}, -40),
                evaluate=False,
            )
        )
    )


# Which tolerances cause the deviation at -40 mm, by the reconstructed sizes -----------------------

# Half the change (mm) of y9 between the limits of each size, for the three sets.
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
# Percentage of the nominal position: all at their worst together, and the root of the squares.
TOTALS = (("10.2", "4.5"), ("9.8", "4.2"), ("9.3", "4.1"))
# The factors of lever and rod, and of roller lever and wedge, for a small displacement there.
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
    """Write the parts of a size as a print."""
    first, *others = numbers
    between = r";\ "
    return rf"{NAMES[size]}\colon {first}\ ({between.join(others)})~\mathrm{{mm}}"


ROWS = (
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
        "the clearance, make up 94 to 95 % of the sum; tolerances of the roller lever three times "
        "as wide would add a tenth to it.",
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
