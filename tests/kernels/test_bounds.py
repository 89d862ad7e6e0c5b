"""Every kernel against its definition at 60 to 700 digits, at points chosen to hurt.

The bounds are worst-case bounds (derived beside the quantities), so there is no false alarm to
allow for; the random points have fixed seeds.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from importlib import import_module
from itertools import product
from typing import Any

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from derived import declared_paper_of

from mechproof.record import Accuracy, Quantity

EPS = float(np.finfo(float).eps)
Point = tuple[Any, ...]


class Oracle:
    """A quantity's definition and scale of error in high precision, for `count` summands."""

    def __init__(self, system: str, quantity: Quantity, count: int = 0) -> None:
        self.quantity, self.count = quantity, count
        letters = declared_paper_of(system).variables
        given = {v.symbol: v.given for v in letters if v.given is not None}
        self.inputs = [s for a in quantity.arguments for s in a.symbols]
        self.names: dict[sp.Basic, sp.Symbol] = {}
        value = self._instance(quantity.definition.subs(given).subs(given))
        scale = accuracy_of(quantity).scale
        scale = scale and self._instance(scale.written_out().subs(given).subs(given))
        symbols = list(self.names.values())
        self.value = sp.lambdify(symbols, value, "mpmath")
        self.scale = sp.lambdify(symbols, scale, "mpmath") if scale is not None else None

    def _instance(self, expression: sp.Basic) -> sp.Basic:
        """Write out sums, and name the elements of indexed symbols."""
        if self.count:
            count = next(s for t in expression.atoms(sp.Sum) for s in t.limits[0][2].free_symbols)
            expression = expression.subs(count, self.count).doit()
        atoms = expression.atoms(sp.Indexed) | (expression.free_symbols & set(self.inputs))
        for atom in sorted(atoms, key=str):
            if not isinstance(atom, sp.IndexedBase):
                self.names.setdefault(atom, sp.Symbol(f"v{len(self.names)}", real=True))
        return expression.xreplace(self.names)

    def worst(self, function: Callable[..., Any], point: Point, eps: float = EPS) -> float:
        """Return the error at one point in units of eps * scale; for a vector, its norm."""
        values = [self._pick(atom, point) for atom in self.names]
        exact = self.value(*values)
        with np.errstate(all="raise", under="ignore"):
            got = np.ravel(function(*point))
        if not np.isfinite(got).all():
            return float("inf")
        exact = list(exact) if isinstance(exact, mp.matrix) else [exact]
        errors = [mp.mpf(float(g)) - x for g, x in zip(got, exact, strict=True)]
        is_vector = len(errors) == 3
        error = mp.norm(errors) if is_vector else max(map(abs, errors))
        size = self.scale(*values) if self.scale else abs(exact[0])
        # Two subnormal spacings: below them no double is nearer.
        return float((error - mp.mpf(1e-323)) / (eps * size)) if error else 0.0

    def _pick(self, atom: sp.Basic, point: Point) -> mp.mpf:
        for argument, value in zip(self.quantity.arguments, point, strict=True):
            if atom in argument.symbols:
                index = argument.symbols.index(atom)
                return mp.mpf(float(value if len(argument.symbols) == 1 else value[index]))
            if isinstance(atom, sp.Indexed) and atom.base in argument.symbols:
                return mp.mpf(float(np.asarray(value)[tuple(int(i) - 1 for i in atom.indices)]))
        raise KeyError(atom)


ECCENTRICITIES = (0.0, 0.28, 0.475, 0.5, float(np.nextafter(0.5, 1)), 0.9, 0.999999, 1 - 1e-12)
LADDER = tuple(10.0**-k for k in range(1, 301, 23))


def near(value: float) -> tuple[float, ...]:
    return (float(np.nextafter(value, 0)), value, float(np.nextafter(value, np.inf)))


def elliptic_points() -> Iterator[Point]:
    random = np.random.default_rng(20240826)
    radii = ((66.0, 16.0), (80.0, 30.0), (50.3, 50.2))
    for e, (r1, r2) in product(ECCENTRICITIES, radii):
        angles = [0.0, 1e-300, *LADDER, *random.uniform(-30, 30, 9), *random.uniform(-1e6, 1e6, 8)]
        for turns in (1, 2, 3, 4, 101, 100_000):
            angles += near(turns * np.pi * r2 / r1)
        # Where the quotient rises most steeply for e near 1, also after many turns.
        narrow = (1 - e) * r2 / r1
        angles += [narrow, 3 * narrow, *(2e5 * np.pi * r2 / r1 + random.uniform(-3, 3, 3) * narrow)]
        yield from ((float(phi), r1, r2, e) for phi in angles)
    yield from WORST_ELLIPTIC


