"""Bound scripts: in, programs with proved bounds; out, the bounds that Coq proves once more.

Coq's analysis has intervals without monomials or grids, so that its bounds are larger: of shares of
ours the least that it proves is kept.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from decimal import ROUND_CEILING, Context, Decimal
from fractions import Fraction
from pathlib import Path

from mechproof.coq.bound_comparison import compare_bound_script
from mechproof.coq.checker import BOUND_LIMIT, check_files
from mechproof.coq.folder import RowScript, write_folder
from mechproof.coq.rounding_scripts import BoundTheorem, write_bound_script
from mechproof.coq.terms import UnwritableError
from mechproof.pipeline.bounding import Bounding
from mechproof.roundoff.boxed import Convention, put_in_box

# In turn, the first to four digits the bound itself.
SHARES = (1.002, 1.02, 1.05, 1.1, 1.2, 1.5, 2.0)
DIGITS = 4


@dataclass(frozen=True)
class CoqBound:
    """The bound that Coq proves and its file, or the reason why there is none."""

    name: str
    file: str = ""
    bound: float | None = None
    reason: str = ""


def prove_in_coq(
    boundings: Sequence[Bounding],
    proved: Sequence[float],
    convention: Convention,
    folder: Path,
    tell: Callable[[str], None] = lambda text: None,
) -> tuple[CoqBound, ...]:
    """Write the scripts that Coq accepts into a folder, and say what they prove, in their order.

    Raises `CheckerError` where Coq is not installed, `ForeignFileError` for a folder with other
    files, and `OSError`.
    """
    found: dict[int, CoqBound] = {}
    accepted: list[RowScript] = []
    for share in SHARES:
        tried: dict[str, tuple[int, RowScript, Fraction]] = {}
        for number, bounding in enumerate(boundings):
            if number in found:
                continue
            bound = _round_up(proved[number] * share)
            try:
                script = _write(bounding, convention, bound, _name_file(number, bounding))
                tried[script.file] = number, script, bound
            except UnwritableError as error:
                found[number] = CoqBound(bounding.name, reason=str(error))
        write_folder(folder, [*accepted, *(script for _, script, _ in tried.values())])
        for file, wrong in check_files(folder, tried, tell, limit=BOUND_LIMIT).items():
            number, script, bound = tried[file]
            if not wrong:
                found[number] = CoqBound(boundings[number].name, file, float(bound))
                accepted.append(script)
    write_folder(folder, accepted)
    lost = f"Coq's analysis proves none below {SHARES[-1]:g} times ours"
    return tuple(
        found.get(number, CoqBound(bounding.name, reason=lost))
        for number, bounding in enumerate(boundings)
    )


def _write(bounding: Bounding, convention: Convention, bound: Fraction, file: str) -> RowScript:
    program = put_in_box(bounding.straight, bounding.ranges, convention)
    theorem = BoundTheorem(program.straight, program.ranges, bound, convention.relative)
    text = write_bound_script(bounding.name, theorem)
    compare_bound_script(text, theorem)
    return RowScript(bounding.name, "PROVED", "rounding errors", "bounds", file, text)


def _name_file(number: int, bounding: Bounding) -> str:
    return f"bound_{number + 1}_{re.sub(r'[^a-z0-9]+', '_', bounding.name.lower())[:40]}.v"


def _round_up(number: float) -> Fraction:
    return Fraction(Context(prec=DIGITS, rounding=ROUND_CEILING).create_decimal(Decimal(number)))
