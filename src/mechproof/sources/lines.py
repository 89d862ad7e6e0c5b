"""A display -> its lines, and the equations that they make up.

A line that begins with a relation or an operator continues the one before it. A wide gap separates
equations, but leaves a condition with its equation.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from mechproof.latex.latex_signs import SPACING, same_sign
from mechproof.latex.printed_relations import EQUAL, RELATIONS
from mechproof.latex.several_equations import ARROWS, EQUIVALENCES
from mechproof.latex.words import OPENS_TEXT, OPENS_WORDS
from mechproof.sources.located_text import LocatedText, join

# Environments that only stack lines; between dollars, Markdown even has whole displays.
_WRAPPING = re.compile(
    r"\\(?:begin|end)\{(?:aligned|split|gathered|alignedat|multlined|align\*?|gather\*?|multline\*?"
    r"|equation\*?)\}"
    r"(?:\[[tbc]\])?(?:\{\d+\})?"
)
_SPACING = re.compile(SPACING)
# A brace in front of equations at the beginning of a line: a system, not the cases of a function.
_SYSTEM = re.compile(
    r"\\begin\s*\{d?cases\}|\\left\s*\\\{\s*(?:\\begin\s*\{(?:array|matrix)\}(?:\s*\{[lcr|\s]*\})?)?"
)
_TABLE_END = re.compile(r"\\end\s*\{(?:array|matrix)\}\s*\Z")
_INTERTEXT = re.compile(r"\\(?:short)?intertext\s*\{(?:[^{}]|\{[^{}]*\})*\}")
_STEP = re.compile(
    r"\\begin\s*\{[^{}]*\}|\\end\s*\{[^{}]*\}|\\\\"
    r"|\\(?:left|right)(?![A-Za-z])\s*(?:\\[A-Za-z]+|\\.|.)"
    r"|\\[A-Za-z]+|\\.|.",
    re.DOTALL,
)
_BRACKETS = {"{": "}", "(": ")"}
# Brackets that lines and columns never split; round ones may continue on the next line.
_BRACES = {"{": "}"}
_EQUALITY = (*EQUAL, r"\approx")
_OPERATORS = ("+", "-", "/", r"\cdot", r"\pm", r"\mp")
_WIDE, _NARROW = (r"\quad", r"\qquad"), (r"\,", r"\;", r"\:", r"\!")
_BLANK = (*_WIDE, *_NARROW, "\\ ", "&", "~", r"\displaystyle")
# Signs that continue an equation: \left. precedes the end of a bracket opened on another line.
_CONTINUING = (*RELATIONS, "+", r"\left.")
# What may separate an equation from the range of its index.
_BEFORE_RANGE = rf"(?:\\q?quad|\\[,;: ]|~|,|\s|{OPENS_WORDS}\s*(?:for|with|where)\s*\}}|\\forall)*"
_RANGE = re.compile(
    rf"{_BEFORE_RANGE}"
    r"(?<![A-Za-z])[a-z]\s*(?:=|\\in\s*\\\{)\s*\d+\s*,\s*(?:\d+\s*,\s*)*"
    r"(?:\\[lc]?dots|\.\.\.)\s*,?\s*(?:\d+|[A-Za-z])(?:\s*\\\})?\s*\Z"
)
# The values of an index one by one; for another letter, this may be a number with a decimal comma.
_LIST = re.compile(
    rf"{_BEFORE_RANGE}\(?\s*(?<![A-Za-z])([a-z])\s*=\s*\d+\s*(?:,(?:\s|\\,)*\d+\s*)+\)?\s*\Z"
)
# "For all x" says nothing of a letter that is real anyway; for i to n it may say that they count.
_ALL = re.compile(
    rf"{_BEFORE_RANGE}(?:\\forall|{OPENS_WORDS}\s*for (?:all|any|every)\s*\}})"
    r"(?:\s|~|\\[,;: ])*(?:(?![i-n])[A-Za-z]|\\[a-z]+)(?:_(?:\w|\{\w+\}))?\s*\Z"
)
_INDEX = r"_(?:\s*|\{{[^{{}}]*){}(?![A-Za-z])"
_TITLE_AT_START = re.compile(rf"\A\s*(?:{OPENS_WORDS}[^{{}}]*\}}|[A-Z])\s*:(?!\s*=)")
_LEADS = (*ARROWS, *EQUIVALENCES, r"\therefore")
_LINKS = r"and|or|resp\.?|hence|thus|therefore|so|so that|whence|i\.e\.|und|also|somit|et|donc|,|;"
_WORD = rf"{OPENS_WORDS}[\s\\;,~]*(?:{_LINKS})?[\s\\;,~]*\}}"
_SIGN_AT_END = re.compile(r"([=+-])(?:\s|\{\}|\\[,;:! ])*\Z")
_SIGN_AT_START = re.compile(r"(?:\s|\{\}|\\[,;:! ]|\\phantom\s*\{[^{}]*\})*([=+-])")
_ARROW = "|".join(map(re.escape, _LEADS))
# The numbers of the equations from which this one follows, if it contains no others:
# (3)\Rightarrow(5)\quad.
_NUMBER = r"\(\d+[a-z]?\)"
_FROM_AT_START = re.compile(
    rf"\A\s*{_NUMBER}(?:\s*,?\s*{_NUMBER})*\s*(?:{_ARROW})(?![A-Za-z])\s*"
    rf"(?:{_NUMBER}\s*(?:\\q?quad|:)|(?=[^\s(]))(?!.*{_NUMBER})",
    re.DOTALL,
)
_AND = re.compile(rf"(?:{_WORD}|(?:{_ARROW})(?![A-Za-z])\s*)\Z")
_LINK_AT_START = re.compile(rf"\A\s*{_WORD}")
_BETWEEN = re.compile(_WORD)
# Cases, whose conditions do not apply to the whole equation.
_PIECES = re.compile(r"\\begin\s*\{(d?cases|array)\}.*?\\end\s*\{\1\}", re.DOTALL)
# Words for a condition in brackets: \text{ring held }(n=0), \text{(ring held, }n=0).
_CLOSED = re.compile(rf"{OPENS_TEXT}\s*\)\s*\}}")
_REMARK = re.compile(
    rf"{OPENS_TEXT}(?P<words>[^{{}}()]*(?:\([^{{}}()]*\}}|\}}\s*\())(?=[^()]*(?:[=<>]|\\[gl]e)[^()]*\)\W*\Z)"
)
# With one of these words the condition is a different one.
_EXCLUDING = re.compile(
    rf"\b(?:{_LINKS}|unless|except|excluding|outside|else|otherwise|but|apart"
    r"|not (?:if|for|at|when|with)|au\xdfer|sonst|sauf|sinon|кроме|иначе)\b",
    re.IGNORECASE,
)
# Words after an equation, in brackets or after a gap.
_BEHIND = re.compile(
    r"(?:\\q?quad(?:\s|\\[,;:! ]|~)*|(?:\\left)?\(\s*|(?=\\[a-z]+\s*\{\s*\())"
    rf"{OPENS_TEXT}(?P<words>[^{{}}$\\<>=?]*)\}}"
    r"(?:\s*(?:\\right)?\))?[\s.,;~]*\Z"
)
# Such words are a remark if one of them is not a unit, and none denies or measures.
_PLAIN_WORD = re.compile(
    r"\b(?!(?:\w*(?:met(?:er|re)|gram)|newton|pascal|watt|joule|degree|radian|second|minute|hour"
    r"|hertz|inch|feet|foot|pound|turn|revolution)(?:e?s)?\b)[^\W\d_]{4}",
    re.IGNORECASE,
)
_NUMBERED = re.compile(r"\([^()]*\d[^()]*\)")
_REFERENCE = re.compile(r"\b(?:see|cf|vgl|fig|eq|tab|sec)\b\.?", re.IGNORECASE)
_DENYING = re.compile(
    r"\b(?:not?|never|wrong|false|incorrect|invalid|impossible|contradict\w*|in|per|units?)\b",
    re.IGNORECASE,
)
_VALUE = re.compile(r"(?:[1-9]|\d\.?0)\s*\Z")
_CONDITION = re.compile(rf"{OPENS_WORDS}\s*(?:if|for|at|when|where|with)\b")


def split_lines(body: LocatedText) -> list[LocatedText]:
    r"""Cut a display at each \\ outside matrices, cases and braces."""
    body = body.replace(_WRAPPING, lambda _: " ").replace(_INTERTEXT, lambda _: r"\\ ")
    lines, start = [], 0
    for sign, place, depth in walk_signs(body.string, _BRACES):
        if sign == r"\\" and depth == 0:
            lines.append(body[start:place])
            spacing = _SPACING.match(body.string, place + 2)
            start = spacing.end() if spacing else place + 2
    kept = [line for line in (*lines, body[start:]) if line.string.strip(" \t\n&")] or [body]
    before = ["", *(line.string for line in kept[:-1])]
    return [part for pair in zip(kept, before, strict=True) for part in _open(*pair)]


def _open(line: LocatedText, before: str) -> Iterator[LocatedText]:
    """Yield the lines of the systems of equations that a line consists of."""
    latex = _drop_leads(line)
    brace = _SYSTEM.match(latex.string)
    signs = list(walk_signs(latex.string)) if brace else []
    close = next((n for n, (_, place, depth) in enumerate(signs) if place and not depth), None)
    has_equations = any(sign in RELATIONS for sign, _, _ in signs[:close])
    if not brace or close is None or not has_equations or ends_open(before):
        yield line
        return
    inside = latex[brace.end() : signs[close][1]].replace(_TABLE_END, lambda _: "")
    end = signs[close + 1][1] if close + 1 < len(signs) else len(latex)
    yield from split_lines(inside)
    rest = _clean(latex[end:])
    if len(rest):
        yield from _open(rest, "")


def walk_signs(
    string: str, brackets: Mapping[str, str] = _BRACKETS
) -> Iterator[tuple[str, int, int]]:
    """Yield the signs of a display as they are read, their places, and their depths of nesting."""
    depth = 0
    for match in _STEP.finditer(string):
        sign = match[0]
        if sign.startswith((r"\begin", r"\left")) or sign in brackets:
            depth += 1
        if sign.startswith((r"\end", r"\right")) or sign in brackets.values():
            depth = max(depth - 1, 0)
        yield same_sign(sign), match.start(), depth


def goes_on(before: str, line: str) -> bool:
    """Return whether a line belongs to the equation in front of it."""
    signs, signs_before = _list_signs(line), _list_signs(before)
    if not signs or not signs_before or ends_open(before):
        return True
    # The ends of an interval may be brackets of two kinds.
    opened, closed = (sum(sign in kind for sign in signs_before) for kind in ("([", ")]"))
    # The content of a coloured group counts as if it were outside.
    deepest = 1 if signs[0] == "{" else 0
    has_relation = any(s in RELATIONS and depth <= deepest for s, _, depth in walk_signs(line))
    return opened > closed or signs[0] in _CONTINUING or not has_relation


def begins_with_sign(line: str) -> bool:
    """Return whether a line begins with a sign of equality, so that its left side is missing."""
    return any(sign in _EQUALITY for sign in _list_signs(line)[:1])


def count_signs(line: str) -> int:
    """Return the number of relation signs of a line outside brackets."""
    return sum(sign in RELATIONS for sign, _, depth in walk_signs(line) if depth == 0)


def ends_open(line: str) -> bool:
    """Return whether a line ends with a sign that something must follow."""
    *before, last = ["", *_list_signs(line)]
    return last in (*RELATIONS, *_OPERATORS) and before[-1:] != ["^"]


def _list_signs(line: str) -> list[str]:
    return [sign for sign, _, _ in walk_signs(line) if not (sign.isspace() or sign in _BLANK)]


def join_lines(lines: Sequence[LocatedText], *, has_columns: bool = True) -> LocatedText:
    """Return lines as one equation, without alignment marks and leading arrows.

    Unless `has_columns` is false, every second alignment mark begins a new column.
    """
    parts: list[LocatedText] = []
    for line in lines:
        part = _drop_leads(join(list(_drop_alignment(line, has_columns))))
        parts[-2:-1] = [_drop_repeated(before, part) for before in parts[-2:-1]]
        parts += [part, line.put(" ", 0)]
    return _clean(join(parts))


def _drop_repeated(before: LocatedText, line: LocatedText) -> LocatedText:
    """Return a line without a sign at its end that the next line repeats at its beginning."""
    last, first = _SIGN_AT_END.search(before.string), _SIGN_AT_START.match(line.string)
    return before[: last.start()] if last and first and last[1] == first[1] else before


def _drop_alignment(line: LocatedText, has_columns: bool) -> Iterator[LocatedText]:
    start, signs = 0, 0
    for sign, place, depth in walk_signs(line.string, _BRACES):
        if sign == "&" and depth == 0:
            signs += 1
            yield line[start:place]
            if has_columns and signs % 2 == 0:
                yield line.put(r"\qquad ", place)
            start = place + 1
    yield line[start:]


def _drop_leads(latex: LocatedText) -> LocatedText:
    """Drop blanks and arrows in front of an equation."""
    for sign, place, _ in walk_signs(latex.string):
        if not (sign.isspace() or sign in _LEADS or sign in _BLANK):
            return latex[place:]
    return latex[len(latex) :]


def _clean(latex: LocatedText) -> LocatedText:
    """Drop titles, links and arrows in front of an equation, and the stop or range after it."""
    latex = latex.replace(_TITLE_AT_START, lambda _: "").replace(_LINK_AT_START, lambda _: "")
    latex = latex.replace(_FROM_AT_START, lambda _: "")
    latex = _drop_leads(latex).strip(end=".,;~")
    string = latex.string
    found = _RANGE.search(string) or _find_list(string) or _ALL.search(string)
    if found and found.start():
        latex = latex[: found.start()]
    while latex.string.endswith((*_WIDE, *_NARROW, ",\\")):
        latex = latex[: latex.string.rindex("\\")].strip(end=".,;~")
    return latex


def _find_list(string: str) -> re.Match[str] | None:
    """Return the values after an equation that one of its indices takes."""
    found = _LIST.search(string)
    is_index = found and re.search(_INDEX.format(found[1]), string[: found.start()])
    return found if is_index else None


def _drop_remarks(latex: LocatedText) -> LocatedText:
    """Drop the words for a condition in brackets, unless they may exclude it."""
    return latex.replace(_CLOSED, lambda _: ")").replace(
        _REMARK, lambda found: found[0] if _EXCLUDING.search(found["words"]) else r"\quad("
    )


def cut_remark(latex: LocatedText) -> tuple[LocatedText, str]:
    r"""Return an equation without the remark after it, \quad\text{(loop 1)}, and that remark.

    After a number, words may be its unit, unless they count something, (loop 1).
    """
    found = _BEHIND.search(latex.string)
    before = latex[: found.start()].strip(end=" .,;~") if found else latex
    words = found["words"].strip(" ~.,;") if found else ""
    is_number = _VALUE.search(before.string) and not _NUMBERED.fullmatch(words)
    is_other = _DENYING.search(words) or _EXCLUDING.search(words) or is_number
    is_remark = _PLAIN_WORD.search(words) or _REFERENCE.search(words)
    if is_other or not (is_remark and count_signs(before.string)):
        return latex, ""
    return _clean(before), f"({words.strip('()')})"


def cut_gaps(latex: LocatedText) -> Iterator[LocatedText]:
    """Yield the equations of a line, separated by wide gaps or by a word such as "or".

    A line that begins with an inequality is left whole, since this may be a condition of them all.
    """
    latex = _drop_remarks(latex)
    if _begins_with_inequality(latex.string):
        yield _clean(latex)
        return
    signs = list(walk_signs(latex.string))
    words = {found.start(): found.end() for found in _BETWEEN.finditer(latex.string)}
    places = {p: p for sign, p, depth in signs if sign in _WIDE and depth == 0}
    places |= {p: words[p] for _, p, depth in signs if p in words and depth == 0}
    start = 0
    for place in sorted(places):
        before, after = latex[start:place], latex[places[place] :]
        if _CONDITION.search(_PIECES.sub("", before.string)):
            continue
        if _is_equation(before.string) and _is_equation(_until_gap(after.string)):
            yield _clean(_drop_and(before))
            start = places[place]
    yield _clean(_drop_and(latex[start:]))


def _begins_with_inequality(string: str) -> bool:
    outside = [sign for sign, _, depth in walk_signs(string) if depth == 0]
    ends = (n for n, sign in enumerate(outside) if sign in (",", ";", *_WIDE))
    first = {*outside[: next(ends, 0)]} & {*RELATIONS}
    return bool(first) and first.isdisjoint(_EQUALITY)


def _drop_and(latex: LocatedText) -> LocatedText:
    latex = _clean(latex)
    found = _AND.search(latex.string)
    return _clean(latex[: found.start()]) if found else latex


def _until_gap(string: str) -> str:
    """Return the text between a gap and the next one."""
    signs = list(walk_signs(string))
    first = next((n for n, s in enumerate(signs) if not (s[0].isspace() or s[0] in _BLANK)), 0)
    ends = (place for sign, place, depth in signs[first:] if sign in _WIDE and depth == 0)
    return string[: next(ends, len(string))][signs[first][1] if signs else 0 :]


def _is_equation(string: str) -> bool:
    """Return whether a piece has an equals sign of its own and does not begin with a word."""
    is_word = string.lstrip().startswith((r"\text", r"\mbox", r"\mathrm{if", r"\mathrm{for"))
    return not is_word and any(s in _EQUALITY and not d for s, _, d in walk_signs(string))