def elliptic_sizes() -> Iterator[Point]:
    random = np.random.default_rng(20240827)
    smaller = random.uniform(0.1, 50, 200)
    larger = smaller * (1 + 10 ** random.uniform(-12, 3, 200))
    flat = 1 - 10 ** random.uniform(-15, 0, 200)
    yield from zip(larger, smaller, flat, strict=True)
    yield from dict.fromkeys((r1, r2, e) for _, r1, r2, e in elliptic_points())


def above_uniform(least: float, most: float) -> Iterator[Point]:
    random = np.random.default_rng(20261125)
    for r1, r2, _ in list(elliptic_sizes())[:200]:
        uniform = 1 + r1 / r2
        for more in np.exp(random.uniform(np.log(least), np.log(most), 3)):
            yield float(np.nextafter(uniform, np.inf) * (1 + more)), r1, r2


def below_uniform() -> Iterator[Point]:
    for largest, r1, r2 in above_uniform(1e-15, 1e6):
        # The smallest ratio that goes with the largest one.
        yield max(1 + (r1 / r2) ** 2 / (largest - 1) * (1 - 1e-15), np.nextafter(1, 2)), r1, r2


def above(least: float) -> Iterator[Point]:
    random = np.random.default_rng(20261126)
    for r1, r2, _ in list(elliptic_sizes())[:200]:
        yield least, r1, r2
        yield from ((least + 10**more, r1, r2) for more in random.uniform(-15, 6, 3))


def both_extremes() -> Iterator[Point]:
    for largest, r1, r2 in above_uniform(1e-15, 1e6):
        smallest = 1 + (r1 / r2) ** 2 / (largest - 1)
        if (largest - 1) * (smallest - 1) > 1 + 1e-12:
            yield largest, smallest


# The worst inputs that searches over the bounds' domain met, for position, ratio and acceleration,
# with and without low word.
WORST_ELLIPTIC: tuple[Point, ...] = (
    (13.45802260045943, 97.1, 1.3, 0.5),
    (1.5360328021029432, 97.1, 1.3, 0.475),
    (783.9680985637104, 50.3, 50.2, 0.28),
    (0.0005407160605085868, 50.3, 50.2, 0.99),
    (3.0283529595885517, 97.1, 1.3, 0.999999999999),
    (-4375.541400057907, 50.3, 50.2, 0.99),
    (3.3642728085041824, 97.1, 1.3, 0.475),
    (13.52502243968266, 97.1, 1.3, 0.475),
    (699.8722554026814, 50.3, 50.2, 0.475),
    (-1.708639626742749e-05, 66.0, 16.0, 0.99),
    (-6.406008440880597e-05, 66.0, 16.0, 0.999999),
    (0.0005112745280106079, 50.3, 50.2, 0.999999),
    (31.502247880091502, 50.3, 50.2, 0.475),
    (10.2406943922781, 97.1, 1.3, 0.6),
)


def turns() -> Iterator[tuple[float, float, float]]:
    random = np.random.default_rng(20221)
    yield from ((s, -s, s) for s in LADDER)
    yield from ((1e-300, 0.0, 0.0), (0.0, 0.0, 0.0), (np.pi, 0, 0), (1000.0, 1e-3, 2e5))
    yield from ((3.1, -3.1, 3.1), (np.pi / 2, -np.pi / 2, 1e-9), (0.00103, 0.00103, 0.0))
    # The identity again, although no angle is small; and turns next to it.
    half = np.array([np.pi, -np.pi, np.pi])
    yield from (tuple(half + step) for step in (0.0, 1e-12, [1e-9, 0, 1e-3]))
    yield (0.83921782, 1.63609161, -2.70272269)
    yield from (tuple(row) for row in random.uniform(-np.pi, np.pi, (25, 3)))
    yield from (tuple(row) for row in 10 ** random.uniform(-20, 0.4, (25, 3)))


def displacement_points() -> Iterator[Point]:
    random = np.random.default_rng(20222)
    for angles in turns():
        point = random.uniform(-50, 50, 3)
        yield point, np.array(angles), np.zeros(3)
        yield point, np.array(angles), random.uniform(-1, 1, 3) * angles[0]


def circle_points() -> Iterator[Point]:
    random = np.random.default_rng(20223)
    radii = ((41.5, 3.75), (41.5, -3.75), (41.5, 0.0), (1.0, 1 - 1e-16), (1.0, 0.99))
    for (radius, shift), periods in product(radii, (1, 6, 7)):
        angles = [0.0, 1e-300, np.pi, np.pi / periods, np.pi / 2 / periods, *LADDER[::4]]
        angles += [*random.uniform(-7, 7, 10), *random.uniform(-1e5, 1e5, 3)]
        yield from ((float(phi), radius, shift, periods) for phi in angles)


