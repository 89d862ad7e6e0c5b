"""The card of a finding: the print and its smallest mend, differences marked, and the rest."""

from __future__ import annotations

import re
from dataclasses import dataclass

from mechproof.latex.changes import Style, mark_changes
from mechproof.latex.sentence_changes import mark_sentences
from mechproof.latex.sentences import is_sentence, walk_outside
from mechproof.ledger.ledger_findings import LedgerFinding
from mechproof.proof.verdict import Verdict

# Styles that mark changes in formulas on a page; parts kept inside a change are grey.
KEPT = r"{{\color{{gray}}{{{}}}}}".format
TAKEN = Style(r"{{\color{{red}}{{{}}}}}".format, KEPT)
PUT = Style(r"{{\color{{green}}{{{}}}}}".format, KEPT)
EQUALS = re.compile("=")
# Verdicts that do not call anything printed wrong, so that nothing is called right instead.
OPEN = (Verdict.NOT_CHECKABLE, Verdict.UNDERDETERMINED)


@dataclass(frozen=True)
class Card:
    """The formulas of a finding: the print and its `mends`, each with a word and with its proof.

    The first is the smallest, the second what holds in general; one is empty if there is none, the
    second also if it is the first.
    """

    printed: str
    mends: tuple[tuple[str, str, str], ...]


def make_card(found: LedgerFinding, taken: Style = TAKEN, put: Style = PUT) -> Card:
    """Return the card of a finding, marking what the mend removes from the print and adds to it."""
    printed, general = found.printed_latex, found.corrected_latex
    mend, by = found.mend_latex, _describe_proof(found.mend_by, found.mend_on)
    corrected_by = _describe_proof(found.corrected_by, found.corrected_on)
    if not mend:
        mend, by, general = general, corrected_by, ""
    if mend and (is_sentence(printed) or is_sentence(mend)):
        printed, mend = mark_sentences(printed, mend, taken, put)
    elif mend:
        kept, member = _split_member(printed, mend)
        marked, mend = mark_changes(member, mend, taken, put)
        printed = kept + marked
    label = "Shown" if found.verdict in OPEN else "Right"
    return Card(printed, ((label, mend, by), ("In general", general, corrected_by)))


def _describe_proof(by: str, on: str) -> str:
    """Return how a formula is proved, and where it holds if not everywhere."""
    return f"{by}; where {on}" if by and on else by


def _split_member(printed: str, mend: str) -> tuple[str, str]:
    """Split a print in front of its last member if the mend is a member, without an equals sign.

    The mend then replaces only that member.
    """
    outside = [
        {m.start() for m in EQUALS.finditer(text)} & set(walk_outside(text))
        for text in (printed, mend)
    ]
    place = max(outside[0]) + 1 if outside[0] and not outside[1] else 0
    return printed[:place], printed[place:]
