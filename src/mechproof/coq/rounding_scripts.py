"""A straight-line program and a bound on its rounding error -> a script with the proof by Coq.

Coq runs an analysis in intervals and halves the box until the bound holds everywhere. The analysis
is a Coq program that `Roundings.v` proves correct once and for all: errors are linear forms of the
roundings as in FPTaylor (Solovyev et al. 2018), with differences in place of derivatives, so that
no second-order term remains. VCFloat (Appel and Kellison 2024) proves bounds in Coq, too, with a
tactic for each operation.

For the elementary functions of compiled kernels, on an angle's remainder modulo quarter turns or on
a small quotient, there are two theorems: how far roundings move the program, and how far the
program without roundings is from the function. De Dinechin, Lauter and Melquiond (2011) divide the
proof of a function of CRlibm in this way, proving the first part by Gappa.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from types import MappingProxyType

import sympy as sp

from mechproof.coq.terms import TAKEN, UnwritableError, write_term
from mechproof.programs.elementary.formats import DOUBLE
from mechproof.programs.elementary.function_programs import build
from mechproof.programs.operations import KINDS
from mechproof.programs.program import Operand
from mechproof.roundoff.elementary_errors import (
    ANGLES,
    QUARTERS,
    bound_roundings,
    find_end_of_rests,
    find_end_of_small,
)
from mechproof.roundoff.running import IN_DOUBLES
from mechproof.roundoff.specialisation import REST, Case, Whole, resolve
from mechproof.roundoff.steps import CONSTANT, EXACT, HALF, Step, StraightLineProgram

Range = tuple[Fraction, Fraction]
# Names that functions have in the analysis.
CALLED: Mapping[str, str] = MappingProxyType(
    {
        "sin": "Sine",
        "cos": "Cosine",
        "tan": "Tangent",
        "arctan": "Arctangent",
        "exp": "Exponential",
        "log": "Logarithm",
    }
)
# For each operation its name in the analysis, and how it is written. All are rounded to nearest.
_OPERATIONS: Mapping[str, tuple[str, str]] = MappingProxyType(
    {
        "copy": ("Copied", "{}"),
        "negate": ("Opposite", "- {}"),
        "add": ("Sum", "{} + {}"),
        "subtract": ("Difference", "{} - {}"),
        "multiply": ("Product", "{} * {}"),
        "divide": ("Quotient", "{} / {}"),
        "fma": ("Fused", "{} * {} + {}"),
        "sqrt": ("Root", "sqrt {}"),
        **{kind: (f"Called {name}", f"{KINDS[kind].coq} {{}}") for kind, name in CALLED.items()},
    }
)
# The depth of halvings at which the analysis gives up.
_HALVINGS, _HALVINGS_RELATIVE = 100, 3000
# Settings of the Taylor models of coq-interval.
_PRECISION = "i_prec 90, i_degree 20"
# Characters that end a comment, or begin a string in it.
_COMMENTED = re.compile(r'[*"]')
_LETTER = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_EPS = Fraction(1, 2**52)
# Smaller inputs are left out: there a product may be below the least normal double.
_LEAST = Fraction(1, 2**300)
# The most by which programs miss their functions without roundings: a quarter of eps.
_OFF = _EPS / 4


@dataclass(frozen=True)
class BoundTheorem:
    """The claim that a program is off by at most a bound, for all inputs in their ranges.

    With `relative`, the bound is a fraction of the exact value's modulus.
    """

    straight: StraightLineProgram
    ranges: Mapping[str, Range]
    bound: Fraction
    relative: bool = False


@dataclass(frozen=True)
class FunctionEnclosure:
    """The claim that, without roundings, a program is within `off` of a function from 0 on."""

    function: sp.Expr
    off: Fraction


def write_bound_script(
    title: str, theorem: BoundTheorem, enclosure: FunctionEnclosure | None = None
) -> str:
    """Write the script of one program. Raises `UnwritableError` if Coq cannot analyse it."""
    writer = _Writer(theorem)
    enclosed = writer.write_enclosed(enclosure) if enclosure else ()
    # Only enclosures need the tactics of coq-interval, which take a third of the time to load.
    tactics = "From Interval Require Import Tactic.\n" if enclosure else ""
    parts = "bound, enclosed" if enclosure else "bound"
    return "\n".join(
        (
            f"(* {_COMMENTED.sub('', title)} *)",
            f"Require Import Roundings.\n{tactics}Open Scope R_scope.\n",
            *writer.write(),
            *enclosed,
            f"Definition all_parts := ({parts}).\n",
        )
    )


class _Writer:
    """The parts of a script; each distinct constant becomes one step."""

    def __init__(self, theorem: BoundTheorem) -> None:
        self._theorem = theorem
        straight = theorem.straight
        if len(straight.outputs) != 1 or not isinstance(straight.outputs[0], str):
            raise UnwritableError("the program must have exactly one output, the result of a step")
        self._steps = tuple(_state_constants(straight.steps))
        names = [name_letter(name) for name in straight.inputs]
        results = [step.result for step in self._steps]
        self._names = dict(zip(straight.inputs, names, strict=True))
        self._computed, self._exact = (
            self._names | {result: f"{letter}{n}" for n, result in enumerate(results, start=1)}
            for letter in "vw"
        )
        if len(set(names)) < len(names):
            raise UnwritableError("two inputs have the same name")
        if results[-1:] != [straight.outputs[0]]:
            raise UnwritableError("the last step must give the output")

    def write(self) -> Iterator[str]:
        theorem, inputs = self._theorem, self._theorem.straight.inputs
        names = [self._names[name] for name in inputs]
        ranges = [theorem.ranges[name] for name in inputs]
        yield f"Theorem bound : forall {' '.join(names)} : R,"
        for name, (low, high) in zip(names, ranges, strict=True):
            yield f"  {_write(low)} <= {name} -> {name} <= {_write(high)} ->"
        yield from self._write_steps(self._computed)
        yield from self._write_steps(self._exact)
        last = self._steps[-1].result
        computed, exact = self._computed[last], self._exact[last]
        share = f" * Rabs {exact}" if theorem.relative else ""
        yield f"  Rabs ({computed} - {exact}) <= {_write(theorem.bound)}{share}."
        yield "Proof."
        yield from self._write_proof(names, ranges)
        yield "Qed.\n"

    def write_enclosed(self, enclosure: FunctionEnclosure) -> Iterator[str]:
        (letter,) = self._theorem.straight.inputs
        name = self._names[letter]
        function = write_term(enclosure.function, {sp.Symbol(letter): name})
        ((_, high),) = self._theorem.ranges.values()
        last = self._exact[self._steps[-1].result]
        yield f"Theorem enclosed : forall {name} : R,"
        yield f"  0 <= {name} -> {name} <= {_write(high)} ->"
        yield from self._write_steps(self._exact)
        yield f"  Rabs ({last} - {function}) <= {_write(enclosure.off)}."
        yield f"Proof.\n  intros {name} low high. cbv zeta."
        yield f"  interval with (i_taylor {name}, i_bisect {name}, {_PRECISION})."
        yield "Qed.\n"

    def _write_steps(self, named: Mapping[str, str]) -> Iterator[str]:
        for step in self._steps:
            text = _write_step(step, named, named is self._computed)
            yield f"  let {named[step.result]} := {text} in"

    def _write_proof(self, names: Sequence[str], ranges: Sequence[Range]) -> Iterator[str]:
        theorem = self._theorem
        relative = "true" if theorem.relative else "false"
        halvings = _HALVINGS_RELATIVE if theorem.relative else _HALVINGS
        boxes = "; ".join(f"({_pair(low)}, {_pair(high)})" for low, high in ranges)
        turn = "; ".join(map(str, range(len(names))))
        followed = [
            ", ".join(named[step.result] for step in self._steps)
            for named in (self._computed, self._exact)
        ]
        steps = ";\n     ".join(self._list_analysed())
        yield "  intros."
        yield f"  refine (error_bounded {relative} {_pair(theorem.bound)}"
        yield f"    [{steps}]"
        yield f"    [{boxes}] [{turn}]%nat {halvings} [{'; '.join(names)}] _ _ _ _ _ _)."
        yield from (f"  - follow ({results}). reflexivity." for results in followed)
        yield "  - repeat (apply Forall2_cons; [unfold lies, real; simpl; lra|])."
        yield "    apply Forall2_nil."
        yield "  - vm_compute. reflexivity."

    def _list_analysed(self) -> Iterator[str]:
        """Yield the steps in the analysis's syntax, operands counted back from the last result."""
        known = [*reversed(self._theorem.straight.inputs)]
        for step in self._steps:
            if step.kind == CONSTANT:
                double, number = map(_pair, _list_values(step))
                yield f"Double {double}" if double == number else f"Constant {double} {number}"
            else:
                places = " ".join(str(known[::-1].index(str(o))) for o in step.operands)
                rounds = "Exact" if step.ulps == EXACT else "Rounded"
                yield f"{rounds} ({_OPERATIONS[step.kind][0]} {places})"
            known.append(step.result)


