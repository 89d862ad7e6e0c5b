"""Bound scripts: from programs with proved bounds to the bounds that Coq proves again.

Coq's analysis has intervals without monomials or grids, so its bounds may be larger: of several
multiples of ours, the smallest that it proves is kept.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import ROUND_CEILING, Context, Decimal
from fractions import Fraction
from functools import partial
from pathlib import Path

from mechproof.coq.checker import BOUND_LIMIT, check_files
from mechproof.coq.folder import write_folder
from mechproof.coq.rounding_scripts import (
    BoundTheorem,
    ElementaryCase,
    list_elementary,
    write_bound_script,
)
from mechproof.coq.script_comparison import compare_bound_script
from mechproof.coq.terms import UnwritableError
from mechproof.pipeline.bounding import Bounding
from mechproof.roundoff.boxed import Convention, put_in_box

# Multiples of a bound that are tried in turn; the first one is the bound itself to four digits.
SHARES = (1.002, 1.02, 1.05, 1.1, 1.2, 1.5, 2.0)
DIGITS = 4


@dataclass(frozen=True)
class CoqBound:
    """The bound that Coq proves and its file, or the reason why there is none.

    For a function that is also enclosed, `off` is the distance of the program without roundings
    from it.
    """

    name: str
    file: str = ""
    bound: Fraction | None = None
    reason: str = ""
    off: Fraction | None = None


# For a multiple of a bound, returns the bound that is then stated, and the script.
Write = Callable[[float], tuple[Fraction, str]]


def prove_in_coq(
    boundings: Sequence[Bounding],
    proved: Sequence[float],
    convention: Convention,
    folder: Path,
    tell: Callable[[str], None] = lambda text: None,
) -> tuple[CoqBound, ...]:
    """Write the scripts that Coq accepts into a folder, and return what they prove, in order.

    Raises `CheckerError` if Coq is not installed, `ForeignFileError` for a folder with other files,
    and `OSError`.
    """
    writers = {
        _name_file(number, bounding.name): partial(_write, bounding, convention, least)
        for number, (bounding, least) in enumerate(zip(boundings, proved, strict=True), start=1)
    }
    return _prove_least([bounding.name for bounding in boundings], writers, folder, tell)


def prove_functions_in_coq(
    folder: Path, tell: Callable[[str], None] = lambda text: None
) -> tuple[CoqBound, ...]:
    """Have Coq prove relative bounds of the elementary functions of compiled kernels.

    Raises as `prove_in_coq` does.
    """
    cases = [*list_elementary()]
    writers = {f"function_{case.name}.v": partial(_write_case, case) for case in cases}
    found = _prove_least([case.name for case in cases], writers, folder, tell)
    return tuple(
        replace(one, off=case.enclosure.off) if one.file and case.enclosure else one
        for one, case in zip(found, cases, strict=True)
    )


def _prove_least(
    names: Sequence[str],
    writers: Mapping[str, Write],
    folder: Path,
    tell: Callable[[str], None],
) -> tuple[CoqBound, ...]:
    """Have Coq try one multiple after another for the files whose bounds are not yet proved."""
    named = dict(zip(writers, names, strict=True))
    found: dict[str, CoqBound] = {}
    accepted: dict[str, str] = {}
    for share in SHARES:
        tried: dict[str, tuple[Fraction, str]] = {}
        for file in writers.keys() - found.keys():
            try:
                tried[file] = writers[file](share)
            except UnwritableError as error:
                found[file] = CoqBound(named[file], reason=str(error))
        write_folder(folder, accepted | {file: text for file, (_, text) in tried.items()})
        for file, wrong in check_files(folder, sorted(tried), tell, limit=BOUND_LIMIT).items():
            bound, text = tried[file]
            if not wrong:
                found[file] = CoqBound(named[file], file, bound)
                accepted[file] = text
    write_folder(folder, accepted)
    lost = f"Coq's analysis proves no bound up to {SHARES[-1]:g} times ours"
    return tuple(found.get(file, CoqBound(name, reason=lost)) for file, name in named.items())


def _write(
    bounding: Bounding, convention: Convention, proved: float, share: float
) -> tuple[Fraction, str]:
    if not math.isfinite(proved):
        raise UnwritableError("there is no bound to begin with")
    program = put_in_box(bounding.straight, bounding.ranges, convention)
    bound = Fraction(round_digits(proved * share, ROUND_CEILING))
    theorem = BoundTheorem(program.straight, program.ranges, bound, convention.relative)
    text = write_bound_script(bounding.name, theorem)
    compare_bound_script(text, theorem)
    return bound, text


def _write_case(case: ElementaryCase, share: float) -> tuple[Fraction, str]:
    theorem = case.state(Fraction(round_digits(case.bound * share, ROUND_CEILING)))
    text = write_bound_script(case.name, theorem, case.enclosure)
    compare_bound_script(text, theorem, case.enclosure)
    return theorem.bound, text


def _name_file(number: int, name: str) -> str:
    return f"bound_{number}_{re.sub(r'[^a-z0-9]+', '_', name.lower())[:40]}.v"


def round_digits(number: float, rounding: str) -> Decimal:
    """Round a bound to `DIGITS` digits; `rounding` is one of the modes of `decimal`."""
    return Context(prec=DIGITS, rounding=rounding).create_decimal(Decimal(number))
