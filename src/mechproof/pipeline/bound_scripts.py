"""Bound scripts: in, programs with proved bounds; out, the bounds that Coq proves once more.

Coq's analysis has intervals without monomials or grids, so that its bounds are larger: of shares of
ours the least that it proves is kept.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from decimal import ROUND_CEILING, Context, Decimal
from fractions import Fraction
from functools import partial
from pathlib import Path

from mechproof.coq.bound_comparison import compare_bound_script
from mechproof.coq.checker import BOUND_LIMIT, check_files
from mechproof.coq.elementary_scripts import ElementaryCase, list_elementary
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
    """The bound that Coq proves and its file, or the reason why there is none.

    Of a function that is enclosed, too, `off` is how far the program without roundings is from it.
    """

    name: str
    file: str = ""
    bound: float | None = None
    reason: str = ""
    off: float | None = None


Write = Callable[[float], tuple[RowScript, Fraction]]


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
    files = map(_name_file, range(len(boundings)), boundings)
    writers = [
        partial(_write, bounding, convention, least, file)
        for bounding, least, file in zip(boundings, proved, files, strict=True)
    ]
    return _prove_least([bounding.name for bounding in boundings], writers, folder, tell)


def prove_functions_in_coq(
    folder: Path, tell: Callable[[str], None] = lambda text: None
) -> tuple[CoqBound, ...]:
    """Do so for the elementary functions of compiled kernels; bounds are shares of their values.

    Raises as `prove_in_coq` does.
    """
    cases = [*list_elementary()]
    writers = [partial(_write_case, case) for case in cases]
    found = _prove_least([case.name for case in cases], writers, folder, tell)
    enclosed = (case.enclosure for case in cases)
    return tuple(
        replace(one, off=float(enclosure.off) if one.file and enclosure else None)
        for one, enclosure in zip(found, enclosed, strict=True)
    )


def _prove_least(
    names: Sequence[str], writers: Sequence[Write], folder: Path, tell: Callable[[str], None]
) -> tuple[CoqBound, ...]:
    """Have Coq prove one share after the other of what is not proved yet."""
    found: dict[int, CoqBound] = {}
    accepted: list[RowScript] = []
    for share in SHARES:
        tried: dict[str, tuple[int, RowScript, Fraction]] = {}
        for number, write in enumerate(writers):
            if number in found:
                continue
            try:
                script, bound = write(share)
                tried[script.file] = number, script, bound
            except UnwritableError as error:
                found[number] = CoqBound(names[number], reason=str(error))
        write_folder(folder, [*accepted, *(script for _, script, _ in tried.values())])
        for file, wrong in check_files(folder, tried, tell, limit=BOUND_LIMIT).items():
            number, script, bound = tried[file]
            if not wrong:
                found[number] = CoqBound(names[number], file, float(bound))
                accepted.append(script)
    write_folder(folder, accepted)
    lost = f"Coq's analysis proves none below {SHARES[-1]:g} times ours"
    return tuple(found.get(n, CoqBound(name, reason=lost)) for n, name in enumerate(names))


def _write(
    bounding: Bounding, convention: Convention, proved: float, file: str, share: float
) -> tuple[RowScript, Fraction]:
    program = put_in_box(bounding.straight, bounding.ranges, convention)
    bound = _round_up(proved * share)
    theorem = BoundTheorem(program.straight, program.ranges, bound, convention.relative)
    text = write_bound_script(bounding.name, theorem)
    compare_bound_script(text, theorem)
    return _as_script(bounding.name, file, text), bound


def _write_case(case: ElementaryCase, share: float) -> tuple[RowScript, Fraction]:
    theorem = case.state(_round_up(case.bound * share))
    text = write_bound_script(case.name, theorem, case.enclosure)
    compare_bound_script(text, theorem, case.enclosure)
    return _as_script(case.name, f"function_{case.name}.v", text), theorem.bound


def _as_script(name: str, file: str, text: str) -> RowScript:
    return RowScript(name, "PROVED", "rounding errors", "bounds", file, text)


def _name_file(number: int, bounding: Bounding) -> str:
    return f"bound_{number + 1}_{re.sub(r'[^a-z0-9]+', '_', bounding.name.lower())[:40]}.v"


def _round_up(number: float) -> Fraction:
    return Fraction(Context(prec=DIGITS, rounding=ROUND_CEILING).create_decimal(Decimal(number)))