def name_letter(name: str) -> str:
    """Return the name of an input in a statement."""
    letter = re.sub(r"\W", "_", name, flags=re.ASCII)
    if not _LETTER.fullmatch(letter) or TAKEN.fullmatch(letter) or re.fullmatch(r"[vw]\d+", letter):
        letter = f"x_{letter}"
    return letter


def _state_constants(steps: Sequence[Step]) -> Iterator[Step]:
    """Yield the steps, each number among their operands preceded by a step of its own."""
    named: dict[Operand, str] = {}
    for step in steps:
        if step.kind == CONSTANT:
            yield step
            continue
        _check(step)
        for operand in step.operands:
            if not isinstance(operand, str) and operand not in named:
                named[operand] = f"number {operand}"
                yield Step(named[operand], CONSTANT, (str(Fraction(operand)),), HALF)
        operands = tuple(named.get(operand, operand) for operand in step.operands)
        yield Step(step.result, step.kind, operands, step.ulps)


def _check(step: Step) -> None:
    if step.kind not in _OPERATIONS:
        raise UnwritableError(f"the analysis does not know {step.kind}")
    if step.ulps not in (EXACT, HALF):
        raise UnwritableError(
            f"{step.kind} within {step.ulps:g} ulp: the analysis rounds to nearest (--ulps 0.5)"
        )


