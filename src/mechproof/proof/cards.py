"""The card of a finding: the print and its smallest mend with what differs marked, and the rest."""

from __future__ import annotations

import re
from dataclasses import dataclass

from mechproof.latex.changes import Style, mark_changes
from mechproof.latex.sentences import is_sentence, walk_outside
from mechproof.proof.findings import LedgerFinding
from mechproof.proof.verdict import Verdict

# What formulas are marked with on a page; what stays within what is changed is neither.
KEPT = r"{{\color{{gray}}{{{}}}}}".format
TAKEN = Style(r"{{\color{{red}}{{{}}}}}".format, KEPT)
PUT = Style(r"{{\color{{green}}{{{}}}}}".format, KEPT)
EQUALS = re.compile("=")
# Of these nothing printed is called wrong, so that nothing is called right instead.
OPEN = (Verdict.NOT_CHECKABLE, Verdict.UNDERDETERMINED)


@dataclass(frozen=True)
class Card:
    """The formulas of a finding: the print, the smallest mend, and what holds in general.

    Empty are a mend that there is not and a general form that is the mend. `label` is what the mend
    is called.
    """

    printed: str
    mend: str
    mend_by: str
    general: str
    general_by: str
    label: str


def make_card(found: LedgerFinding, taken: Style = TAKEN, put: Style = PUT) -> Card:
    """Mark what the mend takes out of the print, and what it puts in; sentences are not marked."""
    printed, general = found.printed_latex, found.corrected_latex
    mend, by = found.mend_latex, found.mend_by
    if not mend:
        mend, by, general = general, found.corrected_by, ""
    general_by = found.corrected_by if general else ""
    if mend and not (is_sentence(printed) or is_sentence(mend)):
        kept, member = _split_member(printed, mend)
        marked, mend = mark_changes(member, mend, taken, put)
        printed = kept + marked
    label = "Shown" if found.verdict in OPEN else "Right"
    return Card(printed, mend, by, general, general_by, label)


def _split_member(printed: str, mend: str) -> tuple[str, str]:
    """Split a print before its last member if the mend is a member, with no equals sign of its own.

    Only that member is what the mend replaces.
    """
    outside = [
        {m.start() for m in EQUALS.finditer(text)} & set(walk_outside(text))
        for text in (printed, mend)
    ]
    place = max(outside[0]) + 1 if outside[0] and not outside[1] else 0
    return printed[:place], printed[place:]
