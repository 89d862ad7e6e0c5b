"""Quantities of the track of paper 5: its radius, its points."""

import sympy as sp

from mechproof.record import *

from ..mechanics import *
from .charts import BY_RADII, IN_FIRST_PART, OFF_POLE
from .poses import SOURCE, turns

RADIUS = printed_radius(THETA)
# Seen from the pole, the distances of the circle's points are between these, whatever the sign of
# A.
LARGEST, SMALLEST = radius + sp.Abs(amplitude), radius - sp.Abs(amplitude)
# Both are even in A.
EVEN = ((amplitude,),)
TRACK = sp.ImmutableDenseMatrix([RADIUS * sp.cos(phi), RADIUS * sp.sin(phi), thickness])
SHIFTED_INSIDE = Part("A has either sign", {amplitude: sp.S.Reals})
root, rho = sp.symbols("root rho", real=True)

# Accuracy, in eps: 1/2 for an arithmetic operation, 1 for sin, cos and hypot.
# radius: u 1.5, w 1.5, its root 1.25, q 3.25 relative, w/q 5.25; the rounding of z*phi 1/2, which
# the second term of the scale covers.
RADIUS_ULP = 6
# track: the radius, a sine and a product.
TRACK_ULP = RADIUS_ULP + 1.5
RUNNING = Scale(
    "the radius and the effect of eps*z*phi",
    sp.Abs(rho) * (1 + sp.Abs(THETA * amplitude * sp.sin(THETA) / root)),
    where=(
        (root, sp.sqrt(radius**2 - amplitude**2 * sp.sin(THETA) ** 2)),
        (rho, root + amplitude * sp.cos(THETA)),
    ),
)

PASSES_POLE = Singular(
    sp.Eq(sp.Abs(amplitude), radius),
    "the circle passes through the pole and the track has corners there",
)
SINGULAR = (
    Singular(sp.Eq(THETA, sp.pi * turns)),
    Singular(sp.Eq(THETA, sp.pi / 2 + sp.pi * turns)),
    Singular(sp.Eq(amplitude, 0)),
    PASSES_POLE,
)
CIRCLE = (
    Argument("phi", (phi,), "polar angle", "rad", usual=(0, 7, 1e5)),
    Argument("R", (radius,), "radius of the shifted circle", "mm", usual=(1, 100)),
    Argument("A", (amplitude,), "shift of the circle, amplitude of the track", "mm", usual=(0, 10)),
    Argument("z", (periods,), "number of periods, a natural number", usual=(1, 6, 20)),
)
HEIGHT = Argument("H", (thickness,), "thickness of the part", "mm", usual=(1, 100))
# Between these sizes (R - A)*(R + A) is a normal double, down to R - A = eps*R. The scale is of
# first order in eps*z*phi: up to here its square is at most eps.
IN_RANGE = (radius >= sp.Rational(1, 10**140), radius <= 10**150, sp.Abs(THETA) <= 2**26)
LOADS = (("N angles, one wheel", ("phi",)),)
TRACK_SOURCE = f"{SOURCE}, equation (16)"

QUANTITIES = (
    Quantity(
        "radius",
        "Compute the radius vector of the track, a shifted circle repeated z times.",
        CIRCLE,
        RADIUS,
        (
            Form("conjugate root", RADIUS, ("conjugate_root",), charts=OFF_POLE),
            Form("printed (16)", RADIUS, key="printed", source=TRACK_SOURCE),
        ),
        TRACK_SOURCE,
        unit="mm",
        on=SHIFTED_INSIDE,
        accuracy=Accuracy(RADIUS_ULP, RUNNING, IN_RANGE),
        singular=SINGULAR,
        workloads=LOADS,
    ),
    Quantity(
        "track",
        "Compute points of the track.",
        (*CIRCLE, HEIGHT),
        TRACK,
        (
            Form(
                "conjugate root",
                TRACK,
                ("conjugate_root",),
                charts=IN_FIRST_PART,
                mirrors=((phi,),),
            ),
            Form(
                "printed (16)",
                sp.ImmutableDenseMatrix(PRINTED_16),
                key="printed",
                source=TRACK_SOURCE,
            ),
        ),
        TRACK_SOURCE,
        unit="mm",
        on=SHIFTED_INSIDE,
        accuracy=Accuracy(TRACK_ULP, RUNNING, IN_RANGE),
        singular=SINGULAR,
        workloads=LOADS,
    ),
    Quantity(
        "largest_radius",
        "Compute the largest radius vector of the track.",
        CIRCLE[1:3],
        LARGEST,
        (Form("sum", LARGEST, charts=BY_RADII, mirrors=EVEN),),
        f"extremes of {TRACK_SOURCE}",
        unit="mm",
        on=SHIFTED_INSIDE,
        accuracy=Accuracy(0.5),
    ),
    Quantity(
        "smallest_radius",
        "Compute the smallest radius vector of the track.",
        CIRCLE[1:3],
        SMALLEST,
        (Form("difference", SMALLEST, charts=BY_RADII, mirrors=EVEN),),
        f"extremes of {TRACK_SOURCE}",
        unit="mm",
        on=SHIFTED_INSIDE,
        accuracy=Accuracy(0.5),
        singular=(PASSES_POLE,),
    ),
)