def _list_values(step: Step) -> tuple[Fraction, Fraction]:
    """Return the double nearest to a constant, and its exact number."""
    number = Fraction(str(step.operands[0]))
    return Fraction(float(IN_DOUBLES[CONSTANT](step.operands[0]))), number


def _write_step(step: Step, names: Mapping[str, str], is_computed: bool) -> str:
    if step.kind == CONSTANT:
        double, number = _list_values(step)
        return _write_whole(double if is_computed else number)
    text = _OPERATIONS[step.kind][1].format(*(names[str(operand)] for operand in step.operands))
    return f"rounded ({text})" if is_computed and step.ulps != EXACT else text


def _write_whole(number: Fraction) -> str:
    """Write a fraction in the analysis's syntax, whole numbers too."""
    return f"{number.numerator} / {number.denominator}"


def _write(number: Fraction) -> str:
    return f"{number.numerator}" if number.denominator == 1 else _write_whole(number)


def _pair(number: Fraction) -> str:
    return f"({number.numerator}, {number.denominator})%Z"


@dataclass(frozen=True)
class ElementaryCase:
    """The steps of a program in a case, with the bound of its roundings, in eps of its value."""

    name: str
    straight: StraightLineProgram
    high: Fraction
    bound: float
    enclosure: FunctionEnclosure | None

    def state(self, bound: Fraction) -> BoundTheorem:
        """State that roundings move the value by at most `bound` eps of its modulus."""
        (name,) = self.straight.inputs
        ranges = {name: (_LEAST, self.high)}
        return BoundTheorem(self.straight, ranges, bound * _EPS, relative=True)


def list_elementary() -> Iterator[ElementaryCase]:
    """Yield the cases of sine, cosine, tangent and small arctangent."""
    rest = sp.Symbol(REST)
    for kind in ANGLES:
        # Two more quarter turns change only signs, if anything.
        for quarters in range(2):
            number = Whole(Fraction(QUARTERS), Fraction(quarters))
            found = resolve(build(kind, DOUBLE).program, Case(number)).straight
            function = getattr(sp, kind)(rest + quarters * sp.pi / 2)
            straight = replace(found, inputs=(REST,))
            yield _bound(f"{kind}_{quarters}", straight, find_end_of_rests(), function)
    small = resolve(build("small_arctan", DOUBLE).program, Case()).straight
    (name,) = small.inputs
    yield _bound("small_arctan", small, find_end_of_small(), sp.atan(sp.Symbol(name)))


def _bound(
    name: str, straight: StraightLineProgram, high: float, function: sp.Expr
) -> ElementaryCase:
    # Near a pole the function has no enclosure.
    at_zero = function.xreplace(dict.fromkeys(function.free_symbols, sp.S.Zero))
    enclosure = FunctionEnclosure(function, _OFF) if at_zero.is_finite else None
    return ElementaryCase(
        name, straight, Fraction(high), bound_roundings(straight, high), enclosure
    )
