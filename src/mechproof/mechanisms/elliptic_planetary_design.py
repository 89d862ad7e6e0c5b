"""Sizes of an elliptical drive from what its ratio is wanted to be.

The closed forms are kernels, proved to be the inverses of the extremes; what is reachable follows
from the monotony that is proved with them.
"""

from __future__ import annotations

from mechproof.arguments.scalars import check_real, choose_one, refuse, require
from mechproof.kernels import elliptic_planetary as kernels

Sizes = tuple[float, float, float]
EPS = 2.0**-52


def find_sizes(wanted: dict[str, object], k: object, radius_1: object, radius_2: object) -> Sizes:
    """Return R1, R2 and e; arguments as in `EllipticPlanetary.design`."""
    given = {name: check_real(name, value) for name, value in wanted.items() if value is not None}
    if given.keys() == {"largest_ratio", "smallest_ratio"}:
        return _find_all(given["largest_ratio"], given["smallest_ratio"], k, radius_1, radius_2)
    name, _ = choose_one(wanted, ", or the largest and the smallest ratio")
    r1, r2 = _find_radii(k, radius_1, radius_2)
    return r1, r2, _find_eccentricity(name, given[name], r1, r2)


def _find_all(
    largest: float, smallest: float, k: object, radius_1: object, radius_2: object
) -> Sizes:
    require(k is None, "k", k, "follows from both extremes; leave it out")
    require(smallest > 1, "smallest_ratio", smallest, "must be above 1")
    allowed = f"must be at least the smallest, {smallest!r}"
    require(smallest <= largest, "largest_ratio", largest, allowed)
    least = 1 + 1 / (smallest - 1)
    allowed = f"must be above {least!r} with this smallest_ratio, {smallest!r}: else R1 <= R2"
    found = float(kernels.radii_of_extremes(largest, smallest))
    require(found > 1, "largest_ratio", largest, allowed)
    e = float(kernels.eccentricity_of_extremes(largest, smallest))
    both = radius_1 is not None and radius_2 is not None
    require(not both, "R2", radius_2, "follows from R1 and both extremes; leave it out")
    return *_find_radii(found, radius_1, radius_2), _check_below_one("largest_ratio", largest, e)


def _find_radii(k: object, radius_1: object, radius_2: object) -> tuple[float, float]:
    """Return both radii from two of the three, or from k alone with R2 = 1 mm."""
    sizes = {"k": k, "R1": radius_1, "R2": radius_2}
    numbers = {n: check_real(n, size) for n, size in sizes.items() if size is not None}
    for name, number in numbers.items():
        require(number > 0, name, number, "must be positive")
    if len(numbers) == 3 or not ("k" in numbers or len(numbers) == 2):
        raise TypeError(f"{sizes!r}: give R1 and R2, or k = R1/R2 and at most one of them")
    if "k" in numbers:
        require(numbers["k"] > 1, "k", k, "must be above 1, for R2 < R1")
        r2 = numbers["R1"] / numbers["k"] if "R1" in numbers else numbers.get("R2", 1.0)
        return numbers.get("R1", numbers["k"] * r2), r2
    r1, r2 = numbers["R1"], numbers["R2"]
    require(r2 < r1, "R2", r2, f"must be below R1 = {r1!r}")
    return r1, r2


def _find_eccentricity(name: str, value: float, r1: float, r2: float) -> float:
    uniform = 1 + r1 / r2
    reach = {
        "largest_ratio": (value >= uniform, f"must be at least 1 + k = {uniform!r}, that of e = 0"),
        "smallest_ratio": (
            1 < value <= uniform,
            f"must be above 1 and at most 1 + k = {uniform!r}, that of e = 0",
        ),
        "quotient": (value >= 1, "must be at least 1, that of e = 0"),
        "non_uniformity": (value >= 0, "must not be negative"),
    }
    holds, allowed = reach[name]
    require(holds, name, value, allowed)
    kernel = getattr(kernels, f"eccentricity_of_{name}")
    e = float(kernel(value, r1, r2))
    if not e > 0:
        # A wish next to that of e = 0 may lie outside the kernel's domain by a rounding; squares
        # of one far away leave the range of doubles, as e nears 1.
        plain = {"quotient": 1.0, "non_uniformity": 0.0}.get(name, uniform)
        e = 0.0 if abs(value - plain) <= 4 * EPS * uniform else 1.0
    return _check_below_one(name, value, e)


def _check_below_one(name: str, value: float, e: float) -> float:
    """Return e, which is below 1 unless it is rounded to 1."""
    if not 0 <= e < 1:
        refuse(name, value, f"needs an eccentricity so near to 1 that a double is {e!r}")
    return e
