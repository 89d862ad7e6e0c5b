"""What follows from the rows for the sizes of Table 1; none of it is printed in the paper."""

import sympy as sp

from mechproof.record import PrintedNumber, Row, all_of, ours, rounded

from .mechanics import FIVE_ERRORS, first_order_remainder
from .symbols import *
from .table import SUM_OF_PRINTED_SQUARES, total_by_printed_sum

SQUARES = {error: PRINTED_VALUES[error] ** 2 for error in FIVE_ERRORS}
FARTHEST = (radius + amplitude).subs(PRINTED_VALUES)
TURNS = PRINTED_K.subs(PRINTED_VALUES)
LARGEST_HEIGHT_ERROR = FARTHEST * sp.sqrt(TURNS[0, 2] ** 2 + TURNS[1, 2] ** 2)
UNIFORM = sp.Integer(3)  # the square of the coefficient of a uniform law
HALF = sp.Rational(1, 2)


def gain(
    error: sp.Symbol,
    left: sp.Expr = sp.S.Zero,
    own: sp.Expr = sp.S.One,
    others: sp.Expr = sp.S.One,
) -> sp.Expr:
    """Fall of the total, in %, when this part of an error is left; K squared of it and the rest.

    It is the same for a temperature error of either kind that stays the same share of the total.
    """
    rest = others * (SUM_OF_PRINTED_SQUARES - SQUARES[error])
    before, after = (rest + own * part**2 * SQUARES[error] for part in (sp.S.One, left))
    return 100 * (1 - sp.sqrt(after / before))


def gain_by_printed_sum(error: sp.Symbol) -> sp.Expr:
    """Fall of the total by (6) as printed, in mm, when an error vanishes, in %."""
    before, after = (
        total_by_printed_sum(sp.S.One, SUM_OF_PRINTED_SQUARES - part)
        for part in (sp.S.Zero, SQUARES[error])
    )
    return 100 * (1 - after / before)


def share_of(error: sp.Symbol) -> sp.Expr:
    """Share of an error in the squared total of the five, in %."""
    return 100 * SQUARES[error] / SUM_OF_PRINTED_SQUARES


def radius_of_curvature(count: int, phase: sp.Expr) -> sp.Expr:
    """Radius of curvature, in mm, of the track with so many periods, as a size."""
    x, y = (c.subs({**PRINTED_VALUES, periods: count}) for c in PRINTED_16[:2])
    at = phase / count
    (dx, dy), (ddx, ddy) = ([c.diff(phi, order).subs(phi, at) for c in (x, y)] for order in (1, 2))
    return sp.Abs(sp.sqrt(dx**2 + dy**2) ** 3 / (dx * ddy - dy * ddx))


CONSEQUENCES: tuple[Row, ...] = (
    ours(
        "Consequences, shares of the errors",
        r"\Delta_y:49.4\,\%,\ \Delta_\delta:34.9\,\%,\ \Delta_u:8.7\,\%,\ \Delta_\phi:5.1\,\%,\ "
        r"\Delta_n:2.0\,\%\text{ of }q=\Delta_\phi^2+\Delta_y^2+\Delta_\delta^2+\Delta_n^2"
        r"+\Delta_u^2",
        all_of(*rounded(("5.1", "49.4", "34.9", "2.0", "8.7"), map(share_of, FIVE_ERRORS))),
        note="Mounting and elastic deformation make five sixths of the squared total, with all "
        "coefficients 1. A random temperature error of 15 % of the total takes 2.25 % of its "
        "square; these are the shares of the rest.",
        marks=("consequence",),
    ),
    ours(
        "Fig. 5, largest possible gain",
        r"1-\sqrt{(q-\Delta_\delta^2)/q}\approx19.3\,\%,\ "
        r"q=\Delta_\phi^2+\Delta_y^2+\Delta_\delta^2+\Delta_n^2+\Delta_u^2",
        PrintedNumber("19.3", gain(elastic)),
        note="With all errors of one law and the other errors of Table 1 unchanged, the total "
        "falls by no more than this even if the elastic error vanishes, whether the temperature "
        "error is random or systematic.",
        marks=("consequence",),
    ),
    ours(
        "Consequences, gain by other laws",
        r"38.0\,\%\text{ if }\Delta_\delta\text{ alone has }K_i=\sqrt3,\ 7.9\,\%\text{ if all"
        r" others have};\ 5.0\,\%\text{ by (6) as printed, in mm}",
        all_of(
            PrintedNumber("38.0", gain(elastic, own=UNIFORM)),
            PrintedNumber("7.9", gain(elastic, others=UNIFORM)),
            PrintedNumber("5.0", gain_by_printed_sum(elastic)),
        ),
        note="How far the bound of 19.3 % moves with what the text at hand does not have: for "
        "normal laws K_i = 1, for uniform ones the square root of 3.",
        marks=("consequence",),
    ),
    ours(
        "Consequences, half the mounting error",
        r"\Delta_y/2\text{ in the place of }\Delta_y\text{: }20.7\,\%\text{ less}",
        PrintedNumber("20.7", gain(mounting, left=HALF)),
        note="Halving the mounting error lowers the total by more than having no elastic error at "
        "all.",
        marks=("consequence",),
    ),
    ours(
        "Consequences, no form error",
        r"\Delta_\phi=0\text{: }2.6\,\%\text{ less}",
        PrintedNumber("2.6", gain(form)),
        note="In finish milling, by Table 1, the form error of the base surface accounts for no "
        "more than this.",
        marks=("consequence",),
    ),
    ours(
        "Consequences, turns alone",
        r"\max_{|p|\le R+A}|\Delta z_0|=0.0659\text{ mm at }z_{13}=0;\ "
        r"\Delta_\Sigma^{XY}=0.00146\,z_{13}\text{ on the axis}",
        all_of(
            PrintedNumber("0.0659", LARGEST_HEIGHT_ERROR),
            PrintedNumber("0.00146", sp.sqrt(TURNS[2, 0] ** 2 + TURNS[2, 1] ** 2)),
        ),
        note="By (15), with a = b = c = 0. In height the two turns of Table 1 alone can move a "
        "point of the track by nearly as much as all errors of (6) together (0.072 mm); in the "
        "plane they act in proportion to the height over O_1, by 1.46 µm for each millimetre.",
        marks=("consequence",),
    ),
    ours(
        "Consequences, first order",
        r"\tfrac12(R+A)(|\alpha|+|\beta|+|\gamma|)^2=0.000096\text{ mm}",
        PrintedNumber("0.000096", first_order_remainder(radius + amplitude).subs(PRINTED_VALUES)),
        note="At points with z_13 = 0, the shift plus the vector product of (alpha, beta, gamma) "
        "and the point gives (15) to within 0.1 µm. At these sizes neither the order of the turns "
        'nor the name "rotation vector" matters.',
        marks=("consequence",),
    ),
    ours(
        "Consequences, number of periods",
        r"\text{radius of curvature at a crest: }8.3\text{ mm for }z=7,\ 6.7\text{ mm for }"
        r"z=8;\text{ at a root for }z=7\text{: }11.0\text{ mm}",
        all_of(
            PrintedNumber("8.3", radius_of_curvature(7, sp.S.Zero)),
            PrintedNumber("6.7", radius_of_curvature(8, sp.S.Zero)),
            PrintedNumber("11.0", radius_of_curvature(7, sp.pi)),
        ),
        note="For R and A of Table 1. If (16) is the path of the centres of the balls, whose "
        "radius is 7.5 mm, a track of eight periods is undercut at its crests; one of seven is "
        "not, neither there nor at its roots.",
        marks=("consequence",),
    ),
)
