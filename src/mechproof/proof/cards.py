"""The card of a finding: the print and its smallest mend with what differs marked, and the rest."""

from __future__ import annotations

from dataclasses import dataclass

from mechproof.latex.changes import Style, mark_changes
from mechproof.latex.sentences import is_sentence
from mechproof.proof.findings import LedgerFinding

# What formulas are marked with on a page; what stays within what is changed is neither.
KEPT = r"{{\color{{gray}}{{{}}}}}".format
TAKEN = Style(r"{{\color{{red}}{{{}}}}}".format, KEPT)
PUT = Style(r"{{\color{{green}}{{{}}}}}".format, KEPT)


@dataclass(frozen=True)
class Card:
    """The formulas of a finding: the print, the smallest mend, and what holds in general.

    Empty are a mend that there is not and a general form that is the mend.
    """

    printed: str
    mend: str
    mend_by: str
    general: str
    general_by: str


def make_card(found: LedgerFinding, taken: Style = TAKEN, put: Style = PUT) -> Card:
    """Mark what the mend takes out of the print, and what it puts in; sentences are not marked."""
    printed, general = found.printed_latex, found.corrected_latex
    mend, by = found.mend_latex, found.mend_by
    if not mend:
        mend, by, general = general, found.corrected_by, ""
    general_by = found.corrected_by if general else ""
    if mend and not (is_sentence(printed) or is_sentence(mend)):
        printed, mend = mark_changes(printed, mend, taken, put)
    return Card(printed, mend, by, general, general_by)
