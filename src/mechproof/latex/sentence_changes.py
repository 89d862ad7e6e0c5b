"""What a correction changes in a sentence: takes two, returns both with their differences marked.

Words and punctuation are compared literally, the formulas between them as formulas.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from difflib import SequenceMatcher
from itertools import groupby

from mechproof.latex.changes import Style, mark_changes
from mechproof.latex.sentences import list_parts

WORD = re.compile(r"[^\s,;:]+\s*|[,;:]\s*|\s+")
# If two sentences have a smaller share in common, they say different things: nothing is marked.
LEAST = 0.5


@dataclass(frozen=True)
class _Piece:
    """A word with the blanks after it, or a formula; and whether the other sentence lacks it."""

    is_word: bool
    latex: str
    changed: bool = field(default=False, compare=False)

    @property
    def same(self) -> tuple[bool, str]:
        """Return the key by which pieces are compared."""
        return self.is_word, self.latex.strip()


def mark_sentences(printed: str, mend: str, taken: Style, put: Style) -> tuple[str, str]:
    """Return both sentences, marking with `taken` and `put` what only the first or second has.

    Sentences that have little in common are returned unchanged.
    """
    left, right = tuple(_list_pieces(printed)), tuple(_list_pieces(mend))
    matcher = SequenceMatcher(None, [p.same for p in left], [p.same for p in right], autojunk=False)
    marked_left, marked_right = list[_Piece](), list[_Piece]()
    for change, *(a, b, c, d) in matcher.get_opcodes():
        old, new = left[a:b], right[c:d]
        if change == "replace":
            within = _mark_formulas(old[0], new[0], taken, put)
            marked_left, marked_right = [*marked_left, *within[:1]], [*marked_right, *within[1:]]
            old, new = (old[1:], new[1:]) if within else (old, new)
        changed = change != "equal"
        marked_left += [_Piece(p.is_word, p.latex, changed) for p in old]
        marked_right += [_Piece(p.is_word, p.latex, changed) for p in new]
    if _measure(marked_left) + _measure(marked_right) < LEAST * (len(printed) + len(mend)):
        return printed, mend
    return _write(marked_left, taken), _write(marked_right, put)


def _list_pieces(latex: str) -> Iterator[_Piece]:
    for is_text, part in list_parts(latex):
        words = WORD.findall(part) if is_text else [part]
        yield from (_Piece(is_text, word) for word in words)


def _mark_formulas(old: _Piece, new: _Piece, taken: Style, put: Style) -> tuple[_Piece, ...]:
    """Return both formulas with their differences marked; () for words or too different formulas.

    A formula with marks inside it counts as kept.
    """
    if old.is_word or new.is_word:
        return ()
    marked = mark_changes(old.latex, new.latex, taken, put)
    if marked == (old.latex, new.latex):
        return ()
    return tuple(_Piece(False, latex) for latex in marked)


def _measure(pieces: Sequence[_Piece]) -> int:
    """Return the number of characters in pieces that both sentences have."""
    return sum(len(piece.latex) for piece in pieces if not piece.changed)


def _write(pieces: Sequence[_Piece], style: Style) -> str:
    written = ""
    for changed, run in groupby(pieces, key=lambda piece: piece.changed):
        parts = groupby(run, key=lambda piece: piece.is_word)
        joined = ((is_word, "".join(piece.latex for piece in part)) for is_word, part in parts)
        text = "".join(rf"\text{{{part}}}" if is_word else part for is_word, part in joined)
        written += style.change(text) if changed else text
    return written
