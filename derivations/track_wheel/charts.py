"""Coordinates over which the rounding errors of paper 5 are bounded."""

from functools import partial

import sympy as sp

from mechproof.record import Chart

from .mechanics import *

# Near no turn all angles are multiples of the largest, with which the matrix vanishes.
QUARTER = sp.Rational(11, 7)
LARGEST, SHARES = sp.Symbol("r"), sp.symbols("y z")
ANYWHERE = {symbol: symbol for symbol in (*SURFACE_POINT, *SHIFT)}
RANGES = {
    LARGEST: sp.Interval(0, QUARTER),
    **dict(zip(SHARES, (sp.Interval(0, 1), sp.Interval(-1, 1)), strict=True)),
    **dict.fromkeys(ANYWHERE, sp.S.Reals),
}


def by_largest(largest: sp.Symbol) -> Chart:
    """Make the chart of angles of which one is the largest."""
    others = (angle for angle in ANGLES if angle != largest)
    shares = {angle: LARGEST * share for angle, share in zip(others, SHARES, strict=True)}
    text = f"|alpha|, |beta|, |gamma| <= {QUARTER}"
    return Chart(text, {largest: LARGEST, **shares, **ANYWHERE}, RANGES)


NEAR_NO_TURN = tuple(map(by_largest, ANGLES))
HALF_TURN = sp.Interval(0, sp.Rational(22, 7))
WITHIN_HALF_TURNS = (
    Chart(
        "|alpha|, |beta|, |gamma| <= 22/7",
        {angle: angle for angle in ANGLES},
        {alpha: HALF_TURN, beta: HALF_TURN, gamma: sp.Interval(-HALF_TURN.end, HALF_TURN.end)},
    ),
)

# Sizes by the larger one, of which the other is a share.
SIZE, SHARE, OTHER_SHARE = sp.symbols("size share other_share", positive=True)
SIZES = {SIZE: sp.Interval(0, sp.oo), SHARE: sp.Interval(0, 1)}


def by_larger(one: sp.Symbol, other: sp.Symbol) -> tuple[Chart, ...]:
    """Make the charts of two sizes."""
    return tuple(
        Chart("", {larger: SIZE, smaller: SIZE * SHARE}, SIZES)
        for larger, smaller in ((one, other), (other, one))
    )


BY_RADII = by_larger(radius, amplitude)
# theta = z*phi is the angle within the periods. The circle may be shifted either way, but not to
# the pole, where the track has corners.
PHASE, COUNT = sp.Symbol("theta", positive=True), sp.Symbol("count", positive=True)
SHIFTED, TURNED = sp.Rational(63, 64), 21
OFF_POLE = tuple(
    Chart(
        f"|A| <= {SHIFTED}*R and z*|phi| <= {TURNED}",
        {radius: SIZE, amplitude: sign * SIZE * SHARE, periods: COUNT, phi: PHASE / COUNT},
        {
            **dict.fromkeys((SIZE, COUNT), sp.Interval.Lopen(0, sp.oo)),
            SHARE: sp.Interval(0, SHIFTED),
            PHASE: sp.Interval(0, TURNED),
        },
        PHASE,
    )
    for sign in (1, -1)
)
# Of a point the polar angle has a sine, too. It is no more than theta.
INSIDE, FIRST_PART = sp.Rational(15, 16), sp.Rational(22, 7)
PERIOD = sp.Symbol("period", positive=True)
IN_FIRST_PART = tuple(
    Chart(
        f"|A| <= {INSIDE}*R and z*|phi| <= {FIRST_PART}",
        {
            radius: SIZE,
            amplitude: sign * SIZE * SHARE,
            periods: 1 / PERIOD,
            phi: PHASE * PERIOD,
            thickness: thickness,
        },
        {
            SIZE: sp.Interval.Lopen(0, sp.oo),
            SHARE: sp.Interval(0, INSIDE),
            PERIOD: sp.Interval.Lopen(0, 1),
            PHASE: sp.Interval(0, FIRST_PART),
            thickness: sp.Interval(0, sp.oo),
        },
    )
    for sign in (1, -1)
)
BY_PLANE = by_larger(error_x, error_y)
# What is the hypotenuse in the plane is a side in space.
BY_SPACE = tuple(
    Chart(
        "",
        {larger: side, smaller: side * OTHER_SHARE, error_z: height},
        {**SIZES, OTHER_SHARE: SIZES[SHARE]},
    )
    for larger, smaller in ((error_x, error_y), (error_y, error_x))
    for side, height in ((SIZE, SIZE * SHARE), (SIZE * SHARE, SIZE))
)

