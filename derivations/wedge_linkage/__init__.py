"""Paper 4: pusher, lever, rod, roller lever and wedge, split into four Assur groups."""

import sympy as sp
from sympy import Rational

from mechproof.record import Cost, Finding, Paper, PublishedSizes, Toleranced

from . import chain, conditioning, mechanics, proofs, sizes
from .boundaries import position_of
from .group_rows import GROUP_ROWS
from .kernels import QUANTITIES
from .sizes import FIRST_SET, LEGIBLE, SECOND_SET, SIZE_ROWS
from .symbols import PRINT, error, l_AB, l_BC, l_CD, l_GH, own_error, stage_ratio
from .tolerances import RANGE_ROWS
from .transfer import TRANSFER_ROWS

ZERO = sp.S.Zero
# With the rod's x5 in (6) to (8) the link 5' would follow as if there were no clearance.
NO_CLEARANCE = PublishedSizes(
    FIRST_SET.source,
    {**FIRST_SET.sizes, l_GH: Toleranced(ZERO, ZERO, ZERO)},
    FIRST_SET.marks,
)
BY_SET = "first reconstructed set of sizes"


def end_of_q() -> sp.Expr:
    """Return the displacement (mm) at which Q of (1) stops being real, at the legible sizes."""
    legible = {symbol: Rational(value) for symbol, _, value, *_ in LEGIBLE}
    arms = legible[l_AB] + legible[l_CD]
    return sp.sqrt(arms**2 - legible[l_BC] ** 2) - arms


FINDINGS = (
    Finding(
        "(6), Ox",
        "(6) to (8) are printed with the displacement x_5 of the rod, but the roller lever is "
        "driven by the link 5' behind the clearance: x_5' is meant (a prime may be lost). As "
        "printed, (4) would never be used.",
        costs=tuple(
            Cost(
                f"y_9 at x_1 = {displacement} mm, {BY_SET}",
                {},
                "mm",
                2,
                printed=position_of(NO_CLEARANCE, {}, displacement),
                right=position_of(FIRST_SET, {}, displacement),
            )
            for displacement in (-10, -40)
        ),
    ),
    Finding(
        "sizes, domain of Fig. 4",
        "With the legible l_BC = 19.75 mm the guide cannot follow the pusher over the range of "
        "Fig. 4: a digit of the table must be another.",
        costs=(
            Cost(
                "pusher moves to x_1",
                {},
                "mm",
                2,
                Rational(-40),
                end_of_q(),
                ("in Fig. 4", "with the legible sizes"),
            ),
        ),
    ),
)

PAPER = Paper(
    system="wedge_linkage",
    citation=(
        "Bazuev, Koksharov, Naichuk 2021, transfer function of a rod semi-automatic, "
        "doi 10.15593/2224-9982/2021.64.07"
    ),
    variables=tuple(
        variable
        for module in (mechanics, chain, conditioning, proofs, sizes)
        for variable in module.VARIABLES
    ),
    notation=PRINT.notation,
    print=PRINT.file,
    rows=(*GROUP_ROWS, *TRANSFER_ROWS, *SIZE_ROWS, *RANGE_ROWS),
    quantities=QUANTITIES,
    published=(FIRST_SET, SECOND_SET),
    usual={error: sp.S.One, stage_ratio: sp.S.Half, own_error: sp.Rational(1, 5)},
    findings=FINDINGS,
    conventions=(
        "Displacements and rotations are counted from the position x1 = 0; angles from Ox, "
        "positive counter-clockwise; x to the right, y upwards."
    ),
)
