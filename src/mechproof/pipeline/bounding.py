"""Bounding: from an FPCore file or a pasted expression to proved bounds on rounding errors.

`roundoff` proves the bound over the box, and its climb finds the worst input.
"""

from __future__ import annotations

import json
import math
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

import sympy as sp

from mechproof.arguments.array_checks import check_flag
from mechproof.arguments.scalars import (
    check_count,
    check_function,
    check_number,
    check_texts,
    require,
)
from mechproof.arithmetic.balls import evaluate
from mechproof.arithmetic.cover import Box, bound_largest
from mechproof.arithmetic.intervals import enclose_ball
from mechproof.fpcore import FPCoreError, read_cores, read_file
from mechproof.latex import ReadingError
from mechproof.latex.errors import TOO_DEEP
from mechproof.pipeline.pasted import PastedError, read_expression
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.programs.lowering import lower_steps
from mechproof.roundoff.boxed import BoxedProgram, Convention, Range, find_worst_input, put_in_box
from mechproof.roundoff.steps import StraightLineProgram, make_step, round_constants

FPCORE = ".fpcore"
# Relative tolerance of a bound, and the most parts that its box is divided into.
TOLERANCE, PARTS = 0.002, 200_000


@dataclass(frozen=True)
class Bounding:
    """A straight-line program, its name, and the ranges of its inputs."""

    name: str
    straight: StraightLineProgram
    ranges: Mapping[str, Range]


@dataclass(frozen=True)
class ProvedBound:
    """A proved bound on the error of a program, and the worst input found.

    `proved` bounds the error, absolute or, with `relative`, divided by the exact value, for every
    input in the box. It is infinite if nothing is proved; `open` then names the part of the box.
    `found` is the error at the exact inputs `at`, which are empty if no error is finite.
    """

    name: str
    proved: float
    found: float
    at: Mapping[str, Fraction]
    relative: bool
    rounded_inputs: bool
    parts: int
    seconds: float
    assumptions: tuple[str, ...]
    open: str = ""

    def as_dict(self) -> dict[str, object]:
        """Return the JSON row, with exact inputs as fractions."""
        return {
            "name": self.name,
            "proved": self.proved if math.isfinite(self.proved) else None,
            "found": self.found,
            "at": {name: str(value) for name, value in self.at.items()},
            "error": "relative" if self.relative else "absolute",
            "inputs": "rounded" if self.rounded_inputs else "doubles",
            "parts": self.parts,
            "seconds": round(self.seconds, 2),
            "assumptions": list(self.assumptions),
            "open": self.open,
        }


def bound(
    source: str | Path,
    *,
    where: list[str] | tuple[str, ...] = (),
    relative: bool = False,
    rounded_inputs: bool = False,
    ulps: float = 1.0,
    tolerance: float = TOLERANCE,
    parts: int = PARTS,
    report: Callable[[str], None] = lambda text: None,
) -> tuple[ProvedBound, ...]:
    """Prove bounds on the rounding errors of programs in doubles, rounded to nearest.

    `source` is the name of an FPCore file, or an expression in LaTeX whose letters lie in the
    ranges given by the relations `where`. Inputs are doubles or, with `rounded_inputs`, real
    numbers that are first rounded. With `relative`, errors are divided by the exact value.
    Functions such as sin are assumed accurate to `ulps` ulps of their results. A bound exceeds the
    least that this analysis can show by a relative `tolerance` at most, unless that takes more than
    `parts` parts of the box. `report` is called with a message about each program.

    Raises `FPCoreError` for a file that cannot be read or is not straight-line, `PastedError` for
    an invalid expression, and `ValueError` or `TypeError` for other invalid arguments.
    """
    require(isinstance(source, str | Path), "source", source, "must be a file or LaTeX", TypeError)
    where = check_texts("where", where)
    relative, rounded_inputs = (
        check_flag("relative", relative),
        check_flag("rounded_inputs", rounded_inputs),
    )
    allowed = "must satisfy 0 < tolerance < 1"
    require(0 < check_number("tolerance", tolerance) < 1, "tolerance", tolerance, allowed)
    check_count("parts", parts)
    check_function("report", report)
    convention = Convention(rounded_inputs, relative, check_number("ulps", ulps))
    if str(source).endswith(FPCORE):
        require(not where, "where", where, f"must be empty; {source} has its own :pre")
        found = read_boundings(Path(source))
    else:
        found = (read_pasted(Pasted(str(source), where=where)),)
    return tuple(bound_all(found, convention, tolerance, parts, report))


