"""The ledger: all judgements of a paper, as records, as JSON and as a readable page."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from html import escape
from types import MappingProxyType

from mechproof.ledger.cards import make_card
from mechproof.ledger.ledger_findings import LedgerFinding
from mechproof.proof.equation_ladder import IDENTICAL
from mechproof.proof.rungs import RUNGS, name_rungs
from mechproof.proof.verdict import Evidence, Judgement, Left, Verdict
from mechproof.record import MARKS, Paper
from mechproof.record.papers import WEIGHTS
from mechproof.tools.notebook import Displayed

# The `$id` of ledger.schema.json in this folder.
SCHEMA = "urn:mechproof:ledger:1"
PLAIN = (Verdict.PROVED, Verdict.DEFINITION)
# Rows are counted by class; the counts are never added up.
CLASSES = {"equation": "printed equations", "claim": "printed claims", "datum": "printed data"}
OURS = "our own rows"
KERNELS = "our rows on kernels"
REBUILT = "rebuilt"
COUNTED = (*CLASSES.values(), OURS, KERNELS)
SECTIONS = (
    "the paper, row by row",
    "consequences",
    "what its kernels rest on, and what their source computes",
)
# Characters with a meaning in Markdown, and how they are escaped.
MARKDOWN = str.maketrans({"<": "&lt;", **{sign: f"\\{sign}" for sign in "|_^$"}})
AT_HAND = """“The text at hand”, or “the transcription”, is the part of a paper that was read,
without its figures and its list of references, and without what a scan has lost. What is missing
from it may still be in the paper."""
INTRODUCTION = f"""# Ledger

The findings come first: what is wrong, ambiguous or missing in print, each cause once and the
gravest first. In a correction, red is what it removes from the print and green what it adds. Then
follows every printed equation and every checkable claim of the papers, with the verdict that
`mechproof verify` computes. This page is generated; the same findings and rows are in
`ledger.json`, under the `id` that is also a row's anchor here, after `LEDGER.md#`. "Read as" is
what was read from the print and judged; rows marked *as typed* were typed by hand. A rung is the
method by which a row was decided; the last section explains each. The last column says which script
of `mechproof certify` proves the row again in Coq, or why there is none ([COQ.md](COQ.md)). The
proved formulas, and what they were compared with, are folded away below each table.

{AT_HAND}

Marks say what a row rests on. Rows marked *ours* are counted separately, and so are those of them
on kernels, which state what their formulas rest on and what their source computes:

"""


@dataclass(frozen=True)
class Origin:
    """The source of a paper's rows: its DOI, and the version of a transcription.

    `sentences` is the number of sentences in the transcription; `aside` says why no row judges
    some.
    """

    doi: str = ""
    transcription: str = ""
    sentences: int = 0
    aside: Mapping[str, str] = field(default_factory=dict)

    @classmethod
    def of(cls, paper: Paper) -> Origin:
        """Return the origin of a paper's rows."""
        return cls(paper.doi, paper.transcription, paper.sentences, dict(paper.aside))


@dataclass(frozen=True)
class Ledger:
    """The judgements of the rows of a paper and the findings among them.

    `shipped` are the numbers of the rows on which kernels rest; `failures` name the rows that could
    not be judged: if there are any, no findings are looked for. `left` are the rows of a paper's
    own source that were not read or not judged.
    """

    system: str
    citation: str
    judgements: tuple[Judgement, ...]
    findings: tuple[LedgerFinding, ...] = ()
    shipped: frozenset[str] = frozenset()
    failures: tuple[str, ...] = ()
    left: tuple[Left, ...] = ()
    origin: Origin = Origin()

    @property
    def outcomes(self) -> set[str]:
        """Return the verdicts that occur, and the states of rows without one."""
        return {row.verdict.value for row in self.judgements} | {x.state.value for x in self.left}


@dataclass(frozen=True, kw_only=True)
class JudgedPaper(Ledger, Displayed):
    """A ledger with its paper."""

    paper: Paper


def classify(judgement: Judgement) -> str:
    """Return the class as which a row is counted."""
    if "ours" not in judgement.marks:
        return CLASSES[judgement.kind]
    return KERNELS if judgement.quantities else OURS


