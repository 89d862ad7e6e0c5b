"""Sizes of paper 4, legible and reconstructed, and what the printed chain makes of them."""

from collections.abc import Callable, Mapping

import sympy as sp
from sympy import Rational, pi, sqrt

from mechproof.record import (
    Completion,
    Completions,
    Conjunction,
    Holds,
    PrintedNumber,
    Published,
    Statement,
    Toleranced,
)

from .mechanics import driven
from .prints import print_1, print_3, print_10
from .symbols import (
    PRINTED_Q,
    PRINTED_R,
    Q,
    alpha_DE,
    alpha_KL,
    alpha_LM,
    l_AB,
    l_BC,
    l_CD,
    l_DE,
    l_EF,
    l_GH,
    l_IK,
    l_KL,
    l_LM,
    l_MN,
    overlap,
    phi3,
    phi7,
    radicand,
    x1,
    x5,
)

Signs = Mapping[sp.Symbol, int]

# Nominal, upper and lower limit deviation (mm, degrees). Two reconstructions of what cannot be
# read, fitted to the printed crossing of two boundary curves at x1 = -29.4 mm, which therefore
# confirms neither; in both, lost upper deviations are +1.22 (BC) and, in the first, 0 (CD).
FIRST_SIZES = {
    l_AB: ("6.25", "0", "0"),
    l_BC: ("49.75", "1.22", "-1.22"),
    l_CD: ("38", "0", "-2.06"),
    l_DE: ("83", "0.92", "-1.05"),
    l_GH: ("2", "1.03", "-0.72"),
    l_KL: ("60", "0.2", "-0.2"),
    l_LM: ("145", "0.1", "-0.1"),
    alpha_DE: ("283.06", "0.62", "-1.10"),
    alpha_KL: ("65", "0.24", "-0.25"),
    alpha_LM: ("123.48", "0", "0"),
}
SECOND_SIZES = {
    **FIRST_SIZES,
    l_BC: ("39.75", "1.22", "-1.22"),
    l_CD: ("28", "1.19", "-2.06"),
    l_DE: ("70.83", "0.92", "-1.05"),
}
ANGLES = (alpha_DE, alpha_KL, alpha_LM)


def unit(size: sp.Symbol) -> sp.Expr:
    """Return what a number of the table of sizes is multiplied by: mm are kept, degrees are not."""
    return pi / 180 if size in ANGLES else sp.S.One


def reconstruct(table: Mapping[sp.Symbol, tuple[str, str, str]]) -> Published:
    """Return a reconstruction of the sizes, named by the three in which both differ."""
    chosen = ", ".join(f"{size} = {table[size][0]}" for size in (l_BC, l_CD, l_DE))
    sizes = {
        size: Toleranced(*(Rational(text) * unit(size) for text in texts))
        for size, texts in table.items()
    }
    return Published(
        f"the set reconstructed with {chosen}", sizes, ("calibrated", "fitted", "uncertain")
    )


FIRST_SET, SECOND_SET = reconstruct(FIRST_SIZES), reconstruct(SECOND_SIZES)

# Symbol, what is printed of it, the value taken for the row, is it uncertain?
LEGIBLE = (
    (l_AB, r"l_{AB}=6.25", "6.25", "", False),
    (l_BC, r"l_{BC}=19.75_{-1.22}", "19.75", "Digits uncertain, upper deviation lost.", True),
    (l_CD, r"l_{CD}=38_{-2.06}", "38", "Upper deviation lost.", True),
    (l_DE, r"l_{DE}=70.833\ (83)^{+0.92}_{-1.05}", "70.833", "Two strings, 70,833 and 83.", True),
    (l_EF, r"l_{EF}=4\pm0.3", "4", "Digits uncertain; without influence.", True),
    (l_GH, r"l_{GH'}=2^{+1.03}_{-0.72}", "2", "The primes vary from place to place.", True),
    (l_KL, r"l_{KL}=60\pm0.2", "60", "", False),
    (l_LM, r"l_{LM}=145\pm0.1", "145", "The sign of the lower deviation is lost.", True),
)
LEGIBLE_ANGLES = (
    (alpha_DE, r"\alpha_{DE}=283.06^{\circ\,+0.62}_{\;\;-1.10}", "283.06"),
    (alpha_KL, r"\alpha_{KL}=65^{\circ\,+0.24}_{\;\;-0.25}", "65"),
    (alpha_LM, r"\alpha_{LM}=123.48^\circ", "123.48"),
)
LOST = (
    (l_IK, r"l_{IK}=z1_{-0.3}", "Digits and upper deviation lost; without influence."),
    (l_MN, r"l_{MN}=\dots^{+0.00}_{-0.17}", "Digits lost; without influence."),
)
TOLERANCED = (l_BC, l_CD, l_DE, l_EF, l_GH, l_IK, l_KL, l_LM, l_MN, alpha_DE, alpha_KL)