def read_boundings(path: Path) -> tuple[Bounding, ...]:
    """Return the cores of a file; an `FPCoreError` names the file."""
    try:
        cores = read_cores(read_file(path))
    except OSError as error:
        raise FPCoreError(f"{path}: {error.strerror}") from error
    except FPCoreError as error:
        raise FPCoreError(f"{path}, {error}") from error
    return tuple(Bounding(core.name, core.straight, core.box) for core in cores)


def read_pasted(pasted: Pasted) -> Bounding:
    """Return an expression as it would be emitted; raise `PastedError` if it cannot be read."""
    try:
        expression, sets = read_expression(pasted)
        letters = sorted(expression.free_symbols, key=str)
        ranges = {str(letter): _find_range(letter, sets[letter]) for letter in letters}
        names = {letter: str(letter) for letter in letters}
        program = lower_steps(names, frozenset(letters), tuple(ranges), (), (expression,))
    except (ReadingError, ValueError, NotImplementedError) as error:
        raise PastedError(str(error)) from error
    except RecursionError as error:
        raise PastedError(TOO_DEEP) from error
    steps = tuple(map(make_step, program.operations))
    straight = StraightLineProgram(tuple(ranges), steps, program.outputs)
    return Bounding(pasted.latex, round_constants(straight), ranges)


def _find_range(letter: sp.Symbol, within: sp.Set) -> Range:
    """Return the ends of a set; ends that are not fractions are rounded outwards to doubles."""
    low, high = (within.inf, within.sup) if isinstance(within, sp.Interval) else (-sp.oo, sp.oo)
    for end, sign in ((low, "<="), (high, ">=")):
        if end.is_infinite:
            raise ValueError(f"--where gives no number {sign} {letter}")
    return _take_end(low, is_low=True), _take_end(high, is_low=False)


def _take_end(end: sp.Expr, *, is_low: bool) -> Fraction:
    if end.is_Rational:
        return Fraction(int(end.p), int(end.q))
    span = enclose_ball(evaluate(end, {}))
    return Fraction(float(span.low if is_low else span.high))


def bound_all(
    boundings: Sequence[Bounding],
    convention: Convention,
    tolerance: float,
    parts: int,
    report: Callable[[str], None],
) -> Iterator[ProvedBound]:
    """Yield the bounds of programs; raise ValueError for an operation that no rule bounds."""
    for bounding in boundings:
        report(f"bounding {bounding.name}")
        yield bound_one(bounding, convention, tolerance, parts)


def bound_one(
    bounding: Bounding, convention: Convention, tolerance: float, parts: int
) -> ProvedBound:
    """Prove a bound and search for the worst input.

    Raises ArithmeticError if an error exceeds the proved bound: then an assumption does not hold
    here, or the proof is wrong.
    """
    start = time.process_time()
    try:
        program = put_in_box(bounding.straight, bounding.ranges, convention)
    except ValueError as error:
        raise ValueError(f"{bounding.name}: {error}") from error
    largest = bound_largest(program.bound, program.box, tolerance, parts)
    worst = find_worst_input(program, (program.box, *largest.highest))
    found, at = (worst.error, worst.at) if worst else (0.0, {})
    if found > largest.bound:
        resting = " and ".join(program.assumptions)
        place = ", ".join(f"{name} = {value}" for name, value in at.items())
        raise ArithmeticError(
            f"{bounding.name}: off by {found} at {place}, above the bound {largest.bound}, "
            f"proved assuming {resting}"
        )
    return ProvedBound(
        bounding.name,
        largest.bound,
        found,
        at,
        convention.relative,
        convention.rounded_inputs,
        largest.count,
        time.process_time() - start,
        program.assumptions,
        "" if largest.open is None else _describe_part(program, largest.open),
    )


def _describe_part(program: BoxedProgram, box: Box) -> str:
    ends = zip(program.straight.inputs, box, strict=True)
    return ", ".join(f"{low:g} <= {name} <= {high:g}" for name, (low, high) in ends)


def bounds_to_json(bounds: Sequence[ProvedBound]) -> str:
    """Return the text of a file of bounds."""
    rows: dict[str, Any] = {"bounds": [one.as_dict() for one in bounds]}
    return json.dumps(rows, indent=1, ensure_ascii=False) + "\n"
