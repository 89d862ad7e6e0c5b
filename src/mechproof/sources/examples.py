"""Worked examples: which words begin one, and where it ends.

What an example says holds only there. One with a heading lasts until the next heading of its level,
one begun by words until the next heading; a statement about all cases ends both. Words are matched,
not understood.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

_TITLE = r"\w*example|\w*beispiel|exemple|пример"
_EXAMPLE = re.compile(rf"\b(?:{_TITLE})(?P<several>s|e|ы)?\b", re.IGNORECASE)
_LEVELS = ("chapter", "section", "subsection", "subsubsection", "paragraph", "subparagraph")
_WORDS = len(_LEVELS)
_START = (
    r"(?:\A\s*|(?<=[.;:!?}])\s+|\n[ \t]*\n\s*)(?:\\noindent\s*)?"
    r"(?:(?:consider|take|let us take|so|thus|hence|here|now),?\s+)?"
)
_UNIT = r"[kMmcµ]?(?:m|g|N|Nm|Pa|W|J|s|Hz|rad|rpm)"
_EVENT = re.compile(
    rf"\\(?P<level>{'|'.join(_LEVELS)})\*?\s*\{{(?P<title>(?:[^{{}}]|\{{[^{{}}]*\}})*)\}}"
    r"|^(?P<marks>#{1,6})\s+(?P<line>[^\n]*)"
    r"|\\(?P<edge>begin|end)\s*\{example\*?\}"
    rf"|{_START}(?P<begun>(?:for example|for instance|as an example|zum beispiel|par exemple"
    r"|например)\b"
    # Sizes with their units: "For $r=66$ mm".
    r"|(?:for|with|f\xfcr|pour|для)\s+\$[^$=]*=\s*[\d.,{}]+"
    rf"(?:\s*(?:\\,|~|\\(?:mathrm|text|unit)\b|\^)|\$[~\s]*{_UNIT}\b)"
    rf"|(?:\\(?:textbf|textit|emph|textsc)\s*\{{|\*\*?)?(?:{_TITLE})(?:\s+[\w.]+)?[.:]?[}}*]*[.:])"
    r"|\b(?P<again>(?:in|of|for) (?:the|this|our|that)(?: \w+)? example|im (?:\w+)?beispiel"
    r"|dans (?:l'|cet )exemple|в (?:этом )?примере)\b"
    r"|\b(?P<general>in general|generally|in (?:every|all|any) cases?|for (?:any|arbitrary|all)"
    r"|(?:re)?turn(?:ing)? (?:back )?to|back to|im allgemeinen|en g\xe9n\xe9ral|в общем)\b",
    re.IGNORECASE | re.MULTILINE,
)
_GAP = re.compile(r"\s*?\n[ \t]*\n\s*\S", re.DOTALL)


@dataclass(frozen=True)
class Example:
    """The worked example that contains a display, counted from 1; 0 means none.

    `last` is the number of the last example, `start` its beginning in the files, `level` the level
    of the heading that begins it; if it `has_several`, each lower heading begins another. `is_sure`
    is false if words begin it and a new paragraph turns to something else.
    """

    number: int = 0
    last: int = 0
    start: int = 0
    level: int = 0
    has_several: bool = False
    is_sure: bool = True

    def go_on(self, words: str, offsets: Sequence[int], *, is_new: bool) -> Example:
        """Return the example that contains the next display, after words at the given offsets."""
        found = self
        if self.number and self.level == _WORDS and is_new and _GAP.match(words):
            found = replace(self, is_sure=False)
        for event in _EVENT.finditer(words):
            found = found._take(event, offsets[event.start()] if offsets else 0)
        return found

    def _take(self, event: re.Match[str], start: int) -> Example:
        if event["level"] or event["marks"]:
            level = _LEVELS.index(event["level"].lower()) if event["level"] else len(event["marks"])
            return self._enter(level, event["title"] or event["line"] or "", start)
        if event["edge"]:
            return self._begin(-1, start) if event["edge"].lower() == "begin" else self._end()
        if event["general"]:
            return self._end()
        if event["begun"]:
            return self if self.number and self.level < _WORDS else self._begin(_WORDS, start)
        return replace(self, is_sure=True) if self.number else self._begin(_WORDS, start)

    def _enter(self, level: int, title: str, start: int) -> Example:
        """Pass a heading: of an example, inside one, or of something else."""
        if said := _EXAMPLE.search(title):
            return replace(self._begin(level, start), has_several=bool(said["several"]))
        if self.number and self.level < level:
            return (
                replace(self._begin(level, start), has_several=True) if self.has_several else self
            )
        return self._end()

    def _begin(self, level: int, start: int) -> Example:
        return Example(self.last + 1, self.last + 1, start, level)

    def _end(self) -> Example:
        return Example(last=self.last)


NO_EXAMPLE = Example()
