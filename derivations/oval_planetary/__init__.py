"""Paper 2: planetary mechanism with two external pairs of oval wheels."""

import sympy as sp

from mechproof.record import Cost, Finding, Paper, PublishedSizes, Together

from .equations import EQUATION_ROWS
from .kernels import QUANTITIES
from .mechanics import E_SERIES, PRINT, R4, R5, VARIABLES, phi1, position_of_one
from .pairs import CYLINDRICAL_PAIR_ROWS, OVAL_PAIR_ROWS
from .readings import LIMITS, MEASUREMENT_ROWS, READINGS
from .variants import VARIANT_ROWS, VARIANTS

DEGREE = sp.pi / 180
WITH_THE_CARRIER = position_of_one(E_SERIES)

FINDINGS = (
    Finding(
        "(1)-(11), sense of the output",
        "(7) and (10) count the output shaft against the sense of the carrier, and no sentence "
        "that survives says so; read in one sense, the output turns the wrong way.",
        costs=tuple(
            Cost(
                f"variant 1, {degrees}° of the carrier",
                {**VARIANTS[1], phi1: degrees * DEGREE},
                "°",
                printed=-WITH_THE_CARRIER,
                right=WITH_THE_CARRIER,
            )
            for degrees in (30, 60)
        ),
    ),
    Finding(
        "special case, angle of wheel 6",
        "For a cylindrical pair 4-5 only the radii are said to become numbers. (5), left as "
        "printed with e_1 = 0, turns wheel 6 as far as the carrier; without slip it turns R_4/R_5 "
        "times as far.",
        costs=tuple(
            Cost(
                f"wheel 6, variant {variant}, 30° of the carrier",
                {**VARIANTS[variant], phi1: 30 * DEGREE},
                "°",
                printed=phi1,
                right=R4 / R5 * phi1,
            )
            for variant in (3, 4)
        ),
    ),
    Finding(
        "measured functions adequate",
        "Neither a criterion of adequacy nor the readings are printed. By the paper's own numbers "
        "the intervals of variants 1, 3 and 4 exclude an error of zero, and single errors of "
        "variant 1 scatter by more than two encoders of 0.3 % of 360° allow.",
        costs=(
            *(
                Cost(
                    f"variant {variant}",
                    {},
                    "°",
                    decimals=2,
                    printed=abs(READINGS[variant].mean) * DEGREE,
                    right=2 * READINGS[variant].uncertainty * DEGREE,
                    names=("mean error", "2u"),
                )
                for variant in (1, 3, 4)
            ),
            Cost(
                "variant 1",
                {},
                "°",
                decimals=3,
                printed=READINGS[1].least_scatter * DEGREE,
                right=READINGS[1].scatter_within(LIMITS[1]) * DEGREE,
                names=("scatter u√n at least", "two encoders at most"),
            ),
        ),
    ),
)

PAPER = Paper(
    system="oval_planetary",
    citation=(
        "Prikhodko, Kurapov, Belina, Azizov, Polivoda 2024, planetary mechanism with oval "
        "wheels, EDN HZWKZJ"
    ),
    variables=VARIABLES,
    notation=PRINT.notation,
    where=PRINT.where,
    print=PRINT.file,
    rows=EQUATION_ROWS + OVAL_PAIR_ROWS + CYLINDRICAL_PAIR_ROWS + VARIANT_ROWS + MEASUREMENT_ROWS,
    quantities=QUANTITIES,
    together=(
        Together("motion", ("position", "ratio", "acceleration")),
        Together(
            "motion_cylindrical",
            ("position_cylindrical", "ratio_cylindrical", "acceleration_cylindrical"),
        ),
    ),
    published=tuple(
        PublishedSizes(f"variant {number}", sizes) for number, sizes in VARIANTS.items()
    ),
    findings=FINDINGS,
    conventions=(
        "Angles in radians, positive in the direction of the carrier's rotation; lengths in mm. "
        "The paper's (10) has the opposite sign."
    ),
)
