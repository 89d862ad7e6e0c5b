"""Displayed equations of a text, numbered as LaTeX numbers them; commas and points in numbers.

Commas and points between digits are decimal, or separate thousands, 1{,}000.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate, count, pairwise

from mechproof.sources.announcements import NOTHING, Announced
from mechproof.sources.equation_numbers import Counter
from mechproof.sources.lines import (
    begins_with_sign,
    cut_gaps,
    cut_remark,
    goes_on,
    join_lines,
    split_lines,
)
from mechproof.sources.located_text import Files, LocatedText, Place, join
from mechproof.sources.macros import Defined, Macro, expand, find_macros
from mechproof.sources.paper_files import DocumentError
from mechproof.sources.plain_displays import (
    BUILT_IN,
    FRAMES,
    list_braced,
    write_frames,
    write_plainly,
)
from mechproof.sources.tabulars import TABLES

_NAMES = r"(?:equation|(?:fl)?align(?:at)?|gather|multline|(?:IEEE)?eqnarray|dmath)\*?|displaymath"
# Told to users: which equations are looked for in a text.
EXPECTED = (
    r"equations are displays, \begin{equation}…\end{equation} and the like (align, gather, "
    r"multline, IEEEeqnarray), \[…\] or $$…$$, not formulas between single $"
)
_EVENT = re.compile(
    rf"\\begin\{{(?P<environment>{_NAMES})\}}(?P<body>(?:(?!\\begin\{{(?:{_NAMES})\}}).)*?)"
    r"\\end\{(?P=environment)\}"
    r"|(?<!\\)\\\[(?P<bracket>.*?)\\\]|\$\$(?P<dollars>.*?)\$\$"
    r"|(?<![\\$])\$(?P<inline>[^$\n]+\$\$[^$\n]+)\$(?!\$)"
    r"|\\(?P<edge>begin|end)\{subequations\}"
    r"|\\(?P<heading>section|subsection|chapter)(?P<star>\*?)(?![A-Za-z])"
    r"|\\numberwithin\s*\{equation\}\s*\{(?P<within>\w+)\}"
    r"|\\(?:counterwithin\*?\s*\{equation\}|@addtoreset\s*\{equation\})\s*\{(?P<reset>\w+)\}"
    r"|\\renewcommand\*?\s*\{?\s*\\theequation\s*\}?\s*(?P<shown>\{(?:[^{}]|\{[^{}]*\})*\})"
    r"|\\setcounter\s*\{equation\}\s*\{(?P<count>\d+)\}"
    r"|\\addtocounter\s*\{equation\}\s*\{(?P<more>-?\d+)\}"
    r"|\\(?P<appendix>appendix)(?![A-Za-z])"
    rf"|(?P<opened>\\begin\{{(?:{_NAMES})\}}|(?<!\\)\\\[|^\$\$)(?P<rest>[^\n]*)",
    re.DOTALL | re.MULTILINE,
)
# A display or a table, outside of which are the sentences of a text.
_UNSAID = rf"{_NAMES}|(?:{'|'.join(FRAMES)})\*?|{TABLES}"
DISPLAY = re.compile(
    rf"\$\$.*?\$\$|(?<!\\)\\\[.*?\\\]|\\begin\{{(?P<name>{_UNSAID})\}}.*?\\end\{{(?P=name)\}}",
    re.DOTALL,
)
# Displays that are one equation with one number, however many lines they have.
_SINGLE = ("", "equation", "displaymath", "multline")
# The argument of a display that gives the number of its columns, or their alignment.
_COLUMNS = re.compile(r"\A\s*\{(?:\d+|[A-Za-z'\"?,:;./*\s]+)\}")
# Beginnings and ends of displays that a macro, or an environment of the paper, may abbreviate.
_FRAMING = re.compile(r"\\(?:begin|end)\s*\{|\\[\[\]]|\$\$")
_DISPLAYING = re.compile(rf"\\(?:begin|end)\{{(?:{_NAMES}|{'|'.join(FRAMES)})\}}|\\[\[\]]|\$\$")
_LABEL = re.compile(r"\\label\s*\{([^{}]*)\}")
_CITE = re.compile(r"\\cite\s*(?:\[[^\[\]]*\]\s*)*\{([^{}]*)\}")
_TAG = re.compile(r"\\tag(\*?)\s*\{((?:[^{}]|\{[^{}]*\})*)\}")
# A number next to an equation that is not a tag, as in Markdown; dots or a dash may lead to it.
_BESIDE = re.compile(
    r"\\q?quad(?:\\q?quad|\\[,;:! ]|\s|[-\u2013\u2014\u2026]|\.{2,}|\\[cl]?dots)*"
    r"\((\d+(?:\.\d+)*[a-z]?)\)[\s.,;]*\Z"
)
_UNNUMBERED = re.compile(r"\\(?:IEEE)?(?:nonumber|notag)(?![A-Za-z])")
# The commands of IEEEeqnarray that number a line, (2), and one below the preceding number, (2a).
_NUMBERED = re.compile(r"\\IEEEyes(?:sub)?number\*?(?![A-Za-z])")
_BELOW = re.compile(r"\\IEEEyessubnumber(?![A-Za-z])")
_NAMING = re.compile("|".join(p.pattern for p in (_LABEL, _CITE, _TAG, _UNNUMBERED, _NUMBERED)))
_COMMA = re.compile(r"(?<=\d)\{,\}(?=\d)")
_NUMBER = re.compile(r"(?<![\d.])\d+(?:\{,\}\d+)+")
_THOUSANDS = re.compile(r"[1-9]\d{0,2}(?:\{,\}\d{3})+")
# With this package a comma is decimal unless a blank follows; in indices it separates numbers.
_ICOMMA = re.compile(r"\\usepackage\s*(?:\[[^\]]*\])?\s*\{[^{}]*\bicomma\b[^{}]*\}")
_DECIMAL = re.compile(r"_\{[^{}]*\}|\\(?:\w*ref|label|tag|cite)\*?\{[^{}]*\}|(?<=\d),(?=\d)")
_WORDS = re.compile(r"\\(?:text|mbox|\w*ref|label|tag)\w*\*?\s*\{[^{}]*\}")
# A point may also separate thousands: 1.500.
_PARTING = re.compile(r"(?<=\d)\.(?=\d{3}(?!\d))")
_POINT = re.compile(r"\d\.(?!\d{3}(?!\d))\d")


@dataclass(frozen=True)
class Printed:
    """One equation of a text: its name, its labels, its citations, its LaTeX, and its fault if any.

    Equations of one display have the same `group`; `announced` is what the words before it say of
    it. The first `taken` characters of its LaTeX are repeated from the end of the display before
    it.
    """

    name: str
    latex: LocatedText
    labels: tuple[str, ...] = ()
    fault: str = ""
    cites: tuple[str, ...] = ()
    group: int = 0
    announced: Announced = NOTHING
    taken: int = 0

    @property
    def offset(self) -> int:
        """Return the offset of the first character that is its own."""
        return self.latex.offsets[self.taken]

    def locate(self, files: Files, place: int = 0) -> Place:
        """Return the place of a character of its LaTeX, by default the first that is its own."""
        offsets = self.latex.offsets
        return files.locate(offsets[min(place or self.taken, len(offsets) - 1)])


def find_displays(text: LocatedText, *, cut: bool = True) -> Iterator[Printed]:
    """Yield the equations of a text in order; one without a number is called "display n".

    Unless `cut`, equations next to each other in one display stay together.
    Raises `DocumentError` for macros that stand for environments and call each other in a circle.
    """
    counter, unnumbered = Counter(), count(1)
    defined, text = _expand_frames(*find_macros(text))
    text = write_frames(text)
    group, last, announced, remark_before = 0, 0, NOTHING, ""
    before: Printed | None = None
    for match in _EVENT.finditer(text.string):
        if match["heading"]:
            if not match["star"]:
                counter.enter(match["heading"])
        elif match["edge"]:
            counter.group(match["edge"])
        elif match["within"] or match["reset"]:
            counter.within = match["within"] or match["reset"]
        elif match["shown"]:
            counter.shown = match["shown"]
        elif match["appendix"]:
            counter.begin_appendix()
        elif match["count"] or match["more"]:
            counter.count = int(match["count"] or counter.count + int(match["more"]))
        elif match["inline"] is not None:
            continue
        else:
            macros = {d.name: d.macro for d in defined if d.place < match.end()}
            words = text[last : match.start()]
            said = announced.go_on(words.string, words.offsets)
            if said.passage != announced.passage:
                remark_before = ""
            announced = said
            group, end = group + 1, match.end()
            if match["opened"]:
                yield _show_opened(text, match, f"display {next(unnumbered)}", group)
                last = end
                continue
            for found in _read_display(text, match, macros, counter, unnumbered, cut=cut):
                latex, remark = cut_remark(found.latex)
                # An equation without a remark, after one with a remark, is about something else.
                if remark or remark_before:
                    announced = announced.go_on(remark or remark_before)
                remark_before = remark
                printed = replace(found, latex=latex, group=group, announced=announced)
                if cut and before and not before.fault:
                    printed = _go_on(before, printed)
                before = printed
                yield printed
            last = end


def hide_displays(string: str) -> str:
    """Return a text with blanks for its displays and tables: sentences keep their places."""
    return DISPLAY.sub(lambda match: " " * len(match[0]), string)


def _show_opened(text: LocatedText, match: re.Match[str], name: str, group: int) -> Printed:
    """Return the first line of a display that has no end, with that fault."""
    rest = text[match.start("rest") : match.end()].strip()
    latex = rest if len(rest) else text[match.start("opened") : match.end("opened")]
    fault = f"{match['opened']} opens a display that is never closed"
    return Printed(name, latex, fault=fault, group=group)


def _go_on(before: Printed, printed: Printed) -> Printed:
    """Return an equation that begins with its relation sign, completed by the preceding display."""
    if not begins_with_sign(printed.latex.string):
        return printed
    taken = join([before.latex, before.latex.put(" ", -1)])
    return replace(printed, latex=taken + printed.latex, taken=len(taken))


def _expand_frames(
    defined: Sequence[Defined], text: LocatedText
) -> tuple[list[Defined], LocatedText]:
    """Expand the macros that abbreviate the beginning or the end of a display."""
    frames = {
        d.name: d.macro
        for d in defined
        if (_DISPLAYING if "{" in d.name else _FRAMING).search(d.macro.body)
    }
    cuts = [0, *(d.place for d in defined), len(text)]
    parts = [expand(text[a:b], frames) for a, b in pairwise(cuts)]
    places = accumulate(len(part) for part in parts[:-1])
    moved = [replace(d, place=place) for d, place in zip(defined, places, strict=True)]
    return moved, join(parts)


def _read_display(
    text: LocatedText,
    match: re.Match[str],
    macros: Mapping[str, Macro],
    counter: Counter,
    unnumbered: Iterator[int],
    *,
    cut: bool,
) -> Iterator[Printed]:
    environment = match["environment"] or ""
    kind = environment.rstrip("*")
    part = next(group for group in ("body", "bracket", "dollars") if match[group] is not None)
    body, fault = text[match.start(part) : match.end(part)], ""
    if kind in ("alignat", "IEEEeqnarray"):
        body = body.replace(_COLUMNS, lambda _: "")
    try:
        body = write_plainly(expand(body, {**BUILT_IN, **macros}))
    except DocumentError as error:
        fault = str(error)
    is_numbered = part == "body" and not environment.endswith("*") and kind != "displaymath"
    lines = split_lines(body)
    groups = [(0, len(lines))] if kind == "multline" else list(_group(lines))
    if kind in _SINGLE:
        parts = [p for first, last in groups for p in _read_lines(lines[first:last], kind, cut=cut)]
        named = [(_name(body, is_numbered, counter), body, parts)]
    else:
        names = [_name(line, is_numbered, counter) for line in lines]
        named = [
            (next(filter(None, names[first:last]), ""), join(lines[first:last]), parts)
            for first, last in groups
            for parts in [list(_read_lines(lines[first:last], kind, cut=cut))]
        ]
    for name, whole, parts in named:
        labels = tuple(found[1] for found in _LABEL.finditer(whole.string))
        cites = tuple(
            key.strip() for found in _CITE.finditer(whole.string) for key in found[1].split(",")
        )
        for number, latex in enumerate(parts, start=1):
            one = name or f"display {next(unnumbered)}"
            shown = f"{one}, part {number}" if name and len(parts) > 1 else one
            yield Printed(shown, latex, labels, fault, cites)


def _read_lines(lines: Sequence[LocatedText], kind: str, *, cut: bool) -> Iterator[LocatedText]:
    """Yield the equations of lines that belong together, without labels, tags and numbers."""
    plain = [line.replace(_NAMING, lambda _: " ").replace(_BESIDE, lambda _: " ") for line in lines]
    latex = join_lines(plain, has_columns=not kind.endswith("eqnarray"))
    yield from (piece for piece in (cut_gaps(latex) if cut else [latex.strip()]) if len(piece))
    if cut:
        yield from list_braced(latex)


def _group(lines: Sequence[LocatedText]) -> Iterator[tuple[int, int]]:
    """Yield the first line of each equation and the line after its last."""
    # Labels and tags are removed: they do not count as the end of a line.
    plain = [_NAMING.sub(" ", line.string) for line in lines]
    starts = [0] if lines else []
    for place in range(1, len(lines)):
        if not goes_on(" ".join(plain[starts[-1] : place]), plain[place]):
            starts.append(place)
    yield from zip(starts, [*starts[1:], len(lines)], strict=True)


def _name(line: LocatedText, is_numbered: bool, counter: Counter) -> str:
    if tag := _TAG.search(line.string):
        named = tag[2].replace(r"\%", "%")
        return named if tag[1] else f"({named})"
    if beside := _BESIDE.search(line.string):
        return f"({beside[1]})"
    if _BELOW.search(line.string):
        return counter.step_below(is_new=r"\IEEEyesnumber" in line.string)
    is_numbered = is_numbered and not _UNNUMBERED.search(line.string)
    return counter.step() if is_numbered or _NUMBERED.search(line.string) else ""


def mark_decimals(text: LocatedText) -> LocatedText:
    """Return a text with 3{,}5 for 3,5 if the text loads the package icomma."""
    if not _ICOMMA.search(text.string):
        return text
    return text.replace(_DECIMAL, lambda match: "{,}" if match[0] == "," else match[0])


def join_thousands(text: LocatedText) -> LocatedText:
    """Return a text without separators of thousands: commas, or points if commas are decimal."""
    numbers = _NUMBER.findall(text.string)
    if not numbers:
        return text
    prints = (_WORDS.sub(" ", one.latex.string) for one in find_displays(text))
    has_points = any(map(_POINT.search, prints))
    if not all(map(_THOUSANDS.fullmatch, numbers)):
        # If commas are decimal, points separate thousands.
        return text if has_points else text.replace(_PARTING, lambda match: "")
    return text.replace(_COMMA, lambda match: "") if has_points else text
