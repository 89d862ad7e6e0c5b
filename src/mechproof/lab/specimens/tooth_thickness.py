"""Ways of computing chords and thickness changes of the tooth, and the linear models."""

from __future__ import annotations

import numpy as np
import sympy as sp

from mechproof.derivations import tooth_thickness as paper
from mechproof.kernels import tooth_thickness as kernels
from mechproof.lab.specimen import Array, Specimen
from mechproof.lab.specimens import tooth_points as points
from mechproof.lab.subject import PointSet, Study, Table
from mechproof.record import Conjunction, Equality

tilt, m, z, alpha = paper.tilt, paper.m, paper.z, paper.alpha
r_b, t_c = paper.r_b, paper.t_c


def base_radius(m: Array, z: Array, alpha: Array) -> Array:
    """Radius of the base circle."""
    return np.asarray(m * z * np.cos(alpha) / 2)


def slope_and_angle(tilt: Array, z: Array, alpha: Array) -> tuple[Array, Array, Array, Array]:
    """Angles of the flank's tangent at both chords, and their roll angles."""
    start = np.pi / (2 * z) + np.tan(alpha) - alpha
    slope = alpha + tilt
    return alpha, alpha + start, slope, slope + start


def direct_height(tilt: Array, m: Array, z: Array, alpha: Array) -> Array:
    """Subtract two distances from the wheel's centre."""
    first, roll, slope, turned = slope_and_angle(tilt, z, alpha)
    nominal = np.cos(first) + roll * np.sin(first)
    return np.asarray(base_radius(m, z, alpha) * (nominal - np.cos(slope) - turned * np.sin(slope)))


def direct_thickness(tilt: Array, m: Array, z: Array, alpha: Array) -> Array:
    """Subtract two chords."""
    first, roll, slope, turned = slope_and_angle(tilt, z, alpha)
    chord = turned * np.cos(slope) - np.sin(slope)
    nominal = roll * np.cos(first) - np.sin(first)
    return np.asarray(2 * base_radius(m, z, alpha) * (chord - nominal))


def first_order_height(tilt: Array, m: Array, z: Array, alpha: Array) -> Array:
    """Follow the tangent of the flank at the constant chord, its length by the roll angle."""
    roll = np.pi / (2 * z) + np.tan(alpha)
    return np.asarray(-base_radius(m, z, alpha) * roll * np.cos(alpha) * tilt)


def first_order_thickness(tilt: Array, m: Array, z: Array, alpha: Array) -> Array:
    """Follow the same tangent."""
    roll = np.pi / (2 * z) + np.tan(alpha)
    return np.asarray(-2 * base_radius(m, z, alpha) * roll * np.sin(alpha) * tilt)


def by_height(tilt: Array, m: Array, z: Array, alpha: Array) -> Array:
    """Compute the exact change of height, then equation (1) with the exact derivative."""
    height = kernels.height_change(tilt, m, z, alpha)
    return np.asarray(kernels.thickness_change_linear(height, alpha))


def half_turned_thickness(tilt: Array, m: Array, z: Array, alpha: Array) -> Array:
    """Return sines of half angles, but the difference sin(tilt) - tilt cos(tilt) as it stands."""
    roll, small = np.pi / (2 * z) + np.tan(alpha), 2 * np.sin(tilt / 2) ** 2
    along = (roll + tilt) * np.sin(tilt) - small
    across = roll * small + np.sin(tilt) - tilt * np.cos(tilt)
    return np.asarray(
        -2 * base_radius(m, z, alpha) * (along * np.sin(alpha) + across * np.cos(alpha))
    )


# What `half_turned_thickness` computes.
small = 2 * sp.sin(tilt / 2) ** 2
HALF_TURNED = (
    -2
    * r_b
    * (
        ((t_c + tilt) * sp.sin(tilt) - small) * sp.sin(alpha)
        + (t_c * small + sp.sin(tilt) - tilt * sp.cos(tilt)) * sp.cos(alpha)
    )
)

# The derivatives by the tilt: the chord's end moves along the flank's tangent by r_b (t_c + tilt).
HEIGHT_SLOPE = -r_b * (t_c + tilt) * sp.cos(alpha + tilt)
THICKNESS_SLOPE = -2 * r_b * (t_c + tilt) * sp.sin(alpha + tilt)


def first_order(change: sp.Expr, slope: sp.Expr) -> Conjunction:
    """State value, slope and curvature; |sin|, |cos| <= 1 and Taylor give the bound."""
    return Conjunction(
        (
            Equality(change.subs(tilt, 0), sp.S.Zero),
            Equality(sp.diff(change, tilt), slope),
            Equality(sp.diff(slope, tilt), curvature(slope)),
        )
    )


