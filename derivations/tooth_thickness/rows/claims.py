"""Table 1 and the conclusions (a) to (e) of paper 3, and what follows for its numbers."""

from sympy import Interval, Rational, S, diff, pi, sqrt

from mechproof.record import *

from ..._metrology import POSITIVE
from ..mechanics import *

# The example of Table 1 ---------------------------------------------------------------------------

CAPTION = ("S27",)

EXAMPLE_ROWS = (
    PRINT.datum(
        "Table 1, accuracy degree",
        Definition(degree, S(6)),
        note="A datum; no formula of the paper uses it. Its digit is damaged; Figs. 4 and 5 have "
        "6H.",
        marks=("uncertain",),
    ),
    PRINT.datum(
        "Table 1, kind of mating",
        Definition(clearance, S.Zero),
        note="A datum; no formula of the paper uses it. That H requires no guaranteed clearance "
        "is taken from GOST 1643-81, by which the paper sets the requirements.",
        marks=("inferred",),
    ),
    PRINT.datum(
        "Table 1, ratio of tolerance and standard deviation",
        defines=(K,),
        note="A datum, the normal level of accuracy of the technology.",
    ),
    PRINT.datum(
        "Table 1, grade of the tip diameter",
        Definition(tip_tolerance, Rational(GRADES[6][1], 1000) * millimetre),
        note="A datum; the 25 µm are from ISO 286-1, not from the paper (see 'step 3, IT grades').",
        marks=("calibrated",),
    ),
    PRINT.datum(
        "Table 1, interval of the gauge",
        Definition(interval, Rational(GAUGE_UM, 1000) * millimetre),
        note="A datum; for which interval may be meant see 'steps 4 and 7, spread of the gauge'.",
    ),
    PRINT.claim(
        "Table 1, 50 of 50",
        all_of(
            PrintedNumber("100", 100 * Rational(50, 50)),
            PrintedNumber("100", 100 * NORMAL_SHARE),
        ),
        note="The share of the 50 and, to a whole per cent, that of all teeth at K = 6, which is "
        "99.73 % for a normal law in the middle of the field. For what 50 teeth can show of it "
        "see 'Table 1, 50 of 50, what it shows'.",
        marks=("calibrated",),
    ),
    ours(
        "Table 1, 50 of 50, what it shows",
        r"50\text{ of }50\text{ are to be expected in 87 \% of wheels at }K=6\text{, and not rare "
        r"(5 \%) with }94.2~\%\text{ of good teeth}",
        all_of(
            PrintedNumber("87", 100 * NORMAL_SHARE**50),
            less(Rational(1, 20), Rational("0.942") ** 50),
            less(Rational("0.941") ** 50, Rational(1, 20)),
        ),
        note="The one-sided 95 % bound of Clopper and Pearson lies between 94.1 and 94.2 % of "
        "good teeth. Normal law, centred.",
        marks=("consequence",),
    ),
    PRINT.claim(
        "Table 1, columns 4 to 6",
        Equality(e_tip + dh_gauge, height_towards_tip),
        corrected=Correction(
            r"(6)=\tfrac12\,(4)+(5)", Equality(e_tip / 2 + dh_gauge, height_towards_tip)
        ),
        note="The sum (6) = (4) + (5) of step 5, column 4 being that of the diameter.",
    ),
    PRINT.claim(
        "Table 1, column 9",
        Equality(E_true + K_m * dh + ds_gauge, reading),
        note="True deviation, error of thickness from the shift, error of the gauge; as in step 8.",
    ),
)


# The conclusions ----------------------------------------------------------------------------------

AS_PRINTED, BY_GEOMETRY = "printed", "involute"
# Percentage of good teeth rejected by grade, as printed and by the geometry: with a perfect gauge,
# and with the recommended one, whose limit error is 2 sigma.
PERFECT = {6: ("0.35", "0.11"), 7: ("1.00", "0.23"), 8: ("3.41", "0.57")}
RECOMMENDED = {6: ("0.41", "0.16"), 7: ("1.09", "0.28"), 8: ("3.53", "0.63")}
# Limit error (um) of 2 and of 3 sigma at which tip and gauge disturb equally, by the geometry.
CROSSOVERS = {6: ("2.5", "3.7"), 7: ("3.9", "5.9"), 8: ("6.2", "9.3")}
LAWS = "K = 6 for tooth and tip, normal laws, centred."
GRADE_COARSER = all_of(
    less(tip_spread(8, BY_GEOMETRY), tip_spread(7)),
    less(tip_spread(7, BY_GEOMETRY), tip_spread(6)),
)


def table(shares: dict[int, tuple[str, str]], limit_error: int) -> Statement:
    """State the percentage of good teeth rejected, as printed and by the geometry."""
    return all_of(
        *(
            PrintedNumber(number, 100 * rejected_by(grade, limit_error, 2, geometry))
            for grade, numbers in shares.items()
            for number, geometry in zip(numbers, (AS_PRINTED, BY_GEOMETRY), strict=True)
        )
    )


def write(shares: dict[int, tuple[str, str]]) -> str:
    """Write a table of such percentages as a print."""
    return r",\quad ".join(
        rf"\mathrm{{IT}}{grade}\colon {printed}\to {right}~\%"
        for grade, (printed, right) in shares.items()
    )


