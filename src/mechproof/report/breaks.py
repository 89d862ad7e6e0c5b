"""Lines of a formula: takes MathML, returns the pieces between which it may be broken.

No browser breaks a line within a formula. The pieces are formulas of their own that follow each
other as words do: each begins with a relation or with the sign of a term, or follows a comma. Only
the first has the LaTeX, which is that of the whole formula.

A wide part inside a root, a fraction, tall brackets or an entry is folded: it becomes a table whose
cells the stylesheet puts next to each other, or below each other if there is no room.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple
from weakref import WeakKeyDictionary
from xml.etree.ElementTree import Element, SubElement, fromstring, tostring

from markupsafe import Markup

from mechproof.report.mathml import CLOSING, NAMESPACE, OPENING, SIGNS, Display

RELATIONS = frozenset("=≠≈≡<>≤≥⩽⩾≪≫→⇒⟹⇔⟺≷≢")
BETWEEN = RELATIONS | {*SIGNS}
OPENS, CLOSES = frozenset(OPENING), frozenset(CLOSING)
# Width, in signs, above which a piece is also broken within its brackets, and below which a left
# side stays where it is.
WIDE, NARROW = 34, 6
# Brackets are opened only if every piece keeps at most this share of the width.
OPENED = 0.75
# Width above which a piece is folded, the least width of its lines, and the gap between entries.
ROOM, LEAST, GAP = 30.0, 8.0, 1.5
FOLDED = "lines"
STACKED = frozenset({"mfrac", "munder", "mover", "munderover", "mtable"})
SCRIPTED = frozenset({"msub", "msup", "msubsup"})
# Relative size of indices, as in MathML Core; width, in letters, of a sign with the gaps around it;
# and the signs that are set large.
SMALLER, SPACED = 0.71, 2.4
BIG = "∑∏∫"
# Widths of elements, as long as these exist: each is requested at every depth above it.
_widths: WeakKeyDictionary[Element, float] = WeakKeyDictionary()


class Broken(NamedTuple):
    """A formula in pieces, and the width of the widest in signs: unfolded, and folded."""

    pieces: Markup
    width: float
    folded: float


def write_broken(math: str, display: Display) -> Broken:
    """Break a formula into pieces, folding wide parts inside them if it is displayed."""
    root = fromstring(math.replace(f' xmlns="{NAMESPACE}"', ""))
    if root.tag != "math":
        return Broken(Markup(math), measure(root), measure(root))
    (row, source), *_ = root
    pieces = _break(list(_unpack(row)), WIDE)
    if display == "block":
        for piece in pieces:
            _fold_parts(piece, ROOM, is_large=True)
    if len(pieces) == 1:
        root.set("xmlns", NAMESPACE)
        return Broken(Markup(tostring(root, encoding="unicode")), *_measure_both([root]))
    written = [_write(piece, display, None if i else source) for i, piece in enumerate(pieces)]
    widths = list(map(_measure_both, pieces))
    return Broken(Markup("<wbr/>").join(map(Markup, written)), *map(max, zip(*widths, strict=True)))


def _measure_both(parts: Sequence[Element]) -> tuple[float, float]:
    return sum(map(measure, parts)), sum(_measure(part, is_folded=True) for part in parts)


def measure(element: Element) -> float:
    """Return the approximate width of a formula in letters, which folding does not change."""
    if element not in _widths:
        _widths[element] = _measure(element, is_folded=False)
    return _widths[element]


def _measure(element: Element, *, is_folded: bool) -> float:
    """Return the width of an element; of stacked parts, the widest counts.

    The sign of a root adds one letter.
    """
    if element.tag == "annotation":
        return 0.0
    if is_folded and element.get("class") == FOLDED:
        return max(_measure(cell, is_folded=True) for cell in element.iter("mtd"))
    widths = [_measure(p, is_folded=True) if is_folded else measure(p) for p in element]
    if element.tag in STACKED:
        return max(widths)
    if element.tag in SCRIPTED:
        base, *scripts = widths
        return base + SMALLER * max(scripts)
    sign = _sign_of(element)
    is_between = sign in BETWEEN and element.get("form") in (None, "infix")
    if sign and (sign in BIG or is_between):
        return SPACED
    return len(element.text or "") + (element.tag == "msqrt") + sum(widths)


def _fold(element: Element, room: float, *, is_large: bool) -> None:
    """Fold the parts of an element that are wider than the room, outermost parts first.

    `is_large` tells whether sums have their limits above and below them here.
    """
    if element.tag in ("msqrt", "mtd"):
        element[:] = _fold_row(list(_unpack(element)), room, is_large=is_large)
    elif element.tag == "mfrac":
        is_large = False
        rows = [part for part in element if part.tag == "mrow"]
        # Neither part is made narrower than the other needs, unless that is far too wide.
        least = [_find_least(list(_unpack(row)), room) for row in rows]
        room = max([room, *(width for width in least if width <= min(WIDE, 2 * room))])
        for row in rows:
            row[:] = _fold_row(list(_unpack(row)), room, is_large=is_large)
    elif element.tag == "mrow" and (fences := [p for p in element if p.get("fence") == "true"]):
        element[1:-1] = _fold_row(list(_unpack(element[1:-1])), room, is_large=is_large)
        if element[1].get("class") == FOLDED:
            for fence in fences:
                fence.attrib.pop("stretchy", None)
    elif element.tag == "mtr" and len(element) > 1:
        room = (room - GAP * (len(element) - 1)) / len(element)
    is_large = is_large and element.tag not in (*SCRIPTED, "mtable")
    if element.tag in (*STACKED, "mtr"):
        for part in element:
            _fold(part, room, is_large=is_large)
    else:
        _fold_parts(list(element), room, is_large=is_large)


def _fold_parts(parts: Sequence[Element], room: float, *, is_large: bool) -> None:
    """Fold parts next to each other: wide ones share the room that the others leave."""
    widths = list(map(measure, parts))
    wide = [width for width in widths if width > LEAST]
    left = max(LEAST, (room - sum(widths) + sum(wide)) / max(1, len(wide)))
    for part in parts:
        if part.get("class") == FOLDED:
            for cell in part[0]:
                _fold_parts(list(cell[0]), left, is_large=is_large)
        else:
            _fold(part, left, is_large=is_large)


def _fold_row(parts: list[Element], room: float, *, is_large: bool) -> list[Element]:
    """Return the parts of a row, as a table of their lines if they need more than one."""
    if sum(map(measure, parts)) <= room:
        return parts
    lines = [*_fill(_break(parts, room), room)]
    if len(lines) == 1:
        return parts
    table = Element("mtable", {"class": FOLDED, "displaystyle": str(is_large).lower()})
    row = SubElement(table, "mtr")
    for line in lines:
        _begin(line)
        # Wrapped in one element, so that a cell is a line.
        SubElement(SubElement(row, "mtd"), "mrow").extend(line)
    return [table]


def _find_least(parts: list[Element], room: float) -> float:
    """Return the width of the widest piece of a row once it is folded."""
    whole = sum(map(measure, parts))
    pieces = _break(parts, room) if whole > room else [parts]
    return max(sum(map(measure, piece)) for piece in pieces)


def _fill(pieces: Sequence[list[Element]], room: float) -> Iterator[list[Element]]:
    """Yield lines filled with pieces as long as there is room."""
    line: list[Element] = []
    for piece in pieces:
        if line and sum(map(measure, line + piece)) > room:
            yield line
            line = []
        line = line + piece
    yield line


def _write(parts: Sequence[Element], display: Display, source: Element | None) -> str:
    """Write a piece as a formula of its own, with the LaTeX if `source` is given."""
    math = Element("math", {"xmlns": NAMESPACE, "display": "inline"})
    if display == "block":
        math.set("displaystyle", "true")
    _begin(parts)
    meaning = SubElement(math, "semantics")
    SubElement(meaning, "mrow").extend(parts)
    if source is not None:
        meaning.append(source)
    written: str = tostring(math, encoding="unicode")
    return written


def _begin(parts: Sequence[Element]) -> None:
    """Make a sign at the beginning keep the gaps that it has between two terms."""
    if _sign_of(parts[0]) in BETWEEN and "form" not in parts[0].attrib:
        parts[0].set("form", "infix")


def _is_tall(part: Element) -> bool:
    """Return whether a row has brackets that are as tall as their contents."""
    fences = [p for p in part if p.get("fence") == "true" and p.get("stretchy") != "false"]
    return part.tag == "mrow" and bool(fences)


def _unpack(row: Iterable[Element]) -> Iterator[Element]:
    """Yield the elements of a row, and those of inner rows that need not be kept together."""
    for part in row:
        if part.tag == "mrow" and not part.attrib and not _is_tall(part):
            yield from _unpack(part)
        else:
            yield part


def _break(parts: list[Element], most: float) -> list[list[Element]]:
    """Break a row outside its brackets, and wide pieces also inside brackets, one level deep."""
    found = [
        narrow
        for piece in _split(parts, 0)
        for narrow in (_open(piece) if sum(map(measure, piece)) > most else (piece,))
    ]
    joined = [found[0]]
    for piece in found[1:]:
        is_narrow = sum(map(measure, joined[-1])) < NARROW
        if is_narrow and _sign_of(piece[0]) in RELATIONS and not _count_open(joined[-1]):
            joined[-1] = joined[-1] + piece
        else:
            joined.append(piece)
    return joined


def _open(piece: list[Element]) -> list[list[Element]]:
    """Break a piece inside its brackets; leave it whole if the wide part is elsewhere."""
    within = list(_split(piece, 1))
    widest = max(sum(map(measure, part)) for part in within)
    return within if widest <= OPENED * sum(map(measure, piece)) else [piece]


def _split(parts: Sequence[Element], deepest: int) -> Iterator[list[Element]]:
    piece: list[Element] = []
    depth, ends = 0, False
    for part in parts:
        sign = _sign_of(part)
        is_blank = part.tag in ("mspace", "mtext") and not sign.strip()
        begins = part.get("form") is None and sign in BETWEEN and depth <= deepest
        if piece and (begins or (ends and not is_blank)):
            yield piece
            piece = []
        piece.append(part)
        depth += _count_open([part])
        ends = depth <= deepest and (sign == "," or (ends and is_blank))
    yield piece


def _sign_of(part: Element) -> str:
    return part.text or "" if part.tag == "mo" else ""


def _count_open(parts: Iterable[Element]) -> int:
    """Count opening minus closing brackets; a power of a bracket is written at the closing one."""
    bases = [part[0] if part.tag in SCRIPTED else part for part in parts]
    return sum(_go_deeper(base, _sign_of(base)) for base in bases)


def _go_deeper(part: Element, sign: str) -> int:
    """Return 1 for an opening bracket, -1 for a closing one, 0 else; bars as they are marked."""
    if sign == "|":
        return {"prefix": 1, "postfix": -1}.get(part.get("form", ""), 0)
    return (sign in OPENS) - (sign in CLOSES)
