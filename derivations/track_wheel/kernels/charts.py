"""Coordinates in which the rounding errors of paper 5 are bounded."""

import sympy as sp

from mechproof.record import Chart

from ..mechanics import *

# Near the identity all angles are multiples of the largest, with which the matrix vanishes.
QUARTER = sp.Rational(11, 7)
LARGEST, SHARES = sp.Symbol("r"), sp.symbols("y z")
ANYWHERE = {symbol: symbol for symbol in (*SURFACE_POINT, *SHIFT)}
RANGES = {
    LARGEST: sp.Interval(0, QUARTER),
    **dict(zip(SHARES, (sp.Interval(0, 1), sp.Interval(-1, 1)), strict=True)),
    **dict.fromkeys(ANYWHERE, sp.S.Reals),
}


def by_largest(largest: sp.Symbol) -> Chart:
    """Return the chart of angles in which `largest` is the largest."""
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

# Sizes in terms of the larger one, of which the other is a share.
SIZE, SHARE, OTHER_SHARE = sp.symbols("size share other_share", positive=True)
SIZES = {SIZE: sp.Interval(0, sp.oo), SHARE: sp.Interval(0, 1)}


def by_larger(one: sp.Symbol, other: sp.Symbol) -> tuple[Chart, ...]:
    """Return the charts of two sizes, either being the larger."""
    return tuple(
        Chart("", {larger: SIZE, smaller: SIZE * SHARE}, SIZES)
        for larger, smaller in ((one, other), (other, one))
    )


BY_RADII = by_larger(radius, amplitude)
# theta = z*phi is the angle within the periods. The circle may be shifted either way, but not as
# far as the pole, where the track has corners.
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
# A point's polar angle enters by its sine, too. It is at most theta.
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
# The hypotenuse of the plane is a side in space.
BY_SPACE = tuple(
    Chart(
        "",
        {larger: side, smaller: side * OTHER_SHARE, error_z: height},
        {**SIZES, OTHER_SHARE: SIZES[SHARE]},
    )
    for larger, smaller in ((error_x, error_y), (error_y, error_x))
    for side, height in ((SIZE, SIZE * SHARE), (SIZE * SHARE, SIZE))
)

# Sums have a coordinate of their own. The thermal error may leave more of the total than it takes,
# or less: a square, with which a root vanishes.
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