# Sums have a coordinate of their own. Of the total the thermal error leaves more than it takes, or
# less: a square, with which a root vanishes.
BY_TOTAL = (Chart("", {scatter: SIZE}, {SIZE: SIZES[SIZE]}),)
RATIO, LEFT = sp.symbols("ratio left", positive=True)
BY_REST = tuple(
    Chart(
        "thermal_share*thermal_scatter <= (1 - 2**-20)*total_scatter",
        {k_thermal: SIZE, share: RATIO * taken, scatter: SIZE * RATIO * whole},
        {**dict.fromkeys((SIZE, RATIO), SIZES[SIZE]), **within},
    )
    for taken, whole, within in (
        (SHARE, 1 + SHARE, {SHARE: SIZES[SHARE]}),
        (1, 1 + LEFT**2, {LEFT: sp.Interval(sp.Rational(1, 2**10), 1)}),
    )
)

# Of a tilt only the error beyond the offset counts, which in the plane is of any size beside it.
ONE, TWO, THREE, OFFSET_ALONE = sp.symbols("one two three offset_alone", positive=True)
# Of the largest error, its root and a little, and the reciprocal of that and a little.
MOST, ROOT, OVER_ROOT = sp.Rational(15, 16), sp.Rational(31, 32), sp.Rational(17, 16)
ENDS = {SIZE: sp.oo, ONE: 1, TWO: 1, THREE: 1, OFFSET_ALONE: sp.oo}
BY_RADIUS, BY_HEIGHT = (radius_vector, thickness), (thickness, radius_vector)


def beyond_offset(
    text: str,
    error: sp.Symbol,
    sizes: tuple[sp.Symbol, sp.Symbol],
    share: sp.Expr,
    offset: sp.Expr,
    over: sp.Expr,
    **ends: sp.Expr,
) -> Chart:
    """Make the chart of two sizes by the larger one, and of an error beyond an offset.

    That is a share of their sum. What vanishes under the root does so as one product.
    """
    larger, smaller = sizes
    whole = sp.expand(offset + over * SIZE * (1 + share))
    arguments = {larger: SIZE, smaller: SIZE * share, error: whole, eccentricity: offset}
    within = {
        symbol: sp.Interval(0, ends.get(symbol.name, end))
        for symbol, end in ENDS.items()
        if any(value.has(symbol) for value in arguments.values())
    }
    return Chart(text, arguments, within)


in_plane = partial(beyond_offset, f"error - offset <= {MOST}*(rho + H)", planar_error)
in_space = partial(beyond_offset, "offset <= H and error - offset <= rho + H", spatial_error)
FOR_PLANAR = (
    in_plane(BY_RADIUS, ONE * TWO, OFFSET_ALONE, ONE**2, one=ROOT, two=OVER_ROOT),
    in_plane(BY_RADIUS, ONE, OFFSET_ALONE, ONE**2 * TWO**2, two=ROOT),
    in_plane(BY_HEIGHT, ONE, OFFSET_ALONE, TWO, two=MOST),
)
FOR_SPATIAL = (
    in_space(BY_RADIUS, ONE * TWO, SIZE * ONE * TWO * THREE, ONE),
    in_space(BY_RADIUS, ONE, SIZE * ONE * TWO * THREE, ONE * TWO),
    in_space(BY_RADIUS, ONE * THREE, SIZE * ONE * TWO * THREE, ONE**3 * TWO * THREE),
    in_space(BY_RADIUS, ONE, SIZE * ONE * TWO, ONE**3 * TWO * THREE**2),
    in_space(BY_HEIGHT, ONE, SIZE * TWO * THREE, TWO),
    in_space(BY_HEIGHT, ONE, SIZE * TWO, TWO * THREE),
)
