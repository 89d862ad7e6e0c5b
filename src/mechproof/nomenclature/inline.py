"""Equations within sentences that a draft proposes: sizes of letters, and what they stand for.

Also the quantities that sentences state without a letter: "a bolt with an area of 157 mm²".
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass

import sympy as sp

from mechproof.latex.words import OPENS_TEXT
from mechproof.nomenclature.cells import Numeral, find_unit, name_unit, read_numeral
from mechproof.nomenclature.shown_letters import name_symbol
from mechproof.record.unit_notation import ONE, Unit, read_unit
from mechproof.sources.displays import Printed, hide_displays
from mechproof.sources.macros import expand, find_macros
from mechproof.sources.paper_files import Source

_INLINE = re.compile(r"(?<![\\$])\$(?P<dollar>[^$]{1,120}?)\$|\\\((?P<bracket>.{1,120}?)\\\)")
EQUATION = re.compile(
    r"\s*(?P<letter>[^=<>]+?)\s*=\s*(?P<value>[^=<>]+?)(?P<rest>(?:\s*=[^=<>]+)*?)\s*[.,;]?\s*\Z"
)
# A multiple of a letter.
_MULTIPLE = re.compile(r"(?P<number>\d+)\s*(?P<letter>\\?[A-Za-z].*)")
RATE = re.compile(r"\\dot\s*\{?\s*(\\?[A-Za-z]+)\s*\}?")
# A letter with the letter that a sentence says it depends on: M(x).
CALL = re.compile(r"(?P<stem>.+?)\s*\(\s*(?P<by>(?!\\pi\s*\))\\?[A-Za-z]+)\s*\)")
_INDEXED = re.compile(r"(?P<stem>.+?)_\{?(?P<index>\\?[A-Za-z]+)\}?")
_DIGITS = re.compile(r"\A[-+\d.,{}\s]+")
# Words in front of something that holds in one case; "at" in front of a speed's value is not one.
_CASE = re.compile(
    r"\b(?:(?:when(?:ever)?|if|once|until|at|for)\s+"
    r"|(?:at|with|under|assuming)\s+(?:(?:the|an?)\s+)?[a-z]+(?:\s+[a-z]+)?,\s+)\Z",
    re.IGNORECASE,
)
# Words of a sentence that defines no letter: it denies, assumes, solves or mentions a position.
_NO_DEFINITION = re.compile(
    r"\b(?:not|never|nor|unless|instead|rather|wrong\w*|special|case|small|approximat\w+|initial\w*"
    r"|instant|moment|optim\w+|extrem\w+|maxim\w+|minim\w+|largest|smallest|greatest|least|stationary"
    r"|equilibri\w+|critical|roots?|zeros?|solutions?|suppos\w+|assum\w+|cho(?:os|s)\w+|taking|setting"
    r"|(?:in|at)\s+the\s+(?:middle|cent(?:re|er)|beginning|start|end|top)"
    r"|gives?|yields?|obtain\w*|follows?|at\s+\$t\s*=[^$]*\$)(?!\w)[^.;:$]*\Z",
    re.IGNORECASE,
)
_DEFINING = re.compile(r",\s*(?:with|where)\s+\Z")
# Words for a constant speed, and for one that changes.
_STEADY = re.compile(r"(?<!not\s)\b(?:constant|uniform(?:ly)?)\b")
_VARYING = re.compile(r"\b(?:not\s+constant|var(?:y|ies|ying|iable)|accelerat\w+|changes?)\b")
_BEFORE = 70
# An equation that another one is joined to, and how many characters are searched for it.
_JOINED = re.compile(r"\$[^$=]+=[^$]+\$,?\s+(?:and|or)\s+\Z")
_FAR = 300
# Commas between equations, but not decimal commas or those in brackets or braces.
_COMMA = re.compile(r",(?!\d)(?![^{}]*\})(?![^()]*\))")
# A unit of one letter, without braces: 3\,\mathrm m.
_UPRIGHT = re.compile(r"\\(?:mathrm|text)\s+([A-Za-z])(?![A-Za-z])")
# What separates the equations of one display.
_PARTS = re.compile(rf"\\q?quad(?![A-Za-z])|(?<![_{{]){OPENS_TEXT}[^{{}}]*\}}")
_SIGNS = re.compile(r"=|\\approx(?![A-Za-z])|&")
# Angles are declared in radians.
_MEANT = {"°": "rad"}
_QUANTITY = re.compile(r"\\(?:SI|qty)\s*\{([^{}]*)\}\s*\{([^{}]*)\}|\\ang\s*\{([^{}]*)\}")
_SAID = re.compile(r"(?<![\w.,^{}/])(?P<digits>\d+(?:[.,]\d+)?)(?![\w])(?P<after>.{1,30})", re.S)
_AFTER = 30
# Where the unit after a number may end; not after the word "in", which is not an inch.
_ENDS = re.compile(r"(?<! in)(?=[\s.,;:)])|\Z")


@dataclass(frozen=True)
class Inline:
    """What a sentence says of a letter, in which line, and whether it concerns a special case.

    `is_varying` marks sentences about a change; `end` is the place after it in the text, `offset`
    its place in the files; `others` are further members of a chain, `by` is the letter that it is
    said to depend on.
    """

    letter: str
    value: str
    line: int
    number: Numeral | None
    unit: str = ""
    is_case: bool = False
    is_varying: bool = False
    end: int = 0
    offset: int = 0
    others: tuple[str, ...] = ()
    by: str = ""

    def write_size(self, unit: str) -> str:
        """Return the size in a unit, "" if its dimension differs."""
        assert self.number is not None
        own, meant = self.number.unit or ONE, read_unit(unit)
        if own.dimension != meant.dimension:
            return ""
        if own.dimension.is_angle and own.scale == sp.pi / 180:
            return rf"{self.number.digits}^\circ"
        return f"{self.number.digits} {self.unit}".strip()


def find_inline(source: Source, letters: Collection[str]) -> Iterator[Inline]:
    """Yield the values that sentences give to letters of the equations."""
    names = {name_symbol(letter): letter for letter in letters}
    text = hide_displays(source.text.string)
    macros = {defined.name: defined.macro for defined in find_macros(source.text)[0]}
    for match in _INLINE.finditer(text):
        inside = source.text[slice(*match.span("dollar" if match["dollar"] else "bracket"))]
        offset = source.text.offsets[match.start()]
        line = source.files.locate(offset).line
        after, _ = _find_unit_after(text[match.end() : match.end() + _AFTER])
        before = _drop_joined(text[max(match.start() - _FAR, 0) : match.start()])[-_BEFORE:]
        sentence = before.rpartition(".")[2] + text[match.end() :][:_BEFORE].partition(".")[0]
        is_varying = bool(_VARYING.search(sentence)) and not _STEADY.search(sentence)
        for letter, value, others, by in _read_equations(expand(inside, macros).string, names):
            number, unit = read_quantity(value, name_unit(after))
            is_case = (letter in letters and bool(_CASE.search(before))) or defines_nothing(before)
            words = (is_case, is_varying, match.end(), offset)
            yield Inline(letter, value, line, number, unit, *words, others, by)


def _drop_joined(before: str) -> str:
    """Return the words before an equation, or before the equations that it is joined to."""
    while (shorter := _JOINED.sub("", before)) != before:
        before = shorter
    return before


def _read_equations(
    text: str, names: Mapping[str, str]
) -> Iterator[tuple[str, str, tuple[str, ...], str]]:
    """Yield the letters that equations give: value, other members, letter it depends on."""
    parts = _COMMA.split(text)
    for part in parts if all("=" in one for one in parts) else [text]:
        if not (found := EQUATION.match(part)):
            continue
        others = tuple(other.strip() for other in found["rest"].split("=")[1:])
        members = (found["letter"], found["value"], *others)
        if others and all(name_symbol(one) in names for one in members[:-1]):
            # Several letters with one value, a=b=5.
            yield from ((names[name_symbol(one)], members[-1], (), "") for one in members[:-1])
        elif letter := _find_letter(found["letter"], found["value"], names):
            yield (*letter[:2], others, letter[2])


def _find_letter(left: str, value: str, names: Mapping[str, str]) -> tuple[str, str, str] | None:
    """Return the letter that is alone on a side, its value, and the letter that it depends on."""
    if (rate := RATE.fullmatch(left)) and name_symbol(rate[1]) in names:
        return left, value, ""
    if (times := _MULTIPLE.fullmatch(left)) and name_symbol(times["letter"]) in names:
        return names[name_symbol(times["letter"])], rf"\frac{{{value}}}{{{times['number']}}}", ""
    if name_symbol(left) in names:
        return names[name_symbol(left)], value, ""
    call = CALL.fullmatch(left)
    letter = names.get(name_symbol(call["stem"])) if call else None
    return (letter, value, call["by"]) if call and letter else None


def defines_nothing(before: str) -> bool:
    """Return whether the words in front of an equation show that it defines no letter."""
    return bool(_NO_DEFINITION.search(before)) and not _DEFINING.search(before)


def _find_unit_after(text: str) -> tuple[str, Unit]:
    """Return the longest print of a unit that begins a text, and the unit; ("", ONE) if none."""
    ends = [end.start() for end in _ENDS.finditer(text)]
    units = ((text[:end], find_unit(text[:end])) for end in reversed(ends))
    return next(((printed, unit) for printed, unit in units if unit), ("", ONE))


def read_quantity(value: str, after: str = "") -> tuple[Numeral | None, str]:
    """Return a number and its unit, which may follow it as `after`; (None, "") if none."""
    plain = _UPRIGHT.sub(r"\\mathrm{\1}", value)
    plain = _QUANTITY.sub(lambda one: one[3] + r"^\circ" if one[3] else one[1] + one[2], plain)
    if after and _DIGITS.fullmatch(bare := plain.replace(r"\,", "").rstrip("\\")):
        plain = rf"{bare}\,\mathrm{{{after}}}"
    number = read_numeral(plain, decimal_comma="{,}" in plain)
    unit = name_unit(_DIGITS.sub("", plain)) if number and number.unit else ""
    return number, _MEANT.get(unit, unit)


def find_printed_units(displays: Iterable[Printed]) -> Iterator[tuple[str, str, int]]:
    """Yield letters that begin displays, the unit of their number, and its place."""
    for printed in displays:
        for part in _PARTS.split(printed.latex.string):
            letter, *members = _SIGNS.split(part)
            units = (read_quantity(member.strip(" \n.,;~"))[1] for member in members)
            if unit := next(filter(None, units), ""):
                yield letter.strip(), unit, printed.latex.offsets[0]


def say_of_others(one: Inline, letters: Collection[str]) -> Iterator[tuple[str, str]]:
    r"""Yield letters with values by analogy: c_\beta and \cos\beta for c_\alpha=\cos\alpha."""
    own = _INDEXED.fullmatch(one.letter)
    names = {name_symbol(letter) for letter in letters}
    for letter in letters if own and own["index"] in one.value else ():
        other = _INDEXED.fullmatch(letter)
        is_like = own and other and other["stem"] == own["stem"] and other["index"] != own["index"]
        if own and other and is_like and name_symbol(other["index"]) in names:
            yield letter, one.value.replace(own["index"], other["index"])


@dataclass(frozen=True)
class SaidQuantity:
    """The digits and unit of a number in the text, its place and its line."""

    digits: str
    unit: Unit
    text: str
    place: int
    line: int


def find_quantities(source: Source) -> Iterator[SaidQuantity]:
    """Yield the numbers with a unit outside displays."""
    text = hide_displays(source.text.string)
    for match in _SAID.finditer(text):
        printed, unit = _find_unit_after(match["after"])
        if printed:
            line = source.files.locate(source.text.offsets[match.start()]).line
            shown = f"{match['digits']}{printed}".replace("$", "").strip()
            digits = match["digits"].replace(",", ".")
            yield SaidQuantity(digits, unit, " ".join(shown.split()), match.end("digits"), line)
