"""Rows of paper 3 on the design data, the smallest deviation and the measuring base."""

from __future__ import annotations

from sympy import Ne, Rational, S, acos, atan, cos, diff, pi, sqrt

from mechproof.record import (
    Claim,
    Completion,
    Completions,
    Conjunction,
    Correction,
    Equality,
    Holds,
    PrintedNumber,
    Reading,
)

from .._relations import less, not_above
from .geometry import (
    chord_by_thinning,
    height_deviation,
    influence,
    involute_chord,
    nominal_height,
    rack_chord,
    rack_height,
)
from .shares import UPWARD
from .symbols import E_cs, T_c, alpha, chord_height, dh_gauge, incline, m, place, thinning
from .wheel import DECREASE_UM, MODULE, PROFILE_ANGLE, TEETH, TOLERANCE_UM, at_angle

DESIGN_ROWS = (
    Claim(
        "data, pitch diameter",
        r"d=150~\mathrm{mm}\quad(m=3~\mathrm{mm},\ z=50)",
        PrintedNumber("150", MODULE * S(TEETH)),
    ),
    Claim(
        "data, constant chord",
        r"\bar S_c=4.161~\mathrm{mm}",
        PrintedNumber("4.161", at_angle(rack_chord, 20)),
        note="With the profile angle 20 deg, which is not printed; it is fitted to this number.",
        marks=("fitted",),
    ),
    Claim(
        "data, height to the constant chord",
        r"\bar h_c=2.243~\mathrm{mm}",
        PrintedNumber("2.243", at_angle(rack_height, 20)),
        note="With 20 deg from the constant chord and an addendum of one module.",
        marks=("calibrated",),
    ),
    Claim(
        "data, profile angle",
        r"\bar S_c=4.161\text{ mm solved for the profile angle: }20.0^\circ",
        PrintedNumber("20.0", 180 / pi * acos(sqrt(2 * Rational("4.161") / (pi * MODULE)))),
        marks=("ours",),
    ),
    Claim(
        "data, no other profile angle",
        r"4.161\text{ and }2.243\text{, rounded, leave }19.99^\circ<\alpha<20.01^\circ",
        Conjunction(
            (
                Equality(rack_chord.subs(alpha, atan(incline)), pi * m / 2 / (1 + incline**2)),
                less(diff(pi * m / 2 / (1 + incline**2), incline), S.Zero),
                Equality(
                    rack_height.subs(alpha, atan(incline)),
                    m * (1 - pi / 4 * incline / (1 + incline**2)),
                ),
                less(diff(m * (1 - pi / 4 * incline / (1 + incline**2)), incline), S.Zero),
                less(Rational("4.1615"), at_angle(rack_chord, "19.99")),
                less(at_angle(rack_height, "20.01"), Rational("2.2425")),
            )
        ),
        note=(
            "Chord and height both fall as the angle grows (to 45 deg). At 19.99 deg the chord "
            "is too long already, at 20.01 deg the height is too small."
        ),
        marks=("ours",),
    ),
    Claim(
        "constant chord",
        r"\bar S_c=\frac{\pi m}2\cos^2\alpha",
        Equality(rack_chord, involute_chord),
        note=(
            "Where the rack touches both flanks at once, from the rack (foot of the perpendicular "
            "from the pitch point) and from the involute; the number of teeth drops out."
        ),
        marks=("ours",),
    ),
    Claim(
        "height to the constant chord",
        r"\bar h_c=m\left(1-\frac\pi8\sin2\alpha\right)",
        Conjunction(
            (
                Equality(chord_height, rack_height),
                Equality(rack_height, nominal_height),
            )
        ),
        note="From the rack and from the involute, addendum of one module.",
        marks=("ours",),
    ),
    Claim(
        "smallest deviation, smallest prescribed decrease",
        r"E_{cs}\text{ is the smallest prescribed decrease; good: }"
        r"E_{cs}-T_c<E_{csu}<E_{cs}",
        not_above(E_cs, -(E_cs - T_c * place)),
        readings=(
            Reading(
                "E_cs enters step 2 with its sign, as the upper deviation -12 um",
                not_above(E_cs, -(-E_cs - T_c * place)),
            ),
        ),
        note=(
            "E_csu = E_cs - T_c p, 0 < p < 1, is any good tooth of step 2; its decrease is -E_csu. "
            "With E_cs = 12 um as printed, good teeth may be thicker than nominal."
        ),
    ),
    Claim(
        "smallest deviation, counted as a decrease",
        r"E_{csu}\text{ counts the decrease; good: }E_{cs}-T_c<E_{csu}<E_{cs}",
        not_above(E_cs, E_cs - T_c * place),
        corrected=Correction(r"E_{cs}<E_{csu}<E_{cs}+T_c", not_above(E_cs, E_cs + T_c * place)),
        note="If the simulated deviation is itself a decrease, step 2 admits only smaller ones.",
        marks=("ours",),
    ),
    Claim(
        "smallest deviation, nominal tooth",
        r"E_{csu}=0\text{ is good by step 2 with }E_{cs}=12,\ T_c=45~\mu\mathrm m",
        Conjunction((less(S.Zero, S(DECREASE_UM)), less(S(DECREASE_UM - TOLERANCE_UM), S.Zero))),
        note="A tooth with no decrease at all passes, though 12 um is the smallest prescribed one.",
        marks=("ours",),
    ),
    Claim(
        "smallest deviation, decrease and backlash",
        r"\text{a thinner pitch arc thins the constant chord by the same amount}",
        Equality(chord_by_thinning, thinning),
        note=(
            "First order, measured at the fixed height: dS = ds on the pitch circle, so this wheel "
            "gives the normal backlash E_cs cos(alpha)."
        ),
        marks=("ours",),
    ),
    Claim(
        "smallest deviation, guaranteed side clearance",
        r"E_{cs}\text{ determines the guaranteed side clearance}",
        Completions(
            Completion(
                "the mate is thinned by 12 um, too: the clearance along the normal is over 15 um",
                less(S(15), 2 * DECREASE_UM * cos(PROFILE_ANGLE)),
            ),
            Completion(
                "the mate is not thinned: the same",
                less(S(15), DECREASE_UM * cos(PROFILE_ANGLE)),
            ),
        ),
        note="The mate and the centre distance have their share, and neither is printed.",
    ),
    Claim(
        "measuring base",
        r"\text{if the tip diameter differs from nominal, the height gets an error}",
        Holds(Ne(height_deviation.subs(dh_gauge, 0), 0, evaluate=False)),
        on=UPWARD,
        note="Half the deviation, and negative: the gauge stands higher, its line nearer the tip.",
    ),
    Claim(
        "measuring base, thickness",
        r"\text{the error of the height leads to an error of the thickness}",
        Conjunction(
            (
                Equality(2 * incline, influence.subs(alpha, atan(incline))),
                less(S.Zero, 2 * incline),
            )
        ),
        note="The derivative is positive: deeper is thicker, so a larger tip diameter makes the "
        "measured tooth thinner.",
    ),
)