def sort_by_class(judgements: Sequence[Judgement]) -> dict[str, list[Judgement]]:
    """Return the rows of each class that occurs, as they are counted."""
    found = {name: [j for j in judgements if classify(j) == name] for name in COUNTED}
    return {name: rows for name, rows in found.items() if rows}


def show_totals(judgements: Sequence[Judgement]) -> dict[str, str]:
    """Return a line for each class of rows with its verdicts in order, without a total."""
    return {name: _count(rows) for name, rows in sort_by_class(judgements).items()}


def _count(judgements: Sequence[Judgement]) -> str:
    counted = Counter(j.verdict for j in judgements)
    proved = [j for j in judgements if j.verdict is Verdict.PROVED]
    # Proved rows that are compared with their own source, or were restored, are counted apart.
    kinds = {
        "identical": sum(j.rung == IDENTICAL for j in proved),
        REBUILT: sum(REBUILT in j.marks for j in proved),
    }
    parts = ", ".join(f"{number} {kind}" for kind, number in kinds.items() if number)
    apart = {Verdict.PROVED: f" (of them {parts})"} if parts else {}
    return ", ".join(f"{counted[v]} {v}{apart.get(v, '')}" for v in Verdict if counted[v])


def to_json(ledgers: Sequence[Ledger]) -> str:
    """Return papers, findings and rows of ledgers as JSON, one record to a line.

    The fields are described in `ledger.schema.json` in this folder.
    """
    tables: dict[str, list[dict[str, object]]] = {
        "papers": [
            {"system": ledger.system, "citation": ledger.citation, **asdict(ledger.origin)}
            for ledger in ledgers
        ],
        "findings": [found.as_dict() for found in sort_findings(ledgers)],
        "rows": [judgement.as_dict() for ledger in ledgers for judgement in ledger.judgements],
    }
    if left := [row.as_dict() for ledger in ledgers for row in ledger.left]:
        tables["left"] = left
    written = [f'"$schema": "{SCHEMA}"']
    written += [f'"{name}": [{_lines(table)}]' for name, table in tables.items()]
    return "{\n" + ",\n".join(written) + "\n}\n"


def sort_findings(ledgers: Sequence[Ledger]) -> list[LedgerFinding]:
    """Return the findings of all papers, the gravest first, otherwise in the papers' order."""
    found = [finding for ledger in ledgers for finding in ledger.findings]
    return sorted(found, key=lambda finding: finding.weight)


def _lines(records: Sequence[dict[str, object]]) -> str:
    written = (json.dumps(r, ensure_ascii=False, separators=(",", ":")) for r in records)
    return ",".join(f"\n{line}" for line in written)


def to_markdown(ledgers: Sequence[Ledger], checks: Mapping[str, str] = MappingProxyType({})) -> str:
    """Return the ledger as a page; formulas are LaTeX between dollar signs.

    `checks` tell by the ids of rows whether Coq has checked them.
    """
    marks = "\n".join(f"- *{mark}*: {meaning}" for mark, meaning in MARKS.items())
    parts = [f"{INTRODUCTION}{marks}\n", "\n## Findings\n"]
    parts += [_finding(found) for found in sort_findings(ledgers)]
    for ledger in ledgers:
        parts.append(_heading(ledger))
        for title, rows in _sort_rows(ledger.judgements).items():
            parts += [f"### {ledger.system}: {title}\n", _table(rows, checks), _list_compared(rows)]
        parts += [_details(j) for j in ledger.judgements if j.verdict not in PLAIN]
    parts.append(_explain_rungs([j for ledger in ledgers for j in ledger.judgements]))
    return "\n".join(parts)


def _finding(found: LedgerFinding) -> str:
    card, number = make_card(found), f"[{_escape(found.number)}](#{found.id})"
    heading = f"### {found.system} {number}: {found.verdict}{_show_marks(found.marks)}"
    paragraphs = [heading, f"*{WEIGHTS[found.weight]}*", _formula(card.printed)]
    for label, latex, by in card.mends:
        paragraphs += [f"{label} (proved: {_escape(by)}):", _formula(latex)] if latex else []
    paragraphs += [_escape(found.wrong)]
    paragraphs += ["\n".join(f"- {_escape(str(cost))}" for cost in found.costs)]
    paragraphs += [f"Check: {_escape(found.check)}" if found.check else ""]
    paragraphs += [f"Figure: {found.figure}" if found.figure else ""]
    if found.follows:
        paragraphs.append(f"Follows from it: {_escape('; '.join(found.follows))}.")
    return "\n\n".join(filter(None, paragraphs)) + "\n"


