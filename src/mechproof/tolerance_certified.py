"""The range of a derived quantity over the whole box of its sizes, certified by ball arithmetic.

A corner range is no bound where the dependence on a size turns between its limits. Here the
derivation of a quantity gives its derivatives, and balls give their signs over the box: a size
in which the quantity is monotonic goes to a limit, the others are cut into halves until the
bound meets a value that is attained, or a budget is spent. What is then open is the gap.

Needs the `derive` extra (sympy, python-flint).

>>> from mechproof import WedgeLinkage
>>> from mechproof.tolerance_certified import certified_range
>>> sizes = WedgeLinkage.published_sizes(1)
>>> bool(certified_range("wedge_linkage", "position", -30.0, sizes).upper_gap < 1e-9)
True
"""

from __future__ import annotations

import heapq
import itertools
from collections.abc import Mapping
from dataclasses import dataclass
from functools import reduce
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechproof.tolerance_sizes import Floats, Size, check_count, check_inputs, check_sizes

if TYPE_CHECKING:
    from mechproof.record import Paper

BITS = 96
# Derivations already loaded; a derivation takes seconds.
_LOADED: dict[str, Paper] = {}

Limits = tuple[float, float]
Box = dict[Any, Limits]


@dataclass(frozen=True, eq=False)
class CertifiedRange:
    """Bounds of a quantity over the whole box of sizes, at every input.

    `lower` and `upper` are bounds: no sizes within their limits give a value beyond. The true
    extremes lie between them and `lower_attained`, `upper_attained`, which are values of the
    quantity at sizes in the box. Infinite bounds mean that the quantity may be undefined there.

    `turning` adds a last axis along `names`, the toleranced sizes: True where the whole box did
    not show the quantity to be monotonic in the size. `without_influence` names the sizes whose
    derivative is proved to be identically zero. `boxes` counts the boxes examined.
    """

    names: tuple[str, ...]
    without_influence: tuple[str, ...]
    lower: Floats
    upper: Floats
    lower_attained: Floats
    upper_attained: Floats
    turning: NDArray[np.bool_]
    boxes: NDArray[np.int64]

    @property
    def lower_gap(self) -> Floats:
        """What remains open at the lower end, in the unit of the quantity."""
        return self.lower_attained - self.lower

    @property
    def upper_gap(self) -> Floats:
        """What remains open at the upper end, in the unit of the quantity."""
        return self.upper - self.upper_attained


def certified_range(
    system: str | Paper,
    quantity: str,
    inputs: ArrayLike,
    sizes: Mapping[str, Size],
    *,
    gap: float = 1e-9,
    budget: int = 200,
) -> CertifiedRange:
    """Bound a quantity of a derivation over the box of its sizes.

    Parameters
    ----------
    system
        Name of a system of the package, or a `Paper` of your own.
    quantity
        Name of one of its scalar quantities; its first argument takes the inputs.
    inputs
        Array-like of any shape.
    sizes
        Name and `Size` of every other argument, and of any other variable of the paper.
    gap
        Cut on while bound and attained value are further apart than this.
    budget
        Boxes to examine at most for each end at each input.

    Returns
    -------
    CertifiedRange
        Arrays of the inputs' shape. NaN in, NaN out.

    Raises
    ------
    ImportError
        Without the `derive` extra.
    TypeError, ValueError
        Names the parameter.

    """
    check_count("budget", budget, 1)
    if not gap >= 0:
        raise ValueError(f"gap = {gap}: must not be negative")
    points = check_inputs(inputs)
    problem = _Problem(_load(system), quantity, sizes)
    results = [problem.bound(x, gap, budget) for x in points.ravel().tolist()]
    ends = np.array([r[:4] for r in results], np.float64).reshape(-1, 4)
    lower, lower_attained, upper, upper_attained = ends.T.reshape(4, *points.shape)
    names = (*problem.names, *problem.idle)
    turning = np.array([[n in r[4] for n in names] for r in results], bool)
    return CertifiedRange(
        names=names,
        without_influence=tuple(problem.idle),
        lower=lower,
        upper=upper,
        lower_attained=lower_attained,
        upper_attained=upper_attained,
        turning=turning.reshape(*points.shape, len(names)),
        boxes=np.array([r[5] for r in results], np.int64).reshape(points.shape),
    )


