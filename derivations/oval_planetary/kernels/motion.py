"""Quantities of paper 2: ratio, position and acceleration, and every form of them."""

import sympy as sp

from mechproof.record import *

from ..._eccentric import by_half_angle, directly, on_branch
from ..mechanics import *
from ..rows.equations import print_10, print_radius
from . import forms
from .charts import MOUNTED, MOUNTED_NEGATED, MOUNTED_ROUNDER, NEGATED, PLAIN, SMOOTH, STEEP

BRANCH_OF_X = Part("|x| < pi, the first branch", {x: sp.Interval.open(-sp.pi, sp.pi)})


def over_turns(code: EmittedForm) -> Statement:
    """State the form at x + 2*pi*m for |x| < pi, where its floor is m."""
    whole = phi1 - driven_angle(e2, x / 2)
    return all_of(
        on_branch(code.output(x), whole, {x: x + 2 * sp.pi * turns}, turns),
        Equality(whole, POSITION_CYLINDRICAL),
    )


# The bounds of the derivatives of the position are stated up to here.
FLAT = sp.Rational(999, 1000)
ECCENTRICITIES = (0, 0.28, 0.5, 0.9, 0.99, 1)
CARRIER = Argument(
    "phi1", (phi1,), "carrier angle, any number of turns", "rad", usual=(0, 10, 1000)
)
OVAL_63 = Argument("e2", (e2,), "eccentricity of the oval pair 6-3", usual=ECCENTRICITIES)
OF_OVALS = (
    CARRIER,
    Argument("e1", (e1,), "eccentricity of the oval pair 4-5", usual=(0, 0.5, 1)),
    OVAL_63,
    Argument(
        "mount",
        (mount,),
        "turn of wheel 6 on its shaft, forward from its place in the paper",
        "rad",
        0.0,
        usual=(0, 0.4, float(sp.pi)),
    ),
)
OF_CYLINDERS = (
    CARRIER,
    Argument("R4", (R4,), "radius of the cylindrical sun 4", "mm"),
    Argument("R5", (R5,), "radius of the cylindrical wheel 5", "mm"),
    OVAL_63,
)

# A wheel makes quarter turns; the major axes of the pair 6-3 meet, where the ratio is steep; wheel
# 6 is mounted along an axis; equal ovals; round and flat ones.
SINGULAR_OVALS = tuple(
    map(
        Singular,
        (
            sp.Eq(phi1, sp.pi / 2 * m),
            sp.Eq(
                (1 + e1) * sp.sin(phi1) * sp.cos(mount) + (1 - e1) * sp.cos(phi1) * sp.sin(mount), 0
            ),
            sp.Eq(mount, sp.pi / 2 * m),
            sp.Eq(e1, e2),
            sp.Eq(e1, 0),
            sp.Eq(e2, 0),
            sp.Eq(e1, 1),
            sp.Eq(e2, 1),
        ),
    )
)

# The ratio is farthest from 1 and nearest to it; equal circles; double zeros of the ratio; the
# round and the flat oval.
SINGULAR_CYLINDERS = tuple(
    map(
        Singular,
        (
            sp.Eq(x, 2 * sp.pi * m),
            sp.Eq(x, sp.pi + 2 * sp.pi * m),
            sp.Eq(R4, R5),
            sp.Eq(k * (1 - e2), 1 + e2),
            sp.Eq(k * (1 + e2), 1 - e2),
            sp.Eq(e2, 0),
            sp.Eq(e2, 1),
        ),
    )
)

SOURCE = "Prikhodko et al. 2024 (oval wheels)"
HALF_ANGLE = (1 - e2) ** 2 + 4 * e2 * sp.sin(x / 2) ** 2

