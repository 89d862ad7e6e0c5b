r"""Sentences of largest and smallest values -> equations that a draft proposes as rows.

"The largest value of $x$ is $r+l$", "$x$ reaches a maximum of $r+l$ at $\varphi=0$", or, behind the
display of a letter, "It reaches a maximum of $r+l$ at $\varphi=0$". Of a display x_{\max}=r+l it is
asked whether it is meant so.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from mechproof.nomenclature.inline import DISPLAY, EQUATION
from mechproof.nomenclature.shown_letters import name_symbol
from mechproof.sources.displays import Printed
from mechproof.sources.paper_files import Source

_KINDS = {
    **dict.fromkeys(("largest", "greatest", "maximum", "maximal", "highest"), "max"),
    **dict.fromkeys(("smallest", "least", "minimum", "minimal", "lowest"), "min"),
}
_KIND = rf"(?P<kind>{'|'.join(_KINDS)})"
_VALUE = r"\$(?P<value>[^$]{1,80})\$"
_PLACE = r"(?:,?\s+(?:at|for|when|where|if)\s+\$(?P<place>[^$]{1,40})\$)?"
_REACHES = (
    rf"(?:reaches|attains|takes|assumes|has)\s+(?:its|an?|the)\s+{_KIND}(?:\s+value)?"
    rf"(?:\s+of|,)?\s+{_VALUE}{_PLACE}"
)
_PATTERNS = (
    re.compile(
        rf"\b{_KIND}(?:\s+value)?\s+of\s+\$(?P<letter>[^$]{{1,40}})\$\s+"
        rf"(?:is|equals|becomes|amounts\s+to)\s+{_VALUE}{_PLACE}"
    ),
    re.compile(rf"\$(?P<letter>[^$]{{1,40}})\$\s+{_REACHES}"),
    re.compile(rf"\b(?:[Ii]t|[Tt]his|[Ww]hich)\s+{_REACHES}"),
)
_NUMBER = re.compile(
    r"[-\d.,\s{}]+(?:\\[,; ]?\s*\\(?:mathrm|text)\{[^{}]*\})?(?:\^\{?\\circ\}?)?\Z"
)
# A sentence with such a word may mean a case, or a part of the values.
_CASE = re.compile(
    r"\b(?:if|when|unless|without|for|range|interval|between|within|up\s+to|local|relative)\b", re.I
)
# A largest or least value that is printed as a letter, and marks of rates.
_NAMED = re.compile(
    r"\s*&?(?P<stem>[^_=&]+)_\{?\s*(?:\\mathrm\s*\{\s*|\\)?(?P<kind>max|min)\s*\}*(?P<primes>'*)"
    r"\s*&?=\s*(?P<value>[^=]+)"
)
_MARKS = re.compile(r"\\d*dot\b|[\s{}']")


def ask_extremes(displays: Sequence[Printed], running: Mapping[str, str]) -> Iterator[str]:
    """Yield the largest and least values that displays print, as claims to be confirmed."""
    known = {name_symbol(letter): by for letter, by in running.items() if by}
    for display in displays:
        if not (said := _NAMED.match(display.latex.string)):
            continue
        letter, value = said["stem"].strip() + said["primes"], said["value"].strip(" ,.;")
        if by := known.get(name_symbol(_MARKS.sub("", letter))):
            which = "largest" if said["kind"] == "max" else "least"
            yield f"# {display.name}: is that the {which} value of {letter} over all {by}?"
            yield rf"# claim \{said['kind']}_{{{by}}}{letter}={value}"


def find_extremes(source: Source, running: Mapping[str, str]) -> Iterator[str]:
    """Yield equations that sentences say, as claims; to be confirmed where they tell of a case.

    `running` are the letters of the equations with those on which they depend, or none.
    """
    names = {name_symbol(letter): letter for letter in running}
    shown = source.text.string
    text = DISPLAY.sub(lambda match: " " * len(match[0]), shown)
    for pattern in _PATTERNS:
        for match in pattern.finditer(text):
            said = match.groupdict()
            letter = said.get("letter") or _find_letter(shown[: match.start()])
            known = names.get(name_symbol(letter))
            place = EQUATION.match(said["place"]) if said["place"] else None
            by = place["letter"].strip() if place else running.get(known or "", "")
            if known is None or (said["place"] and place is None):
                continue
            line = source.files.locate(source.text.offsets[match.start()]).line
            around = (
                text[: match.start()].rpartition(".")[2] + text[match.end() :].partition(".")[0]
            )
            mark = "# " if _CASE.search(around) else ""
            claims = []
            if by and not _NUMBER.match(said["value"]):
                claims.append(rf"\{_KINDS[said['kind']]}_{{{by}}}{known}={said['value']}")
            if place:
                claims.append(rf"{known}={said['value']}\quad\text{{for }}{said['place']}")
            for claim in claims:
                yield from (f"# line {line} says:", f"{mark}claim {claim}")


def _find_letter(before: str) -> str:
    """Return the left side of the last display, none where it is not alone."""
    displays = list(DISPLAY.finditer(before))
    side = displays[-1][0].partition("=")[0] if displays else ""
    return re.sub(r"\$\$|\\\[|\\begin\{\w+\*?\}|\\label\{[^{}]*\}|&", "", side).strip()
