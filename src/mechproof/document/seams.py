"""Places where the pieces of laws meet that are printed one by one, as rows to be judged."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from mechproof.document.known import Known
from mechproof.document.printed_laws import find_seams
from mechproof.document.tasks import Role, Sign, Task
from mechproof.record import Equality, Equation, Paper
from mechproof.sources.displays import Printed
from mechproof.sources.located_text import Files


def make_seams(
    printed: Sequence[Printed], known: Known, papers: Mapping[bool, Paper], files: Files
) -> Iterator[Task]:
    """Make tasks of the places where the pieces of laws meet.

    A letter whose derivative is printed does not jump, nor does one at a place of two pieces.
    `papers` are the paper with the units of its letters, and without.
    """
    for letter, pieces in known.laws.items():
        by, steps = pieces[0].by, known.symbols.find_steps(letter)[1]
        order = steps.index(letter)
        is_smooth = not order and known.met[steps[1]] > 0
        for seam in find_seams(pieces):
            before, behind = (one.xreplace({by: seam.place}) for one in seam.values)
            names = (seam.before.name, seam.behind.name)
            shown = [one for one in printed if one.name in names]
            row = Equation(
                f"{known.name_law(letter)}, {letter} at {by} = {seam.place}",
                r"\quad ".join(one.latex.string for one in shown),
                says=Equality(before, behind, "member"),
                read_as=f"{before} = {behind}",
            )
            sides = known.settle(before), known.settle(behind)
            letters = sides[0].free_symbols | sides[1].free_symbols
            paper = papers[not letters & known.symbols.bare]
            asserts = is_smooth or (seam.is_shared and not order)
            sign, place = Sign(Role.SEAM), shown[-1].locate(files)
            yield Task(row, place, sign, paper, asserts, residual=sides[0] - sides[1])
