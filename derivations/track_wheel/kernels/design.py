"""Quantities for the design of paper 5: tilts of the blank for given errors."""

from functools import partial

import sympy as sp

from mechproof.record import *

from ..._algebra import is_moderate, is_zero_or_moderate
from ..mechanics import *
from ..rows import design
from .charts import SIZE
from .poses import SOURCE
from .track import HEIGHT

# For a tilt only the error beyond the offset matters, which in the plane may be of any size
# relative to it.
ONE, TWO, THREE, OFFSET_ALONE = sp.symbols("one two three offset_alone", positive=True)
# Of the largest error, its root rounded up, and the reciprocal of that rounded up.
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
    """Return the chart of two sizes by the larger one, and of an error beyond an offset.

    The excess is a share of their sum. Whatever vanishes under the root does so as one product.
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

# Accuracy, in eps: a rounding of g moves the tilt by its own size over the root, and so do those of
# the terms under the root, none of which is larger than g permits.
MODERATE = (
    *(is_moderate(size) for size in (radius_vector, thickness)),
    is_zero_or_moderate(eccentricity),
)
OFFSET = Argument("offset", (eccentricity,), "offset of the axis", "mm", usual=(0, 1))
CREST_RADIUS = Argument(
    "rho", (radius_vector,), "largest radius of the track", "mm", usual=(1, 100)
)


def tilt_for(
    name: str,
    where: str,
    error: sp.Symbol,
    tangent: sp.Expr,
    over: sp.Expr,
    on: Part,
    charts: tuple[Chart, ...],
) -> Quantity:
    """Return the quantity of the tilt at which the largest error is the given one."""
    excess, below = tangent.as_numer_denom()
    tilt = 2 * sp.atan2(excess, below)
    return Quantity(
        f"tilt_of_{name}",
        f"Compute the tilt with which the largest error {where} is the one wanted.",
        (
            Argument("error", (error,), "largest error wanted", "mm", usual=(0.01, 1)),
            OFFSET,
            CREST_RADIUS,
            HEIGHT,
        ),
        tilt,
        (Form("root without cancellation", tilt, charts=charts),),
        f"inverse of {SOURCE}, equation (15)",
        unit="rad",
        on=on,
        accuracy=Accuracy(
            6,
            Scale("the tilt and the effect of eps*(error - offset)", tilt + over),
            (*MODERATE, is_moderate(error)),
        ),
    )


QUANTITIES = (
    tilt_for(
        "planar_error",
        "in the plane",
        planar_error,
        design.PLANAR_ROOT,
        design.OVER_PLANE / sp.sqrt(design.PLANAR_SQUARE),
        design.IN_PLANE,
        FOR_PLANAR,
    ),
    tilt_for(
        "spatial_error",
        "in space",
        spatial_error,
        design.SPATIAL_ROOT,
        2 * spatial_error * (spatial_error - eccentricity) / sp.sqrt(design.SPATIAL_SQUARE),
        design.IN_SPACE,
        FOR_SPATIAL,
    ),
)
