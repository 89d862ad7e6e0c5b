r"""Gaps in square brackets that part the entries of a row: [x\quad y] is (x,y)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from mechproof.latex.latex_signs import (
    CLOSING,
    DOTS,
    GAPS,
    NARROW,
    OPENING,
    WIDE,
    Token,
    find_close,
    measure_depths,
)
from mechproof.latex.printed_relations import RELATIONS

# What is no list of entries.
_OTHERS = (*RELATIONS, r"\in", ",", ";", ":", "&", r"\\")
_JOINING = ("+", "-", "/", r"\pm", r"\mp", *DOTS)


def part_rows(tokens: Sequence[Token]) -> tuple[list[Token], set[int]]:
    """Return signs with commas for wide gaps between entries, and which narrow ones may be some.

    Those stand between what nothing else joins.
    """
    texts = [token.text for token in tokens]
    parted, unclear = list(tokens), set[int]()
    for start in (n for n, text in enumerate(texts) if text == "["):
        inside = texts[start : start + find_close(texts[start:])]
        own = [start + n for n, depth in enumerate(measure_depths(inside)) if depth == 1]
        signs = {texts[n] for n in own}
        if signs & {*_OTHERS} or any(text.startswith(r"\text") for text in signs):
            continue
        gaps = [n for n in own if texts[n] in (WIDE, NARROW) and _stands_between(texts, n)]
        wide = [n for n in gaps if texts[n] == WIDE]
        for place in wide:
            parted[place] = replace(tokens[place], text=",")
        if not wide and not signs & {*_JOINING}:
            unclear |= {*gaps}
    return parted, unclear


def _stands_between(texts: Sequence[str], place: int) -> bool:
    """Return whether a gap stands between two entries, of which the second may have a sign."""
    before = next(text for text in texts[place::-1] if text not in GAPS)
    after = [text for text in texts[place + 1 :] if text not in GAPS][:1]
    is_sign = texts[place + 1 : place + 2] == ["-"] and texts[place + 2] not in GAPS
    begins = is_sign or (after[0] not in (*_JOINING, *CLOSING) if after else False)
    is_first = texts[place - 1] not in GAPS
    return is_first and begins and before not in (*_JOINING, *OPENING)
