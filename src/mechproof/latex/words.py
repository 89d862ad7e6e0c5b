"""The words of a print that carry meaning: those that begin, join or end conditions."""

from __future__ import annotations

import re

# How words begin; and how words, or names in upright letters, begin.
OPENS_TEXT = r"\\(?:text(?:rm|it|sf|bf|up|normal)?|mbox|hbox|emph)\s*\{"
OPENS_WORDS = rf"(?:{OPENS_TEXT}|\\(?:mathrm|operatorname\*?)\s*\{{)"
AND = r"\text{and}"
_IF = (
    *("if", "for", "at", "where", "since", "when", "whenever", "with", "provided", "provided that"),
    *("for all", "for any", "for each", "for every", "if also", "as long as"),
)
IF = tuple(rf"\text{{{word}}}" for word in _IF)
UNDEFINED = (r"\text{undefined}", r"\text{not defined}")
ELSE = (r"\text{else}", r"\text{otherwise}")
# The longest row of letters in italics that is taken for letters, not for a word.
LONGEST_ROW = 3
# Words that are sometimes printed as letters in italics.
ITALICS = ("if", "for", "where", "when", "with", "and", "or", "else", "forall")
_BLANK = re.compile(r"\\[,;: ]|[~\s]+")


def to_text(words: str) -> str:
    """Return the sign of a text without outer blanks and points; known words in lower case."""
    text = _BLANK.sub(" ", words).strip(" ,;:.")
    small = rf"\text{{{text.lower()}}}"
    return small if small in (AND, *IF, *ELSE, *UNDEFINED) else rf"\text{{{text}}}"
