"""Coordinates in which the rounding errors of the stages of paper 4 are bounded."""

from collections.abc import Iterator

from sympy import Expr, Integer, Interval, Rational, Symbol, oo

from mechproof.record import Chart, Toleranced

from ..mechanics import *
from ..rows.sizes import FIRST_SET

# All lengths are shares of the largest one.
LARGEST, PART = Symbol("R", positive=True), Symbol("l_AB/arm", positive=True)
SHARES = tuple(Symbol(f"share_{letter}", positive=True) for letter in "abc")
LENGTHS, SHARE = Interval(0, oo), Interval(0, 1)
X, Y, Z, W = (Symbol(letter, positive=True) for letter in "xyzw")


def by_largest(
    displacement: Symbol, sizes: tuple[Symbol, ...], text: str, angles: dict[Symbol, Interval]
) -> Iterator[Chart]:
    """Yield the charts of a displacement of either sign and sizes, by which is the largest."""
    lengths = (displacement, *sizes)
    for largest in lengths:
        others = [length for length in lengths if length is not largest]
        within = {LARGEST: LENGTHS, **dict.fromkeys(SHARES[: len(others)], SHARE), **angles}
        for sign in (1, -1):
            shares = dict(zip(others, SHARES, strict=False))
            values = {largest: LARGEST, **{n: LARGEST * share for n, share in shares.items()}}
            values[displacement] = sign * values[displacement]
            yield Chart(text, {**values, **{angle: angle for angle in angles}}, within)


UPWARD = "alpha_KL <= 22/7"
RADICAND = tuple(by_largest(x1, (l_AB, l_BC, l_CD), "", {}))
CLEARANCE = tuple(by_largest(x5, (l_GH,), "", {}))
OFFSET = tuple(by_largest(x5, (l_KL,), UPWARD, {alpha_KL: Interval(0, Rational(22, 7))}))

# Beyond, the square of BC cancels, and its error is compared with a condition that has no bound.
CLOSING = "x1 >= -l_BC*min(1, l_BC/(l_AB + l_CD))/4"
QUARTER = Interval(0, Rational(1, 4))


def guide_chart(x: Expr, length: Expr, arm: Expr, within: dict[Symbol, Interval]) -> Chart:
    """Return the chart of the pusher's displacement, of the guide's length and of the arm."""
    arguments = {x1: LARGEST * x, l_BC: LARGEST * length, l_AB: LARGEST * arm * PART}
    arguments[l_CD] = LARGEST * arm * (1 - PART)
    return Chart(CLOSING, arguments, {LARGEST: LENGTHS, PART: SHARE, **within})


# The arm, the guide or the displacement is the largest; next to a long arm both may be small.
LEVER = (
    guide_chart(Y**2 * W, Y, 1, {Y: SHARE, W: SHARE}),
    guide_chart(Z**2, Z * W, 1, {Z: SHARE, W: SHARE}),
    guide_chart(X, 1, Y, {X: SHARE, Y: SHARE}),
    guide_chart(1, X, Y, {X: SHARE, Y: SHARE}),
    guide_chart(-(Y**2) * W, Y, 1, {Y: SHARE, W: QUARTER}),
    guide_chart(-X, 1, Y, {X: QUARTER, Y: SHARE}),
)

# Farther out, the height of the roller cancels, and its error has no bound, like the guide's.
LIFTED = "-alpha_KL**2*l_KL/10 <= x5 <= l_KL/4 and alpha_KL <= 2"
LIFTED_FAR = "l_KL/4 <= x5 <= l_KL and alpha_KL <= 5/4"
RAISED = Interval(-Rational(1, 10), Rational(1, 8))
ROLLER = tuple(
    Chart(text, {l_KL: LARGEST, x5: LARGEST * x, alpha_KL: angle}, {LARGEST: LENGTHS, **within})
    for text, x, angle, within in (
        (LIFTED, alpha_KL**2 * W, alpha_KL, {alpha_KL: Interval(0, 2), W: RAISED}),
        (LIFTED, Z**2, Z * W, {Z: Interval(0, Rational(1, 2)), W: Interval(0, 3)}),
        (
            LIFTED_FAR,
            X,
            alpha_KL,
            {X: Interval(Rational(1, 4), 1), alpha_KL: Interval(0, Rational(5, 4))},
        ),
    )
)


def arm(
    turned: Symbol, direction: Symbol, length: Symbol, least: Expr, text: str
) -> tuple[Chart, ...]:
    """Return the charts of an arm that turns by at most half a turn, to either side."""
    within = {
        X: Interval(0, Rational(22, 7)),
        direction: Interval(least, Rational(44, 7)),
        LARGEST: LENGTHS,
    }
    return tuple(
        Chart(text, {turned: sign * X, direction: direction, length: LARGEST}, within)
        for sign in (1, -1)
    )


# At a direction of 0, the turn and the direction vanish together, and with them the value and
# everything to which the rounding of their sum is compared.
ROD = arm(phi3, alpha_DE, l_DE, Rational(1, 8), "|phi3| <= 22/7 and 1/8 <= alpha_DE <= 44/7")
WEDGE = arm(phi7, alpha_LM, l_LM, 0, "|phi7| <= 22/7 and 0 <= alpha_LM <= 44/7")

# A size without deviations gets these, as a share of itself, so that it is not a single double.
LEAST_DEVIATION = Rational(1, 1000)


def tolerate(size: Toleranced) -> Interval:
    """Return the range of a size between its limits."""
    low, high = size.nominal + size.lower, size.nominal + size.upper
    return Interval(
        min(low, size.nominal * (1 - LEAST_DEVIATION)),
        max(high, size.nominal * (1 + LEAST_DEVIATION)),
    )


def describe_place(place: Expr) -> str:
    """Write a displacement of the pusher with its unit."""
    return f"{place} mm" if place else "0"


def whole_chain(*ways: tuple[Expr, Expr]) -> tuple[Chart, ...]:
    """Return the charts of ranges of the pusher, in mm, and of all sizes within their limits."""
    sizes = {size: tolerate(value) for size, value in FIRST_SET.sizes.items()}
    places = " or ".join(
        f"{describe_place(first)} <= x1 <= {describe_place(last)}" for first, last in ways
    )
    least = f"at least {float(100 * LEAST_DEVIATION):g} %"
    text = f"{places}, and the sizes are within the limits ({least}) of {FIRST_SET.source}"
    ranges = ({x1: Interval(first, last), **sizes} for first, last in ways)
    return tuple(
        Chart(text, {argument: argument for argument in within}, within) for within in ranges
    )


CHAIN = whole_chain((Integer(-37), Integer(0)))
# Between these, contact starts for some of the sizes, and the velocity jumps.
VELOCITY = whole_chain((Integer(-37), Integer(-2)), (-Rational(3, 4), Integer(0)))
