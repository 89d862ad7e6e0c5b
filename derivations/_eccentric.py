"""Common to papers 1 and 2, for an angle x and eccentricity e: ellipses, places, branches, jerks.

A place is x, e and the ranges of their coordinates, in which whatever vanishes is a product of
powers. With e = 1 - d near 1, x and d are small together; places differ in which of x, d and x**2
is smallest.
"""

from collections.abc import Mapping
from typing import TypeAlias

import sympy as sp
from sympy import Expr, Interval, Rational, Symbol

from mechproof.record import Chart, Equality, Form, Scale

from ._algebra import solve_linear

Ranges: TypeAlias = Mapping[Symbol, Interval]
Place: TypeAlias = tuple[Expr, Expr, Ranges]
Steps: TypeAlias = tuple[tuple[sp.Symbol, Expr], ...]

ANGLE_X, S = Symbol("x"), Symbol("pi - x")
D, V, W, Y, Z = (Symbol(name) for name in ("d", "d/x**2", "x**2/d", "x/d", "d/x"))
UP_TO_HALF, UP_TO_LARGE = Interval(0, Rational(1, 2)), Interval(0, Rational(5, 8))
UP_TO_TURN = Interval(0, Rational(22, 7))
WITHIN_TURN = "|x| <= 22/7"
# Next to x = pi the low word is as large as the remainder of x, and no bound recognises that they
# belong together: so a small part is left out. Beyond half a turn x is known only with its low
# word.
OFF_PI = f"{WITHIN_TURN} and |pi - |x|| >= 2**-40"


def radius_from_focus(a: Expr, e: Expr, theta: Expr) -> Expr:
    """Radius of an ellipse from a focus: the distances to both foci, 2 a e apart, add up to 2 a."""
    r = Symbol("r", real=True)
    to_other_squared = r**2 - 4 * a * e * r * sp.cos(theta) + 4 * a**2 * e**2
    return solve_linear(sp.Eq((2 * a - r) ** 2, to_other_squared), r)


def roll(e: Expr, angle: Expr) -> tuple[Expr, Expr]:
    """Return cosine and sine of the angle that a congruent ellipse reaches by rolling on another.

    It is ahead of its driver by twice atan(y/x).
    """
    cosine, sine = sp.cos(angle), sp.sin(angle)
    y, x = e * sine, 1 - e * cosine
    ahead = (x**2 - y**2) / (x**2 + y**2), 2 * x * y / (x**2 + y**2)
    return cosine * ahead[0] - sine * ahead[1], sine * ahead[0] + cosine * ahead[1]


def list_places(e: Symbol, farthest: Expr, widest: Expr, roundest: Interval) -> tuple[Place, ...]:
    """Return the places of angles up to the farthest, first those with d up to the widest."""
    return (
        (D * Y, 1 - D, {D: Interval(0, widest), Y: Interval(0, 8)}),
        (Z * W, 1 - Z**2 * W, {Z: Interval(0, Rational(1, 8)), W: Interval(0, 1)}),
        (ANGLE_X, 1 - ANGLE_X**2 * V, {ANGLE_X: Interval(0, Rational(3, 4)), V: Interval(0, 1)}),
        (ANGLE_X, 1 - D, {ANGLE_X: Interval(Rational(2, 3), farthest), D: UP_TO_HALF}),
        (ANGLE_X, e, {ANGLE_X: Interval(0, farthest), e: roundest}),
    )


def first_turn(e: Symbol) -> tuple[Place, ...]:
    """Return the places of half a turn to either side."""
    return list_places(e, Rational(22, 7), Rational(1, 2), UP_TO_HALF)


def first_turn_of_jerk(e: Symbol) -> tuple[Place, ...]:
    """Return the same places with narrower ranges next to e = 1, where it grows with 1/d**3."""
    narrow = Rational(1, 8)
    left = {ANGLE_X: Interval(0, Rational(3, 4)), D: Interval(narrow, Rational(1, 2))}
    return (*list_places(e, Rational(22, 7), narrow, UP_TO_HALF), (ANGLE_X, 1 - D, left))


def below_pi(e: Symbol) -> tuple[Place, ...]:
    """Return the places that end before half a turn."""
    return list_places(e, sp.Integer(3), Rational(3, 8), UP_TO_LARGE)


def next_to_pi(e: Symbol) -> tuple[tuple[Expr, Expr, Ranges, Expr], ...]:
    """Return the places next to half a turn, each with the remainder of x after whole turns."""
    near = {ANGLE_X: UP_TO_TURN, S: Interval(Rational(1, 2**40), Rational(1, 7))}
    return tuple(
        (ANGLE_X, there, {**near, symbol: UP_TO_HALF}, sp.pi + side)
        for there, symbol in ((1 - D, D), (e, e))
        for side in (S, -S)
    )


def on_branch(form: Expr, whole: Expr, place: Mapping[Symbol, Expr], turns: Symbol) -> Equality:
    """State that a form with one floor equals `whole` at a place, its floor being `turns`."""
    (count,) = form.atoms(sp.floor)
    return Equality(form.xreplace({count: turns}).subs(place), whole.subs(place))


def by_half_angle(
    value: Expr, charts: tuple[Chart, ...], mirrors: tuple[tuple[sp.Basic, ...], ...] = ()
) -> Form:
    """Return the form of a quotient in the tangent of half of x, whose low word is known."""
    rewrites = ("low_word", "half_angle_tangent")
    return Form(
        "half-angle quotient with low word", value, rewrites, charts=charts, mirrors=mirrors
    )


def directly(value: Expr) -> Form:
    """Return the form that divides by a power of the square of a distance."""
    return Form("1 + e**2 - 2 e cos x", value, key="direct")


def jerk_scale(factor: Expr, e: Symbol, x: Expr, eps_x: Expr, where: Steps = ()) -> Scale:
    """Return the scale of a jerk: the larger of its terms, plus the effect of eps*x on both."""
    spread = (1 - e) ** 2 + 4 * e * sp.sin(x / 2) ** 2
    sine, cosine = sp.Abs(sp.sin(x)), sp.Abs(sp.cos(x))
    slope = spread**2 + 12 * e * cosine * spread + 24 * e**2 * sp.sin(x) ** 2
    larger = sp.Max(factor / spread**2, 4 * factor * e * sp.sin(x) ** 2 / spread**3)
    return Scale(
        "the larger of the two terms, with 1 for cos(x), and the effect of eps*x",
        larger + factor * eps_x * sine * slope / spread**4,
        where,
    )


def jerk_quotient(factor: Expr, e: Expr, x: Expr) -> Expr:
    """Return a jerk as a single quotient."""
    spread = 1 + e**2 - 2 * e * sp.cos(x)
    return factor * (sp.cos(x) * spread - 4 * e * sp.sin(x) ** 2) / spread**3
