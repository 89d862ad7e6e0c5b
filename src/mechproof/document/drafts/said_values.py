"""What sentences propose for a draft: values and sizes of letters, and which equations follow."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator, Mapping, Sequence

from mechproof.document.example_values import find_example
from mechproof.nomenclature.inline import DISPLAY, RATE, Inline, defines_nothing, say_of_others
from mechproof.nomenclature.said import Said
from mechproof.nomenclature.shown_letters import name_symbol
from mechproof.sources.displays import Printed
from mechproof.sources.paper_files import Source

# A reference, or a number in brackets.
_REFERENCE = re.compile(r"\\(?:eq|c|C|auto)?ref\s*\{([^{}]*)\}|(\(\d+(?:\.\d+)*[a-z]?\))")
# Characters between a reference and the equation that it is made for.
_NEAR = 400
# An equation in a sentence, behind such a word or behind another equation there.
_RELATION = re.compile(r"\$(?P<left>[^$=]{2,80})=(?P<right>[^$=]{1,80})\$|\$[^$]*\$")
_INTRODUCED = re.compile(r"(?:\b(?:[Ww]ith|[Ww]here)|=[^$=]{1,80}\$,?\s+and)\s+\Z")
# Signs of letters.
_SIGN = re.compile(r"\\[A-Za-z]+|[A-Za-z0-9]")
# A letter, or its opposite or a multiple, alone or turned by parts of pi.
_TURN = r"(?:\s|\d|/|\\pi|\\d?t?frac|\\circ|[{}^])*"
_MULTIPLE = r"(?:\d+|\\d?t?frac\s*(?:\d\d|\{\d+\}\s*\{\d+\}))?\s*"
# What has a second derivative: its first is no constant.
_SECOND = re.compile(r"\\ddot\s*\{?\s*(\\?[A-Za-z]+)")


def propose_values(
    displays: Sequence[Printed],
    running: Mapping[str, str],
    said: Mapping[str, Said],
    inline: Sequence[tuple[str, Inline]],
) -> Iterator[str]:
    """Yield what sentences say that letters are: their sizes, and what no display says of them.

    `running` has all letters, each with the one that it depends on.
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
            # The letter of a speed that varies is defined by it.
            is_free ^= one.is_varying and one.letter not in letters and one.value in letters
            given, value = (one.letter, one.value) if is_free else (one.value, one.letter)
            line = f"let {given}={value}"
            is_alone = one.letter in letters and _is_position(one.value, letters)
            is_within = bool(find_example(one.offset, displays))
            if one.is_case or is_alone or is_within:
                yield from _ask(one.line, line)
                continue
            for other, others in say_of_others(one, letters):
                if name_symbol(other) not in {*defined, *said}:
                    alike[other] = others
        is_special = one.number is None or one.number.value == 0 or one.letter in running.values()
        if one.number is not None and not is_special:
            size = one.write_size(said[name].unit if name in said else "")
            line = f"sizes {one.letter}={size}" if size else ""
        if line:
            yield from (f"# line {one.line} says:", line)
    if alike:
        yield "# By analogy:"
        yield from (f"let {letter}={value}" for letter, value in alike.items())


def propose_relations(
    source: Source, letters: Sequence[str], displays: Sequence[Printed]
) -> Iterator[str]:
    r"""Yield relations that sentences give beside what they introduce: with $\tan\rho=\mu$."""
    text = DISPLAY.sub(lambda match: " " * len(match[0]), source.text.string)
    names = {name_symbol(letter) for letter in letters}
    for match in _RELATION.finditer(text):
        before = text[max(match.start() - _NEAR, 0) : match.start()]
        if not (match["left"] and _INTRODUCED.search(before)):
            continue
        left, right = match["left"].strip(), match["right"].strip()
        is_letter = name_symbol(left) in names or RATE.fullmatch(left)
        if not is_letter and _has_letter(left, "", letters) and _has_letter(right, "", letters):
            offset = source.text.offsets[match.start()]
            line = source.files.locate(offset).line
            is_case = defines_nothing(before) or find_example(offset, displays)
            said = (f"# line {line} says:", f"claim {left}={right}")
            yield from _ask(line, said[1]) if is_case else said


def _ask(number: int, line: str) -> Iterator[str]:
    yield from (f"# line {number}: a special case, or does it always hold?", f"# {line}")


def _has_letter(value: str, own: str, letters: Sequence[str]) -> bool:
    """Return whether a value is one of other letters."""
    met = {*_SIGN.findall(value)}
    return any({*_SIGN.findall(x)} <= met for x in letters if name_symbol(x) != own)


def _is_position(value: str, letters: Sequence[str]) -> bool:
    """Return whether a value is another letter or its multiple, or one turned by parts of pi."""
    names = "|".join(re.escape(letter) for letter in letters)
    turned = rf"\s*(?:{_TURN}[-+]\s*)?{_MULTIPLE}(?:{names})\s*(?:/\s*\d+\s*)?(?:[-+]{_TURN})?"
    return bool(re.fullmatch(turned, value))


def ask_what_follows(source: Source, displays: Sequence[Printed]) -> Iterator[str]:
    """Yield which equations words before another refer to: it may follow from these."""
    names: dict[str, dict[str, None]] = {}
    for one in displays:
        for label in (*one.labels, one.name, one.name.partition(",")[0]):
            names.setdefault(label, {})[one.name] = None
    starts = [one.latex.offsets[0] for one in displays]
    met: dict[int, dict[str, int]] = {}
    for match in _REFERENCE.finditer(source.text.string):
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
