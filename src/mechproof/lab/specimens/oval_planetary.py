"""Ways of computing position, ratio and acceleration of the oval pairs, any mount or cylinders."""

from __future__ import annotations

import numpy as np
import sympy as sp

from mechproof.derivations import oval_planetary as paper
from mechproof.lab.specimen import Specimen
from mechproof.lab.specimens import oval_forms as forms
from mechproof.lab.specimens import oval_points as points
from mechproof.lab.subject import Study, Table
from mechproof.record import Conjunction, Equality, Part, Variable

phi1, e1, e2, mount, k, x = paper.phi1, paper.e1, paper.e2, paper.mount, paper.k, paper.x
turns = sp.Symbol("m_turns", integer=True, nonnegative=True)
QUARTER = sp.Interval.open(-sp.pi / 2, sp.pi / 2)
# One branch of the tangent, for the pair 4-5 and for a cylindrical one.
BRANCH = Part("|phi1| < pi/2, the first branch", {phi1: QUARTER})
BRANCH_OF_X = Part("|x| < pi, the first branch", {x: sp.Interval.open(-sp.pi, sp.pi)})
VARIABLES = (Variable(turns, "whole turns of x", within=sp.S.Naturals0),)


def driven_branch(eccentricity: sp.Expr, driver: sp.Expr) -> sp.Expr:
    """Angle of the driven wheel by one arctangent, on its first branch."""
    return sp.atan((1 + eccentricity) / (1 - eccentricity) * sp.tan(driver))


# What the ways through both pairs rest on: each pair by itself, and the pairs in series.
ONE_PAIR = Equality(driven_branch(paper.e, phi1), paper.driven_angle(paper.e, phi1))
IN_SERIES = Equality(1 / (1 - paper.ratio_of_map(*paper.COEFFICIENTS)), 1 / paper.wheel_3_rate)
THROUGH_BOTH = Conjunction(
    (
        Equality(
            sp.diff(paper.driven_angle(paper.e, phi1), phi1),
            paper.pair_ratio(paper.e, paper.COS_4),
        ),
        IN_SERIES,
    )
)
BRANCHES = Conjunction((ONE_PAIR, IN_SERIES))
UNSPLIT = Conjunction(
    tuple(
        Equality(printed, coefficient)
        for printed, coefficient in zip(
            paper.COEFFICIENTS, (paper.alpha, paper.beta, paper.gamma), strict=True
        )
    )
)
OF_COEFFICIENTS = "the row says that its coefficients are those of the definition"
NO_BOUND = "no bound: the solver controls an estimate of the local error"
SAMPLED = "no bound is proved: it would need the fourth derivative of the ratio over the samples"

POSITION = (
    Specimen(
        "leads by atan2, 1 - e cos 2 phi",
        forms.atan2_form,
        THROUGH_BOTH,
        note="the row says that each lead is that of a pair and that the pairs act in series",
    ),
    Specimen("tan/arctan + floor", forms.floored, BRANCHES, on=BRANCH),
    Specimen(
        "tan/arctan + unwrap",
        forms.unwrapped,
        BRANCHES,
        on=BRANCH,
        ordered=True,
        note="beyond the branch only if no step of the samples turns a wheel by half of pi",
    ),
    Specimen(
        "one atan2, unsplit",
        forms.by_tangent,
        UNSPLIT,
        note=OF_COEFFICIENTS,
    ),
    Specimen("cumulative Simpson", forms.simpson, ordered=True, note=SAMPLED),
    Specimen(
        "solve_ivp, DOP853 1e-12",
        forms.integrated,
        ordered=True,
        slow=True,
        source="peer",
        note=NO_BOUND,
    ),
)
RATIO = (
    Specimen(
        "printed (3)-(6), (10)",
        forms.printed_ratio,
        IN_SERIES,
        note="the print with its sign reversed and rho6 at the mounted angle; the row says that "
        "one minus it is the speed of wheel 3 through both pairs",
    ),
    Specimen("double angles", forms.direct_ratio, UNSPLIT, note=OF_COEFFICIENTS),
)
ACCELERATION = (
    Specimen("double angles", forms.direct_acceleration, UNSPLIT, note=OF_COEFFICIENTS),
)

