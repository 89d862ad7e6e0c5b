"""The ledger: all judgements of a paper, as records, as JSON and as a readable page."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Sequence

from mechproof.proof.verdict import Evidence, Judgement, Verdict
from mechproof.record import Paper

PLAIN = (Verdict.PROVED, Verdict.DEFINITION)
INTRODUCTION = """# Ledger

Every printed equation and every checkable claim of the papers, with the verdict that
`mechproof verify` computes. This page is generated; the same rows are in `ledger.json`.
Rows marked *ours* are not printed in the paper: they are results that other rows or the
kernels rest on, and they are counted apart. "Read as" is what was read from the print and judged;
rows marked *as typed* were typed by hand instead.
"""


def totals(judgements: Sequence[Judgement], ours: bool) -> Counter[Verdict]:
    """Count the verdicts of the printed rows, or of our own."""
    return Counter(j.verdict for j in judgements if ("ours" in j.marks) is ours)


def show_totals(judgements: Sequence[Judgement], ours: bool) -> str:
    """Return the totals as one line, in the order of the verdicts; no sum over verdicts."""
    counted = totals(judgements, ours)
    return ", ".join(f"{counted[v]} {v}" for v in Verdict if counted[v]) or "none"


def to_json(judgements: Sequence[Judgement]) -> str:
    """Return the ledger as a JSON list of rows."""
    rows = [judgement.as_dict() for judgement in judgements]
    return json.dumps(rows, indent=1, ensure_ascii=False) + "\n"


def to_markdown(papers: Sequence[tuple[Paper, Sequence[Judgement]]]) -> str:
    """Return the ledger as a page; formulas are LaTeX between dollar signs."""
    parts = [INTRODUCTION]
    for paper, judgements in papers:
        parts += [_heading(paper, judgements), _table(judgements)]
        parts += [_details(j) for j in judgements if j.verdict not in PLAIN]
    return "\n".join(parts)


def _heading(paper: Paper, judgements: Sequence[Judgement]) -> str:
    return (
        f"\n## {paper.system}\n\n{paper.citation}\n\n"
        f"Printed rows: {show_totals(judgements, ours=False)}.\n\n"
        f"Our own rows: {show_totals(judgements, ours=True)}.\n"
    )


def _table(judgements: Sequence[Judgement]) -> str:
    lines = ["| number | read as | verdict | rung | reason |", "|---|---|---|---|---|"]
    for j in judgements:
        marks = f" *{', '.join(j.marks)}*" if j.marks else ""
        cells = (f"{j.number}{marks}", j.read_as, j.verdict.value, j.rung, j.reason)
        lines.append("| " + " | ".join(_escape(cell) for cell in cells) + " |")
    return "\n".join(lines) + "\n"


def _escape(cell: str) -> str:
    return cell.replace("|", "\\|").replace("<", "&lt;").replace("_", "\\_").replace("^", "\\^")


def _details(j: Judgement) -> str:
    lines = [f"### {j.system} {j.number}: {j.verdict}\n", f"$$ {j.printed_latex} $$\n"]
    lines += [f"Read as: `{j.read_as}`\n"] if j.read_as else []
    lines += [f"{_escape(j.reason)}\n"]
    lines += [f"- {_describe(item)}" for item in j.evidence]
    if j.corrected_latex:
        by = f" (proved: {j.corrected_by})" if j.corrected_by else ""
        lines.append(f"\nCorrected{by}:\n\n$$ {j.corrected_latex} $$")
    return "\n".join(lines) + "\n"


def _describe(item: Evidence) -> str:
    at = ", ".join(f"{name} = {value}" for name, value in item.at.items())
    sides = [f"printed {item.printed}" if item.printed else ""]
    sides += [f"rebuilt {item.rebuilt}" if item.rebuilt else ""]
    values = "; ".join(part for part in (f"at {at}" if at else "", *sides) if part)
    return f"{_escape(item.what)}" + (f": `{values}`" if values else "")
