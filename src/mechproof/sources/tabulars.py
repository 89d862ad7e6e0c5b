r"""Tables of a text, LaTeX or Markdown -> rows of cells with their places.

Rules are left out; a cell that spans several columns is put in the first of them, and the content
of `\multirow` is repeated in the rows below.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from mechproof.latex.latex_signs import find_brace
from mechproof.sources.lines import split_lines, walk_signs
from mechproof.sources.located_text import LocatedText
from mechproof.sources.macros import expand, find_macros
from mechproof.sources.paper_files import DocumentError

TABLES = r"tabular[*xy]?|longtable|(?:long)?tabu"
_BEGIN = re.compile(rf"\\begin\{{({TABLES})\}}")
_OPTION = re.compile(r"\s*\[[^\]]*\]|\s*(?=\{)")
# Number of arguments in braces in front of the rows.
_ARGUMENTS = {"tabular*": 2, "tabularx": 2, "tabulary": 2}
_RULES = re.compile(
    r"\\(?:hline|toprule|midrule|bottomrule|endhead|endfirsthead|endfoot|endlastfoot|centering)"
    r"(?![A-Za-z])(?:\[[^\]]*\])?"
    r"|\\(?:cline|cmidrule|specialrule|addlinespace|rowcolor|cellcolor|arrayrulecolor)(?![A-Za-z])"
    r"(?:\([^)]*\)|\[[^\]]*\]|\{[^{}]*\})*"
    r"|\\(?:caption|label)\*?\s*\{[^{}]*\}"
)
_SPAN = re.compile(r"\\multicolumn\s*\{(\d+)\}\s*\{[^{}]*\}\s*\{(.*)\}\Z", re.DOTALL)
_DOWN = re.compile(r"\\multirow\*?\s*(?:\[[^\]]*\])?\{(\d+)\}\s*\{[^{}]*\}\s*\{(.*)\}\Z", re.DOTALL)
_WRAPPED = re.compile(
    r"\\(?:textbf|textit|textrm|emph|makecell|thead|bfseries|itshape|boldmath|small|footnotesize)"
    r"(?![A-Za-z])\s*"
)
_PIPES = re.compile(
    r"^[^\n]*\|[^\n]*\n[ \t]*\|?[ \t]*:?-+:?[ \t]*(?:\|[ \t]*:?-+:?[ \t]*)*\|?[ \t]*\n"
    r"(?:[^\n]*\|[^\n]*(?:\n|\Z))+",
    re.MULTILINE,
)
_RULE = re.compile(r"[ \t]*\|?[ \t:|-]*\Z")
_PIPE = re.compile(r"\$[^$]*\$|\\.|\|")


@dataclass(frozen=True)
class TableCell:
    """The content of a cell, and its place in all that was read."""

    string: str
    offset: int


@dataclass(frozen=True)
class Tabular:
    """A table: its place, and its rows, which all have the same number of cells."""

    offset: int
    rows: tuple[tuple[TableCell, ...], ...]


def find_tabulars(text: LocatedText) -> Iterator[Tabular]:
    """Yield the tables of a text with at least two rows, in order."""
    defined, plain = find_macros(text)
    found = [(match.start(), _read_pipes(plain, match)) for match in _PIPES.finditer(plain.string)]
    for match in _BEGIN.finditer(plain.string):
        macros = {d.name: d.macro for d in defined if d.place <= match.start()}
        body = _find_body(plain, match)
        try:
            body = expand(body, macros)
        except DocumentError:
            continue
        found.append((match.start(), [_cut(line) for line in _split(body)]))
    for place, rows in sorted(found, key=lambda pair: pair[0]):
        square = _fill(rows)
        if len(square) > 1:
            yield Tabular(plain.offsets[place], tuple(map(tuple, square)))


def _find_body(text: LocatedText, match: re.Match[str]) -> LocatedText:
    """Return the content of an environment after its arguments."""
    kind, place, string = match[1], match.end(), text.string
    for _ in range(_ARGUMENTS.get(kind, 1)):
        option = _OPTION.match(string, place)
        place = option.end() if option else place
        close = find_brace(string, place) if string[place : place + 1] == "{" else None
        place = place if close is None else close + 1
    end = string.find(rf"\end{{{kind}}}", place)
    return text[place : len(text) if end < 0 else end]


def _split(body: LocatedText) -> Iterator[LocatedText]:
    for line in split_lines(body.replace(_RULES, lambda _: " ")):
        if line.string.strip():
            yield line


def _cut(line: LocatedText) -> list[TableCell]:
    """Cut a line at each & outside brackets."""
    cells, start = [], 0
    for sign, place, depth in walk_signs(line.string):
        if sign == "&" and depth == 0:
            cells += _make(line[start:place])
            start = place + 1
    return [*cells, *_make(line[start:])]


def _make(text: LocatedText) -> list[TableCell]:
    """Return a cell, and empty ones for the other columns that it spans."""
    bare = text.strip()
    if not len(bare):
        return [TableCell("", text.offsets[0] if len(text) else 0)]
    span = _SPAN.match(bare.string)
    if span is None:
        return [TableCell(bare.string, bare.offsets[0])]
    empty = TableCell("", bare.offsets[0])
    return [TableCell(span[2].strip(), bare.offsets[0]), *[empty] * (int(span[1]) - 1)]


def _read_pipes(text: LocatedText, match: re.Match[str]) -> list[list[TableCell]]:
    rows, place = [], match.start()
    for line in match[0].splitlines(keepends=True):
        if not _RULE.match(line.rstrip("\n")):
            rows.append(list(_cut_pipes(text[place : place + len(line)].strip())))
        place += len(line)
    return rows


def _cut_pipes(line: LocatedText) -> Iterator[TableCell]:
    start, end = 0, len(line)
    places = [m.start() for m in _PIPE.finditer(line.string) if m[0] == "|"]
    if places[:1] == [0]:
        start, places = 1, places[1:]
    if places[-1:] == [end - 1]:
        end, places = end - 1, places[:-1]
    for place in (*places, end):
        yield from _make(line[start:place])
        start = place + 1


def _fill(rows: Sequence[Sequence[TableCell]]) -> list[list[TableCell]]:
    """Return rows of equal width, with cells that span several rows repeated in each."""
    width = max(map(len, rows), default=0)
    held: dict[int, tuple[int, TableCell]] = {}
    filled = []
    for row in rows:
        cells = [*row, *[TableCell("", row[-1].offset)] * (width - len(row))]
        for column, cell in enumerate(cells):
            if down := _DOWN.match(cell.string):
                cells[column] = TableCell(down[2].strip(), cell.offset)
                held[column] = int(down[1]) - 1, cells[column]
            elif not cell.string and held.get(column, (0, cell))[0] > 0:
                left, above = held[column]
                cells[column] = TableCell(above.string, cell.offset)
                held[column] = left - 1, above
        filled.append([TableCell(_WRAPPED.sub("", c.string).strip(), c.offset) for c in cells])
    return filled
