"""How the forms of paper 4 are proved from their emitted source.

Up to the rod, the chain is a function of x1; from the link 5' onwards, it is a function of that
link's displacement, here called x5.
"""

from collections.abc import Callable

import sympy as sp
from sympy import cos, sin

from mechproof.record import EmittedForm, Equality, Holds, Part, Statement, Variable, all_of

from ..._metrology import POSITIVE
from ..mechanics import *
from ..rows.transfer import push_by
from .chain import (
    DIRECTION,
    LINKS,
    MEANT,
    POSITION,
    ROLLER,
    Chain,
    cos_lever,
    extended,
    gain,
    guide_length,
    in_chain,
    push,
    run,
)

wedge_slope = sp.Symbol("dy9/dx5", real=True)
# The angles of a chain in contact, each as a variable of its own.
ANGLES = {MEANT.lever: phi3, MEANT.roller: phi7, MEANT.engaged: sp.S.One, extended: reach}
# cos(turn_3) by its half-angle, in x1 and the present length of BC.
COS_LEVER = ((l_BC + reach) ** 2 - x1**2) / ((l_BC + reach) ** 2 + x1**2)
SLOPE = (sp.diff(print_10, phi7) * roller_slopes[x5]).subs(phi7, MEANT.roller)
VARIABLES = (Variable(wedge_slope, "derivative of y9 by the displacement of the link 5'"),)

REACHED = Part("|R| < l_KL", where=(l_KL - PRINTED_R > 0, l_KL + PRINTED_R > 0))
UPWARD = Part(
    "alpha_KL = 2 arctan(kappa) in [0, pi), KL upwards",
    {kappa: sp.Interval(0, sp.oo), tau: POSITIVE},
)
NOT_UPRIGHT = Part(
    "R > 0 or R < 0, |R| <= l_KL", {**FIRST_QUADRANT.within, **SECOND_QUADRANT.within}
)


# Stages ----------------------------------------------------------------------------------------


def same_lever(code: EmittedForm) -> Statement:
    """State that the form is the direction that solves the projections."""
    return Equality(code.output(), lever_angle)


def by_pushing(code: EmittedForm) -> Statement:
    """State a form of the clearance."""
    return all_of(*push_by(code.output()))


def list_cases(value: sp.Basic, condition: sp.Basic = sp.true) -> list[tuple[sp.Expr, sp.Basic]]:
    """Return the cases of nested choices in the order in which they are tried."""
    if not isinstance(value, sp.Piecewise):
        return [(value, condition)]
    return [case for piece in value.args for case in list_cases(*piece)]


def by_quadrants(angle: sp.Basic) -> tuple[Statement, ...]:
    """State the two cases of an angle in R, and that each is chosen where it holds."""
    (first, in_first), (second, in_second), *_ = list_cases(angle)
    right, left = {R: l_KL * cosine_of_tau}, {R: l_KL * cosine_of_sigma}
    return (
        Equality(first.subs(right), direction_tau - alpha_KL),
        Equality(second.subs(left), direction_sigma - alpha_KL),
        Holds(in_first.subs(right)),
        Holds(sp.And(sp.Not(in_first), in_second).subs(left)),
    )


def upwards(angle: sp.Basic) -> tuple[Statement, ...]:
    """State that an angle in R and the one that is meant are both the direction 2 arctan(tau).

    The latter is stated by cosine and sine: with a nonnegative sine it is in [0, pi], like 2
    arctan(tau).
    """
    placed, meant = (form.subs(R, l_KL * cosine_of_tau) for form in (angle, DIRECTION + alpha_KL))
    given = {alpha_KL: 2 * sp.atan(kappa)}
    by_tangent = sp.factor(by_half_angle(placed, alpha_KL, kappa).subs(given), deep=True)
    return (
        Equality(by_tangent, (direction_tau - alpha_KL).subs(given)),
        Equality(sp.Matrix([cos(meant), sin(meant)]), sp.Matrix([cosine_of_tau, sine_of_tau])),
    )


def as_meant(angle: sp.Basic) -> tuple[Statement, ...]:
    """State that an angle in R is the one that is meant."""
    placed = {R: l_KL * cosine_of_tau}
    return (Equality(angle.subs(placed), DIRECTION.subs(placed)),)


InR = Callable[[sp.Basic], tuple[Statement, ...]]


