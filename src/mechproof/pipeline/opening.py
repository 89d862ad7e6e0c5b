"""Opening: from the place of a derivation to its paper and the tasks to be judged.

The rows of derivatives are only stated when they are judged: stating them takes as long as the
proof.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from pathlib import Path

from mechproof.codegen.form_rows import (
    derivative_rows,
    form_rows,
    list_derivative_numbers,
    number_shipped,
)
from mechproof.derivation import DerivationError, load_paper
from mechproof.ledger.ledger_findings import follower_rows
from mechproof.programs.reverse_mode import select_wanted
from mechproof.record import Paper, Quantity, Row
from mechproof.tools.cache import digest_program


@dataclass(frozen=True)
class Opened:
    """A loaded derivation: its paper, all rows, and the part of the paper that affects verdicts.

    Its tasks are its rows, then the derivatives of each quantity in `derivatives`. `kernels` holds
    the numbers of the rows on which shipped code rests.
    """

    location: Path
    paper: Paper
    rows: tuple[Row, ...]
    derivatives: tuple[Quantity, ...]
    domain: Paper
    kernels: frozenset[str]

    @property
    def tasks(self) -> tuple[str, ...]:
        """Return the names of tasks: row numbers, for a task of several rows the first one."""
        own = (row.number for row in self.rows)
        return (*own, *(list_derivative_numbers(quantity)[0] for quantity in self.derivatives))

    def is_kernel(self, task: int) -> bool:
        """Return whether shipped code rests on a task."""
        return task >= len(self.rows) or self.rows[task].number in self.kernels

    def state(self, task: int) -> tuple[Row, ...]:
        """State the rows of a task."""
        if task < len(self.rows):
            return (self.rows[task],)
        one = self.derivatives[task - len(self.rows)]
        alone = replace(self.paper, rows=(), findings=(), quantities=(one,), one_pass=())
        return derivative_rows(alone)

    def list_sources(self) -> tuple[object, ...]:
        """Return, for each task, everything that its rows are stated from."""
        made = (digest_program(), self.paper.given)
        return (*self.rows, *((*made, quantity) for quantity in self.derivatives))


def open_derivation(location: Path) -> Opened:
    """Load a derivation and state the rows of its forms.

    Raises `DerivationError`, which names the place.
    """
    return open_paper(location, load_paper(location))


def open_paper(location: Path, paper: Paper) -> Opened:
    """State the rows of the forms of a paper that was loaded from a place."""
    try:
        rows = (*paper.rows, *follower_rows(paper), *form_rows(paper))
    except (ValueError, NotImplementedError) as error:
        raise DerivationError(f"{location}: {error}") from error
    variables = tuple(replace(variable, meaning="", sign="") for variable in paper.variables)
    domain = Paper(
        paper.system, "", variables, (), paper.where, published=paper.published, usual=paper.usual
    )
    shipped = number_shipped(paper)
    opened = Opened(location, paper, rows, select_wanted(paper), domain, shipped)
    derived = (n for quantity in opened.derivatives for n in list_derivative_numbers(quantity))
    counted = Counter([*(row.number for row in rows), *derived])
    if twice := [number for number, count in counted.items() if count > 1]:
        raise DerivationError(f"{location}: rows given twice by the paper and its forms: {twice}")
    known = {quantity.name for quantity in paper.quantities}
    if unknown := sorted({name for row in rows for name in row.quantities} - known):
        raise DerivationError(f"{location}: rows name unknown quantities: {unknown}")
    return opened
