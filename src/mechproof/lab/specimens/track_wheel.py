"""Ways of computing turns, displacements, tracks and error sums of the wheel."""

from __future__ import annotations

import numpy as np
import sympy as sp

from mechproof.derivations import track_wheel as paper
from mechproof.kernels import track_wheel as kernels
from mechproof.lab.specimen import Array, Specimen
from mechproof.lab.specimens import track_points as points
from mechproof.lab.specimens import track_sums as sums
from mechproof.lab.subject import PointSet, Study, Table
from mechproof.record import Equality


def product_of_turns(alpha: Array, beta: Array, gamma: Array) -> Array:
    """Multiply the three matrices."""
    one, none = np.ones_like(alpha), np.zeros_like(alpha)
    (sa, ca), (sb, cb), (sg, cg) = ((np.sin(t), np.cos(t)) for t in (alpha, beta, gamma))
    a = np.array([[one, none, none], [none, ca, sa], [none, -sa, ca]])
    b = np.array([[cb, none, -sb], [none, one, none], [sb, none, cb]])
    c = np.array([[cg, sg, none], [-sg, cg, none], [none, none, one]])
    a, b, c = (np.moveaxis(m, (0, 1), (-2, -1)) for m in (a, b, c))
    return np.asarray(c @ b @ a)


def scipy_matrix(alpha: Array, beta: Array, gamma: Array) -> Array:
    """Let SciPy make the matrix; ours sees the part's frame, hence the transpose."""
    from scipy.spatial.transform import Rotation

    angles = np.stack(np.broadcast_arrays(alpha, beta, gamma), axis=-1)
    return np.asarray(Rotation.from_euler("XYZ", angles).as_matrix().swapaxes(-1, -2))


def scipy_displacement(p: Array, angles: Array, shift: Array) -> Array:
    """Let SciPy turn the points."""
    from scipy.spatial.transform import Rotation

    return np.asarray(Rotation.from_euler("XYZ", angles).apply(p) - (p - shift))


def direct_displacement(p: Array, angles: Array, shift: Array) -> Array:
    """Compute (15) as it stands."""
    matrix = kernels.rotation(*np.moveaxis(np.asarray(angles), -1, 0))
    turned = p @ matrix if np.ndim(angles) == 1 else np.einsum("...ij,...i->...j", matrix, p)
    return np.asarray(turned - (p - shift))


def direct_radius(phi: Array, r: Array, a: Array, z: Array) -> Array:
    """Compute (16) as printed."""
    return np.asarray(a * np.cos(z * phi) + np.sqrt(r**2 - a**2 * np.sin(z * phi) ** 2))


def direct_track(phi: Array, r: Array, a: Array, z: Array, h: Array) -> Array:
    """Put the radius of (16) at its angle."""
    rho = direct_radius(phi, r, a, z)
    columns = np.broadcast_arrays(rho * np.cos(phi), rho * np.sin(phi), h)
    return np.stack(columns, axis=-1)


def direct_planar(errors: Array) -> Array:
    """Compute (17) as printed."""
    return np.asarray(np.sqrt(errors[..., 0] ** 2 + errors[..., 1] ** 2))


def direct_spatial(errors: Array) -> Array:
    """Call the norm of NumPy."""
    return np.asarray(np.linalg.norm(errors, axis=-1))


def direct_sum(t: Array, s: Array, k: Array, total: Array) -> Array:
    """Add the squares."""
    return np.asarray(np.sqrt(np.sum((k * s * t) ** 2, axis=-1)) / total)


def quadratic_form(t: Array, s: Array, k: Array, matrix: Array, total: Array) -> Array:
    """Add the covariances by einsum."""
    term = k * s * t
    return np.asarray(np.sqrt(np.einsum("...i,...ij,...j", term, matrix, term)) / total)