def from_projection(direction: InR) -> Callable[[EmittedForm], Statement]:
    """Return the statement of a form of the roller lever's angle, written in R."""

    def states(code: EmittedForm) -> Statement:
        return all_of(*direction(code.output().subs(x5, l_KL * cos(alpha_KL) - R)))

    return states


# The chain -------------------------------------------------------------------------------------


def by_stages(
    chain: Chain, direction: InR, definition: sp.Basic
) -> Callable[[EmittedForm], Statement]:
    """Return the statement of a chain, stage by stage; slopes of the stages are in contact."""

    def states(code: EmittedForm) -> Statement:
        def stage(step: sp.Symbol, before: sp.Symbol, called: sp.Symbol) -> sp.Expr:
            return code.step(step, before).subs(before, called)

        form = in_chain(code.output(*chain, extended), MEANT, chain)
        parts = [
            Equality(code.step(Q), PRINTED_Q),
            Equality(code.step(chain.lever, Q).subs(Q, l_BC * reach), lever_by_reach),
            Equality(stage(chain.travel, chain.lever, phi3), rod),
            *push_by(stage(chain.contact, chain.travel, x5)),
            Equality(stage(chain.offset, chain.contact, x5), PRINTED_R),
            *direction(stage(chain.roller, chain.offset, R)),
            Equality(form.xreplace(ANGLES), definition.xreplace(ANGLES)),
        ]
        if definition.has(MEANT.engaged):
            engaged = stage(chain.engaged, chain.travel, x5)
            parts += [
                Equality(engaged.subs(x5, l_GH + excess), sp.S.One),
                Equality(engaged.subs(x5, l_GH - lack), sp.S.Zero),
                Equality(form.subs(MEANT.engaged, 0), definition * 0),
                Equality(code.step(extended), LINKS[extended]),
            ]
        return all_of(*parts)

    return states


def of_rod(expression: sp.Basic) -> sp.Basic:
    """Return an expression of the chain in x1 and the present length of BC, called reach."""
    return expression.xreplace(LINKS | {extended: reach}).xreplace({LINKS[extended]: reach})


def up_to_push(code: EmittedForm) -> tuple[Statement, ...]:
    """State what the kernels of the chain compute up to the link 5'."""
    travel = code.step(run, guide_length).subs(guide_length, reach)
    return (
        Equality(code.step(guide_length), LINKS[extended]),
        Equality(travel, of_rod(LINKS[MEANT.travel])),
        *push_by(code.step(push, run).subs(run, x5)),
    )


def of_link(definition: sp.Basic) -> sp.Basic:
    """Return a definition in contact, from the link 5' onwards, in its displacement."""
    by_displacement = {MEANT.engaged: sp.S.One, MEANT.roller: ROLLER}
    return of_rod(definition.xreplace(by_displacement))


def position_in_contact(code: EmittedForm) -> Statement:
    """State the position; without a push there is no displacement."""
    return all_of(*up_to_push(code), Equality(code.output(push).subs(push, x5), of_link(POSITION)))


def slopes_in_contact(definition: sp.Basic) -> Callable[[EmittedForm], Statement]:
    """Return the statement of derivatives: those in contact from its start onwards, zero before.

    The slope of y9 by x5' is proved separately and is a symbol in all derivatives with that factor.
    """

    def states(code: EmittedForm) -> Statement:
        before = code.output(run).subs(run, l_GH - lack)
        slope = code.step(gain, run, push).subs(run, l_GH + excess).subs(push, x5)
        form = code.output(push, gain, guide_length, cos_lever).subs(
            {push: x5, guide_length: reach, cos_lever: COS_LEVER}
        )
        return all_of(
            *up_to_push(code),
            Equality(code.step(cos_lever), COS_LEVER.subs(reach, LINKS[extended])),
            Equality(before, definition * 0),
            Equality(slope, of_link(SLOPE)),
            # Equal entries, those of l_AB and l_CD, are stated once.
            *dict.fromkeys(map(_equal_by_slope, sp.Matrix([form]), sp.Matrix([definition]))),
        )

    return states


def _equal_by_slope(form: sp.Expr, definition: sp.Expr) -> Equality:
    if form.has(gain):
        cosine = cos(alpha_LM + MEANT.roller)
        definition = definition.xreplace({cosine: wedge_slope * cosine / SLOPE})
    return Equality(form.subs(gain, wedge_slope), of_link(definition))
