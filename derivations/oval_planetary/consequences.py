"""What follows from the rows of paper 2 for its own numbers and conclusions."""

from __future__ import annotations

import sympy as sp

from mechproof.record import Claim, PrintedNumber, Row

from .._readings import if_u_is_s
from .._relations import all_of, less, not_above
from .mechanics import R4, R5, eta, phi1, position_45
from .pairs import edge
from .readings import GAINS, LIMITS, RATIOS, READINGS
from .variants import DWELL_3, with_cylinders

NEAR_REST = sp.Rational("0.01")
DWELL = with_cylinders(2 * R5 / R4 * sp.atan(edge), 3).subs(eta, NEAR_REST)
MOVED = with_cylinders(position_45, 3)

CONSEQUENCES: tuple[Row, ...] = (
    Claim(
        "near rest of variant 3",
        r"|\varphi_3'|\le0.01\text{ over }10.2^\circ\text{ of the carrier, in which the output "
        r"turns by }0.034^\circ",
        all_of(
            PrintedNumber("10.2", DWELL * 180 / sp.pi),
            PrintedNumber(
                "-0.034",
                (MOVED.subs(phi1, DWELL_3 + DWELL / 2) - MOVED.subs(phi1, DWELL_3 - DWELL / 2))
                * 180
                / sp.pi,
            ),
        ),
        note="Variant 3, called intermittent, rests only at single points; around each of them, "
        "three times in a turn of the carrier, the ratio stays below a hundredth over this angle. "
        "The output then turns by less than half a step of the encoder, 0.088°: its reading "
        "changes by one step at most.",
        marks=("ours", "consequence", "inferred"),
    ),
    Claim(
        "Table 2, scatter and two encoders",
        r"u\sqrt n=2.38^\circ,\ 0.55^\circ,\ 1.61^\circ,\ 2.08^\circ,\quad "
        r"u\sqrt n<M\sqrt{\tfrac n{n-1}},\quad "
        r"M=1.08^\circ(1+\max|\varphi_3'|)=2.43^\circ,\ 1.62^\circ,\ 2.43^\circ,\ "
        r"2.88^\circ,\quad\max|\varphi_3'|=1.25,\ 0.50,\ 1.25,\ 1.67",
        all_of(
            *(
                PrintedNumber(printed, line.implied_scatter)
                for printed, line in zip(
                    ("2.38", "0.55", "1.61", "2.08"), READINGS.values(), strict=True
                )
            ),
            *(
                PrintedNumber(printed, limit)
                for printed, limit in zip(
                    ("2.43", "1.62", "2.43", "2.88"), LIMITS.values(), strict=True
                )
            ),
            *(
                less(line.least_scatter, line.scatter_within(LIMITS[variant]))
                for variant, line in READINGS.items()
            ),
            *(
                statement
                for variant, printed in enumerate(("1.25", "0.50", "1.25", "1.67"), start=1)
                for statement in (
                    PrintedNumber(printed, GAINS[variant]),
                    not_above(-GAINS[variant], RATIOS[variant]),
                    not_above(RATIOS[variant], GAINS[variant]),
                )
            ),
        ),
        note="If u belongs to the mean, two encoders that keep to 0.3 % of 360° may explain "
        "how single errors scatter, whatever offset manufacture adds; in variant 1 only if both "
        "are nearly at their limits all the time: u at the lower end of its rounding gives 2.315°"
        ", and the bound is 2.437°.",
        marks=("ours", "inferred", "consequence"),
    ),
    if_u_is_s(
        "Table 2",
        READINGS,
        halves=("0.027", "0.006", "0.015", "0.022"),
        distances=("57", "12", "170", "50"),
    ),
)
