r"""Draft lines from sentences: values and sizes of letters, and which equations follow.

Sentences about largest and smallest values are proposed as rows: "The largest value of $x$ is
$r+l$", "$x$ reaches a maximum of $r+l$ at $\varphi=0$", or, after the display of a letter, "It
reaches a maximum of $r+l$ at $\varphi=0$". A display x_{\max}=r+l leads to a question about
whether it is meant that way.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

from mechproof.document.example_values import find_example
from mechproof.latex.words import OPENS_WORDS
from mechproof.nomenclature.inline import (
    CALL,
    EQUATION,
    RATE,
    Inline,
    defines_nothing,
    say_of_others,
)
from mechproof.nomenclature.said import Said
from mechproof.nomenclature.shown_letters import collect_letters, name_symbol
from mechproof.sources.displays import DISPLAY, Printed, hide_displays
from mechproof.sources.paper_files import Source

# A reference, or a number in brackets.
_REFERENCE = re.compile(r"\\(?:eq|c|C|auto)?ref\s*\{([^{}]*)\}|(\(\d+(?:\.\d+)*[a-z]?\))")
# Most characters between a reference and the equation it belongs to.
_NEAR = 400
# An equation in a sentence, after an introducing word or after another equation.
_RELATION = re.compile(
    rf"\$(?P<left>[^$=]{{2,80}})=(?!\s*{OPENS_WORDS}\s*const)(?P<right>[^$=]{{1,80}})\$"
    r"|\$[^$]*\$"
)
_INTRODUCED = re.compile(r"(?:\b(?:[Ww]ith|[Ww]here)|=[^$=]{1,80}\$,?\s+and)\s+\Z")
# A condition that a sentence says to hold: since $|\psi|<\pi/2$.
_CONDITION = re.compile(
    r"\b(?:[Ss]ince|[Bb]ecause|as|[Ww]here|[Ww]ith)\s+"
    r"\$(?P<says>[^$=]+(?:[<>]|\\l[et]q?(?![a-z])|\\g[et]q?(?![a-z]))[^$=]+)\$"
)
# The signs that letters consist of.
_SIGN = re.compile(r"\\[A-Za-z]+|[A-Za-z0-9]")
# A turn by parts of pi, and a factor: a letter with these is another position.
_TURN = r"(?:\s|\d|/|\\pi|\\d?t?frac|\\circ|[{}^])*"
_MULTIPLE = r"(?:\d+|\\d?t?frac\s*(?:\d\d|\{\d+\}\s*\{\d+\}))?\s*"
# An index that is one sign.
_BRACED = re.compile(r"_\{\s*(\w|\\[A-Za-z]+)\s*\}")
# A letter with a second derivative, so that its first one is not constant.
_SECOND = re.compile(r"\\ddot\s*\{?\s*(\\?[A-Za-z]+)")
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
# A display of a largest or least value, printed as a letter with an index and perhaps primes.
_NAMED = re.compile(
    r"\s*&?(?P<stem>[^_=&]+)_\{?\s*(?:\\mathrm\s*\{\s*|\\)?(?P<kind>max|min)\s*\}*(?P<primes>'*)"
    r"\s*&?=\s*(?P<value>[^=]+)"
)
_EQUALS = re.compile(r"=(?![^{}]*\})")
# A letter with an index, and words that tell at which place it is the value of the letter.
_INDEXED = re.compile(
    r"\s*&?(?P<stem>[^_=&]+)_(?:\w|\{[^{}]*(?:\{[^{}]*\})?[^{}]*\})(?P<primes>'*)"
    r"\s*&?=\s*(?P<value>[^=]+)"
)
_AT_PLACE = re.compile(
    r"\b(?:at|for|when|where)\s+(?:[\w\s]{1,30},\s+)?\$(?P<place>[^$=]{1,20}=[^$=]{1,40})\$,?"
    r"(?:\s+(?:is|becomes|equals|reads|amounts\s+to|has\s+the\s+value|it\s+is|we\s+\w+))?:?\s*\Z",
    re.IGNORECASE,
)
_MARKS = re.compile(r"\\d*dot\b|[\s{}']")


def propose_values(
    displays: Sequence[Printed],
    running: Mapping[str, str],
    said: Mapping[str, Said],
    inline: Sequence[tuple[str, Inline]],
) -> Iterator[str]:
    """Yield the values that sentences give letters: sizes, and formulas that no display gives.

    `running` maps every letter to the one that it depends on, or to "".
    """
    letters = [*running]
    sides = (one.latex.string.partition("=")[::2] for one in displays)
    defined = {name_symbol(one) for one, other in sides if _has_letter(other, "", letters)}
    named = {name for name, _ in inline}
    moving = {name_symbol(letter) for letter, by in running.items() if by}
    texts = [*(one.latex.string for one in displays), *(one.value for _, one in inline)]
    changing = named | {name_symbol(found) for text in texts for found in _SECOND.findall(text)}
    alike: dict[str, str] = {}
    for name, one in inline:
        line = ""
        rate = RATE.fullmatch(one.value)
        is_free = rate is None or name in moving or name_symbol(rate[1]) in changing
        is_free = is_free or one.is_varying
        if name in defined and is_free:
            continue
        if one.number is None and _has_letter(one.value, name, letters):
            # A varying speed is not a value: it defines the letter that is equated with it.
            is_free ^= one.is_varying and one.letter not in letters and one.value in letters
            given, value = (one.letter, one.value) if is_free else (one.value, one.letter)
            line = f"let {given}={value}"
            is_alone = one.letter in letters and _is_position(one.value, letters)
            is_within = bool(find_example(one.offset, displays))
            if one.is_case or is_alone or is_within:
                yield from _propose(one.line, line, is_case=True)
                continue
            for other, others in say_of_others(one, letters):
                if name_symbol(other) not in {*defined, *said}:
                    alike[other] = others
        is_special = one.number is None or one.number.value == 0 or one.letter in running.values()
        if one.number is not None and not is_special:
            size = one.write_size(said[name].unit if name in said else "")
            line = f"sizes {one.letter}={size}" if size else ""
        if line:
            yield from _propose(one.line, line)
            said_too = (x for x in one.others if _has_letter(x, name, letters) and "const" not in x)
            yield from (f"claim {one.letter}={other}" for other in said_too)
    if alike:
        yield "# By analogy:"
        yield from (f"let {letter}={value}" for letter, value in alike.items())


def propose_relations(
    source: Source, letters: Sequence[str], displays: Sequence[Printed]
) -> Iterator[str]:
    r"""Yield relations that a sentence adds to its subject: with $\tan\rho=\mu$."""
    text = hide_displays(source.text.string)
    names = {name_symbol(letter) for letter in letters}
    for match in _RELATION.finditer(text):
        before = text[max(match.start() - _NEAR, 0) : match.start()]
        if not (match["left"] and _INTRODUCED.search(before)):
            continue
        left, right = match["left"].strip(), match["right"].strip()
        call = CALL.fullmatch(left)
        is_letter = name_symbol(call["stem"] if call else left) in names or RATE.fullmatch(left)
        if not is_letter and _has_letter(left, "", letters) and _has_letter(right, "", letters):
            offset = source.text.offsets[match.start()]
            is_case = defines_nothing(before) or bool(find_example(offset, displays))
            number = source.files.locate(offset).line
            yield from _propose(number, f"claim {left}={right}", is_case)


def propose_conditions(
    source: Source, letters: Sequence[str], displays: Sequence[Printed]
) -> Iterator[str]:
    """Yield conditions that sentences say to hold; those in an example as questions."""
    text = hide_displays(source.text.string)
    for match in _CONDITION.finditer(text):
        if _has_letter(match["says"], "", letters):
            offset = source.text.offsets[match.start()]
            number, is_case = source.files.locate(offset).line, bool(find_example(offset, displays))
            yield from _propose(number, f"where {match['says'].strip()}", is_case)


def _propose(number: int, line: str, is_case: bool = False) -> tuple[str, str]:
    """Return a line of the block with where it is from, as a question if it is about a case."""
    if is_case:
        return f"# line {number}: a special case, or does it always hold?", f"# {line}"
    return f"# line {number} says:", line


def _has_letter(value: str, own: str, letters: Sequence[str]) -> bool:
    """Return whether a value contains one of the letters other than its own."""
    met = {*_SIGN.findall(value)}
    return any({*_SIGN.findall(x)} <= met for x in letters if name_symbol(x) != own)


def _is_position(value: str, letters: Sequence[str]) -> bool:
    """Return whether a value is another letter or its multiple, or one turned by parts of pi."""
    names = "|".join(re.escape(_BRACED.sub(r"_\1", letter)) for letter in letters)
    turned = rf"\s*(?:{_TURN}[-+]\s*)?{_MULTIPLE}(?:{names})\s*(?:/\s*\d+\s*)?(?:[-+]{_TURN})?"
    return bool(re.fullmatch(turned, _BRACED.sub(r"_\1", value)))


def ask_what_follows(source: Source, displays: Sequence[Printed]) -> Iterator[str]:
    """Ask whether displays follow from the equations that the words before them refer to."""
    names: dict[str, dict[str, None]] = {}
    for one in displays:
        for label in (*one.labels, one.name, one.name.partition(",")[0]):
            names.setdefault(label, {})[one.name] = None
    starts = [one.latex.offsets[0] for one in displays]
    met: dict[int, dict[str, int]] = {}
    # A display refers to others for itself, and may have its own number beside it.
    text = hide_displays(source.text.string)
    for match in _REFERENCE.finditer(text):
        offset = source.text.offsets[match.start()]
        after = bisect_right(starts, offset)
        before = {one.name for one in displays[:after]}
        for name in names.get(match[1] or match[2], ()):
            if name in before and after < len(starts) and starts[after] - offset < _NEAR:
                met.setdefault(after, {}).setdefault(name, source.files.locate(offset).line)
    for after, found in met.items():
        if found:
            name, others = displays[after].name, ", ".join(found)
            them = "them" if len(found) > 1 else "it"
            line = min(found.values())
            yield f"# line {line} refers to {others}. Does {name} follow from {them}?"
            yield f"# follows {name}: {others}"


def ask_extremes(displays: Sequence[Printed], running: Mapping[str, str]) -> Iterator[str]:
    """Yield largest and least values printed in displays, as claims to be confirmed."""
    known = {name_symbol(letter): by for letter, by in running.items() if by}
    for display in displays:
        if not (said := _NAMED.match(display.latex.string)):
            continue
        letter, value = said["stem"].strip() + said["primes"], said["value"].strip(" ,.;")
        if by := known.get(name_symbol(_MARKS.sub("", letter))):
            which = "largest" if said["kind"] == "max" else "least"
            yield f"# {display.name}: is that the {which} value of {letter} over all {by}?"
            yield rf"# claim \{said['kind']}_{{{by}}}{letter}={value}"


def ask_givens(displays: Sequence[Printed], inline: Sequence[tuple[str, Inline]]) -> Iterator[str]:
    r"""Yield questions about chains whose members share no letter, i=n_1/n_2=z_2/z_1.

    No equation gives any of their letters, so nothing printed makes the members equal.
    """
    prints = [one.latex.string for one in displays]
    given = {name for name, _ in inline}
    given |= {name_symbol(latex.partition("=")[0].strip(" &\n")) for latex in prints}
    for display in displays:
        _, *members = _EQUALS.split(display.latex.string)
        found = [{*map(name_symbol, collect_letters([x], guess=True).letters)} for x in members]
        pairs = ((one, other) for one, other in pairwise(found) if one and other)
        if any(not one & other and not (one | other) & given for one, other in pairs):
            yield f"# {display.name}: its members share no letter. Is it given, not derived?"
            yield f"# constraint {display.name.partition(',')[0]}"


def ask_places(
    source: Source, displays: Sequence[Printed], running: Mapping[str, str]
) -> Iterator[str]:
    r"""Yield displays of values at a place named just before: at $\varphi=0$ it is x_0=r+l."""
    known = {name_symbol(letter) for letter, by in running.items() if by}
    shown = source.text.string
    starts = {source.text.offsets.index(one.latex.offsets[0]): one for one in displays}
    for match in DISPLAY.finditer(shown):
        inside = (one for start, one in starts.items() if match.start() < start < match.end())
        place = _AT_PLACE.search(shown, max(match.start() - _NEAR, 0), match.start())
        display = next(inside, None)
        said = _INDEXED.match(display.latex.string) if display and place else None
        if not (said and display and place):
            continue
        letter, value = said["stem"].strip() + said["primes"], said["value"].strip(" ,.;")
        if name_symbol(_MARKS.sub("", letter)) in known:
            at = place["place"]
            yield f"# {display.name}: is that the value of {letter} for {at}?"
            yield rf"# claim {letter}={value}\quad\text{{for }}{at}"


def ask_functions(letters: Sequence[str], running: Mapping[str, str]) -> Iterator[str]:
    """Yield questions about letters whose value at a place is printed."""
    known = {name_symbol(letter) for letter, by in running.items() if by}
    for name in letters:
        if name_symbol(_MARKS.sub("", name)) not in known:
            yield f"# A value of {name} at a place: say what {name} depends on, {name}(…) :"


def find_extremes(
    source: Source, displays: Sequence[Printed], running: Mapping[str, str]
) -> Iterator[str]:
    """Yield claims of largest and least values from sentences, commented out if about a case.

    `running` maps the letters of the equations to those that they depend on, or to "".
    """
    names = {name_symbol(letter): letter for letter in running}
    text = hide_displays(source.text.string)
    for pattern in _PATTERNS:
        for match in pattern.finditer(text):
            said = match.groupdict()
            offset = source.text.offsets[match.start()]
            before = [d for d in displays if source.places[d.latex.offsets[0]] < match.start()]
            letter = said.get("letter") or _find_letter(before)
            known = names.get(name_symbol(letter))
            place = EQUATION.match(said["place"]) if said["place"] else None
            by = place["letter"].strip() if place else running.get(known or "", "")
            if known is None or (said["place"] and place is None):
                continue
            line = source.files.locate(offset).line
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


def _find_letter(displays: Sequence[Printed]) -> str:
    """Return the left side of the last display, or "" if there is none."""
    first = next((one for one in displays if one.group == displays[-1].group), None)
    return first.latex.string.partition("=")[0].strip() if first else ""