def circle_sizes() -> Iterator[Point]:
    random = np.random.default_rng(20226)
    yield from ((41.5, 3.75), (41.5, -3.75), (41.5, 0.0), (1.0, 1 - 1e-16), (1e300, -1e300))
    yield from ((r, r * s) for r, s in random.uniform((1, -1), (99, 1), (50, 2)))


def error_points() -> Iterator[Point]:
    random = np.random.default_rng(20224)
    yield from (
        (row,) for row in random.normal(size=(30, 3)) * 10.0 ** random.integers(-9, 9, 30)[:, None]
    )
    yield from ((np.array(v),) for v in ((3e200, 4e200, 0.0), (3e-200, 4e-200, 1e-201)))


def sums(count: int, extra: Callable[[np.random.Generator], Point]) -> Iterator[Point]:
    random = np.random.default_rng(20225 + count)
    for _ in range(12):
        tolerances = 10 ** random.uniform(-6, 0, count)
        signs = random.uniform(-2, 2, count)
        yield tolerances, signs, random.uniform(0.5, 2, count), *extra(random)


def correlation(random: np.random.Generator, count: int = 5) -> np.ndarray:
    """Return a well-conditioned correlation matrix, symmetric and with ones to the last bit."""
    rows = random.normal(size=(count, 3 * count))
    rows /= np.linalg.norm(rows, axis=1, keepdims=True)
    upper = np.triu(rows @ rows.T, 1)
    return upper + upper.T + np.eye(count)


# Points, number of summands, digits: a definition that cancels 1 - cos(1e-300) needs 700.
POINTS: dict[tuple[str, str], tuple[Callable[[], Iterator[Point]], int, int]] = {
    ("elliptic_planetary", "ratio"): (elliptic_points, 0, 60),
    ("elliptic_planetary", "position"): (elliptic_points, 0, 60),
    ("elliptic_planetary", "acceleration"): (elliptic_points, 0, 60),
    ("elliptic_planetary", "largest_ratio"): (elliptic_sizes, 0, 60),
    ("elliptic_planetary", "smallest_ratio"): (elliptic_sizes, 0, 60),
    ("elliptic_planetary", "jerk"): (elliptic_points, 0, 60),
    **{
        ("elliptic_planetary", name): (elliptic_sizes, 0, 60)
        for name in (
            "largest_acceleration", "angle_of_smallest_acceleration", "smallest_jerk",
            "largest_jerk", "angle_of_largest_jerk",
        )
    },
    **{
        ("elliptic_planetary", f"eccentricity_of_{name}"): (wanted, 0, 60)
        for name, wanted in (
            ("largest_ratio", lambda: above_uniform(1e-15, 1e6)),
            ("smallest_ratio", below_uniform),
            ("quotient", lambda: above(1.0)),
            ("non_uniformity", lambda: above(0.0)),
        )
    },
    ("elliptic_planetary", "eccentricity_of_extremes"): (both_extremes, 0, 60),
    ("elliptic_planetary", "radii_of_extremes"): (both_extremes, 0, 60),
    ("track_wheel", "rotation"): (turns, 0, 60),
    ("track_wheel", "displacement"): (displacement_points, 0, 700),
    ("track_wheel", "radius"): (circle_points, 0, 60),
    ("track_wheel", "track"): (lambda: ((*p, 20.0) for p in circle_points()), 0, 60),
    ("track_wheel", "largest_radius"): (circle_sizes, 0, 60),
    ("track_wheel", "smallest_radius"): (circle_sizes, 0, 60),
    ("track_wheel", "planar_error"): (error_points, 0, 60),
    ("track_wheel", "spatial_error"): (error_points, 0, 60),
    ("track_wheel", "error_sum"): (lambda: sums(9, lambda r: (r.uniform(1, 2),)), 9, 60),
    ("track_wheel", "error_sum_correlated"): (
        lambda: sums(5, lambda r: (correlation(r), r.uniform(1, 2))), 5, 60,
    ),
    ("track_wheel", "error_sum_thermal"): (
        lambda: sums(6, lambda r: (1.2, (1 - 10 ** r.uniform(-14, -1)) / 1.7, 1.2 * 1.7)), 6, 60,
    ),
}  # fmt: skip


def find_quantity(system: str, name: str) -> Quantity:
    return next(q for q in declared_paper_of(system).quantities if q.name == name)


def accuracy_of(quantity: Quantity) -> Accuracy:
    assert quantity.accuracy is not None
    return quantity.accuracy


def find_kernel(system: str, name: str) -> Callable[..., Any]:
    kernel: Callable[..., Any] = getattr(import_module(f"mechproof.kernels.{system}"), name)
    return kernel


