"""Formulas: the LaTeX of a paper in, MathML or a sentence out; nothing in it is trusted."""

from __future__ import annotations

import re
from collections.abc import Iterator
from html import unescape
from itertools import pairwise
from typing import Literal
from xml.etree.ElementTree import Element, SubElement, tostring

from latex2mathml.converter import convert_to_element
from markupsafe import Markup, escape

Display = Literal["block", "inline"]
# What the elements may carry on; others, as links and styles, are dropped.
ATTRIBUTES = frozenset({
    "accent", "columnalign", "display", "displaystyle", "fence", "form", "largeop", "linethickness",
    "lspace", "mathvariant", "maxsize", "minsize", "movablelimits", "rspace", "scriptlevel",
    "separator", "stretchy", "width", "xmlns",
})  # fmt: skip
GAP = re.compile(r",\s*\\q?quad\s*")
# Text that is read as words; shorter pieces are names and units within a formula.
WORDS = re.compile(r"[^\W\d_]{4}|[^\W\d_]{2}.* |^ .*[^\W\d_]{2}|^ ")
UPRIGHT = re.compile(r"\\mathrm\s*(?:\{([^\W\d_]+)\}|([^\W\d_]))")
ESCAPED = re.compile(r"\\([_%#&$ ])")
# SymPy's name for the angle of a vector, and everyone else's.
TWO_ARGUMENTS = (r"\operatorname{atan}_{2}", r"\operatorname{atan2}")
OPENING = "([{|⟨⌈⌊"
# Where a space before a function's name is not needed.
BEFORE = ("+", "−", "=", "<", ">", "≤", "≥", "(", "[", "{", ",", "|", "⋅", "·", "±", "∓")


def write_print(latex: str) -> Markup:
    """Write what a paper prints: a paragraph where it has words, else formulas on their own."""
    if not latex:
        return Markup("")
    if is_sentence(latex):
        return Markup('<p class="sentence">{}</p>').format(write_sentence(latex))
    blocks = (
        Markup('<div class="formula">{}</div>').format(write_formula(line, "block"))
        for line in _split(latex, GAP)
    )
    return Markup("").join(blocks)


def write_lines(latex: str) -> Markup:
    """Write a list of formulas, each on a line of its own: as a sentence where it has words."""
    return Markup("").join(write_print(line) for line in _split(latex, GAP))


def is_sentence(latex: str) -> bool:
    """Return whether words stand in it outside every group and every bracket."""
    return any(is_text and WORDS.search(part) for is_text, part in _list_parts(latex))


def write_sentence(latex: str) -> Markup:
    """Write words as words, and the formulas between them as such."""
    parts = (
        Markup(escape(_read_text(part))) if is_text else _write_within(part)
        for is_text, part in _list_parts(latex)
    )
    return Markup("").join(parts)


def _write_within(latex: str) -> Markup:
    before = " " if re.match(r"\s|\\[ ,;]|~", latex) else ""
    bare = re.sub(r"^(?:\s|\\[ ,;]|~)+|(?:\s|\\[ ,;]|~)+$", "", latex)
    return Markup("{}{}").format(before, write_formula(bare, "inline")) if bare else Markup(before)


def _read_text(text: str) -> str:
    return ESCAPED.sub(r"\1", text).replace(r"\^{}", "^").replace("~", "\N{NO-BREAK SPACE}")


def _list_parts(latex: str) -> Iterator[tuple[bool, str]]:
    r"""Yield what lies in \text{...} outside of groups, and what lies between."""
    start = 0
    for begin, end in _find_texts(latex):
        if latex[start:begin].strip():
            yield False, latex[start:begin]
        yield True, latex[begin + len(r"\text{") : end]
        start = end + 1
    if latex[start:].strip():
        yield False, latex[start:]


def _find_texts(latex: str) -> Iterator[tuple[int, int]]:
    for place in _walk_outside(latex):
        if latex.startswith(r"\text{", place):
            end = _find_end(latex, place + len(r"\text{"))
            if end < len(latex):
                yield place, end


