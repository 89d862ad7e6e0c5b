"""How the paper prints its symbols, and the prints that other rows and kernels go back to, read."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from mechproof.latex import Reader
from mechproof.record import ChainLink, Equation, Notation, Part, Scope

from .curve import (
    CURVE_VARIABLES,
    POSITION_ERROR,
    THETA,
    amplitude,
    on_track,
    phi,
    planar_error,
    radius,
    radius_by_sine_rule,
    spatial_error,
)
from .error_sums import DEVIATIONS, UNCORRELATED, UNIT_INFLUENCE, propagate
from .errors import ERROR_VARIABLES, i, j, k, total
from .frame import (
    ANGLES,
    ELEMENTS,
    FRAME_VARIABLES,
    MATRIX_A,
    MATRIX_B,
    MATRIX_C,
    MATRIX_K,
    SHIFT,
    SURFACE_POINT,
    TURNED_PART,
    alpha,
    compose,
    parameter,
    project,
    see_from_turned_frame,
)

VARIABLES = ERROR_VARIABLES + FRAME_VARIABLES + CURVE_VARIABLES
# K is the scatter coefficient and a matrix, A the amplitude and a matrix.
NOTATION = Notation(
    indices=(i, j, k),
    scopes=(
        Scope(("(8)", "(12)", "(13)"), {"A": MATRIX_A}),
        Scope(("(14)", "(15)"), {"K": MATRIX_K}),
    ),
)
READER = Reader(VARIABLES, NOTATION)

EQUATION_5 = Equation(
    "(5)",
    r"\Delta_\Sigma=\frac1K\sqrt{\sum_{i=1}^n(K_iT_i)^2}",
    derived={total: propagate(DEVIATIONS, UNCORRELATED, UNIT_INFLUENCE)},
    note="True under both stated premises together: independent errors and S_i = 1.",
)
EQUATION_8 = Equation(
    "(8)",
    r"A=\begin{pmatrix}a_{11}&a_{12}&a_{13}\\a_{21}&a_{22}&a_{23}\\a_{31}&a_{32}&a_{33}"
    r"\end{pmatrix}=\begin{pmatrix}1&0&0\\0&\cos\alpha&\sin\alpha\\0&-\sin\alpha&\cos\alpha"
    r"\end{pmatrix}",
    links={
        2: ChainLink(
            derived=dict(zip(ELEMENTS, see_from_turned_frame(0, alpha), strict=True)),
            note="Rebuilt from the turn of space backwards that an observer in the turned frame "
            "sees.",
        )
    },
)
EQUATION_14 = Equation(
    "(14)",
    r"K=\begin{pmatrix}\cos\beta\cos\gamma&\sin\alpha\sin\beta\cos\gamma+\cos\alpha\sin\gamma"
    r"&-\cos\alpha\sin\beta\cos\gamma+\sin\alpha\sin\gamma\\"
    r"-\cos\beta\sin\gamma&-\sin\alpha\sin\beta\sin\gamma+\cos\alpha\cos\gamma"
    r"&\cos\alpha\sin\beta\sin\gamma+\sin\alpha\cos\gamma\\"
    r"\sin\beta&-\sin\alpha\cos\beta&\cos\alpha\cos\beta\end{pmatrix}",
    derived={MATRIX_K: project(TURNED_PART)},
    note="Rebuilt by turning a triad about its own axes x10, y11, z12 and projecting.",
)
EQUATION_16 = Equation(
    "(16)",
    r"x_{13}=\left(\sqrt{R^2-A^2\sin^2(z\varphi)}+A\cos(z\varphi)\right)\cos\varphi,\ "
    r"y_{13}=(\dots)\sin\varphi,\ z_{13}=H_s",
    derived=dict(zip(SURFACE_POINT[:2], on_track(radius_by_sine_rule(THETA)), strict=False)),
    defines=(SURFACE_POINT[2],),
    note="Rebuilt by the sine rule in the triangle of pole, centre and point.",
    on=Part("|A| <= R", where=(sp.Le(sp.Abs(amplitude), radius),)),
    singular=("A = R: the circle passes through the pole and the track has corners there",),
    links={3: ChainLink(note="Names the height of the points.")},
)
EQUATION_17 = Equation(
    "(17)",
    r"\Delta_\Sigma^{XY}=\sqrt{\Delta x_0^2+\Delta y_0^2}",
    defines=(planar_error,),
    note="The position error of one point; not the scatter field that (3)-(7) call Delta_Sigma.",
)
EQUATION_18 = Equation(
    "(18)",
    r"\Delta_\Sigma^{XYZ}=\sqrt{\Delta x_0^2+\Delta y_0^2+\Delta z_0^2}",
    defines=(spatial_error,),
    note="As (17), in space.",
)
_, PRINTED_5 = READER.members(EQUATION_5)
*_, PRINTED_A = READER.members(EQUATION_8)
_, PRINTED_K = READER.members(EQUATION_14)
PRINTED_16 = sp.ImmutableMatrix(READER.members(EQUATION_16)[1::2])
_, PRINTED_17 = READER.members(EQUATION_17)
_, PRINTED_18 = READER.members(EQUATION_18)
EQUATION_15 = Equation(
    "(15)",
    r"(\Delta x_0,\Delta y_0,\Delta z_0)^T=K^T(x_{13},y_{13},z_{13})^T"
    r"-(x_{13}-a,\;y_{13}-b,\;z_{13}-c)^T",
    derived={
        MATRIX_K: PRINTED_K,
        **dict(
            zip(
                POSITION_ERROR,
                SHIFT + compose(TURNED_PART, SURFACE_POINT) - SURFACE_POINT,
                strict=True,
            )
        ),
    },
    note="Where the point is after the displacement minus where it should be: the same three "
    "numbers serve as coordinates in the part and as nominal place from O_1.",
)
PRINTED_15 = READER.members(EQUATION_15)[1].subs(MATRIX_K, PRINTED_K).doit()

FACTORS = {"A": PRINTED_A, "B": MATRIX_B, "C": MATRIX_C}
ALONG_LINE = PRINTED_K.subs({angle: parameter * angle for angle in ANGLES}, simultaneous=True)


def printed_radius(theta: sp.Expr) -> sp.Expr:
    """Bracket printed in (16), at theta = z varphi."""
    return (PRINTED_16[0] / sp.cos(phi)).subs(THETA, theta)


def product_of(order: Sequence[str]) -> sp.ImmutableMatrix:
    """Multiply the factors in the order written, from left to right."""
    left, middle, right = (FACTORS[name] for name in order)
    return left * middle * right
