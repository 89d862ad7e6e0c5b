"""Coordinates over which the rounding errors of paper 5 are bounded."""

import sympy as sp

from mechproof.record import Chart

from .symbols import *

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
