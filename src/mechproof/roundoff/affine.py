"""Affine: a map M*p + v of points, and a bound on the norm of its error.

Each rounding of an entry moves the matrix by a multiple of another one (`moved_matrices`), and so
does each rounding of a sum of products. A fused row rounds each sum of the shift and its last
products. If the order of the sums is unknown, a row of three rounds its products, a sum of two of
them (at most the sum of all their sizes), the sum of all, and this plus the shift.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import sympy as sp

from mechproof.arithmetic.intervals import EPS, UNIT, Ends, Interval, exactly
from mechproof.programs.operations import Arithmetic
from mechproof.programs.program import Operand
from mechproof.roundoff.bound import ErrorAnalysis
from mechproof.roundoff.error_sums import ErrorScale
from mechproof.roundoff.moved_matrices import bound_stretch, sort_moves
from mechproof.roundoff.steps import HALF, Step, StraightLineProgram


@dataclass(frozen=True)
class AffineMap:
    """The steps of a matrix, row by row; the names of a point's coordinates and of the shift's.

    `is_fused` states that the products are fused with their sums, the last product first.
    """

    entries: StraightLineProgram
    points: tuple[str, ...]
    shift: tuple[str, ...]
    is_fused: bool = False

    @property
    def rows(self) -> list[tuple[Operand, ...]]:
        """List the rows of the matrix."""
        count, outputs = len(self.points), self.entries.outputs
        return [outputs[i * count : (i + 1) * count] for i in range(count)]

    def apply(self) -> StraightLineProgram:
        """Return the steps that map a point, its products summed in a fixed order."""
        steps: list[Step] = []
        outputs: list[Operand] = []
        for i, row in enumerate(self.rows):
            total: Operand = self.shift[i]
            for j, (entry, point) in enumerate(zip(row, self.points, strict=True)):
                product, name = f"product{i}{j}", f"sum{i}{j}"
                steps.append(Step(product, "multiply", (entry, point), HALF))
                steps.append(Step(name, "add", (total, product), HALF))
                total = name
            outputs.append(total)
        together = (*self.entries.steps, *steps)
        return replace(self.entries, steps=together, outputs=tuple(outputs))

    def bound(self, evaluation: ErrorAnalysis, bar: ErrorScale) -> Ends:
        """Bound the norm of the error in eps of D*|p| + |v|, D being the scale."""
        count = len(self.points)
        assert bar.scale is not None
        moves = [[evaluation.list_moves(e, bar.scale) for e in row] for row in self.rows]
        for i, row in enumerate(self.rows):
            for j, entry in enumerate(row):
                size = (evaluation.value(entry) / bar.scale).expanded()
                moves[i][j] |= self.list_sums(i, j, size)
        norm = bound_stretch(sort_moves(moves))
        # The second factor is needed as other roundings have already moved what a rounding moves.
        roundings = len(self.entries.steps) + 2 * count**2
        norm = norm * (1 + EPS * roundings) * (1 + 2 * EPS * norm)
        of_shift = _add_roundings(count if self.is_fused else 1) / EPS
        return np.where(np.isfinite(norm), np.maximum(norm, of_shift), np.inf)

    def list_sums(self, i: int, j: int, entry: Interval) -> dict[str, Interval]:
        """Return how far roundings of products and sums move the map, as if they moved an entry."""
        half = exactly(UNIT / EPS)
        if self.is_fused:
            return {f"sum{i}{k}": entry * half for k in range(j + 1)}
        return {f"products{i}{j}": entry, f"sums{i}": entry}

    def compute_scale(self, size: Any, given: Mapping[str, Any], arithmetic: Arithmetic) -> Any:
        """Return D*|p| + |v|."""
        point, shift = (
            measure_norm([given[n] for n in names], arithmetic)
            for names in (self.points, self.shift)
        )
        return size * point + shift


def find_size(scale: sp.Expr, points: Sequence[sp.Basic], shift: Sequence[sp.Basic]) -> sp.Expr:
    """Return D of a scale D*|p| + |v|; ValueError for a scale of any other shape."""
    first, *others = points
    size = scale.subs({first: 1, **dict.fromkeys((*others, *shift), 0)})
    lengths = [sp.sqrt(sum(s**2 for s in symbols)) for symbols in (points, shift)]
    if scale != size * lengths[0] + lengths[1] or size.free_symbols & {*points, *shift}:
        raise ValueError(f"{scale} is not a multiple of a point's size plus a shift's size")
    return size


def measure_norm(components: Sequence[Any], arithmetic: Arithmetic) -> Any:
    """Return the norm of a vector."""
    return arithmetic.sqrt(sum(c * c for c in components))


def _add_roundings(count: int) -> float:
    """Bound the relative error of a number after `count` roundings in a row."""
    return count * UNIT * (1 + EPS * count)
