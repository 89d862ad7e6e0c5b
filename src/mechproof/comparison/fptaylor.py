"""FPTaylor: a boxed program -> a task for FPTaylor, and its bound on the absolute error.

FPTaylor (Solovyev et al. 2018) is run with the improved rounding model and with the whole
optimisation problem, which its authors call configuration b. Functions have the same errors in ulps
as here.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from math import isfinite
from pathlib import Path
from shutil import which
from tempfile import TemporaryDirectory

from mechproof.comparison import call, name_all, spell
from mechproof.programs.operations import KINDS
from mechproof.programs.program import Operand
from mechproof.roundoff.boxed import BoxedProgram
from mechproof.roundoff.steps import CONSTANT, EXACT, HALF, Step

COMMAND = "fptaylor"
OPTIONS = {
    **{"opt": "bb", "opt-approx": "false", "opt-exact": "true", "find-bounds": "false"},
    **{"fp-power2-model": "true", "const-approx-real-vars": "false", "rel-error": "false"},
}
_WRITTEN = frozenset({CONSTANT, *(kind for kind, row in KINDS.items() if row.fptaylor)})
_FOUND = re.compile(r"Absolute error \(exact\): (\S+)")
_PI = Fraction("3.14159265358979323846264338327950288419716939937511")
_NUMBERS = {"#pi": f"{_PI.numerator} / {_PI.denominator}"}


def is_installed() -> bool:
    """Return whether the command is installed."""
    return which(COMMAND) is not None


def find_bound(program: BoxedProgram) -> float | None:
    """Return the bound that FPTaylor finds, or None if it finds none in time."""
    kinds = {step.kind for step in program.straight.steps}
    if program.convention.relative or not kinds <= _WRITTEN:
        return None
    with TemporaryDirectory() as folder:
        (Path(folder) / "task.txt").write_text(write_task(program), encoding="utf-8")
        said = "".join(f"{key} = {value}\n" for key, value in OPTIONS.items())
        (Path(folder) / "options.cfg").write_text(said, encoding="utf-8")
        done = call([COMMAND, "-c", "options.cfg", "task.txt"], cwd=folder)
    found = _FOUND.findall(done.stdout) if done else []
    bound = float(found[-1]) if found else float("nan")
    return bound if isfinite(bound) else None


def write_task(program: BoxedProgram) -> str:
    """Return the task of a program, each step with its own rounding."""
    names = name_all(program)
    kind = "real" if program.convention.rounded_inputs else "float64"
    inputs = zip(program.straight.inputs, program.box, strict=True)
    lines = [
        "Variables",
        *(f"  {kind} {names[n]} in [{_write(low)}, {_write(high)}];" for n, (low, high) in inputs),
        "Definitions",
        *(f"  {names[s.result]} = {_round(s, _fill(s, names))};" for s in program.straight.steps),
        "Expressions",
        f"  result = {names[str(program.straight.outputs[0])]};",
    ]
    return "\n".join(lines) + "\n"


def _fill(step: Step, names: Mapping[str, str]) -> str:
    if step.kind == CONSTANT:
        return _NUMBERS.get(str(step.operands[0]), str(step.operands[0]))
    return spell(KINDS[step.kind].fptaylor, (_find(o, names) for o in step.operands))


def _round(step: Step, text: str) -> str:
    if step.ulps == EXACT:
        return text
    # FPTaylor expects the error as a multiple of half an ulp.
    return f"rnd[64, ne, {step.ulps / HALF:g}]({text})"


def _find(operand: Operand, names: Mapping[str, str]) -> str:
    return names[operand] if isinstance(operand, str) else f"({_write(operand)})"


def _write(number: float | Fraction) -> str:
    exact = Fraction(number)
    sign = "0 - " if exact < 0 else ""
    return f"{sign}{abs(exact.numerator)} / {exact.denominator}"
