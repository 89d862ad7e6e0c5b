"""What misleads in paper 4, and what it costs at sizes reconstructed from its table."""

from __future__ import annotations

import sympy as sp
from sympy import Rational

from mechproof.record import Cost, Finding, PublishedSizes, Toleranced

from .boundaries import position_of
from .sizes import FIRST_SET, LEGIBLE
from .symbols import l_AB, l_BC, l_CD, l_GH

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
