"""Few of the equations that the five papers print are typed by hand or not parsed."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

from derived import declared_paper_of, paper_of

from mechproof.latex import Reader, ReadingError
from mechproof.proof.judge import AS_TYPED
from mechproof.record import Equation, Paper, Row

PAPERS = (
    *("elliptic_planetary", "oval_planetary", "tooth_thickness"),
    *("track_wheel", "wedge_linkage"),
)
MOST_TYPED = 5
MOST_UNREAD = 3


@lru_cache
def equations(system: str) -> tuple[Paper, tuple[Row, ...], tuple[Row, ...]]:
    """Return a paper, its equations as declared, and its equations, one for each relation sign."""
    read, declared = paper_of(system), declared_paper_of(system)
    return read, *(tuple(r for r in p.rows if isinstance(r, Equation)) for p in (declared, read))


def typed_rows() -> Iterator[tuple[Paper, Row]]:
    for system in PAPERS:
        paper, declared, _ = equations(system)
        for row in declared:
            if row.says is not None or any(link.says is not None for link in row.links.values()):
                yield paper, row


def is_read(paper: Paper, row: Row) -> bool:
    try:
        chains = Reader(paper.variables, paper.notation).parse(row.printed_latex, row.number).chains
    except ReadingError:
        return False
    return all(chain.relations for chain in chains)


def test_few_equations_are_typed() -> None:
    typed = [f"{paper.system} {row.number}" for paper, row in typed_rows()]
    assert len(typed) <= MOST_TYPED, typed


def test_few_equations_are_not_parsed() -> None:
    unread = [f"{p.system} {row.number}" for p, row in typed_rows() if not is_read(p, row)]
    assert len(unread) <= MOST_UNREAD, unread


def test_every_equation_says_how_it_was_read_or_that_it_was_typed() -> None:
    for system in PAPERS:
        _, declared, read = equations(system)
        assert declared
        typed = {row.number for paper, row in typed_rows() if paper.system == system}
        unread = {row.number for row in read if not row.read_as}
        assert {n for n in unread if not n.startswith(tuple(typed))} == set()


def test_the_ledger_says_of_every_equation_how_it_was_read() -> None:
    file = Path(__file__).parents[2] / "generated" / "ledger.json"
    ledger = json.loads(file.read_text(encoding="utf-8"))
    rows = [r for r in ledger["rows"] if r["kind"] == "equation" and "ours" not in r["marks"]]
    typed = [row["number"] for row in rows if not row["read_as"]]
    assert {row["system"] for row in rows} >= set(PAPERS)
    assert all((AS_TYPED in row["marks"]) == (not row["read_as"]) for row in rows)
    assert len(typed) <= MOST_TYPED, typed