def solved_by_hand(t: Array, s: Array, k: Array, total: Array, share: Array, kt: Array) -> Array:
    """Solve for the total, squares under the root."""
    return np.asarray(np.sqrt(np.sum((k * s * t) ** 2, axis=-1) / (total**2 - (kt * share) ** 2)))


def as_defined(definition: sp.Basic) -> Equality:
    """State that the code is the definition itself, typed in: nothing was rewritten."""
    return Equality(definition, definition)


SOLVED_BELOW = paper.scatter**2 - (paper.k_thermal * paper.share) ** 2
DISPLACEMENT = (
    Specimen(
        "direct K^T p - (p - t)",
        direct_displacement,
        Equality(paper.PRINTED_15, sp.Matrix(paper.DISPLACEMENT)),
    ),
    Specimen(
        "first order",
        kernels.displacement_linear,
        bound=next(q for q in paper.QUANTITIES if q.name == "displacement_linear").form.bound,
        note="the bound is |p| times half the squared sum of the angles, in the derivation",
    ),
    Specimen("scipy Rotation", scipy_displacement, source="peer"),
)


def study_sum(sets: tuple[PointSet, ...], specimen: Specimen) -> Study:
    """Return the rows of a sum of errors."""
    loads = (("N sums of nine", sums.independent_load),) if sets is sums.INDEPENDENT else ()
    return Study((specimen,), sets, within=sums.keep_squares, workloads=loads)


TABLE = Table(
    studies={
        "rotation": Study(
            specimens=(
                Specimen(
                    "product of three matrices",
                    product_of_turns,
                    Equality(
                        sp.Matrix(paper.MATRIX_C * paper.MATRIX_B * paper.PRINTED_A),
                        sp.Matrix(paper.ROTATION),
                    ),
                ),
                Specimen("scipy Rotation", scipy_matrix, source="peer"),
            ),
            sets=points.TURNS,
            workloads=(("N turns", points.turns),),
        ),
        "displacement": Study(
            specimens=DISPLACEMENT,
            sets=points.POSES,
            cells=points.CELLS,
            in_cell=points.in_cell,
            workloads=points.POSE_LOADS,
            maps=points.MAPS,
        ),
        "displacement_linear": Study(sets=points.POSES, workloads=points.POSE_LOADS),
        "radius": Study(
            specimens=(Specimen("printed (16)", direct_radius, as_defined(paper.RADIUS)),),
            sets=points.CIRCLES,
            workloads=(("N angles, one wheel", points.circle_load),),
        ),
        "track": Study(
            specimens=(Specimen("printed (16)", direct_track, as_defined(sp.Matrix(paper.TRACK))),),
            sets=points.TRACKS,
            workloads=(("N angles, one wheel", points.track_load),),
        ),
        "planar_error": Study(
            specimens=(Specimen("sqrt(x**2 + y**2)", direct_planar, as_defined(paper.PLANAR)),),
            sets=(PointSet("vectors", points.vectors),),
            workloads=(("N vectors", points.vector_load),),
        ),
        "spatial_error": Study(
            specimens=(
                Specimen(
                    "np.linalg.norm", direct_spatial, as_defined(paper.SPATIAL), source="peer"
                ),
            ),
            sets=(PointSet("vectors", points.vectors),),
            workloads=(("N vectors", points.vector_load),),
        ),
        "error_sum": study_sum(
            sums.INDEPENDENT,
            Specimen("sum of squares, by hand", direct_sum, as_defined(paper.INDEPENDENT)),
        ),
        "error_sum_correlated": study_sum(
            sums.CORRELATED,
            Specimen("einsum", quadratic_form, as_defined(paper.CORRELATED)),
        ),
        "error_sum_thermal": study_sum(
            sums.THERMAL,
            Specimen(
                "squares under the root",
                solved_by_hand,
                Equality(paper.SQUARES / SOLVED_BELOW, paper.SOLVED**2),
                note="the squares are compared",
            ),
        ),
    },
)
