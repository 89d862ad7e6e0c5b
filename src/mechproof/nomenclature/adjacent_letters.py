r"""Adjacent signs in a single equation: r(1-\cos x), \cos\omega t, \delta t, \Delta x.

A paper declares its letters; for a single equation there is only its print to go by.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import pairwise

from mechproof.latex.characters import is_digit
from mechproof.latex.latex_signs import find_close, measure_depths
from mechproof.latex.left_scripts import begins_letter
from mechproof.latex.printed_commands import ACCENTS, DOTTED
from mechproof.latex.printed_functions import FUNCTIONS
from mechproof.latex.tokens import list_signs

# Letters that stand for functions as often as for numbers.
_FUNCTIONS = ("f", "g", "F", "G", r"\Phi")
# Letters that may be rates or numbers in front of an angle, a time or a length; functions of
# angles; angular velocities; and letters for angles, times and lengths.
_RATES = (*"abckmnpq", r"\lambda", r"\mu", r"\nu")
_OF_ANGLES = (r"\sin", r"\cos", r"\tan", r"\cot", r"\sinh", r"\cosh", r"\tanh", r"\coth")
_SPEEDS = (r"\omega", r"\Omega")
_TIMES = ("t", r"\tau")
RUNNING = (*"xyz", *_TIMES, r"\varphi", r"\phi", r"\theta", r"\vartheta", r"\psi", r"\alpha")
# Signs in front of the variable of a derivative.
_BY = ["{", "d"]
_INCREMENT = re.compile(r"\\Delta\s*(?:[A-Za-z]|\\[a-z]+)(?:_(?:\w|\{[^{}]*\}))?")


def find_factors(prints: Iterable[str], numbers: Collection[str] = ()) -> tuple[str, ...]:
    r"""Return the letters that multiply the bracket after them: r(1-\cos\varphi)=r-r\cos\varphi.

    Such a letter also appears without a bracket, or has dots, and none of its brackets may be an
    argument. A sum whose running letters are all bound by integrals around it is not an argument,
    nor is one after a letter of `numbers`, which conditions compare with numbers, unless that
    letter may depend on another one in the sum.
    """
    bare: set[str] = set()
    brackets: dict[str, list[bool]] = defaultdict(list)
    for texts in map(list_signs, prints):
        spans = list(_find_integrals(texts))
        ends = ((x, skip_power(texts, end)) for x, end in list_letters(texts))
        met = [(letter, n, texts[n : n + 1]) for letter, n in ends]
        around = {n: {by for low, high, by in spans if low < n <= high} for _, n, _ in met}
        bare |= {letter for letter, _, after in met if after != ["("]}
        beside = {letter for letter, n, after in met if after != ["("] and not around[n]}
        for letter, n in ((letter, n) for letter, n, after in met if after == ["("]):
            inside = texts[n : n + find_close(texts[n:])]
            argument = {*inside} & {*RUNNING, *around[n]}
            is_bound = letter in beside and bool(argument) and argument <= around[n]
            # Rates and numbers may depend on time, v(t-t_0), all else on any letter that runs.
            moved_by = _TIMES if letter in _RATES else RUNNING
            is_number = letter in numbers and not {*inside} & {*moved_by}
            brackets[letter].append(_is_factor(inside, is_known=is_bound or is_number))
    bare |= {letter for letter in brackets if letter.startswith(DOTTED)}
    return tuple(
        x
        for x in brackets
        if x in bare and all(brackets[x]) and x.rpartition("{")[2].strip("}") not in _FUNCTIONS
    )


def find_phases(prints: Iterable[str]) -> set[tuple[str, str]]:
    r"""Return the pairs of letters that make an angle: \cos\omega t, or \sin bx and \cos bx.

    Further pairs are a letter and \pi, or a variable of a limit, derivative or integral, and the
    letters of a ratio of fixed letters and a running one, \sin\frac{2\pi}Tt. Letters in a bracket
    count one by one, \cos(a+b)x, unless \cos(a+b) is also printed without a letter after it.
    """
    met: list[tuple[str, str]] = []
    found: set[tuple[str, str]] = set()
    for texts in map(list_signs, prints):
        going = {"".join(texts[n + 3 : n + 4]) for n, x in enumerate(texts) if x == r"\lim"}
        going |= {by for *two, by in zip(texts, texts[1:], texts[2:], strict=False) if two == _BY}
        begin = texts.index(r"\int") if r"\int" in texts else len(texts)
        going |= {by for d, by in pairwise(texts[begin:]) if d == "d"}
        starts = [n for n, text in enumerate(texts) if text.removeprefix("\\") in FUNCTIONS]
        arguments = {start: _find_argument(texts, start) for start in starts}
        waves = [(texts[n], *_read_bracket(texts, place)) for n, place in arguments.items()]
        bare = [(wave, inside) for wave, inside, by in waves if by not in (*going, *RUNNING)]
        for start, n in arguments.items():
            one, other, third = _read_names(texts, n)
            met.append((one, other))
            if one in _RATES and other in going:
                found.add((one, other))
            inside, after = _read_bracket(texts, n)
            rates = {text for text in inside if begins_letter(text)}
            if rates <= {*_RATES} and (after == r"\pi" or (texts[start], inside) not in bare):
                met += [(rate, after) for rate in rates]
                found |= {(rate, after) for rate in rates if after in (*going, r"\pi")}
            if texts[start] not in _OF_ANGLES:
                continue
            if one == r"\pi" or (other == r"\pi" and one.isalpha()):
                found.add((one, other))
            if one == r"\pi" and other in (*_RATES, "f") and third in RUNNING:
                found.add((other, third))
            if one == r"\frac":
                found |= {*_find_ratio(texts[n:])}
    return found | {
        (one, other)
        for one, other in met
        if (one.partition("_")[0] in _SPEEDS and other in _TIMES)
        or ((one in (*_RATES, *_SPEEDS) and other in RUNNING) and met.count((one, other)) > 1)
    }


def _find_argument(texts: Sequence[str], start: int) -> int:
    """Return the place behind a function, its power and a number before its argument."""
    place = skip_power(texts, start + 1)
    while texts[place : place + 1] and is_digit(texts[place]):
        place += 1
    return place


def _read_bracket(texts: Sequence[str], place: int) -> tuple[Sequence[str], str]:
    """Return the content of the bracket at a place and the sign after it; nothing if none."""
    if texts[place : place + 1] != ["("]:
        return [], ""
    inside = texts[place : place + find_close(texts[place:])]
    return inside, "".join(texts[place + len(inside) + 1 : place + len(inside) + 2])


def _read_names(texts: Sequence[str], place: int) -> tuple[str, str, str]:
    """Return the three signs at a place, each with its index."""
    names: list[str] = []
    while len(names) < 3:
        end = place + 1
        if texts[end : end + 2] == ["_", "{"] and "}" in texts[end:]:
            end = texts.index("}", end) + 1
        names.append("".join(texts[place:end]))
        place = end
    return names[0], names[1], names[2]


def _find_ratio(texts: Sequence[str]) -> Iterator[tuple[str, str]]:
    r"""Yield each letter of the fraction that begins `texts`, with the letter after the fraction.

    Nothing is yielded for a fraction over a number, except of \pi and speeds: its letter may be an
    angle that is halved.
    """
    middle = find_close(texts[1:]) + 2
    end = find_close(texts[middle:]) + middle
    after = "".join(texts[end + 1 : end + 2])
    parts = (texts[:middle], texts[middle:end])
    over, under = ({letter for letter, _ in list_letters(part)} for part in parts)
    is_rate = bool(under) or over <= {r"\pi", *_SPEEDS} or after == r"\pi"
    if after in (*RUNNING, r"\pi") and is_rate and all(map(_is_fixed, over | under)):
        yield from ((letter, after) for letter in over | under)


def _is_fixed(letter: str) -> bool:
    """Return whether a letter may be a number or a rate, and is rarely an angle."""
    stem = letter.partition("_")[0]
    return stem not in RUNNING and (stem.isalpha() or stem in (r"\pi", *_RATES, *_SPEEDS))


def find_increments(prints: Sequence[str]) -> tuple[str, ...]:
    r"""Return \Delta x as a single name, and \delta if it also appears alone or in an exponent."""
    found = dict.fromkeys(name for text in prints for name in _INCREMENT.findall(text))
    for texts in map(list_signs, prints):
        places = [place for place, text in enumerate(texts) if text == r"\delta"]
        is_alone = any(not begins_letter("".join(texts[n + 1 : n + 2])) for n in places)
        if is_alone or any(texts[max(n - 3, 0) : n] == ["^", "{", "-"] for n in places):
            found[r"\delta"] = None
    return tuple(found)


def list_letters(texts: Sequence[str]) -> Iterator[tuple[str, int]]:
    """Yield each letter with its index, and its end, except primed ones and those after a d."""
    end = 0
    for place, text in enumerate(texts):
        if place < end or not begins_letter(text):
            continue
        is_accent = text in ACCENTS and texts[place + 3 : place + 4] == ["}"]
        end = place + (4 if is_accent else 1)
        if texts[end : end + 2] == ["_", "{"] and "}" in texts[end:]:
            end = texts.index("}", end) + 1
        if texts[end : end + 1] != ["'"] and texts[place - 1 : place] != ["d"]:
            yield "".join(texts[place:end]), end


def skip_power(texts: Sequence[str], place: int) -> int:
    """Return the end of the power at a place, or the place itself if there is none."""
    if texts[place : place + 2] == ["^", "{"] and "}" in texts[place:]:
        return texts.index("}", place) + 1
    return place


def _find_integrals(texts: Sequence[str]) -> Iterator[tuple[int, int, str]]:
    """Yield the beginnings and ends of integrals with limits, and their variables."""
    begun: list[int] = []
    for place, text in enumerate(texts):
        if text == r"\int":
            begun.append(place)
        if text == "d" and begun and texts[place - 1] != "{":
            start = begun.pop()
            if texts[start + 1 : start + 2] == ["_"]:
                yield start, place, "".join(texts[place + 1 : place + 2])


def _is_factor(bracket: Sequence[str], *, is_known: bool) -> bool:
    """Return whether a bracket is not an argument, as x+h is, or 1-x outside an integral over x.

    It contains a product with a dot, or it is a sum: after a number, with a bound variable, with a
    function, or of 1 and a power.
    """
    depths = measure_depths(bracket)
    inside = [x if depth == 1 else "" for x, depth in zip(bracket, depths, strict=True)]
    has_function = any(x.removeprefix("\\") in FUNCTIONS or x == r"\sqrt" for x in inside)
    is_ratio = inside[1:2] == ["1"] and "^" in inside
    is_sum = any(sign in inside[2:] for sign in ("+", "-", r"\pm"))
    return r"\cdot" in inside or (is_sum and (is_known or has_function or is_ratio))