def measure(system: str, name: str, function: Callable[..., Any], eps: float = EPS) -> float:
    """Return the worst error over the points of a quantity, in units of its scale."""
    return max(list_errors(system, name, function, eps))


def list_errors(
    system: str, name: str, function: Callable[..., Any], eps: float = EPS
) -> Iterator[float]:
    points, count, digits = POINTS[system, name]
    with mp.workdps(digits):
        oracle = Oracle(system, find_quantity(system, name), count)
        yield from (oracle.worst(function, point, eps) for point in points())


def is_rejected(system: str, name: str, function: Callable[..., Any]) -> bool:
    """Return whether some point is off by more than a thousand times the bound."""
    limit = 1000 * accuracy_of(find_quantity(system, name)).ulp
    return any(error > limit for error in list_errors(system, name, function))


@pytest.mark.slow
@pytest.mark.parametrize(("system", "name"), POINTS, ids=map("-".join, POINTS))
def test_bound(system: str, name: str) -> None:
    accuracy = accuracy_of(find_quantity(system, name))
    assert measure(system, name, find_kernel(system, name)) <= accuracy.ulp


def direct_ratio(phi1: float, r1: float, r2: float, e: float) -> Any:
    k = r1 / r2
    return 1 + k * (1 - e**2) / np.maximum(1 + e**2 - 2 * e * np.cos(k * phi1), 1e-300)


def direct_displacement(point: Any, angles: Any, shift: Any) -> Any:
    return find_kernel("track_wheel", "rotation")(*angles).T @ point - (point - shift)


def direct_radius(phi: float, radius: float, shift: float, periods: int) -> Any:
    angle = periods * phi
    root = np.sqrt(np.maximum(radius**2 - shift**2 * np.sin(angle) ** 2, 0))
    return shift * np.cos(angle) + root


def test_the_measure_rejects_nan() -> None:
    def sometimes_nan(phi: float, *rest: Any) -> Any:
        return np.nan if phi == 0 else find_kernel("track_wheel", "radius")(phi, *rest)

    assert measure("track_wheel", "radius", sometimes_nan) == float("inf")


@pytest.mark.parametrize(
    ("system", "name", "naive"),
    [
        ("elliptic_planetary", "ratio", direct_ratio),
        (
            "elliptic_planetary",
            "position",
            find_kernel("forms.elliptic_planetary", "position_principal"),
        ),
        ("track_wheel", "displacement", direct_displacement),
        ("track_wheel", "radius", direct_radius),
    ],
    ids=["ratio", "position", "displacement", "radius"],
)
def test_the_measure_rejects_the_direct_formula(
    system: str, name: str, naive: Callable[..., Any]
) -> None:
    assert is_rejected(system, name, naive)


@pytest.mark.parametrize("name", ["ratio", "position", "acceleration"])
def test_bound_in_single_precision(name: str) -> None:
    # |phi1| <= 30: beyond, float32 has no digits left after the reduction of the angle.
    quantity = find_quantity("elliptic_planetary", name)
    random = np.random.default_rng(5)
    kernel, oracle = find_kernel("elliptic_planetary", name), Oracle("elliptic_planetary", quantity)
    accuracy = accuracy_of(quantity)
    with mp.workdps(60):
        for phi, e in product(random.uniform(-30, 30, 60), (0.0, 0.475, 0.9, 0.999)):
            point = tuple(map(np.float32, (phi, 66, 16, e)))
            assert kernel(*point).dtype == np.float32
            assert oracle.worst(kernel, point, float(np.finfo(np.float32).eps)) <= accuracy.ulp


@pytest.mark.slow
@pytest.mark.parametrize("name", ["ratio", "position", "acceleration"])
def test_the_measure_sees_the_low_word(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for part in ("_product_rest", "_quotient_rest"):
        with monkeypatch.context() as patch:
            patch.setattr(import_module("mechproof.kernels.elliptic_planetary"), part, no_rest)
            kernel = find_kernel("elliptic_planetary", name)
            assert is_rejected("elliptic_planetary", name, kernel)


def no_rest(*words: Any) -> float:
    return 0.0


def test_position_within_four_spacings() -> None:
    """The bound of `position` in its stricter reading: spacings of floats at the value itself."""
    quantity, kernel = (f("elliptic_planetary", "position") for f in (find_quantity, find_kernel))
    oracle = Oracle("elliptic_planetary", quantity)
    with mp.workdps(60):
        for point in elliptic_points():
            got = float(kernel(*point))
            exact = oracle.value(*(oracle._pick(atom, point) for atom in oracle.names))
            assert abs(mp.mpf(got) - exact) <= 4 * float(np.spacing(abs(got)))