def _load(system: str | Paper) -> Paper:
    try:
        import flint  # noqa: F401

        from mechproof.derivation import load_paper, packaged_directory
    except ImportError as error:
        raise ImportError(
            f"certified_range needs {error.name}: install mechproof with the extra `derive`"
        ) from error
    if not isinstance(system, str):
        return system
    file = packaged_directory() / f"{system}.py"
    if not file.is_file():
        raise ValueError(f"system = {system!r}: no derivation of this name")
    if system not in _LOADED:
        _LOADED[system] = load_paper(file)
    return _LOADED[system]


class _Problem:
    """A quantity and its derivatives, ready to be enclosed over boxes of sizes."""

    def __init__(self, paper: Paper, name: str, sizes: Mapping[str, Size]) -> None:
        from mechproof.proof.domain import Domain

        domain = Domain.of(paper)
        found = {q.name: q for q in paper.quantities}
        if name not in found:
            raise ValueError(f"quantity = {name!r}: must be one of {sorted(found)}")
        quantity = found[name]
        self.running = quantity.arguments[0].symbols[0]
        symbols = {str(v.symbol): v.symbol for v in paper.variables}
        symbols |= {a.name: a.symbols[0] for a in quantity.arguments}
        _check_names(sizes, [a.name for a in quantity.arguments[1:]], symbols)
        given = {s: g for s, g in domain.given.items() if s not in symbols.values()}
        given |= {s: g for s, g in domain.given.items() if str(s) not in sizes}
        # Definition and form are equal (an approximation is not used), but not their balls: the
        # narrower counts. The form spares cancellations, the definition has shorter derivatives.
        exact = [quantity.definition]
        exact += [quantity.form.expression] if quantity.form.bound is None else []
        self.values = [Domain(domain.within, (), given).resolve(e) for e in exact]
        self.fixed = {symbols[n]: s.nominal for n, s in sizes.items() if not s.tolerance}
        varying = {n: symbols[n] for n in check_sizes(sizes)}
        self.idle = [n for n, s in varying.items() if _is_idle(self.values[-1], s, domain)]
        self.fixed |= {varying[n]: sizes[n].nominal for n in self.idle}
        self.names = {n: s for n, s in varying.items() if n not in self.idle}
        self.limits: Box = {s: sizes[n].limits for n, s in self.names.items()}
        self.slopes = {
            s: [_branches(value, s) for value in self.values] for s in self.names.values()
        }

    def bound(self, x: float, gap: float, budget: int) -> tuple[Any, ...]:
        """Return lower bound, attained; upper bound, attained; turning names; boxes."""
        if x != x:
            return (x, x, x, x, (), 0)
        known = {**self.fixed, self.running: x}
        low = _Search(self, known, -1).run(gap, budget)
        high = _Search(self, known, 1).run(gap, budget)
        turning = [n for n, s in self.names.items() if s in low.turning | high.turning]
        return (-low.bound, -low.attained, high.bound, high.attained, turning,
                low.boxes + high.boxes)  # fmt: skip


class _Search:
    """Branch and bound for the largest value of direction * quantity."""

    def __init__(self, problem: _Problem, known: Mapping[Any, float], direction: int) -> None:
        self.problem, self.known, self.direction = problem, known, direction
        self.attained = self.bound = -np.inf
        self.boxes = 0
        self.turning: set[Any] = set()

    def run(self, gap: float, budget: int) -> _Search:
        order = itertools.count()
        bound, box, steep = self._examine(self.problem.limits)
        self.turning = {s for s, (a, b) in box.items() if a < b}
        heap = [(-bound, next(order), box, steep)]
        while self.boxes < budget and -heap[0][0] - self.attained > gap and heap[0][3]:
            _, _, box, steep = heapq.heappop(heap)
            for half in _halves(box, max(steep, key=steep.__getitem__)):
                bound, part, slopes = self._examine(half)
                heapq.heappush(heap, (-bound, next(order), part, slopes))
        self.bound = max(-heap[0][0], self.attained)
        return self

    def _examine(self, box: Box) -> tuple[float, Box, dict[Any, float]]:
        """Return a bound over the box, its face where the extreme lies, and reach by size."""
        self.boxes += 1
        steep: dict[Any, float] = {}
        slopes: dict[Any, Any] = {}
        while True:
            before = box
            for symbol in [s for s, (a, b) in box.items() if a < b]:
                slope = self._slope(symbol, box)
                slopes[symbol], sign = slope, _sign(slope)
                if sign:
                    box = {**box, symbol: (box[symbol][1 if sign > 0 else 0],) * 2}
            if box == before:
                break
        still_open = [s for s, (a, b) in box.items() if a < b]
        middle = {s: ((a + b) / 2,) * 2 for s, (a, b) in box.items()}
        centre = self._value(middle)
        self._attain(centre)
        corner = {s: (b if _middle(slopes.get(s)) > 0 else a,) * 2 if s in still_open else (a, b)
                  for s, (a, b) in box.items()}  # fmt: skip
        self._attain(self._value(corner))
        linear = centre
        for symbol in still_open:
            deviation = _ball(box[symbol]) - _ball(middle[symbol])
            linear = linear + _hull(slopes[symbol]) * deviation
            steep[symbol] = _reach(slopes[symbol], box[symbol])
        natural = [self._evaluate(value, box) for value in self.problem.values]
        return min(map(_upper, [linear, *natural])), box, steep

    def _slope(self, symbol: Any, box: Box) -> list[Any]:
        """Return the branches of the derivative, by the way whose hull is narrowest."""
        ways = [[self._evaluate(b, box) for b in way] for way in self.problem.slopes[symbol]]
        signed = [way for way in ways if _sign(way)]
        return signed[0] if signed else min(ways, key=lambda way: _width(_hull(way)))

    def _value(self, box: Box) -> Any:
        return self._evaluate(self.problem.values[-1], box)

    def _evaluate(self, expression: Any, box: Box) -> Any:
        from mechproof.proof import balls

        values = {s: balls.to_ball(v) for s, v in self.known.items()}
        values |= {s: _ball(limits) for s, limits in box.items()}
        return self.direction * balls.evaluate(expression, values, BITS)

    def _attain(self, ball: Any) -> None:
        if ball.is_finite():
            self.attained = max(self.attained, _down(ball.lower()))


