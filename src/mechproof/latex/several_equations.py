"""Several equations in one print: rows of an environment, and steps joined by arrows.

A `matrix` that contains relations is not a matrix but rows of equations: conditions belong to
their row, `&` between two equations is a comma, and `&` next to a relation sign means nothing.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from mechproof.latex.latex_signs import GAPS, Token, measure_depths
from mechproof.latex.printed_relations import RELATIONS

ARROWS = (r"\to", r"\Rightarrow", r"\implies", r"\Longrightarrow")
# Arrows that are not read as steps: one direction alone would prove a step.
EQUIVALENCES = (r"\iff", r"\Leftrightarrow", r"\Longleftrightarrow")
_ROWS = ("matrix", "aligned", "gathered", "split")
_SIGNS = (*RELATIONS, "+", "-", r"\pm", r"\mp", ",", ";", r"\in")


@dataclass(frozen=True)
class Line:
    """The signs of one print, and the arrow in front if it follows from the preceding print."""

    tokens: list[Token]
    arrow: Token | None = None


def split(tokens: Sequence[Token]) -> list[Line]:
    """Return the prints that a print consists of."""
    rows = _split_rows(tokens) or [[*tokens]]
    return [line for row in rows for line in _split_steps(row)]


def _measure(tokens: Sequence[Token]) -> Iterator[tuple[int, Token]]:
    """Yield signs with the number of brackets and environments around them."""
    return zip(measure_depths(token.text for token in tokens), tokens, strict=True)


def _split_rows(tokens: Sequence[Token]) -> list[list[Token]]:
    """Return the rows of a print that is a single environment with relations, else an empty list.

    The signs after the environment belong to each row.
    """
    kinds = [rf"\begin{{{kind}}}" for kind in _ROWS]
    levels = list(_measure(tokens))
    end = next((n for n, (depth, _) in enumerate(levels) if n and depth == 0), None)
    if end is None or tokens[0].text not in kinds:
        return []
    after = next((t.text for t in tokens[end + 1 :] if t.text not in GAPS.values()), ",")
    inside = any(depth == 1 and token.text in RELATIONS for depth, token in levels[:end])
    if not inside or after not in (",", ";", ".", "("):
        return []
    rows: list[list[Token]] = [[]]
    for depth, token in levels[1:end]:
        if depth == 1 and token.text == r"\\":
            rows.append([])
        else:
            rows[-1].append(token)
    rows = [row for row in map(_strip, rows) if row]
    joined: list[list[Token]] = []
    for row in rows:
        first = next(token.text for token in row if token.text not in GAPS.values())
        if joined and first in ("&", *RELATIONS):
            joined[-1] += row
        else:
            joined.append(row)
    return [[*_part_cells(row), *tokens[end + 1 :]] for row in joined]


def _strip(row: Sequence[Token]) -> list[Token]:
    """Return a row without the punctuation and blanks at its end."""
    end = len(row)
    while end and row[end - 1].text in (",", ";", ".", *GAPS.values()):
        end -= 1
    return list(row[:end])


def _part_cells(row: Sequence[Token]) -> Iterator[Token]:
    """Yield the signs of a row, with a comma for an `&` that separates two equations."""
    for place, (depth, token) in enumerate(_measure(row)):
        if depth or token.text != "&":
            yield token
            continue
        before, after = _find_neighbours(row, place)
        if not before or before in _SIGNS or after in (*_SIGNS, "&", ""):
            continue
        yield replace(token, text=",")


def _find_neighbours(row: Sequence[Token], place: int) -> tuple[str, str]:
    plain = [(n, token.text) for n, token in enumerate(row) if token.text not in GAPS.values()]
    before = [text for n, text in plain if n < place]
    after = [text for n, text in plain if n > place]
    return before[-1] if before else "", after[0] if after else ""


def _split_steps(row: Sequence[Token]) -> Iterator[Line]:
    lines = [Line([])]
    for depth, token in _measure(row):
        if depth == 0 and token.text in ARROWS:
            lines.append(Line([], token))
        else:
            lines[-1].tokens.append(token)
    is_step = all(any(token.text in RELATIONS for token in line.tokens) for line in lines)
    yield from lines if is_step else [Line(list(row))]
