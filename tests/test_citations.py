"""The citable parts of a ledger: the ids of printed rows, and the sentences that they judge.

`tests/kept_ids.txt` lists the ids of the printed rows of the papers that are read through. An id
leaves it only with the row itself: renaming a row would break other people's citations.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest
from derived import judge_all, paper_of

from mechproof.proof.verdict import Judgement
from mechproof.record import Paper

# The papers in whose transcription every sentence is judged or laid aside.
READ_THROUGH = (
    "elliptic_planetary",
    "oval_planetary",
    "tooth_thickness",
    "track_wheel",
    "wedge_linkage",
)
# Claims numbered by the block of a flow chart that they judge: it has no sentences to cite.
BLOCKS = ("controlled parameters", "step 10")
KEPT = Path(__file__).with_name("kept_ids.txt")

for_each_paper = pytest.mark.parametrize(
    "system",
    [pytest.param(s, marks=pytest.mark.xdist_group(f"verdicts {s}")) for s in READ_THROUGH],
)


def list_left_out(paper: Paper) -> list[str]:
    """List the sentences of a paper that no row cites and no reason lays aside."""
    met = {name for row in paper.rows for name in row.cites} | paper.aside.keys()
    names = (f"S{number}" for number in range(1, paper.sentences + 1))
    return [name for name in names if name not in met]


def list_printed(system: str) -> list[Judgement]:
    """List the judgements of the rows that a paper prints, which excludes our own."""
    return [j for j in judge_all(system).values() if "ours" not in j.marks]


def list_kept(system: str) -> list[str]:
    """List the ids of a paper that `KEPT` holds."""
    lines = KEPT.read_text(encoding="utf-8").splitlines()
    return [line for line in lines if line.startswith(f"{system}/")]


@for_each_paper
def test_every_sentence_is_judged_or_laid_aside_with_a_reason(system: str) -> None:
    paper = paper_of(system)
    assert paper.sentences
    assert list_left_out(paper) == []
    assert [name for name, reason in paper.aside.items() if not reason.strip()] == []


@for_each_paper
def test_every_printed_row_but_equations_cites_its_sentence(system: str) -> None:
    rows = [j for j in list_printed(system) if j.kind != "equation" and j.number not in BLOCKS]
    assert [j.number for j in rows if not j.cites] == []


@for_each_paper
def test_printed_rows_keep_their_ids(system: str) -> None:
    assert sorted(j.id for j in list_printed(system)) == sorted(list_kept(system))


@for_each_paper
def test_no_two_rows_of_a_paper_have_one_id(system: str) -> None:
    met = Counter(j.id for j in judge_all(system).values())
    assert [name for name, count in met.items() if count > 1] == []


def test_a_sentence_without_a_row_is_found() -> None:
    paper = paper_of(READ_THROUGH[0])
    name, *_ = paper.aside
    aside = {other: reason for other, reason in paper.aside.items() if other != name}
    assert list_left_out(replace(paper, aside=aside)) == [name]
    (row, *_) = (row for row in paper.rows if row.cites)
    rows = tuple(replace(r, cites=()) if r.cites == row.cites else r for r in paper.rows)
    assert list_left_out(replace(paper, rows=rows)) == list(row.cites)
