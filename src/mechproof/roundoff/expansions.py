"""Expansions: operations of the support package written out as programs.

They mirror `mechproof.kernel_support`; a test runs both and compares every bit.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType

from mechproof.arithmetic.intervals import EPS
from mechproof.programs.elementary.fits import FITS, enclose, fit
from mechproof.programs.program import Operand, Operation, Program


@dataclass(frozen=True)
class Expansion:
    """A program in place of one operation; `errors` are those of approximations, in eps.

    `proved` are the functions of which the error is proved; what is `scaled` is so by a factor
    that depends on the first operand alone.
    """

    program: Program
    errors: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))
    proved: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))
    scaled: frozenset[str] = frozenset()


# A result, its kind, its operands.
Line = tuple[str, str, tuple[Operand, ...]]


def _write(inputs: str, *lines: Line) -> Program:
    operations = tuple(Operation(*line) for line in lines)
    return Program(tuple(inputs.split()), operations, (operations[-1].result,))


def _evaluate(name: str, z: str, coefficients: Sequence[float]) -> list[Line]:
    """Write Horner's rule down; the last result has the name."""
    *others, first = coefficients
    lines: list[Line] = []
    value: Operand = first
    for number in reversed(others):
        product, total = f"{name}{len(lines)}", f"{name}{len(lines) + 1}"
        lines += [(product, "multiply", (value, z)), (total, "add", (product, number))]
        value = total
    return [*lines[:-1], (name, *lines[-1][1:])]


TANGENT, ARC = (fit(target, *degrees) for target, degrees in FITS.values())
TANGENT_ERROR, ARC_ERROR = (enclose(t, fit(t, *degrees)) / EPS for t, degrees in FITS.values())
PLAIN_QUOTIENT = _write(
    "y a b",
    ("t", "tan", ("y",)),
    ("square", "square", ("t",)),
    ("product", "multiply", ("b", "square")),
    ("below", "add", ("a", "product")),
    ("q", "divide", ("t", "below")),
)
PLAIN_ARCTANGENT = _write("y", ("q", "arctan", ("y",)))
QUOTIENT = _write(
    "y a b",
    ("r", "pi_off", ("y",)),
    ("z", "square", ("r",)),
    *_evaluate("above", "z", TANGENT.above),
    ("fit", "multiply", ("above", "r")),
    ("u", "approximate", ("fit",)),
    *_evaluate("v", "z", TANGENT.below),
    ("w", "multiply", ("u", "v")),
    ("uu", "square", ("u",)),
    ("vv", "square", ("v",)),
    ("cos", "subtract", ("vv", "uu")),
    ("opposite", "multiply", ("cos", "w")),
    ("cos2", "square", ("cos",)),
    ("half_a", "divide", ("a", 2)),
    ("near", "multiply", ("cos2", "half_a")),
    ("w2", "square", ("w",)),
    ("twice_b", "multiply", (2, "b")),
    ("far", "multiply", ("w2", "twice_b")),
    ("below", "add", ("near", "far")),
    ("q", "divide", ("opposite", "below")),
)
ARCTANGENT = _write(
    "y",
    ("z", "square", ("y",)),
    *_evaluate("u", "z", ARC.above),
    *_evaluate("v", "z", ARC.below),
    ("ratio", "divide", ("u", "v")),
    ("rest", "multiply", ("ratio", "z")),
    ("arc", "multiply", ("rest", "y")),
    ("sum", "add", ("arc", "y")),
    ("q", "approximate", ("sum",)),
)
# The ways in which an operation is computed, on one host or another.
WAYS: Mapping[str, Mapping[str, Expansion]] = MappingProxyType(
    {
        "NumPy's functions": {
            "tangent_quotient": Expansion(PLAIN_QUOTIENT),
            "small_arctan": Expansion(PLAIN_ARCTANGENT),
        },
        "by polynomials": {
            "tangent_quotient": Expansion(QUOTIENT, {"u": TANGENT_ERROR}),
            "small_arctan": Expansion(ARCTANGENT, {"q": ARC_ERROR}),
        },
    }
)
