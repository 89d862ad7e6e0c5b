"""Comparing: from programs and the bounds cited for them to a page of bounds side by side.

Gappa and FPTaylor are run if they are installed, with the same steps and conventions. Functions are
assumed to be rounded to nearest, as FPTaylor assumes; as those of NumPy are not, no worst input is
sought for programs with functions.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import ROUND_CEILING, ROUND_FLOOR
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from mechproof.arithmetic.cover import bound_largest
from mechproof.comparison import fptaylor, gappa
from mechproof.coq import checker
from mechproof.pipeline.bound_scripts import DIGITS, prove_in_coq, round_digits
from mechproof.pipeline.bounding import PARTS, TOLERANCE, Bounding
from mechproof.roundoff.boxed import Convention, find_worst_input, put_in_box
from mechproof.roundoff.steps import FUNCTIONS, HALF
from mechproof.tools.processes import WorkerError, run_tasks

# Time limit, in seconds, for all programs with one convention.
LIMIT = 3600.0
CITED = "cited.json"
NEAR, BELOW, NEAR_CITED = 1.02, 0.99, 1.1
HEADS = {
    "doubles": "Inputs are doubles",
    "rounded": "Inputs are real numbers, which are rounded first",
}
_COLUMNS = (
    *("program", "proved", "Coq", "found", "Gappa", "FPTaylor"),
    *("ours/best run", "cited", "ours/cited"),
)
_TITLE = """# Bounds of rounding errors

`mechproof bound docs/fpbench/benchmarks.fpcore --table docs/bounds.md` writes this page: absolute
errors, in doubles, of programs of [FPBench](fpbench/benchmarks.fpcore). Functions are taken as
rounded to nearest, as FPTaylor takes them.

- *proved*: our bound.
- *Coq*: the lowest of some multiples of our bound that Coq proves, as with `--coq FOLDER`.
- *found*: the error at the worst input that a search of fixed budget found.
- *Gappa*, *FPTaylor*: their bounds on the same steps with the same conventions. Gappa is run
  plainly and with the box cut into some 256 parts; the better bound counts.
- *cited*: the lowest bound that others publish.

Bounds are rounded up, and found errors down. A dash means: none, not run, or not published.
"""


@dataclass(frozen=True)
class Compared:
    """A program's bounds: ours, the worst error found, those of others and the best cited."""

    name: str
    proved: float
    found: float | None
    gappa: float | None
    fptaylor: float | None
    cited: tuple[float, str] | None
    coq: float | None = None

    @property
    def others(self) -> list[float]:
        """Return the bounds of the other programs that were run."""
        return [bound for bound in (self.gappa, self.fptaylor) if bound is not None]


def compare(
    boundings: Sequence[Bounding], cited: Path, report: Callable[[str], None] = lambda text: None
) -> str:
    """Return the page; raises ValueError for a program that is not bounded or takes too long."""
    known = json.loads(cited.read_text("utf-8")) if cited.is_file() else {}
    parts = [_TITLE]
    for inputs, head in HEADS.items():
        report(head)
        tasks = [(bounding, inputs, known.get(inputs, {})) for bounding in boundings]
        found: dict[int, Compared] = {}
        for number, row in run_tasks(_compare, tasks, limit=LIMIT):
            if isinstance(row, WorkerError):
                raise ValueError(f"{boundings[number].name}: {row}")
            found[number] = row
        rows = _put_coq(boundings, [found[n] for n in range(len(tasks))], _choose(inputs), report)
        parts.append("\n".join(_write_table(head, rows)))
    sources = [f"- {name}: {text}." for name, text in known.get("sources", {}).items() if text]
    parts.append("\n".join(("## Sources of what is cited", "", *sources)))
    return "\n".join(parts) + "\n"


def _choose(inputs: str) -> Convention:
    return Convention(rounded_inputs=inputs == "rounded", ulps=HALF)


def _put_coq(
    boundings: Sequence[Bounding],
    rows: list[Compared],
    convention: Convention,
    report: Callable[[str], None],
) -> list[Compared]:
    """Return the rows with the bounds that Coq proves, if it is installed."""
    if not checker.is_installed():
        return rows
    with TemporaryDirectory() as folder:
        proved = [row.proved for row in rows]
        found = prove_in_coq(boundings, proved, convention, Path(folder), report)
    return [
        replace(row, coq=None if one.bound is None else float(one.bound))
        for row, one in zip(rows, found, strict=True)
    ]


def _compare(task: tuple[Bounding, str, Mapping[str, Any]]) -> Compared:
    bounding, inputs, cited = task
    program = put_in_box(bounding.straight, bounding.ranges, _choose(inputs))
    largest = bound_largest(program.bound, program.box, TOLERANCE, PARTS)
    has_functions = any(step.kind in FUNCTIONS for step in program.straight.steps)
    boxes = (program.box, *largest.highest)
    worst = None if has_functions else find_worst_input(program, boxes)
    if worst and worst.error > largest.bound:
        raise ArithmeticError(f"{worst.error} at {worst.at}, where {largest.bound} is proved")
    published = ((bound, name) for name, bound in cited.get(bounding.name, {}).items())
    return Compared(
        bounding.name,
        largest.bound,
        worst.error if worst else None,
        gappa.find_bound(program) if gappa.is_installed() else None,
        fptaylor.find_bound(program) if fptaylor.is_installed() else None,
        min(published, default=None),
    )


def _write_table(head: str, rows: Sequence[Compared]) -> Iterator[str]:
    yield f"## {head}"
    yield ""
    yield f"| {' | '.join(_COLUMNS)} |"
    yield f"|{'---|' * len(_COLUMNS)}"
    for row in rows:
        others, cited = row.others, row.cited
        run = _write_ratio(row.proved / min(others)) if others else "-"
        told = f"{cited[0]:.3g} ({cited[1]})" if cited else "-"
        share = _write_ratio(row.proved / cited[0]) if cited else "-"
        proved = float(round_digits(row.proved, ROUND_CEILING))
        found = None if row.found is None else float(round_digits(row.found, ROUND_FLOOR))
        bounds = map(_write, (proved, row.coq, found, row.gappa, row.fptaylor))
        yield f"| {' | '.join((row.name, *bounds, run, told, share))} |"
    yield ""
    yield _count(rows)
    yield ""


def _count(rows: Sequence[Compared]) -> str:
    run = [row.proved / min(row.others) for row in rows if row.others]
    cited = [row.proved / row.cited[0] for row in rows if row.cited]
    checked = [row.coq / row.proved for row in rows if row.coq]
    also = [row.gappa / row.proved for row in rows if row.gappa]
    return (
        f"Others were run on {len(run)}: {sum(r <= NEAR for r in run)} bounds are within {NEAR} of "
        f"the best of theirs, {sum(r <= BELOW for r in run)} at least 1 % below all. Of "
        f"{len(cited)} with a cited bound {sum(r <= NEAR_CITED for r in cited)} are within "
        f"{NEAR_CITED} of the best. Gappa proves {sum(r <= NEAR for r in also)} within {NEAR} of "
        f"ours, Coq {sum(r <= NEAR for r in checked)} of the {len(checked)} that it proves."
    )


def _write(bound: float | None) -> str:
    return "-" if bound is None else f"{bound:.{DIGITS}g}"


def _write_ratio(ratio: float) -> str:
    return f"{ratio:.3f}" if ratio >= 0.001 else "< 0.001"