def _check_names(sizes: Mapping[str, Size], needed: list[str], symbols: Mapping[str, Any]) -> None:
    missing = sorted(set(needed) - set(sizes))
    unknown = sorted(set(sizes) - set(symbols))
    if missing or unknown:
        raise ValueError(f"sizes: missing {missing}, unknown {unknown}; needed are {needed}")


def _is_idle(value: Any, symbol: Any, domain: Any) -> bool:
    """Prove that the derivative is identically zero."""
    import sympy as sp

    from mechproof.proof.algebra import decide_equal

    slope = sp.diff(value, symbol)
    return slope == 0 or (
        not slope.has(sp.Heaviside, sp.Max) and decide_equal(slope, sp.S.Zero, domain) is not None
    )


def _branches(value: Any, symbol: Any) -> list[Any]:
    """Differentiate; each step function at a kink of Max may be anything from 0 to 1.

    The quantity must be continuous: by the mean value theorem of Lipschitz functions the slope
    between two points lies in the hull of the branches.
    """
    import sympy as sp

    if value.has(sp.Piecewise, sp.floor, sp.sign):
        raise ValueError("the quantity has branches that need not meet; use Max, Min or Abs")
    kinked = value.replace(sp.Abs, lambda a: sp.Max(a, -a))
    slope = sp.diff(kinked, symbol)
    steps = sorted(slope.atoms(sp.Heaviside), key=str)
    choices = itertools.product((0, 1), repeat=len(steps))
    return [slope.xreplace(dict(zip(steps, map(sp.Integer, c), strict=True))) for c in choices]


def _halves(box: Box, symbol: Any) -> tuple[Box, Box]:
    low, high = box[symbol]
    middle = (low + high) / 2
    return {**box, symbol: (low, middle)}, {**box, symbol: (middle, high)}


def _ball(limits: Limits) -> Any:
    from flint import arb

    low, high = limits
    return arb(low) if low == high else arb(low).union(arb(high))


def _sign(slopes: list[Any]) -> int:
    if all(s >= 0 for s in slopes):
        return 1
    return -1 if all(s <= 0 for s in slopes) else 0


def _hull(slopes: list[Any]) -> Any:
    return reduce(lambda hull, slope: hull.union(slope), slopes)


def _middle(slopes: list[Any] | None) -> float:
    return float(_hull(slopes).mid()) if slopes else 0.0


def _reach(slopes: list[Any], limits: Limits) -> float:
    hull = _hull(slopes)
    steepest = float(hull.abs_upper()) if hull.is_finite() else np.inf
    return steepest * (limits[1] - limits[0])


def _width(ball: Any) -> float:
    return float(ball.rad()) if ball.is_finite() else np.inf


def _upper(ball: Any) -> float:
    return -_down(-ball.upper()) if ball.is_finite() else np.inf


def _down(number: Any) -> float:
    """Round to a double not above; float() of a ball rounds to some neighbour."""
    return float(np.nextafter(float(number), -np.inf))