CLAIM_ROWS = (
    PRINT.claim(
        "(e)",
        all_of(
            Equality(
                error_variance(PRINTED_INFLUENCE, PRINTED_INFLUENCE).subs(
                    {sigma_height: 0, sigma_thickness: 0}
                ),
                (PRINTED_INFLUENCE * sigma_tip) ** 2,
            ),
            less(rejected_by(6, 0), rejected_by(7, 0)),
            less(rejected_by(7, 0), rejected_by(8, 0)),
        ),
        note="With a perfect gauge only the error from the tip is left, by steps 5 and 6 as "
        "printed, and the share of wrongly rejected teeth rises with the grade. The law of the "
        f"teeth themselves stays the same. {LAWS}",
        marks=("calibrated",),
    ),
    PRINT.claim(
        "(a), curves of Figs. 4 and 5",
        NotCheckable(
            "the curves are lost in the scan, and the text at hand has neither the laws nor the "
            "multiple of the limit error"
        ),
    ),
    ours(
        "(a), rise with the limit error",
        r"\frac{\partial}{\partial w}\tfrac12\left[\mathrm{erf}\frac{q_1}w"
        r"+\mathrm{erf}\frac{q_2}w\right]<0",
        less((sqrt(pi) * diff(chance_to_accept, width)).expand(), S.Zero),
        on=Part(
            "the expected reading of the tooth lies inside the limits",
            {above: POSITIVE, below: POSITIVE},
        ),
        note="A tooth whose expected reading lies q_1 and q_2 inside the limits is accepted less "
        "often as the normal error grows. With a centred gauge this holds for every good tooth: "
        "for every law of the true deviation Fig. 4 rises and Fig. 5 falls. A gauge with a bias, "
        "a parameter of the flow chart, accepts some teeth more often the more it scatters.",
    ),
    PRINT.claim(
        "(d)",
        less(tip_spread(7), tip_spread(8, BY_GEOMETRY)),
        corrected=Correction(
            r"\text{for gear wheels of degrees 6 and 7 the IT grades 7 and 8 of the tip diameter "
            r"can be recommended}",
            GRADE_COARSER,
        ),
        note="Refuted: that IT8 changes the thickness by more than the recommended IT7 does by "
        "the printed steps. The text at hand has no limit; any limit that admits IT7 by the "
        "printed steps admits IT8 by the geometry, for degree 7 and every tolerance.",
        marks=("calibrated",),
    ),
    PRINT.claim(
        "(d), literature",
        NotCheckable(
            "the text at hand says neither which share of good teeth may be rejected nor what the "
            "literature recommends for degrees other than 6 and 7"
        ),
    ),
    ours(
        "(d), good teeth rejected, perfect gauge",
        write(PERFECT),
        table(PERFECT, 0),
        note="By the steps as printed, and by the geometry with half the deviation of the "
        f"diameter. {LAWS}",
        marks=("consequence", "calibrated"),
    ),
    PRINT.claim(
        "(b)",
        less(crossover(6, BY_GEOMETRY), gauge_um),
        on=Part(
            "the gauge is no coarser than that of Table 1",
            {gauge_um: Interval.Lopen(0, GAUGE_UM)},
        ),
        holds_on=Part(
            "a limit error over 2.5 µm (2 sigma) or 3.7 µm (3 sigma), tip of IT6",
            {gauge_um: Interval.Lopen(Rational("1.2261"), GAUGE_UM)},
        ),
        note="Influences are compared by the standard deviations of the geometry, with which the "
        "shares rise; that of the tip is the IT tolerance over K. The gauge of Table 1 (50 µm) is "
        "above the crossover, the one recommended in (c) (2 µm) below it.",
        marks=("calibrated",),
    ),
    ours(
        "(b), crossovers",
        r"\text{the instrument has the stronger influence only above a limit error of }"
        + r"\text{, }".join(
            rf"{two}\text{{ to }}{three}~\mu\mathrm{{m}}\text{{ with IT{grade}}}"
            for grade, (two, three) in CROSSOVERS.items()
        ),
        all_of(
            *(
                PrintedNumber(number, multiple * crossover(grade, BY_GEOMETRY))
                for grade, numbers in CROSSOVERS.items()
                for multiple, number in zip((2, 3), numbers, strict=True)
            )
        ),
        note="The limit error, 2 or 3 sigma, of a gauge that disturbs the measurement as much as "
        "the tip does, by the geometry; the printed steps give about twice as much.",
        marks=("consequence", "calibrated"),
    ),
    PRINT.claim(
        "(c)",
        NotCheckable(
            "the text at hand has neither the share that is still allowed nor the tolerances of "
            "degrees 7 and 8"
        ),
        note="For what that gauge does to the wheel of degree 6 see '(c), good teeth rejected "
        "with the recommended gauge'.",
    ),
    PRINT.claim(
        "(c), degrees 6, 7 and 8",
        NotCheckable("the text at hand has a single U, for no named degree"),
    ),
    ours(
        "(c), good teeth rejected with the recommended gauge",
        write(RECOMMENDED),
        table(RECOMMENDED, RECOMMENDED_UM),
        note="By the steps as printed, and by the geometry with half the deviation of the "
        f"diameter. U = 2 sigma = 2 µm. {LAWS}",
        marks=("consequence", "calibrated"),
    ),
)

ROWS = (*EXAMPLE_ROWS, *CLAIM_ROWS)
