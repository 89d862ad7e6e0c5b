"""Gappa: a boxed program -> a script, and the bound that Gappa proves.

Gappa (Daumas and Melquiond 2010) has no bounds for sines and the like: such programs are left out.
Besides the plain script, one is run with the box cut into parts, and the better bound is taken.
Gappa can also be asked whether it proves a given bound.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from shutil import which

from mechproof.comparison import call, name_all, spell
from mechproof.programs.operations import KINDS
from mechproof.programs.program import Operand
from mechproof.roundoff.boxed import BoxedProgram
from mechproof.roundoff.running import IN_DOUBLES
from mechproof.roundoff.steps import CONSTANT, EXACT, Step

COMMAND = "gappa"
# The number of parts into which the box is cut, over all its sides together.
PARTS = 256
_WRITTEN = frozenset({CONSTANT, *(kind for kind, row in KINDS.items() if row.gappa)})
_FOUND = re.compile(r" in \[(?:0|[^,\]]*), ([0-9]+)(?:b(-?[0-9]+))?[^\]]*\]")


def is_installed() -> bool:
    """Return whether the command is installed."""
    return which(COMMAND) is not None


def can_write(program: BoxedProgram) -> bool:
    """Return whether Gappa has all operations of a program, and its error is an absolute one."""
    kinds = {step.kind for step in program.straight.steps}
    return not program.convention.relative and kinds <= _WRITTEN


def find_bound(program: BoxedProgram) -> float | None:
    """Return the lowest bound that Gappa finds, or None if it finds none."""
    if not can_write(program):
        return None
    found = [b for cuts in (1, PARTS) if (b := _run(write_script(program, None, cuts))) is not None]
    return min(found, default=None)


def proves(program: BoxedProgram, bound: float) -> bool:
    """Return whether Gappa proves a bound with the box cut into parts."""
    return can_write(program) and _call(write_script(program, Fraction(bound), PARTS)) is not None


def write_script(program: BoxedProgram, bound: Fraction | None, parts: int = 1) -> str:
    """Return the script that proves a bound, or looks for one."""
    names = name_all(program)
    output = program.straight.outputs[0]
    assumed = " /\\ ".join(
        f"{names[name]} in [{_write(Fraction(low))}, {_write(Fraction(high))}]"
        for name, (low, high) in zip(program.straight.inputs, program.box, strict=True)
    )
    goal = "?" if bound is None else f"[0, {_write(bound)}]"
    exact = _find(output, _exact_names(program, names))
    lines = [
        "@rnd = float<ieee_64, ne>;",
        *_write_steps(program, names),
        f"{{ {assumed} -> |{_find(output, names)} - {exact}| in {goal} }}",
    ]
    if parts > 1:
        each = max(2, int(parts ** (1 / len(program.box)) + 1e-9))
        lines.append(f"$ {', '.join(f'{names[n]} in {each}' for n in program.straight.inputs)};")
    return "\n".join(lines) + "\n"


def _exact_names(program: BoxedProgram, names: Mapping[str, str]) -> dict[str, str]:
    exact = {step.result: f"M{names[step.result]}" for step in program.straight.steps}
    return {**names, **exact}


def _write_steps(program: BoxedProgram, names: Mapping[str, str]) -> Iterator[str]:
    """Yield each step both with its rounding and without any rounding."""
    exact = _exact_names(program, names)
    if not program.convention.rounded_inputs:
        yield from (f"{names[n]} = rnd(x{names[n]});" for n in program.straight.inputs)
    for step in program.straight.steps:
        name = names[step.result]
        if step.kind == CONSTANT:
            double = Fraction(float(IN_DOUBLES[CONSTANT](step.operands[0])))
            yield f"{name} = {_write(double)};"
            yield f"M{name} = {step.operands[0]};"
            continue
        text = _fill(step, names)
        yield f"{name} = {text if step.ulps == EXACT else f'rnd({text})'};"
        yield f"M{name} = {_fill(step, exact)};"


def _fill(step: Step, names: Mapping[str, str]) -> str:
    return spell(KINDS[step.kind].gappa, (_find(operand, names) for operand in step.operands))


def _find(operand: Operand, names: Mapping[str, str]) -> str:
    return names[operand] if isinstance(operand, str) else _write(Fraction(operand))


def _write(number: Fraction) -> str:
    """Write a double in Gappa's syntax, as a whole number times a power of two."""
    return f"{number.numerator}b-{number.denominator.bit_length() - 1}"


def _run(script: str) -> float | None:
    told = _call(script)
    found = None if told is None else _FOUND.findall(told)
    if not found:
        return None
    digits, power = found[-1]
    return float(Fraction(int(digits)) * Fraction(2) ** int(power or 0))


def _call(script: str) -> str | None:
    """Return Gappa's output, or None if it proves nothing or takes too long."""
    done = call([COMMAND], input=script)
    return done.stdout + done.stderr if done and done.returncode == 0 else None
