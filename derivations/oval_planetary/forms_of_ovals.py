"""Forms of two oval pairs, and the statements that prove them from their emitted sources."""

from __future__ import annotations

import sympy as sp

from mechproof.record import Conjunction, Equality, Part, Statement, Written

from .mechanics import COS_4, cos_6, pair_ratio, sin_6
from .positions import ACCELERATION, POSITION, RATIO, t
from .printed import print_radius
from .symbols import (
    alpha,
    alpha_double,
    beta,
    beta_double,
    both,
    delta,
    driven_angle,
    e1,
    e2,
    gamma,
    gamma_double,
    lam,
    less,
    mount,
    mount_counted,
    mu,
    nu,
    phi1,
    phi6,
    phi6_closed,
    phi6_counted,
    rho5,
    rho6,
    rise,
    shift,
    swing,
    tangent,
    tau,
    turns,
    xi,
    y,
)

# All coefficients divided by 1 - e2, and beta + gamma*t split into less + y. y has the sine of the
# mounted wheel's angle as a factor and is large beside the rest as e2 -> 1; rounded once, it
# enters both arguments of atan2, and what is left of it where it vanishes is one small angle.
POSITION_FORM = sp.atan2(t * (y - swing), less + y + both * t**2)
SPREAD_FORM = (less + y) ** 2 + both**2 * t**2
WHEEL_3_FORM = both * (less + shift) * (1 + t**2) / SPREAD_FORM
TILT = (
    y * (rise - shift * t),
    less * rise * (1 - t**2),
    (swing * (less + both) - 2 * less * shift) * t,
)
ACCELERATION_FORM = 2 * WHEEL_3_FORM * sum(TILT) / SPREAD_FORM

# Statements. The coefficients of the map are variables of their own, lambda, mu, nu, and the steps
# are those of the paper: so neither proof has to deal with more than it is about.
PARTS = {both: lam, less: mu - xi, shift: xi, rise: nu, swing: lam - mu + xi}
DOUBLE = {alpha_double: lam, beta_double: mu, gamma_double: nu}
ANY_MAP = {alpha: lam, beta: mu, gamma: nu, delta: lam - mu}
SCALED_MAP = {s: (1 - e2) * value for s, value in ANY_MAP.items()}
BY_TANGENT = {
    sp.cos(2 * phi1): (1 - tangent**2) / (1 + tangent**2),
    sp.sin(2 * phi1): 2 * tangent / (1 + tangent**2),
}
TANGENT = tuple(Equality(f, by.subs(tangent, t)) for f, by in BY_TANGENT.items())


def of_parts(code: Written, *unused: sp.Symbol) -> tuple[Equality, ...]:
    """State what the emitted steps are, 1 - e2 times: the coefficients of the map."""
    step = {part: code.step(part) for part in PARTS if part not in unused}
    sums = {
        alpha: step[both],
        beta: step[less] + step[shift],
        gamma: step[rise],
        delta: step.get(swing, step[both] - step[less]) - step[shift],
    }
    return tuple(Equality((1 - e2) * total, coefficient) for coefficient, total in sums.items())


def ratio_by_parts(code: Written) -> Statement:
    """State the ratio of the parts, and the parts."""
    form = code.output(*PARTS).xreplace(PARTS)
    return Conjunction((Equality(form, RATIO.xreplace(SCALED_MAP)), *of_parts(code, swing)))


def acceleration_by_parts(code: Written) -> Statement:
    """State the acceleration of the parts, and the parts."""
    form = code.output(*PARTS).xreplace(PARTS)
    return Conjunction((Equality(form, ACCELERATION.xreplace(SCALED_MAP)), *of_parts(code)))


def position_by_parts(code: Written) -> Statement:
    """State the position of the parts, by the tangent, and the parts."""
    form = code.output(*PARTS).xreplace({**PARTS, t: tangent})
    position = POSITION.xreplace(SCALED_MAP).xreplace(BY_TANGENT)
    return Conjunction((Equality(form, position), *TANGENT, *of_parts(code)))


