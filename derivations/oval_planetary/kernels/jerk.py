"""The jerk of paper 2: forms, their proofs and accuracy."""

import sympy as sp

from mechproof.record import Accuracy, Form, Periodicity, Quantity, Scale

from ..._eccentric import by_half_angle, directly, jerk_quotient, jerk_scale
from ..mechanics import *
from . import forms
from .charts import MOUNTED_NEGATED, MOUNTED_ROUNDER, NEGATED, OF_JERK
from .motion import OF_CYLINDERS, OF_OVALS, SINGULAR_CYLINDERS, SINGULAR_OVALS, SOURCE

JERK = sp.diff(ACCELERATION, phi1)
JERK_CYLINDRICAL = sp.diff(ACCELERATION_CYLINDRICAL, x) * 2 * k

# Z, the sum of TILT, is z0*(1 - t**2) + z1*t; dZ/dphi1 - 2*t*Z = z1*(1 - t**2) - 4*z0*t.
BEND = (
    (swing * (lesser + both) + rise**2) * (1 - t**2),
    -shift * (shift + 2 * lesser) * (1 - t**2),
    -4 * rise * (lesser + shift) * t,
)
FORM = (
    2
    * forms.WHEEL_3_FORM
    * (sum(BEND) - 4 * sum(forms.TILT) ** 2 / forms.SPREAD_FORM)
    / forms.SPREAD_FORM
)


# Accuracy. Both are differences, with an accuracy relative to their terms: some 30 operations, plus
# the effect of the terms of y, changed against each other, and of eps*x, as for the acceleration.
TERMS = Scale(
    "the larger of the terms, and what the roundings of y make of them",
    forms.W
    / forms.S
    * (
        2
        * (
            (swing * (lesser + both) + rise**2 + shift * (shift + 2 * lesser)) * (1 + forms.T**2)
            + 4 * sp.Abs(rise * forms.T) * (lesser + shift)
        )
        + 8 * forms.Z**2 / forms.S
        + 16
        * sp.Abs(forms.Z * forms.CHANGE)
        * (sp.Abs(rise - shift * forms.T) + sp.Abs(lesser + y))
        / forms.S
    ),
    (
        *forms.STEPS,
        forms.WHEEL_3,
        (swing, GIVEN[swing]),
        (forms.Z, sum(forms.TILT).xreplace(forms.OF_T)),
    ),
)
# k**3, times a tiny e2, and divided by a tiny number where e2 is next to 1.
CUBE_OF_SPEED = (R4 >= R5 / 10**30, R4 <= 10**80 * R5)
# Next to half turns of x it divides by a power of the tangent before it multiplies.
NO_UNDERFLOW_OF_CUBES = sp.Or(sp.Eq(e2, 0), sp.Ge(e2, sp.Rational(1, 2**300)))
TERMS_CYLINDRICAL = jerk_scale(8 * e2 * k**3 * (1 - e2**2), e2, x, forms.EPS_X, forms.OF_X)

QUANTITIES = (
    Quantity(
        "jerk",
        "Compute d acceleration/d phi1, the jerk of the output at unit carrier speed.",
        OF_OVALS,
        JERK,
        (
            Form(
                "quotient in tan(phi1)",
                FORM,
                ("low_product",),
                states=forms.by_parts(JERK),
                charts=MOUNTED_ROUNDER,
                mirrors=MOUNTED_NEGATED,
            ),
            Form(
                "double angles",
                sp.diff(ratio_of_map(*forms.DOUBLE), phi1, 2),
                key="direct",
                states=forms.by_map(JERK),
            ),
        ),
        f"{SOURCE}, second derivative of (10)",
        accuracy=Accuracy(30, TERMS, forms.NO_UNDERFLOW),
        singular=SINGULAR_OVALS,
        periodicity=Periodicity(sp.pi),
    ),
    Quantity(
        "jerk_cylindrical",
        "Compute d acceleration/d phi1 with a cylindrical pair 4-5.",
        OF_CYLINDERS,
        JERK_CYLINDRICAL,
        (
            by_half_angle(jerk_quotient(8 * e2 * k**3 * (1 - e2**2), e2, x), OF_JERK, NEGATED),
            directly(JERK_CYLINDRICAL),
        ),
        f"{SOURCE}, second derivative of (10), pair 4-5 cylindrical",
        accuracy=Accuracy(
            24,
            TERMS_CYLINDRICAL,
            (*forms.LOW_WORD, *CUBE_OF_SPEED, *forms.NO_UNDERFLOW_OF_LEAD, NO_UNDERFLOW_OF_CUBES),
        ),
        singular=SINGULAR_CYLINDERS,
        periodicity=Periodicity(sp.pi / k),
    ),
)