def _walk_outside(latex: str) -> Iterator[int]:
    r"""Yield the places that lie in no group, no \left...\right and no environment."""
    depth = 0
    for token in re.finditer(r"\\[A-Za-z]+|\\.|.", latex, re.DOTALL):
        closes = token[0] in ("}", r"\right", r"\end")
        opens = token[0] in ("{", r"\left", r"\begin")
        if depth == 0:
            yield token.start()
        depth = max(depth + opens - closes, 0)


def _find_end(latex: str, start: int) -> int:
    depth = 1
    for token in re.finditer(r"\\.|[{}]", latex[start:], re.DOTALL):
        depth += {"{": 1, "}": -1}.get(token[0], 0)
        if depth == 0:
            return start + token.start()
    return len(latex)


def _split(latex: str, gap: re.Pattern[str]) -> Iterator[str]:
    outside = set(_walk_outside(latex))
    places = [m.span() for m in gap.finditer(latex) if m.start() in outside]
    edges = [0, *(edge for span in places for edge in span), len(latex)]
    return (latex[low:high] for low, high in zip(edges[::2], edges[1::2], strict=True))


def write_formula(latex: str, display: Display = "inline") -> Markup:
    """Write a formula as MathML, with its LaTeX for who copies it; as code if it is no LaTeX."""
    plain = UPRIGHT.sub(_as_text, latex).replace(*TWO_ARGUMENTS)
    try:
        math = convert_to_element(plain, display=display)
    except Exception:  # The library raises many kinds, which the user's own paper may meet.
        return Markup('<code class="latex">{}</code>').format(latex)
    _mend(math)
    row = math[0]
    math.remove(row)
    meaning = SubElement(math, "semantics")
    meaning.append(row)
    source = SubElement(meaning, "annotation", {"encoding": "application/x-tex"})
    source.text = latex
    return Markup(tostring(math, encoding="unicode"))


def _as_text(name: re.Match[str]) -> str:
    return rf"\text{{{name[1] or name[2]}}}"


def _mend(element: Element) -> None:
    """Read entities, drop what is not allowed, and say what the library leaves to the browser."""
    element.text = unescape(element.text) if element.text else element.text
    element.attrib = {k: v for k, v in element.attrib.items() if k in ATTRIBUTES}
    if element.tag == "mtext" and element.text:
        element.text = _read_text(element.text)
    if element.tag == "mi" and element.text:
        _mend_name(element, element.text)
    for child in element:
        _mend(child)
    _space_functions(element)


def _mend_name(element: Element, text: str) -> None:
    if len(text) == 1 and not (text.isalnum() or text in "∂∇∞∅ℓ′″‴%°ℝℕℤ…"):
        element.tag = "mo"
    elif len(text) == 1 and "Α" <= text <= "Ω":
        element.set("mathvariant", "normal")


def _space_functions(row: Element) -> None:
    """Set the name of a function apart from what it is applied to, and from what it multiplies."""
    for left, right in list(pairwise(row)):
        if row.tag not in ("mrow", "math", "mtd", "mstyle", "msqrt"):
            return
        after = _is_function(left) and not _opens(right)
        if after or (_is_function(right) and _multiplies(left)):
            row.insert(list(row).index(right), Element("mspace", {"width": "0.167em"}))


def _is_function(element: Element) -> bool:
    base = element[0] if element.tag in ("msup", "msub", "msubsup") and len(element) else element
    return base.tag == "mi" and len(base.text or "") > 1


def _opens(element: Element) -> bool:
    first = element
    while first.tag in ("mrow", "mstyle") and len(first):
        first = first[0]
    return first.tag == "mspace" or (first.tag == "mo" and (first.text or "") in OPENING)


def _multiplies(element: Element) -> bool:
    is_mark = element.tag == "mo" and (element.text or "").strip() in BEFORE
    return not is_mark and element.tag not in ("mspace", "mo")
