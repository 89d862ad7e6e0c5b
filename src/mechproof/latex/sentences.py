"""Sentences in LaTeX: which prints are words with formulas between them, and their parts."""

from __future__ import annotations

import re
from collections.abc import Iterator

from mechproof.latex.latex_signs import find_brace

# Text that is read as words; shorter pieces are names and units within a formula.
WORDS = re.compile(r"[^\W\d_]{4}|[^\W\d_]{2}.* |^ .*[^\W\d_]{2}|^ ")


def is_sentence(latex: str) -> bool:
    """Return whether a print has words outside all groups and brackets."""
    return any(is_text and WORDS.search(part) for is_text, part in list_parts(latex))


def list_parts(latex: str) -> Iterator[tuple[bool, str]]:
    r"""Yield the texts of \text{...} outside groups (True) and the pieces between them (False)."""
    start = 0
    for begin, end in _find_texts(latex):
        if latex[start:begin].strip():
            yield False, latex[start:begin]
        yield True, latex[begin + len(r"\text{") : end]
        start = end + 1
    if latex[start:].strip():
        yield False, latex[start:]


def _find_texts(latex: str) -> Iterator[tuple[int, int]]:
    for place in walk_outside(latex):
        if latex.startswith(r"\text{", place):
            end = find_brace(latex, place + len(r"\text"))
            if end is not None:
                yield place, end


def walk_outside(latex: str) -> Iterator[int]:
    r"""Yield the places that lie in no group, no \left...\right and no environment."""
    depth = 0
    for token in re.finditer(r"\\[A-Za-z]+|\\.|.", latex, re.DOTALL):
        closes = token[0] in ("}", r"\right", r"\end")
        opens = token[0] in ("{", r"\left", r"\begin")
        if depth == 0:
            yield token.start()
        depth = max(depth + opens - closes, 0)
