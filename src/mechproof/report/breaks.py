"""Lines of a formula: MathML in, the pieces between which it may be broken out.

No browser breaks a line within a formula. Its pieces are formulas of their own, which stand after
each other as words do: they begin with a relation or with the sign of a term, or stand behind a
comma. Only the first has the LaTeX, which is that of all.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from xml.etree.ElementTree import Element, SubElement, fromstring, tostring

from markupsafe import Markup

from mechproof.report.mathml import CLOSING, NAMESPACE, OPENING, SIGNS, Display

RELATIONS = "=≠≈≡<>≤≥⩽⩾≪≫→⇒⟹⇔⟺≷≢"
# A piece of more signs is broken within its brackets, too; a left side of fewer stays where it is.
WIDE, NARROW = 34, 6
STACKED = frozenset({"mfrac", "munder", "mover", "munderover", "mtable"})
SCRIPTED = frozenset({"msub", "msup", "msubsup"})
# Indices are smaller, by what MathML Core says; signs between members have gaps around them, and
# those of sums are large: how many letters they are as wide as.
SMALLER, SPACED = 0.71, 2.4
BIG = "∑∏∫"


def write_broken(math: str, display: Display) -> tuple[Markup, float]:
    """Return a formula in pieces, and of how many signs the widest is."""
    root = fromstring(math.replace(f' xmlns="{NAMESPACE}"', ""))
    if root.tag != "math":
        return Markup(math), measure(root)
    (row, source), *_ = root
    pieces = _break(list(_unpack(row)))
    if len(pieces) == 1:
        return Markup(math), measure(root)
    widths = [sum(map(measure, piece)) for piece in pieces]
    written = [_write(piece, display, None if i else source) for i, piece in enumerate(pieces)]
    return Markup("<wbr/>").join(map(Markup, written)), max(widths)


def measure(element: Element) -> float:
    """Return about how many letters a formula is wide: as the widest of what stands above others.

    A root is wider by its sign.
    """
    if element.tag == "annotation":
        return 0.0
    if element.tag in STACKED:
        return max(map(measure, element))
    if element.tag in SCRIPTED:
        base, *scripts = map(measure, element)
        return base + SMALLER * max(scripts)
    sign = _sign_of(element)
    if sign and (sign in BIG or (sign in (*RELATIONS, *SIGNS) and element.get("form") is None)):
        return SPACED
    own = len(element.text or "") + (element.tag == "msqrt")
    return own + sum(map(measure, element))


def _write(parts: Sequence[Element], display: Display, source: Element | None) -> str:
    """Write a piece; the sign at its beginning keeps the gaps that it has between two members."""
    math = Element("math", {"xmlns": NAMESPACE, "display": "inline"})
    if display == "block":
        math.set("displaystyle", "true")
    if _sign_of(parts[0]) in (*RELATIONS, *SIGNS) and "form" not in parts[0].attrib:
        parts[0].set("form", "infix")
    meaning = SubElement(math, "semantics")
    SubElement(meaning, "mrow").extend(parts)
    if source is not None:
        meaning.append(source)
    written: str = tostring(math, encoding="unicode")
    return written


def _unpack(row: Element) -> Iterator[Element]:
    """List what stands in a row, and in the rows within it that nothing holds together."""
    for part in row:
        tall = any(p.get("fence") == "true" and p.get("stretchy") != "false" for p in part)
        if part.tag == "mrow" and not part.attrib and not tall:
            yield from _unpack(part)
        else:
            yield part


def _break(parts: list[Element]) -> list[list[Element]]:
    """Break a row outside of its brackets; what is wide even so within them, one deep."""
    found = [
        narrow
        for piece in _split(parts, 0)
        for narrow in (_split(piece, 1) if sum(map(measure, piece)) > WIDE else (piece,))
    ]
    joined = [found[0]]
    for piece in found[1:]:
        is_narrow = sum(map(measure, joined[-1])) < NARROW
        if is_narrow and _sign_of(piece[0]) in tuple(RELATIONS):
            joined[-1] = joined[-1] + piece
        else:
            joined.append(piece)
    return joined


def _split(parts: Sequence[Element], deepest: int) -> Iterator[list[Element]]:
    piece: list[Element] = []
    depth, ends = 0, False
    for part in parts:
        sign = _sign_of(part)
        is_blank = part.tag in ("mspace", "mtext") and not sign.strip()
        begins = part.get("form") is None and sign in (*RELATIONS, *SIGNS) and depth <= deepest
        if piece and (begins or (ends and not is_blank)):
            yield piece
            piece = []
        piece.append(part)
        depth += _go_deeper(part, sign)
        ends = depth <= deepest and (sign == "," or (ends and is_blank))
    yield piece


def _sign_of(part: Element) -> str:
    return part.text or "" if part.tag == "mo" else ""


def _go_deeper(part: Element, sign: str) -> int:
    """Return 1 for a bracket that opens, -1 for one that closes; bars do as they are marked."""
    if sign == "|":
        return {"prefix": 1, "postfix": -1}.get(part.get("form", ""), 0)
    return (sign in tuple(OPENING)) - (sign in tuple(CLOSING))