# "+" is the upper limit, "-" the lower; what is not named is at its nominal value.
BOUNDARY_II = {
    l_BC: 1, l_CD: -1, l_DE: -1, l_GH: 1, l_KL: 1, l_LM: -1, alpha_DE: 1, alpha_KL: 1,
}  # fmt: skip
BOUNDARY_III = {size: -sign for size, sign in BOUNDARY_II.items()}
BOUNDARY_IV = {**BOUNDARY_III, alpha_KL: 1}
LENGTHS_OF_IV = {size: sign for size, sign in BOUNDARY_III.items() if str(size).startswith("l_")}


def limits(table: Published, signs: Signs) -> dict[sp.Symbol, sp.Expr]:
    """Return the exact sizes of a combination: nominal, or at the limit its sign names."""
    sizes = {}
    for size, value in table.sizes.items():
        assert isinstance(value, Toleranced)
        deviation = {1: value.upper, -1: value.lower}.get(signs.get(size, 0), sp.S.Zero)
        sizes[size] = value.nominal + deviation
    return sizes


def position_of(table: Published, signs: Signs, displacement: int | str) -> sp.Expr:
    """Compose the chain of (1), (3), (4), (7)/(8) and (10) at exact sizes: an exact number."""
    sizes = limits(table, signs)
    # Unevaluated: SymPy would spend seconds on assumptions of numbers that balls decide.
    with sp.evaluate(False):
        turned = print_1.xreplace({Q: PRINTED_Q}).xreplace({**sizes, x1: Rational(displacement)})
        run = driven.xreplace({overlap: print_3.xreplace({**sizes, phi3: turned}) - sizes[l_GH]})
        offset = PRINTED_R.xreplace({**sizes, x5: run})
        direction = sp.atan2(sqrt(sizes[l_KL] ** 2 - offset**2), offset)
        return print_10.xreplace({**sizes, phi7: direction - sizes[alpha_KL]})


def above(table: Published, one: Signs, other: Signs, displacement: int | str) -> Holds:
    """State that curve `one` lies above curve `other` at a displacement (mm)."""
    first, second = (position_of(table, signs, displacement) for signs in (one, other))
    return Holds(sp.Gt(first, second, evaluate=False))


def crossing(table: Published) -> Conjunction:
    """State that curves III and IV change order within half a last place around -29.4 mm."""
    return Conjunction(
        (
            above(table, BOUNDARY_III, BOUNDARY_IV, "-29.45"),
            above(table, BOUNDARY_IV, BOUNDARY_III, "-29.35"),
        )
    )


def spread(table: Published, displacement: int) -> sp.Expr:
    """Return the width between the boundaries II and III or IV."""
    lower = BOUNDARY_III if displacement > Rational("-29.4") else BOUNDARY_IV
    upper = position_of(table, BOUNDARY_II, displacement)
    return sp.Add(upper, -position_of(table, lower, displacement), evaluate=False)


def largest_at_the_end(table: Published) -> Conjunction:
    """State that the spread at -40 mm is not below that at -35, -30, ..., 0 mm."""
    at_the_end = spread(table, -40)
    return Conjunction(
        tuple(
            Holds(sp.Ge(at_the_end, spread(table, displacement), evaluate=False))
            for displacement in range(-35, 1, 5)
        )
    )


def ten_percent(table: Published) -> Conjunction:
    """State that both deviations at -40 mm round to 10 % of the nominal position."""
    nominal, upper, lower = (
        position_of(table, signs, -40) for signs in ({}, BOUNDARY_II, BOUNDARY_IV)
    )
    # The position is negative, so the upper boundary is the smaller one in amount.
    with sp.evaluate(False):
        deviations = (100 * (1 - upper / nominal), 100 * (lower / nominal - 1))
    return Conjunction(tuple(PrintedNumber("10", deviation) for deviation in deviations))


def in_both(statement: Callable[[Published], Statement]) -> Conjunction:
    """State the same of both reconstructions."""
    return Conjunction((statement(FIRST_SET), statement(SECOND_SET)))


def differ(statement: Callable[[Published], Statement]) -> Completions:
    """State a claim on which the reconstructions may differ."""
    return Completions(
        Completion(FIRST_SET.source, statement(FIRST_SET)),
        Completion(SECOND_SET.source, statement(SECOND_SET)),
    )


def signs_of_iv(table: Published) -> Conjunction:
    """State that of four ways to complete IV only -alpha_DE, +alpha_KL is lowest."""
    others = [
        {**LENGTHS_OF_IV, alpha_DE: one, alpha_KL: two} for one, two in ((1, 1), (1, -1), (-1, -1))
    ]
    return Conjunction(
        tuple(
            above(table, other, BOUNDARY_IV, displacement)
            for other in others
            for displacement in (-40, -35)
        )
    )


def radicand_of(displacement: int | str, guide: str) -> sp.Expr:
    """Return the radicand of Q over l_BC**2 at the legible sizes and the length `guide` of BC."""
    sizes = {**limits(FIRST_SET, {}), l_BC: Rational(guide), x1: Rational(displacement)}
    return radicand.subs(sizes)


def influence(size: sp.Symbol) -> Conjunction:
    """State that the position at -40 mm differs between the limits of the size, both sets."""
    return in_both(
        lambda table: Holds(
            sp.Ne(
                position_of(table, {size: 1}, -40),
                position_of(table, {size: -1}, -40),
                evaluate=False,
            )
        )
    )