def curvature(slope: sp.Expr) -> sp.Expr:
    """Second derivative, from the two kinds of slope."""
    if slope == HEIGHT_SLOPE:
        return -r_b * (sp.cos(alpha + tilt) - (t_c + tilt) * sp.sin(alpha + tilt))
    return -2 * r_b * (sp.sin(alpha + tilt) + (t_c + tilt) * sp.cos(alpha + tilt))


# r_b (1 + t_c + |tilt|) tilt**2/2, with r_b < m z/2 and tan(alpha) < 1.
HEIGHT_BOUND = m * tilt**2 * (z * (2 + sp.Abs(tilt)) + sp.pi / 2) / 4
# The slopes' difference is -m z (t_c + tilt) sin(tilt); |sin(tilt)| <= |tilt| and
# tan(alpha) < 1, integrated.
INFLUENCE = 2 * sp.tan(alpha)
MODEL = Conjunction(
    (
        Equality(
            (paper.thickness_change - INFLUENCE * paper.height_change).subs(tilt, 0), sp.S.Zero
        ),
        Equality(
            sp.diff(paper.thickness_change - INFLUENCE * paper.height_change, tilt),
            -m * z * (t_c + tilt) * sp.sin(tilt),
        ),
    )
)
MODEL_BOUND = m * tilt**2 * (sp.pi / 4 + z / 2 + z * sp.Abs(tilt) / 3)
TAYLOR = "|sin|, |cos| <= 1 and tan(alpha) < 1 in Taylor's remainder"

HEIGHT = (
    Specimen(
        "difference of two distances",
        direct_height,
        Equality(
            paper.chord_distance(alpha, paper.half_tooth)
            - paper.chord_distance(alpha + tilt, paper.half_tooth),
            paper.height_change,
        ),
    ),
    Specimen(
        "first order in the tilt",
        first_order_height,
        first_order(paper.height_change, HEIGHT_SLOPE),
        bound=HEIGHT_BOUND,
        note=TAYLOR,
    ),
)
THICKNESS = (
    Specimen(
        "difference of two chords",
        direct_thickness,
        Equality(
            2 * paper.chord_half(alpha + tilt, paper.half_tooth)
            - 2 * paper.chord_half(alpha, paper.half_tooth),
            paper.thickness_change,
        ),
    ),
    Specimen(
        "half angles, by hand",
        half_turned_thickness,
        Equality(HALF_TURNED, paper.thickness_change),
    ),
    Specimen(
        "first order in the tilt",
        first_order_thickness,
        first_order(paper.thickness_change, THICKNESS_SLOPE),
        bound=2 * HEIGHT_BOUND,
        note=TAYLOR,
    ),
    Specimen(
        "2 tan(alpha) times the height",
        by_height,
        MODEL,
        bound=MODEL_BOUND,
        note="the derivative of what is missing is proved; |sin(tilt)| <= |tilt|, integrated",
    ),
)


def handbook(factor: float) -> Specimen:
    """Return the row of the number that handbooks print for 20 degrees."""
    return Specimen(
        f"{factor:g} m",
        lambda m, alpha: np.asarray(factor * m * np.ones_like(alpha)),
        note="printed for a profile angle of 20 deg, rounded; wrong for every other",
    )


def study_flank(*specimens: Specimen) -> Study:
    """Return the rows of a change along the flank."""
    return Study(
        specimens,
        points.FLANKS,
        points.CELLS,
        points.in_cell,
        workloads=(("N tilts, one wheel", points.flank_load),),
    )


def study_sets(sets: tuple[PointSet, ...], *specimens: Specimen) -> Study:
    """Return the rows of a quantity that is one formula."""
    return Study(specimens, sets)


TABLE = Table(
    studies={
        # 4.161 mm and 2.243 mm of the paper are for a module of 3 mm.
        "constant_chord": study_sets(points.SIZES, handbook(1.387)),
        "chord_height": study_sets(points.SIZES, handbook(0.7476)),
        "height_change": study_flank(*HEIGHT),
        "thickness_change": study_flank(*THICKNESS),
        "thickness_change_linear": study_sets(points.DEPTHS),
        "linearisation_bound": Study(
            sets=points.HEIGHTS, workloads=(("N depths, one wheel", points.height_load),)
        ),
        "thickness_error": Study(
            specimens=(
                Specimen(
                    "printed",
                    lambda tip, height, alpha: (
                        kernels.thickness_error_printed(tip, height) + 0 * alpha
                    ),
                    Equality(
                        paper.PRINTED_INFLUENCE * (paper.e_tip + paper.dh_gauge),
                        2 * sp.tan(alpha) * (paper.dh_gauge - paper.e_tip / 2),
                    ),
                ),
            ),
            sets=points.ERRORS,
            workloads=(("N errors, one wheel", points.error_load),),
        ),
    },
)
