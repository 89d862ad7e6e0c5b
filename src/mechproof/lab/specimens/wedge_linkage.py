"""Ways of computing the wedge linkage: its lever, its roller lever and the whole chain.

No library computes the same: `pylinkage` solves one position after another, and has neither a
guide that turns about a pivot of its own nor a link that is only pushed.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from mechproof.derivations import wedge_linkage as paper
from mechproof.lab.specimen import Arguments, Array, Specimen
from mechproof.lab.specimens import wedge_forms as forms
from mechproof.lab.specimens import wedge_groups as groups
from mechproof.lab.specimens import wedge_loads as loads
from mechproof.lab.specimens import wedge_points as points
from mechproof.lab.subject import Map, PointSet, Study, Table
from mechproof.record import Conjunction, Equality, Part

LEVER = Equality(paper.print_1, paper.lever_angle)
FULL_LEVER = Equality(sp.atan2(paper.print_1_top, paper.print_1_bottom), paper.lever_angle)
CASES = (
    Equality(
        paper.print_7.subs(paper.R, paper.l_KL * paper.cosine_of_tau),
        paper.direction_tau - paper.alpha_KL,
    ),
    Equality(
        paper.print_8.subs(paper.R, paper.l_KL * paper.cosine_of_sigma),
        paper.direction_sigma - paper.alpha_KL,
    ),
)
NOT_UPRIGHT = Part(
    "R > 0 or R < 0, |R| <= l_KL",
    {**paper.FIRST_QUADRANT.within, **paper.SECOND_QUADRANT.within},
)
PRINTED_CHAIN = Part(
    f"{paper.BEFORE_PIVOT.text}; {NOT_UPRIGHT.text}", NOT_UPRIGHT.within, paper.BEFORE_PIVOT.where
)
STAGES = (Equality(paper.print_3, paper.rod), Equality(paper.print_10, paper.wedge))
DIFFERENCE = "no bound: h**2/6 of the third derivative and eps/h, h = 1e-4 mm or rad"


Workload = tuple[str, Callable[[int], Arguments]]


def as_defined(definition: sp.Basic) -> Equality:
    """State that the code is the definition itself, typed in: nothing was rewritten."""
    return Equality(definition, definition)


ROLLER = (
    Specimen(
        "printed (7), (8)",
        forms.printed_roller,
        Conjunction(CASES),
        on=NOT_UPRIGHT,
        note="R = 0 is in neither case",
    ),
    Specimen(
        "(7) or else (8)",
        forms.hasty_roller,
        Conjunction(CASES),
        on=NOT_UPRIGHT,
        note="at R = 0 the quotient is infinite and (8) off by pi",
    ),
    Specimen("atan2", forms.full_roller, as_defined(paper.ROLLER)),
    Specimen(
        "arccosine",
        forms.arccosine_roller,
        Equality(sp.acos(paper.cosine_of_tau), paper.direction_tau),
        note="R/l_KL is the cosine of the direction 2 arctan(tau)",
    ),
)
POSITION = (
    Specimen(
        "printed chain",
        forms.printed_chain,
        Conjunction((LEVER, *CASES, *STAGES)),
        on=PRINTED_CHAIN,
        note="stage by stage; R = 0 is in neither case",
    ),
    Specimen(
        "chain with atan2",
        forms.full_chain,
        Conjunction((FULL_LEVER, *STAGES)),
        note="stage by stage; the roller lever's is its definition",
    ),
)
VELOCITY = (
    Specimen("product of slopes", forms.stage_slopes, as_defined(paper.VELOCITY)),
    Specimen("central difference", forms.speed_difference, note=DIFFERENCE),
)


def study_part(
    sets: tuple[PointSet, ...],
    *specimens: Specimen,
    timed: tuple[Workload, ...] = (),
    maps: tuple[Map, ...] = (),
) -> Study:
    """Return the rows of one group of the linkage."""
    return Study(specimens, sets, workloads=timed, maps=maps)


def study_chain(
    *specimens: Specimen,
    timed: tuple[Workload, ...] = loads.LOADS,
    within: Callable[..., Array] | None = points.off_the_edge,
    maps: tuple[Map, ...] = (),
) -> Study:
    """Return the rows of a quantity of the whole chain."""
    return Study(
        specimens,
        points.CHAIN,
        points.CELLS,
        points.in_cell,
        within,
        workloads=timed,
        maps=maps,
    )


TABLE = Table(
    studies={
        "lever_angle": study_part(
            groups.LEVER,
            Specimen(
                "printed (1)",
                forms.printed_lever,
                LEVER,
                on=paper.MOVABLE,
                holds_on=paper.BEFORE_PIVOT,
            ),
            Specimen("(1) with atan2", forms.full_lever, FULL_LEVER),
            timed=(("N inputs, one lever", loads.lever_load),),
        ),
        "rod_displacement": study_part(groups.ARMS),
        "clearance": study_part(groups.LINKS),
        "roller_lever_angle": study_part(
            groups.ROLLER,
            *ROLLER,
            timed=(("N inputs, one lever", loads.roller_load),),
            maps=(loads.roller_map("printed (7), (8)", "atan2", "kernel"),),
        ),
        "wedge_displacement": study_part(groups.ARMS),
        "position": study_chain(
            *POSITION,
            timed=loads.POSITION_LOADS,
            within=None,
            maps=(loads.contact_map("printed chain", "chain with atan2", "kernel"),),
        ),
        "velocity": study_chain(
            *VELOCITY,
            maps=(loads.contact_map("central difference", "product of slopes", "kernel"),),
        ),
        "sensitivities": study_chain(
            Specimen("central differences", forms.size_differences, note=DIFFERENCE),
        ),
    },
)
