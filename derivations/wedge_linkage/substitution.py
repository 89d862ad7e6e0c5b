"""Rows of paper 4 on the chain that substitution gives, and on the one place that it lacks."""

import sympy as sp
from sympy import pi

from mechproof.record import Correction, Equality, Part, PrintedNumber, all_of, less, ours, rounded

from .boundaries import upright_at, upright_wedge
from .chain import PUSHED_IN_PRINT
from .group_rows import ONE_FORM
from .mechanics import (
    BEFORE_PIVOT,
    FIRST_QUADRANT,
    SECOND_QUADRANT,
    cosine_of_sigma,
    cosine_of_tau,
    direction_sigma,
    direction_tau,
    half_7,
    lever_angle,
    rod,
    upright,
    wedge,
)
from .proofs import push_by
from .sizes import SETS
from .symbols import *

SUBSTITUTED = "(1), (3), (4), (7), (8), (10), substituted"
SUBSTITUTION_ROWS = (
    ours(
        "(7) and (8), at R = 0",
        r"\varphi_7=\tfrac\pi2-\alpha_{KL}\text{ for }R=0",
        Equality(pi / 2 - alpha_KL, direction_tau.subs(tau, 1) - alpha_KL),
        note="KL is upright: tau = 1. Both (7) and (8) tend to this value.",
    ),
    ours(
        "(7) and (8), where R = 0",
        r"R=0\text{ at }x_1=-15.7\ (-14.8;\ -14.9)~\mathrm{mm},\quad y_9=-45.1~\mathrm{mm}",
        all_of(
            *rounded(("-15.7", "-14.8", "-14.9"), map(upright_at, SETS)),
            *(PrintedNumber("-45.1", upright_wedge(table)) for table in SETS),
        ),
        note="First set of reconstructed sizes (second; third): where KL is upright, in the "
        "middle of Fig. 4. The position of the wedge there depends only on l_KL, l_LM and their "
        "angles.",
        marks=("consequence", "calibrated"),
    ),
    PRINT.claim(
        SUBSTITUTED,
        all_of(
            Equality(print_1, lever_angle),
            Equality(print_3, rod),
            *push_by(PUSHED_IN_PRINT),
            Equality(print_7.subs(R, l_KL * cosine_of_tau), direction_tau - alpha_KL),
            Equality(print_8.subs(R, l_KL * cosine_of_sigma), direction_sigma - alpha_KL),
            Equality(print_10, wedge),
            less(sp.S.Zero, cosine_of_tau),
        ),
        corrected=Correction(
            ONE_FORM,
            Equality(upright(2 * sp.atan(half_7)), 2 * sp.atan(tau) - 2 * sp.atan(kappa)),
        ),
        note="Stated are each stage, compared with its group, and that R is not 0, since the "
        "arctangents of (7) and (8) divide by it. The corrected form replaces both.",
        on=Part(
            f"{BEFORE_PIVOT.text}; KL points upwards",
            {kappa: POSITIVE, tau: sp.Interval(0, 1), **SECOND_QUADRANT.within},
            BEFORE_PIVOT.where,
        ),
        holds_on=Part("R > 0 for (7), R < 0 for (8)", FIRST_QUADRANT.within),
        marks=("rebuilt", "uncertain"),
    ),
)
