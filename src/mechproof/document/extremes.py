r"""Sentences of largest and smallest values -> equations that a draft proposes as rows.

"The largest value of $x$ is $r+l$", "$x$ reaches a maximum of $r+l$ at $\varphi=0$", or, behind the
display of a letter, "It reaches a maximum of $r+l$ at $\varphi=0$".
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from mechproof.nomenclature.inline import DISPLAY, EQUATION
from mechproof.nomenclature.letters import name_symbol
from mechproof.sources.files import Source

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


def find_extremes(source: Source, running: Mapping[str, str]) -> Iterator[tuple[str, int]]:
    """Yield equations with the lines of the sentences that say them.

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
            if by and not _NUMBER.match(said["value"]):
                yield rf"\{_KINDS[said['kind']]}_{{{by}}}{known}={said['value']}", line
            if place:
                yield rf"{known}={said['value']}\quad\text{{for }}{said['place']}", line


def _find_letter(before: str) -> str:
    """Return the left side of the last display, none where it is not alone."""
    displays = list(DISPLAY.finditer(before))
    side = displays[-1][0].partition("=")[0] if displays else ""
    return re.sub(r"\$\$|\\\[|\\begin\{\w+\*?\}|\\label\{[^{}]*\}|&", "", side).strip()
