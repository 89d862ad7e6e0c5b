"""Paper 3: thickness of gear teeth, measured with a gear-tooth gauge, and the sorting by it."""

from sympy import Expr, Rational, S, sqrt

from mechproof.record import Cost, Finding, Follower, Paper, PublishedSizes

from .algorithm import ALGORITHM_ROWS
from .claims import CLAIM_ROWS
from .design import DESIGN_ROWS, PARAMETER_ROWS
from .example import EXAMPLE_ROWS
from .influence import INFLUENCE_ROWS
from .kernels import QUANTITIES
from .mechanics import (
    DECREASE_UM,
    GAUGE_UM,
    GRADES,
    K_PRINTED,
    NOTATION,
    PRINT,
    PRINTED_SIZES,
    RECOMMENDED_UM,
    TEETH,
    VARIABLES,
    WHEEL,
    E_true,
    K_m,
    dh,
    dh_gauge,
    ds_gauge,
    e_tip,
    gauge_spread,
    rejected_by,
    tip_spread,
)

MICROMETRE = Rational(1, 1000)
LAWS = f"normal laws, centred, K = {K_PRINTED}"
READINGS_OF_50 = ("as the full width of 3 sigma", "as half the width of 2 sigma")
SPREAD_6 = Rational(GRADES[6][1], K_PRINTED) * MICROMETRE
# A tip circle off by the whole tolerance, a gauge without error.
TIP_6 = {**WHEEL, e_tip: GRADES[6][1] * MICROMETRE, dh_gauge: S.Zero}


def rejected_at_8(geometry: str) -> Expr:
    """Share of good teeth rejected by a perfect gauge on a tip circle of IT8."""
    return rejected_by(8, 0, geometry=geometry)


FINDINGS = (
    Finding(
        "smallest deviation, smallest prescribed decrease",
        "E_cs = 12 µm is called the smallest prescribed decrease, but with its plus sign step 2 "
        "passes teeth up to 12 µm thicker than nominal as good; it has to enter with a minus.",
        costs=(
            Cost(
                "thickest good tooth, from nominal",
                {},
                "µm",
                0,
                DECREASE_UM * MICROMETRE,
                -DECREASE_UM * MICROMETRE,
            ),
        ),
    ),
    Finding(
        "step 3, a new tip deviation for each tooth",
        "A new deviation of the tip diameter is simulated for each tooth. If the teeth are those "
        "of one wheel, which is not said, they have one tip circle, whose error does not average "
        "out over them.",
        costs=(
            Cost(
                "spread of the tip circle's mean over the wheel, IT6",
                {},
                "µm",
                printed=SPREAD_6 / sqrt(TEETH),
                right=SPREAD_6,
                names=("a deviation per tooth", "one per wheel"),
            ),
        ),
    ),
    Finding(
        "steps 4 and 7, spread of the gauge",
        "Which interval the 50 µm of the gauge are is not printed, nor how many standard "
        "deviations it spans; the shares depend on it.",
        costs=(
            Cost(
                "standard deviation of the gauge",
                {},
                "µm",
                printed=Rational(GAUGE_UM, 6) * MICROMETRE,
                right=Rational(GAUGE_UM, 2) * MICROMETRE,
                names=READINGS_OF_50,
            ),
            Cost(
                f"good teeth rejected, tip of IT6, steps as printed, {LAWS}",
                {},
                "%",
                printed=rejected_by(6, Rational(GAUGE_UM, 2), 3),
                right=rejected_by(6, GAUGE_UM, 2),
                names=READINGS_OF_50,
            ),
        ),
    ),
    Finding(
        "step 5",
        "The whole deviation of the tip diameter is added to the height, where only half of it, "
        "that of the tip circle's radius on which the gauge stands, can enter. In which sense it "
        "counts is not printed.",
        costs=(
            Cost(f"Δh for a tip diameter {GRADES[6][1]} µm too large (IT6)", TIP_6, "µm"),
            Cost(
                "measured thickness for it",
                TIP_6,
                "µm",
                printed=(e_tip + dh_gauge) * K_m,
                right=(e_tip / 2 + dh_gauge) * K_m,
            ),
            Cost(
                f"good teeth rejected, tip of IT8, perfect gauge, {LAWS}",
                {},
                "%",
                2,
                rejected_at_8("printed"),
                rejected_at_8("involute"),
            ),
        ),
        follows=(
            "controlled parameters, expectation of the error",
            Follower("steps 5 and 6, tip diameter alone", parts={e_tip: -e_tip / 2}),
        ),
    ),
    Finding(
        "(b)",
        "That the gauge matters more than a tip diameter of IT6 holds from a limit error of 5 to "
        "7 µm on; for the gauge that (c) recommends it is the other way round.",
        costs=(
            Cost(
                f"spread of the thickness, gauge of ±{RECOMMENDED_UM} µm (3 sigma), tip of IT6",
                {},
                "µm",
                printed=gauge_spread(Rational(RECOMMENDED_UM, 3)) * MICROMETRE,
                right=tip_spread(6) * MICROMETRE,
                names=("gauge", "tip diameter"),
            ),
        ),
    ),
)

PAPER = Paper(
    system="tooth_thickness",
    citation="Paper 3: stochastic simulation of tooth thickness and of its measurement",
    variables=VARIABLES,
    notation=NOTATION,
    where=PRINT.where,
    print=PRINT.file,
    rows=(
        *DESIGN_ROWS,
        *INFLUENCE_ROWS,
        *PARAMETER_ROWS,
        *ALGORITHM_ROWS,
        *EXAMPLE_ROWS,
        *CLAIM_ROWS,
    ),
    quantities=QUANTITIES,
    published=(
        PublishedSizes("paper on tooth thickness, design data", PRINTED_SIZES, ("fitted",)),
    ),
    # A tip diameter off by IT6, a gauge and a tooth off by less.
    usual={
        e_tip: Rational(25, 1000),
        dh_gauge: Rational(10, 1000),
        ds_gauge: Rational(10, 1000),
        E_true: Rational(-30, 1000),
        dh: Rational(20, 1000),
    },
    findings=FINDINGS,
    conventions="Lengths in mm, angles in rad. Heights grow from the tip towards the centre; "
    "deviations of thickness are positive for a thicker tooth.",
)
