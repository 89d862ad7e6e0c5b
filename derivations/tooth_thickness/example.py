"""Rows of paper 3 on the example of Table 1."""

from sympy import Rational, S

from mechproof.record import Correction, Definition, Equality, PrintedNumber, all_of, less, ours

from .mechanics import GAUGE_UM, GRADES, NORMAL_SHARE, height_towards_tip, reading
from .symbols import *

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