STABLE_CYLINDRICAL = (1 - k) * phi1 - sp.atan2(
    e2 * sp.sin(x), (1 - e2) + 2 * e2 * sp.sin(x / 2) ** 2
)
BRANCH_CYLINDRICAL = phi1 - driven_branch(e2, x / 2)
FLOOR_CYLINDRICAL = Equality(
    driven_branch(e2, x / 2) + sp.pi * turns,
    x / 2
    + sp.pi * turns
    + sp.atan2(e2 * sp.sin(x + 2 * sp.pi * turns), 1 - e2 * sp.cos(x + 2 * sp.pi * turns)),
)
POSITION_CYLINDRICAL = (
    Specimen(
        "atan2, 1 - e cos x",
        forms.atan2_cylindrical,
        Equality(
            (1 - k) * phi1 - paper.driven_angle(e2, x / 2) + x / 2, paper.POSITION_CYLINDRICAL
        ),
    ),
    Specimen(
        "atan2, no cancellation",
        forms.stable_cylindrical,
        Equality(STABLE_CYLINDRICAL, paper.POSITION_CYLINDRICAL),
    ),
    Specimen(
        "tan/arctan + floor",
        forms.floored_cylindrical,
        FLOOR_CYLINDRICAL,
        on=BRANCH_OF_X,
        note="proved for |x - 2 pi m| < pi; the computed floor and tangent disagree at the ends",
    ),
    Specimen(
        "tan/arctan + unwrap",
        forms.unwrapped_cylindrical,
        Equality(BRANCH_CYLINDRICAL, paper.POSITION_CYLINDRICAL),
        on=BRANCH_OF_X,
        ordered=True,
        note="beyond the branch only if no step of the samples turns a wheel by half of pi",
    ),
    Specimen("cumulative Simpson", forms.simpson_cylindrical, ordered=True, note=SAMPLED),
    Specimen(
        "solve_ivp, DOP853 1e-12",
        forms.integrated_cylindrical,
        ordered=True,
        slow=True,
        source="peer",
        note=NO_BOUND,
    ),
)
RATIO_CYLINDRICAL = (
    Specimen(
        "printed (4), (10)",
        forms.printed_ratio_cylindrical,
        Equality(paper.ratio_with_cylinders_45, paper.RATIO_CYLINDRICAL),
        note="the print with its sign reversed",
    ),
    Specimen(
        "half-angle sine",
        forms.stable_ratio_cylindrical,
        Equality(
            1 - k * (1 - e2) * (1 + e2) / ((1 - e2) ** 2 + 4 * e2 * sp.sin(x / 2) ** 2),
            paper.RATIO_CYLINDRICAL,
        ),
    ),
)
ACCELERATION_CYLINDRICAL = (
    Specimen(
        "1 + e**2 - 2 e cos x",
        forms.direct_acceleration_cylindrical,
        Equality(sp.diff(paper.ratio_45, phi1), paper.ACCELERATION_CYLINDRICAL),
    ),
)


def study_ovals(
    *specimens: Specimen, mapped: tuple[str, ...], period: float | None = None
) -> Study:
    """Return the rows of a quantity of two oval pairs."""
    return Study(
        specimens,
        points.SETS,
        points.CELLS,
        points.ovals_in_cell,
        points.both_representable,
        period,
        (("N angles, one mechanism", points.workload),),
        (points.meeting_map(*mapped, "kernel"),),
    )


def study_cylinders(
    *specimens: Specimen, mapped: tuple[str, ...], period: float | None = None
) -> Study:
    """Return the rows of a quantity with a cylindrical pair 4-5."""
    return Study(
        specimens,
        points.CYLINDER_SETS,
        points.CELLS,
        points.cylinders_in_cell,
        points.within_low_word,
        period,
        (("N angles, one mechanism", points.workload_of_cylinders),),
        (points.peak_map(*mapped, "kernel"),),
    )


TABLE = Table(
    studies={
        "position": study_ovals(
            *POSITION, mapped=(POSITION[0].name, POSITION[3].name), period=np.pi
        ),
        "ratio": study_ovals(*RATIO, mapped=(RATIO[0].name, RATIO[1].name)),
        "acceleration": study_ovals(*ACCELERATION, mapped=(ACCELERATION[0].name,)),
        "position_cylindrical": study_cylinders(
            *POSITION_CYLINDRICAL,
            mapped=(POSITION_CYLINDRICAL[0].name, POSITION_CYLINDRICAL[1].name),
            period=np.pi,
        ),
        "ratio_cylindrical": study_cylinders(
            *RATIO_CYLINDRICAL, mapped=(RATIO_CYLINDRICAL[0].name, RATIO_CYLINDRICAL[1].name)
        ),
        "acceleration_cylindrical": study_cylinders(
            *ACCELERATION_CYLINDRICAL, mapped=(ACCELERATION_CYLINDRICAL[0].name,)
        ),
    },
    variables=VARIABLES,
)