def _show_marks(marks: Sequence[str]) -> str:
    return f" *{', '.join(marks)}*" if marks else ""


def _heading(ledger: Ledger) -> str:
    totals = (f"- {name}: {line}" for name, line in show_totals(ledger.judgements).items())
    lines = [f"\n## {ledger.system}", _escape(ledger.citation), "\n".join(totals)]
    return "\n\n".join(lines) + "\n"


def _sort_rows(judgements: Sequence[Judgement]) -> dict[str, list[Judgement]]:
    """Sort the rows of a paper into its sections, leaving empty ones out."""
    sorted_rows: dict[str, list[Judgement]] = {title: [] for title in SECTIONS}
    for row in judgements:
        place = 2 if classify(row) == KERNELS else 1 if "consequence" in row.marks else 0
        sorted_rows[SECTIONS[place]].append(row)
    return {title: rows for title, rows in sorted_rows.items() if rows}


def _table(judgements: Sequence[Judgement], checks: Mapping[str, str]) -> str:
    lines = ["| number | read as | verdict | reason | rung | Coq |", "|---|---|---|---|---|---|"]
    for j in judgements:
        number, checked = f"{j.number}{_show_marks(j.marks)}", checks.get(j.id, "")
        cells = (number, j.read_as, j.verdict.value, j.reason, j.rung, checked)
        written = " | ".join(_escape(cell) for cell in cells)
        lines.append(f'| <a id="{escape(j.id)}"></a>{written} |')
    return "\n".join(lines) + "\n"


def _list_compared(judgements: Sequence[Judgement]) -> str:
    """Write the formulas of the proved rows in a folded section."""
    proved = [j for j in judgements if j.verdict is Verdict.PROVED and j.compared_with]
    lines = [f"<details><summary>{len(proved)} proved rows: what was compared</summary>\n"]
    for j in proved:
        lines.append(f"**{_escape(j.number)}**\n\n{_formula(j.printed_latex)}\n")
        lines.append(f"compared with\n\n{_formula(j.compared_with)}\n")
    return "\n".join([*lines, "</details>\n"]) if proved else ""


def _explain_rungs(judgements: Sequence[Judgement]) -> str:
    """Explain every rung that occurs, once."""
    met = name_rungs(j.rung for j in judgements)
    lines = ["\n## Rungs\n", "| rung | what it shows |", "|---|---|"]
    return "\n".join([*lines, *(f"| {name} | {_escape(RUNGS[name])} |" for name in met), ""])


def _formula(latex: str) -> str:
    """Write a formula on a line of its own, without letting it end the formula or open a tag."""
    line = re.sub(r"(?<!\\)\$", r"\\$", " ".join(latex.split()))
    return f"$$ {re.sub('<(?=[A-Za-z/!?])', '< ', line)} $$"


def _escape(cell: str) -> str:
    return " ".join(cell.splitlines()).translate(MARKDOWN)


def _details(j: Judgement) -> str:
    lines = [f"### {j.system} {_escape(j.number)}: {j.verdict}\n", f"{_formula(j.printed_latex)}\n"]
    lines += [f"Read as: `{j.read_as}`\n"] if j.read_as else []
    lines += [f"{_escape(j.reason)} ({j.rung})\n"]
    lines += [f"Compared with:\n\n{_formula(j.compared_with)}\n"] if j.compared_with else []
    lines += [f"- {_describe(item)}" for item in j.evidence]
    if j.corrected_latex:
        by = f" (proved: {j.corrected_by})" if j.corrected_by else ""
        lines.append(f"\nCorrected{by}:\n\n{_formula(j.corrected_latex)}")
    return "\n".join(lines) + "\n"


def _describe(item: Evidence) -> str:
    values = "; ".join(item.list_values(("printed", "rebuilt")))
    return f"{_escape(item.what)}" + (f": `{values}`" if values else "")
