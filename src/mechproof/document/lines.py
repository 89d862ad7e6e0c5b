r"""A display -> its lines, and the equations that they are.

What begins with a relation or an operator goes on with the line before it. A wide gap parts
equations, and leaves a condition with its own.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from mechproof.document.text import Text, join
from mechproof.latex.relations import RELATIONS
from mechproof.latex.tokens import same_sign

# What only puts lines below each other; between dollars Markdown has whole displays.
_WRAPPING = re.compile(
    r"\\(?:begin|end)\{(?:aligned|split|gathered|alignedat|align\*?|gather\*?|equation\*?)\}"
    r"(?:\{\d+\})?"
)
_SPACING = re.compile(r"\s*(?:\[-?[\d.]*\s*(?:px|pt|em|ex|cm|mm|\\[A-Za-z]+)\]|\*)")
_INTERTEXT = re.compile(r"\\(?:short)?intertext\s*\{[^{}]*\}")
_STEP = re.compile(
    r"\\begin\s*\{[^{}]*\}|\\end\s*\{[^{}]*\}|\\\\"
    r"|\\(?:left|right)(?![A-Za-z])\s*(?:\\[A-Za-z]+|\\.|.)"
    r"|\\[A-Za-z]+|\\.|.",
    re.DOTALL,
)
_OPENING = ("{", "(")
_CLOSING = ("}", ")")
_EQUALITY = ("=", r"\approx", r"\equiv", r"\simeq")
_OPERATORS = ("+", "-", "/", r"\cdot", r"\pm", r"\mp")
_RELATIONS = (*RELATIONS, *_EQUALITY)
_BLANK = (r"\quad", r"\qquad", r"\,", r"\;", r"\:", r"\!", "\\ ", "&", "~", r"\displaystyle")
_LEADS = (r"\Rightarrow", r"\implies", r"\therefore", r"\Longrightarrow", r"\iff", r"\to")
_AND = re.compile(r"\\(?:text|mbox|textrm)\{\s*(?:and|,|;)?\s*\}\Z")


def split_lines(body: Text) -> list[Text]:
    r"""Cut a display at its \\, but for those inside of matrices, cases and braces."""
    body = body.replace(_WRAPPING, lambda _: " ").replace(_INTERTEXT, lambda _: r"\\ ")
    lines, start = [], 0
    for sign, place, depth in walk_signs(body.string):
        if sign == r"\\" and depth == 0:
            lines.append(body[start:place])
            spacing = _SPACING.match(body.string, place + 2)
            start = spacing.end() if spacing else place + 2
    kept = [line for line in (*lines, body[start:]) if line.string.strip(" \t\n&")]
    return kept or [body]


def walk_signs(string: str) -> Iterator[tuple[str, int, int]]:
    """Yield the signs of a display as they are read, their places, and how deep they stand."""
    depth = 0
    for match in _STEP.finditer(string):
        sign = match[0]
        if sign.startswith((r"\begin", r"\left")) or sign in _OPENING:
            depth += 1
        if sign.startswith((r"\end", r"\right")) or sign in _CLOSING:
            depth = max(depth - 1, 0)
        yield same_sign(sign), match.start(), depth


def goes_on(before: str, line: str) -> bool:
    """Return whether a line belongs to the one before it."""
    signs = [sign for sign, _, _ in walk_signs(line) if not (sign.isspace() or sign in _BLANK)]
    ending = [sign for sign, _, _ in walk_signs(before) if not (sign.isspace() or sign in _BLANK)]
    if not signs or not ending or ending[-1] in (*_RELATIONS, *_OPERATORS):
        return True
    has_relation = any(sign in _RELATIONS for sign, _, depth in walk_signs(line) if depth == 0)
    return signs[0] in _RELATIONS or not has_relation


def join_lines(lines: Sequence[Text], *, has_columns: bool = True) -> Text:
    """Return lines as one equation, without what aligns them and what leads to them.

    Every second sign that aligns begins a column of its own, but for displays of one.
    """
    parts: list[Text] = []
    for line in lines:
        parts += [_drop_leads(join(list(_drop_alignment(line, has_columns)))), line.put(" ", 0)]
    return _clean(join(parts))


def _drop_alignment(line: Text, has_columns: bool) -> Iterator[Text]:
    start, signs = 0, 0
    for sign, place, depth in walk_signs(line.string):
        if sign == "&" and depth == 0:
            signs += 1
            yield line[start:place]
            if has_columns and signs % 2 == 0:
                yield line.put(r"\qquad ", place)
            start = place + 1
    yield line[start:]


def _drop_leads(latex: Text) -> Text:
    """Drop blanks and arrows before an equation."""
    for sign, place, _ in walk_signs(latex.string):
        if not (sign.isspace() or sign in _LEADS or sign in _BLANK):
            return latex[place:]
    return latex[len(latex) :]


def _clean(latex: Text) -> Text:
    """Drop what leads to an equation, and the stop behind it."""
    latex = _drop_leads(latex).strip(end=".,;~")
    while latex.string.endswith(_BLANK[:6]):
        latex = latex[: latex.string.rindex("\\")].strip(end=".,;~")
    return latex


def cut_gaps(latex: Text) -> Iterator[Text]:
    """Yield the equations of a line that wide gaps part."""
    signs = list(walk_signs(latex.string))
    places = [n for n, (sign, _, depth) in enumerate(signs) if sign in _BLANK[:2] and depth == 0]
    start = 0
    for gap in places:
        place = signs[gap][1]
        before, behind = latex[start:place], latex[place:]
        if _is_equation(before.string) and _is_equation(_until_gap(behind.string)):
            yield _clean(_drop_and(before))
            start = place
    yield _clean(latex[start:])


def _drop_and(latex: Text) -> Text:
    latex = _clean(latex)
    found = _AND.search(latex.string)
    return latex[: found.start()] if found else latex


def _until_gap(string: str) -> str:
    """Return what stands between a gap and the next one."""
    signs = list(walk_signs(string))
    first = next((n for n, s in enumerate(signs) if not (s[0].isspace() or s[0] in _BLANK)), 0)
    ends = (place for sign, place, depth in signs[first:] if sign in _BLANK[:2] and depth == 0)
    return string[: next(ends, len(string))][signs[first][1] if signs else 0 :]


def _is_equation(string: str) -> bool:
    """Return whether a piece has an equals sign of its own and begins with no word."""
    is_word = string.lstrip().startswith((r"\text", r"\mbox", r"\mathrm{if", r"\mathrm{for"))
    return not is_word and any(s in _EQUALITY and not d for s, _, d in walk_signs(string))
