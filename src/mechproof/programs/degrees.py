"""Degrees: the powers of unknown factors in a value, as for homogeneous functions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from mechproof.programs.operations import KINDS, Arithmetic
from mechproof.programs.program import Operand


@dataclass(frozen=True)
class Degree:
    """The powers of unknown factors in a value; `powers` is empty if it has none."""

    powers: Mapping[Operand, int]

    def __add__(self, other: Degree) -> Degree:
        if self.powers != other.powers:
            raise ValueError("a sum of differently scaled values")
        return self

    __sub__ = __add__

    def __mul__(self, other: Degree) -> Degree:
        return self._join(other, 1)

    def __truediv__(self, other: Degree) -> Degree:
        return self._join(other, -1)

    def __neg__(self) -> Degree:
        return self

    def _join(self, other: Degree, sign: int) -> Degree:
        names = {**self.powers, **other.powers}
        found = {n: self.powers.get(n, 0) + sign * other.powers.get(n, 0) for n in names}
        return Degree({name: power for name, power in found.items() if power})


NONE = Degree({})


def _take_plain(*degrees: Degree) -> Degree:
    if any(degree.powers for degree in degrees):
        raise ValueError("a function of a scaled value")
    return NONE


DEGREES = Arithmetic(
    {
        **{k: _take_plain for k, row in KINDS.items() if row.sympy is not None},
        "number": lambda number: NONE,
    }
)