def of_double(code: Written) -> tuple[Equality, ...]:
    """State what the emitted steps are: the coefficients of the map."""
    pairs = zip(DOUBLE, (alpha, beta, gamma), strict=True)
    return tuple(Equality(code.step(step), coefficient) for step, coefficient in pairs)


def ratio_by_map(code: Written) -> Statement:
    """State the ratio of any map, and the coefficients."""
    form = code.output(*DOUBLE).xreplace(DOUBLE)
    return Conjunction((Equality(form, RATIO.xreplace(ANY_MAP)), *of_double(code)))


def acceleration_by_map(code: Written) -> Statement:
    """State the acceleration of any map, and the coefficients."""
    form = code.output(*DOUBLE).xreplace(DOUBLE)
    return Conjunction((Equality(form, ACCELERATION.xreplace(ANY_MAP)), *of_double(code)))


def position_by_map(code: Written) -> Statement:
    """State the position of any map, by the tangent, and the coefficients."""
    form = code.output(*DOUBLE).xreplace({**DOUBLE, t: tangent})
    position = POSITION.xreplace(ANY_MAP).xreplace(BY_TANGENT)
    return Conjunction((Equality(form, position), *TANGENT, *of_double(code)))


# The double angle of wheel 6, by which the row on any mount puts the two pairs in series.
WHEEL_6 = (
    Equality(sp.cos(2 * phi6_closed), cos_6),
    Equality(sp.sin(2 * phi6_closed), sin_6),
)


def through_pairs(code: Written) -> Statement:
    """State that each pair integrates its ratio, and the double angle of wheel 6."""
    form = code.output(phi6_closed).xreplace({phi6_closed: phi6})
    of_first = pair_ratio(e1, COS_4).subs(phi1, tau)
    of_second = pair_ratio(e2, sp.cos(2 * (tau + mount)))
    return Conjunction(
        (
            Equality(code.step(phi6_closed), sp.Integral(of_first, (tau, 0, phi1))),
            Equality(form, phi1 - sp.Integral(of_second, (tau, 0, phi6))),
            *WHEEL_6,
        )
    )


def over_branches(code: Written) -> Statement:
    """State each pair at its angle + pi*m, |angle| < pi/2, where its floor is m."""
    form = code.output(phi6_counted, mount_counted).xreplace({phi6_counted: phi6})
    of_second = phi1 - driven_angle(e2, phi6 + mount) + mount_counted
    return Conjunction(
        (
            on_branch(code.step(phi6_counted), driven_angle(e1, phi1), phi1, phi1),
            on_branch(code.step(mount_counted), driven_angle(e2, mount), mount, mount),
            on_branch(form, of_second, phi6, phi6 - mount),
        )
    )


def on_branch(form: sp.Expr, whole: sp.Expr, angle: sp.Symbol, value: sp.Expr) -> Equality:
    """State that a form with one floor is a whole where an angle has a value and m half turns."""
    (count,) = form.atoms(sp.floor)
    at_turn = {angle: value + sp.pi * turns}
    return Equality(form.xreplace({count: turns}).subs(at_turn), whole.subs(at_turn))


def as_printed(code: Written) -> Statement:
    """State the speed of wheel 3 through both pairs at any angle of wheel 6, and that angle."""
    form = code.output(phi6_closed).xreplace({phi6_closed: phi6})
    second = pair_ratio(e2, sp.cos(2 * (phi6 + mount)))
    return Conjunction(
        (
            Equality(1 - form, second / pair_ratio(e1, -sp.cos(2 * phi6))),
            Equality(1 / pair_ratio(e1, -cos_6), pair_ratio(e1, COS_4)),
            Equality(code.step(phi6_closed), phi6_closed),
            *WHEEL_6,
        )
    )


QUARTER = sp.Interval.open(-sp.pi / 2, sp.pi / 2)
BRANCHES = Part("each angle on its first branch", dict.fromkeys((phi1, phi6, mount), QUARTER))
PRINTED_RADII = {
    rho5: print_radius(e1, sp.pi / 2 - phi6_closed),
    rho6: print_radius(e2, phi6_closed + mount),
}
