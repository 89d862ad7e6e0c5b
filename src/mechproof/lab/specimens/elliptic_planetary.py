"""Ways of computing the position, ratio and acceleration of the elliptical pair."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from importlib.util import find_spec

import numpy as np
import sympy as sp

from mechproof.derivations import elliptic_planetary as paper
from mechproof.kernels import elliptic_planetary as kernels
from mechproof.lab.specimen import Array, Specimen
from mechproof.lab.specimens import elliptic_forms as forms
from mechproof.lab.specimens import elliptic_points as points
from mechproof.lab.subject import Study, Table
from mechproof.record import LENGTH, Conjunction, Equality, Holds, Variable

phi1, e, k, x = paper.phi1, paper.e, paper.k, paper.x

# Fourier series: E stands for e**n and T for n*x, so that one step proves every n.
nu = sp.Symbol("nu", positive=True)
E, T, turns = sp.Symbol("E", positive=True), sp.Symbol("T", real=True), sp.Symbol("m", integer=True)
step = sp.Symbol("h", positive=True)
VARIABLES = (
    Variable(nu, "number of terms", within=sp.Interval.open(0, sp.oo)),
    Variable(E, "e**nu", within=sp.Interval.open(0, sp.oo)),
    Variable(T, "nu*x"),
    Variable(turns, "whole turns of x", within=sp.S.Naturals0),
    Variable(step, "step of the samples", LENGTH**0, sp.Interval.open(0, sp.oo)),
)
D = 1 + e**2 - 2 * e * sp.cos(x)
CLOSED = 2 * sp.atan2(e * sp.sin(x), 1 - e * sp.cos(x))


def remainder(power: sp.Expr, angle: sp.Expr) -> sp.Expr:
    """Slope of what is left of the series, power = e**n and angle = n*x."""
    return 2 * power * e * (sp.cos(angle + x) - e * sp.cos(angle)) / D


def tail(power: sp.Expr, terms: sp.Expr) -> sp.Expr:
    """Bound of what is left of the series after `terms` terms, power = e**terms."""
    return 2 * power * e / ((terms + 1) * (1 - e))


# The slope of what is left starts as that of the whole, falls by one term at each step, and its
# bound falls by no less than the bound of a term; both go to 0 with e**n.
SERIES = Conjunction(
    (
        Equality(remainder(sp.S.One, sp.S.Zero), sp.diff(CLOSED, x)),
        Equality(remainder(E, T) - remainder(E * e, T + x), 2 * E * e * sp.cos(T + x)),
        Holds(sp.Ge(tail(E, nu) - tail(E * e, nu + 1), 2 * E * e / (nu + 1))),
    )
)


def power_sum(order: int) -> sp.Expr:
    """Sum of 2*m**order*e**m over m >= 1, which no derivative of the series exceeds."""
    total = 2 * e / (1 - e)
    for _ in range(order):
        total = sp.factor(e * sp.diff(total, e))
    return total


# One interval of the interpolating parabola misses h**4/24 of the third derivative.
SIMPSON_BOUND = sp.Abs(phi1) * step**3 / 24 * k**4 * power_sum(3)
# Hall and Meyer 1976: the interpolating cubic spline misses 5/384 h**4 of the fourth derivative.
SPLINE_BOUND = sp.Rational(5, 384) * (2 * sp.pi / forms.KNOTS) ** 4 * power_sum(3)
THIRD_POWERS = Equality(2 * e * (1 + 4 * e + e**2) / (1 - e) ** 4, power_sum(3))

# x = y + 2 pi m with |y| < pi: the floor is m, and the rest is one branch.
WITH_TURNS = Equality(
    2 * sp.atan((1 + e) / (1 - e) * sp.tan(x / 2)) + 2 * sp.pi * turns,
    x
    + 2 * sp.pi * turns
    + 2 * sp.atan2(e * sp.sin(x + 2 * sp.pi * turns), 1 - e * sp.cos(x + 2 * sp.pi * turns)),
)
ATAN2_STABLE = (1 + k) * phi1 + 2 * sp.atan2(e * sp.sin(x), (1 - e) + 2 * e * sp.sin(x / 2) ** 2)
TAN_HALF = (1 + k) * phi1 + 2 * sp.atan(
    2 * e * sp.tan(x / 2) / ((1 - e) + (1 + e) * sp.tan(x / 2) ** 2)
)
PRINTED_RATIO = paper.print_8.subs(paper.phi5, -paper.R1 / paper.R2 * phi1)
HALF_ANGLE_D = (1 - e) ** 2 + 4 * e * sp.sin(x / 2) ** 2


def fourier(terms: int) -> Specimen:
    """Return the row of the series cut after `terms` terms."""
    bound = tail(e**terms, sp.Integer(terms))
    compute = partial(forms.fourier, terms)
    return Specimen(f"Fourier series, {terms} terms", compute, SERIES, bound=bound)


# Roundings of float32, u = 2**-24, in Clenshaw's recurrence
# b_m = a_m + 2 cos(y) b_(m+1) - b_(m+2): |b_m| <= 2 e**m/(1 - e), and an error d in b_m moves the
# sum by |sin(m y)*d| <= |d|. A step loses 3u |2 cos(y) b_(m+1)| + 2u |b_(m+2)| + u |b_m|, the
# cosine 3u of itself; coefficients and y lose u, the sine 3u and the product u. Up to |x| = 2**26
# x, rounded twice, and its reduction lose 2**-26 each, and the two sums in double as much.
SINGLE = e * (2 + 24 * e + 4 * e**2) / (1 - e) ** 2 + 17 * e / (1 - e)
SINGLE_BOUND = SINGLE / 2**24 + sp.Rational(1, 2**24)


def fourier_single(terms: int) -> Specimen:
    """Return the row of the series computed in float32."""
    bound = tail(e**terms, sp.Integer(terms)) + SINGLE_BOUND
    compute = partial(forms.fourier_single, terms)
    name = f"Fourier series, {terms} terms, float32"
    return Specimen(name, compute, SERIES, bound=bound, note="bound of the series and its rounding")


EQUALS = paper.position_closed
POSITION: tuple[Specimen, ...] = (
    Specimen("printed (12)", kernels.position_printed, Equality(paper.print_12, EQUALS)),
    Specimen(
        "tan/arctan",
        kernels.position_principal,
        Equality(paper.position_principal, EQUALS),
        holds_on=paper.BRANCH,
    ),
    Specimen(
        "tan/arctan + unwrap",
        forms.unwrapped,
        Equality(paper.position_principal, EQUALS),
        on=paper.BRANCH,
        ordered=True,
        note="beyond the branch only if no step of the samples turns the output by pi",
    ),
    Specimen(
        "tan/arctan + floor",
        forms.floored,
        WITH_TURNS,
        on=paper.BRANCH,
        note="proved for |x - 2 pi m| < pi; the computed floor and tangent disagree at the ends",
    ),
    Specimen(
        "x + 2 atan2, 1 - e cos x",
        forms.atan2_form,
        Equality((1 + k) * phi1 + CLOSED, EQUALS),
    ),
    Specimen("x + 2 atan2, no cancellation", forms.atan2_stable, Equality(ATAN2_STABLE, EQUALS)),
    Specimen("tan-half, by hand", forms.tan_half, Equality(TAN_HALF, EQUALS)),
    *map(fourier, (2, 4, 8, 16, 64)),
    *map(fourier_single, (2, 4, 8, 12)),
    Specimen(
        "cumulative Simpson",
        forms.simpson,
        THIRD_POWERS,
        bound=SIMPSON_BOUND,
        ordered=True,
        note="h/24 of the third derivative for each step; h is the step of phi1",
    ),
    Specimen(
        "cubic spline, 1024 knots",
        forms.splined,
        THIRD_POWERS,
        bound=SPLINE_BOUND,
        note="5/384 h**4 of the fourth derivative by Hall and Meyer 1976",
    ),
    Specimen(
        "solve_ivp, DOP853 1e-12",
        forms.integrated,
        ordered=True,
        slow=True,
        source="peer",
        note="no bound: the solver controls an estimate of the local error",
    ),
    Specimen(
        "scipy.stats.wrapcauchy",
        forms.wrapped_cauchy,
        source="peer",
        note="its cdf is (position - phi1)/(2 pi) on the first turn of x",
    ),
)

# The eccentric and true anomalies of an orbit are tied by the same arctangent.
ORBIT = 2 * e / (1 + e**2)
ANOMALY = Equality(
    2 * sp.atan(sp.sqrt((1 + ORBIT) / (1 - ORBIT)) * sp.tan(x / 2)),
    2 * sp.atan((1 + e) / (1 - e) * sp.tan(x / 2)),
)
if find_spec("kepler"):
    POSITION += (
        Specimen(
            "kepler.py",
            forms.by_kepler,
            ANOMALY,
            on=paper.BRANCH,
            source="peer",
            note="solves Kepler's equation on the way, which the position does not need",
        ),
    )

MAPPED = ("printed (12)", "x + 2 atan2, 1 - e cos x", "kernel")


def study(
    *specimens: Specimen,
    mapped: tuple[str, ...],
    within: Callable[..., Array] = points.near_enough,
    period: float | None = None,
) -> Study:
    """Return the rows of a quantity; all three share points, boxes and workload."""
    return Study(
        specimens,
        points.SETS,
        points.CELLS,
        points.in_cell,
        within,
        period,
        (("N angles, one mechanism", points.workload),),
        (points.peak_map(*mapped),),
        points.AS_TIMED.name,
    )


TABLE = Table(
    studies={
        "position": study(*POSITION, mapped=MAPPED, period=2 * np.pi),
        "ratio": study(
            Specimen("printed (8)", forms.direct_ratio, Equality(paper.print_8, paper.RATIO)),
            Specimen(
                "half-angle sine",
                forms.stable_ratio,
                Equality(1 + k * (1 - e) * (1 + e) / HALF_ANGLE_D, paper.RATIO),
            ),
            mapped=("printed (8)", "half-angle sine", "kernel"),
        ),
        "acceleration": study(
            Specimen(
                "1 + e**2 - 2 e cos x",
                forms.direct_acceleration,
                Equality(sp.diff(PRINTED_RATIO, phi1), paper.ACCELERATION),
            ),
            Specimen(
                "half-angle sine",
                forms.stable_acceleration,
                Equality(
                    -2 * e * k**2 * (1 - e) * (1 + e) * sp.sin(x) / HALF_ANGLE_D**2,
                    paper.ACCELERATION,
                ),
            ),
            mapped=("1 + e**2 - 2 e cos x", "half-angle sine", "kernel"),
            within=points.near_and_large_enough,
        ),
    },
    variables=VARIABLES,
)