QUANTITIES = (
    Quantity(
        "ratio",
        "Compute the transmission ratio d phi3/d phi1 of the output wheel to the carrier.",
        OF_OVALS,
        RATIO,
        (
            Form(
                "quotient in tan(phi1)",
                1 - forms.WHEEL_3_FORM,
                states=forms.by_parts(RATIO, swing),
                charts=MOUNTED,
                mirrors=MOUNTED_NEGATED,
            ),
            Form(
                "printed (3)-(6), (10)",
                -print_10.subs(forms.PRINTED_RADII).subs(a, 1),
                key="printed",
                states=forms.as_printed,
                source=f"{SOURCE}, equations (3)-(6) and (10)",
                note="the print with its sign reversed, wheel 6 at its mounted angle; proved to be "
                "the speed of wheel 3, which the row on any mount has for the map",
            ),
            Form(
                "double angles",
                ratio_of_map(*forms.DOUBLE),
                key="direct",
                states=forms.by_map(RATIO),
            ),
        ),
        f"{SOURCE}, equation (10)",
        accuracy=forms.ACCURACY["ratio"],
        singular=SINGULAR_OVALS,
        periodicity=Periodicity(sp.pi),
    ),
    Quantity(
        "position",
        "Compute the position function phi3(phi1) of the output wheel, phi3(0) = 0.",
        OF_OVALS,
        POSITION,
        (
            Form(
                "one arctangent of tan(phi1)",
                forms.POSITION_FORM,
                states=forms.position_by_parts,
                charts=MOUNTED,
                mirrors=MOUNTED_NEGATED,
            ),
            Form(
                "leads by atan2, 1 - e cos 2 phi",
                phi1 - phi6_closed - lead(e2, phi6_closed + mount) + lead(e2, mount),
                key="atan2",
                states=forms.through_pairs,
                note="proved for each pair; the rows on any mount put the pairs in series",
            ),
            Form(
                "tan/arctan + floor",
                phi1 - count_branches(e2, phi6_counted + mount) + mount_counted,
                key="floor",
                states=forms.over_branches,
                on=forms.BRANCHES,
                note="proved to be that by atan2, for each angle beside pi m; the computed floor "
                "and tangent disagree at the ends",
            ),
            Form(
                "one atan2, unsplit",
                sp.atan2(
                    t * (gamma_double * t - alpha_double + beta_double),
                    beta_double + gamma_double * t + alpha_double * t**2,
                ),
                key="unsplit",
                states=forms.position_by_map,
            ),
        ),
        f"{SOURCE}, integral (11)",
        unit="rad",
        # Beyond, a step in 1 - e that cancels is not known accurately enough; both parts of the
        # slope are rounded, and up to there their cancellation costs no more than a few times 4
        # eps.
        slopes=Accuracy(16, within=(e1 <= FLAT, e2 <= FLAT)),
        accuracy=forms.ACCURACY["position"],
        singular=SINGULAR_OVALS,
        period=sp.pi,
        periodicity=Periodicity(sp.pi),
    ),
    Quantity(
        "acceleration",
        "Compute d ratio/d phi1, the angular acceleration of the output at unit carrier speed.",
        OF_OVALS,
        ACCELERATION,
        (
            Form(
                "quotient in tan(phi1)",
                forms.ACCELERATION_FORM,
                ("low_product",),
                states=forms.by_parts(ACCELERATION),
                charts=MOUNTED_ROUNDER,
                mirrors=MOUNTED_NEGATED,
            ),
            Form(
                "double angles",
                sp.diff(ratio_of_map(*forms.DOUBLE), phi1),
                key="direct",
                states=forms.by_map(ACCELERATION),
            ),
        ),
        f"{SOURCE}, derivative of (10)",
        accuracy=forms.ACCURACY["acceleration"],
        singular=SINGULAR_OVALS,
        periodicity=Periodicity(sp.pi),
    ),
    Quantity(
        "ratio_cylindrical",
        "Compute the ratio d phi3/d phi1 with a cylindrical pair 4-5.",
        OF_CYLINDERS,
        RATIO_CYLINDRICAL,
        (
            by_half_angle(RATIO_CYLINDRICAL, STEEP, NEGATED),
            Form(
                "printed (4), (10)",
                -print_10.subs({rho5: R5, rho6: print_radius(e2, x / 2)}).subs(a, (R4 + R5) / 2),
                key="printed",
                source=f"{SOURCE}, equations (4) and (10)",
                note="the print with its sign reversed",
            ),
            Form("half-angle sine", 1 - k * (1 - e2) * (1 + e2) / HALF_ANGLE, key="half_angle"),
        ),
        f"{SOURCE}, equation (10), pair 4-5 cylindrical",
        accuracy=forms.ACCURACY["ratio_cylindrical"],
        singular=SINGULAR_CYLINDERS,
        periodicity=Periodicity(sp.pi / k),
    ),
    Quantity(
        "position_cylindrical",
        "Compute the position function phi3(phi1) with a cylindrical pair 4-5, phi3(0) = 0.",
        OF_CYLINDERS,
        POSITION_CYLINDRICAL,
        (
            Form(
                "half-angle atan",
                POSITION_CYLINDRICAL,
                ("positive_atan2", "half_angle_tangent"),
                when=forms.PLAIN_PRODUCT,
                charts=PLAIN,
                mirrors=NEGATED,
            ),
            Form(
                "half-angle atan with low word",
                POSITION_CYLINDRICAL,
                ("positive_atan2", "low_word", "half_angle_tangent"),
            ),
            Form("atan2, 1 - e cos x", (1 - k) * phi1 - forms.LEAD, key="atan2"),
            Form(
                "atan2, no cancellation",
                (1 - k) * phi1 - sp.atan2(e2 * sp.sin(x), nearest + 2 * e2 * sp.sin(x / 2) ** 2),
                key="atan2_stable",
            ),
            Form(
                "tan/arctan + floor",
                phi1 - count_branches(e2, x / 2),
                key="floor",
                states=over_turns,
                on=BRANCH_OF_X,
                note="proved for |x - 2 pi m| < pi; the computed floor and tangent disagree at "
                "the ends",
            ),
        ),
        f"{SOURCE}, integral (11), pair 4-5 cylindrical",
        unit="rad",
        accuracy=forms.ACCURACY["position_cylindrical"],
        singular=SINGULAR_CYLINDERS,
        period=sp.pi,
        periodicity=Periodicity(sp.pi / k, sp.pi * (1 - k) / k),
    ),
    Quantity(
        "acceleration_cylindrical",
        "Compute d ratio/d phi1 with a cylindrical pair 4-5.",
        OF_CYLINDERS,
        ACCELERATION_CYLINDRICAL,
        (
            by_half_angle(ACCELERATION_CYLINDRICAL, SMOOTH),
            directly(ACCELERATION_CYLINDRICAL),
        ),
        f"{SOURCE}, derivative of (10), pair 4-5 cylindrical",
        accuracy=forms.ACCURACY["acceleration_cylindrical"],
        singular=SINGULAR_CYLINDERS,
        periodicity=Periodicity(sp.pi / k),
    ),
)
