"""What the text of a paper says of its letters: meaning, unit and size, matched by layout.

A sentence ("$r$ is the radius"), an item of a list that begins or ends with a letter, the first
columns of a table. Words are matched, not understood.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from mechproof.nomenclature.cells import name_unit
from mechproof.nomenclature.shown_letters import name_symbol
from mechproof.record.unit_notation import UnitError, read_unit
from mechproof.sources.paper_files import Source

_NAME = r"\$(?P<name>[^$&|\n]{1,30}?)\s*=?\s*\$"
_UNIT = (
    r"(?:\s*(?:\[([^\]\[]{1,12})\]|\(in\s+([^)]{1,12})\)"
    r"|,?\s+in\s+(rad|deg|rpm|[kMmc]?(?:m|g|N|Nm|Pa|W|Hz|s))\b))?"
)
# A unit right after letters: "a mass $m$ in kg", "the force $F$ [N]".
_MULTIPLE = r"(?:rad|deg|°|rpm|[kMmcµ]?(?:m|g|N|Nm|Pa|W|J|Hz|s)|min)(?:\^?\{?-?[1-3]\}?)?"
_SAID_UNIT = rf"{_MULTIPLE}(?:\s*[/·]\s*{_MULTIPLE}){{0,2}}(?![\w/^])"
_BESIDE = re.compile(
    r"(?P<list>(?:\$[^$&|\n=<>]{1,30}\$(?:\s*,\s*|,?\s+and\s+))*)\$(?P<name>[^$&|\n=<>]{1,30})\$[\s~]*"
    rf"(?:\[(?P<square>[^\]\[]{{1,40}})\]|\((?:in\s+)?(?P<round>{_SAID_UNIT}|\\[^()]{{1,40}})\)"
    rf"|,?\s*in\s+(?P<plain>{_SAID_UNIT}))"
)
_VERBS = r"(?:is|are|denotes?|represents?|stands? for|means|being|:|--|---|\u2013|\u2014)"
_ARTICLE = r"(?:the\s+|an?\s+)?"
# An "and" that ends a meaning, unlike that of "the rear and front wheel".
_AND = (
    r"\s+and\s(?!(?!the\b|an?\b|it|we\b|they\b|th[ai]|has\b|is\b)"
    r"(?:[a-z-]+[ ]){0,2}[a-z-]+\s*[.,;:(])"
)
# A list of letters with a common list of meanings; commas do not end these.
_NAMES = (
    r"(?P<name>(?:\$[^$&|\n]{1,30}\$\s*(?:,\s*(?:and\s+)?|and\s+)){1,6}\$[^$&|\n]{1,30}\$"
    r"|\$(?:(?:[^$&|\n{},]|\{[^{}$]*\}){1,30},){1,6}[^$&|\n]{1,30}\$)"
)
_BEHIND = r"(?=[.;:(\n\\$]|,[^.,;:\n]*\$|,\s+(?:wh|so|with|but)|\s+and\s[^.,;:\n]{0,30}\$)"
_BULLET = r"^[ \t]*(?:[-*+]|\\item|\d+\.)[ \t]+"
# A noun right in front of its letters: "the crank radius $r$", "a rod of length $l$ and mass $m$".
_NO_NAME = (
    r"(?:the|an?|of|with|and|or|for|from|by|at|to|in|on|as|is|are|be|has|have|that|this|these|those"
    r"|its|their|which|where|when|if|then|thus|hence|let|all|any|every|each|both|some|no|small|large"
    r"|constant|given|fixed|positive|negative|zero|using|eliminating|solving|taking|setting|inserting"
    r"|gives?|yields?|obtain|denotes?|calls?|cases?|equations?|relations?|formulas?|letters?|symbols?"
    r"|functions?|points?|between|into|we|it|respect)\b"
)
_WORD = rf"(?!{_NO_NAME})[A-Za-z][a-z-]+"
# Properties of things: "a crank of radius $r$" is about the radius.
_HAD = (
    r"(?:(?:[a-z]+\s)?(?:radius|diameter|length|width|height|mass|weight|stiffness|speed|area)\b)"
)
_CHANGE = r"(?:changes?|increases?|decreases?|differences?|variations?|deviations?|errors?)"
_NOUN = (
    rf"(?:{_CHANGE}\s+(?:of|in)\s+(?:the\s+)?{_WORD}"
    rf"|{_WORD}(?:\s+{_WORD}){{0,2}}(?:\s+of\s+(?:the\s+)?(?!{_HAD}){_WORD}(?:\s+{_WORD})?)?)"
)
_ALONE = r"\$[^$&|\n=<>]{1,30}\$"
_PATTERNS = (
    re.compile(
        r"(?:\b(?:[Tt]he|[Aa]n?|[Oo]f|[Ww]ith|[Aa]nd|[Ff]or|[Ff]rom|[Bb]y)\s|,\s)\s*"
        rf"(?P<meaning>{_NOUN})\s+(?P<name>{_ALONE}(?:(?:\s*,\s*|\s+and\s+){_ALONE})*)"
    ),
    re.compile(
        rf"{_NAME}\s*{_VERBS}\s+{_ARTICLE}(?P<meaning>[^.,;:$\\\n(\[]{{3,60}}?)"
        rf"{_UNIT}(?=[.,;:(\n\\$]|{_AND})"
    ),
    re.compile(
        rf"{_NAMES}\s+(?:are|denote|represent|stand for)\s+{_ARTICLE}"
        rf"(?P<meaning>[^.;:$\\\n(\[]{{3,80}}?){_UNIT}{_BEHIND}"
    ),
    re.compile(
        rf"(?:\b(?:[Ll]et|and|[Hh]ere|[Ww]here|[Ww]ith)|,)\s+{_NAME}\s+(?:be\s+)?the\s+(?P<meaning>[^.,;:$\\\n(\[]{{3,60}}?)"
        rf"{_UNIT}(?=[.,;:(\n\\$]|{_AND})"
    ),
    re.compile(
        rf"(?:\b(?:[Ll]et|and|[Hh]ere|[Ww]here|[Ww]ith)|,)\s+{_NAMES}\s+(?:be\s+)?the\s+"
        rf"(?P<meaning>[^.;:$\\\n(\[]{{3,80}}?){_UNIT}{_BEHIND}"
    ),
    re.compile(
        rf"{_BULLET}{_NAME}[ \t]*[:,]?[ \t]*(?P<meaning>[^\W\d_][^.,;:$\\\n(\[]{{2,60}}?)"
        rf"{_UNIT}[ \t]*(?=[.,;:(\n\\]|\Z)",
        re.MULTILINE,
    ),
    # A line between line breaks, whatever the verb of its language is.
    re.compile(
        rf"^[ \t]*{_NAME}[ \t]+(?P<meaning>[^\W\d_][^.,;:$\\\n(\[]{{2,60}}?)"
        rf"{_UNIT}[ \t]*[.,;]?[ \t]*(?=\\newline|\\\\)",
        re.MULTILINE,
    ),
    re.compile(
        rf"{_BULLET}(?P<meaning>[^\W\d_][^.,;:$\\\n(\[]{{2,60}}?)[ \t]*[:,]?[ \t]+{_NAME}"
        rf"{_UNIT}[ \t]*[.,;]?[ \t]*$",
        re.MULTILINE,
    ),
    re.compile(
        r"^\s*\$(?P<name>[^$&]{1,30})\$\s*&\s*(?P<meaning>[^&$\\\n]{3,60}?)\s*"
        r"(?:&\s*(?:\\si\{)?\$?([^&$\\\n{}]{0,12})\$?\}?\s*)?(?:&[^\n]*)?(?:\\\\|$)",
        re.MULTILINE,
    ),
    re.compile(
        rf"^[ \t]*\|[ \t]*{_NAME}[ \t]*\|[ \t]*(?P<meaning>[^|$\\\n(\[]{{3,60}}?)[ \t]*"
        r"(?:\[([^\]\[]{1,12})\]|\([^)|]*\))?[ \t]*\|"
        r"(?:[ \t]*\[?([^|$\\\n\[\]]{1,12})\]?[ \t]*\|)?",
        re.MULTILINE,
    ),
)
# Words that begin a meaning, or are all of it, and say what is done with a letter, not what it is.
_NO_NOUN = re.compile(
    r"(?:defined|given|called|denoted|obtained|chosen|equal|shown|known|found|used|assumed|said|taken"
    r"|determined|computed|calculated|expressed|proportional|independent|related|less|greater|smaller"
    r"|[a-z]+\s+to\s+be|[a-z]+ed\s+(?:at|by|in|on|to|with|from|between)|larger|not|also|then|thus|as|to|in|on|at|by|of|for|from|with|always|never|only)\b"
    r"|(?:constant|positive|negative|small|large|fixed|zero|unknown|variable)s?\Z"
    # A clause of its own: "with $a$, $b$ the length of the path is", "the belt couples $a$".
    r"|.*\b(?:is|are|becomes?|equals?|reads?|follows|couples|relates|connects)\Z"
    # The bullet of an item after a colon.
    r"|[\W\d]*\Z"
)
# Asterisks that emphasize words in Markdown.
_EMPHASIS = re.compile(r"(?<=\w)\*+|\*+(?=\w)")
# Separators of letters in a list, but not in indices.
_BETWEEN = re.compile(r",(?![^{}]*\})|\band\b")
_RESPECTIVELY = re.compile(r",?\s*respectively")
_ITEMS = re.compile(r",\s*(?:and\s+)?(?:the\s+)?|\s+and\s+(?:the\s+)?")
# A line break within a sentence.
_WRAPPED = re.compile(r"(?<=\w)\n(?=[ \t]*[a-z])")
_INLINE = re.compile(r"\\([()])")
# Words by which a sentence is about the number pi itself.
_NUMBER = re.compile(r"circ|constant|number|approx|irrational|3[.,]1", re.IGNORECASE)


@dataclass(frozen=True)
class Said:
    """What the text says of a letter, and in which line."""

    meaning: str
    unit: str
    line: int


def find_said(source: Source) -> Iterator[tuple[str, Said]]:
    """Yield letters with their meanings; of several meanings of a letter, the last one counts."""
    string = _write_inline(source)
    for pattern in _PATTERNS:
        for match in reversed(list(pattern.finditer(string))):
            named = {*match.groupdict().values()}
            units = [group for group in match.groups() if group and group not in named]
            place = source.files.locate(source.text.offsets[match.start("name")])
            letters = [name.strip(" $") for name in _BETWEEN.split(match["name"])]
            letters = [name for name in letters if name]
            for name, meaning in zip(letters, _share(match["meaning"], len(letters)), strict=True):
                if not _NO_NOUN.match(meaning):
                    yield name_symbol(name), Said(meaning, _check_unit(units), place.line)


def _write_inline(source: Source) -> str:
    """Return a text of the same length with dollars around letters, and sentences on one line."""
    string = _INLINE.sub(lambda match: " $" if match[1] == "(" else "$ ", source.text.string)
    return _WRAPPED.sub(" ", string)


def find_units(source: Source) -> Iterator[tuple[str, str, int]]:
    """Yield letters in sentences with the unit printed after them, and their places.

    A unit in words, "in mm", applies to all letters of a list, one in brackets to the last only.
    """
    for match in _BESIDE.finditer(_write_inline(source)):
        said = next(filter(None, match.group("square", "round", "plain")))
        unit = name_unit(said)
        if not any(map(str.isalpha, unit.replace("°", "d"))):
            continue
        others = _BETWEEN.split(match["list"]) if match["plain"] else []
        for name in (*others, match["name"]):
            if letter := name.strip(" $"):
                yield letter, unit, source.text.offsets[match.start("name")]


def find_pi(said: Mapping[str, Said]) -> Said | None:
    r"""Return what the text says of a letter \pi; None if it is about the number."""
    found = said.get("pi")
    return None if found is None or _NUMBER.search(found.meaning) else found


def _share(text: str, count: int) -> list[str]:
    """Return the meaning of each of `count` letters: "radius and length, respectively"."""
    meaning = " ".join(_EMPHASIS.sub("", text).split()).strip(" ~*_")
    items = _ITEMS.split(_RESPECTIVELY.sub("", meaning))
    is_shared = len(items) != count or not _RESPECTIVELY.search(meaning)
    return [meaning] * count if is_shared else items


def _check_unit(units: list[str]) -> str:
    try:
        read_unit(units[0].strip()) if units else None
    except UnitError:
        return ""
    return units[0].strip() if units else ""
