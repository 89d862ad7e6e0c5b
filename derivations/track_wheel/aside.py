"""The sentences of paper 5 that no row judges, by their numbers, and why."""

from collections.abc import Mapping

PURPOSE = "says what the method is for"
MOTIVE = "says why the subject matters, without a number"
SCHEME = "describes the gear or the set-up"
TEXTS: Mapping[str, tuple[str, ...]] = {
    "title, authors, keywords": ("S1", "S7"),
    MOTIVE: ("S2", "S11", "S12"),
    SCHEME: ("S8", "S9", "S10", "S50"),
    PURPOSE: ("S13", "S24"),
    "tells of the method, which the rows of its formulas judge": ("S4", "S14"),
    "a principle for any part, before a formula is given": ("S15",),
    "leads over to the matrices: blanks may be turned, too": ("S29",),
    "recommends the methods; costs are in none of the formulas": ("S68",),
}
ASIDE = {name: reason for reason, names in TEXTS.items() for name in names}
