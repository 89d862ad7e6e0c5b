r"""Prints that may be no letter in a single equation: e^x, \frac{d}{dx}, 1+j, \Gamma(x), f(x).

A letter may be declared a function, as in f(x)=x^2, or be an arbitrary one. The argument in
brackets after it replaces its variable.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from itertools import groupby

import sympy as sp
from sympy.core.symbol import Str

from mechproof.latex.latex_signs import find_close
from mechproof.latex.left_scripts import begins_letter
from mechproof.latex.printed_commands import ACCENTS
from mechproof.latex.tokens import list_signs
from mechproof.nomenclature.shown_letters import name_symbol
from mechproof.pipeline import moving_letters
from mechproof.record import AnyFunction, Variable

EULER = r"e=\mathrm{e}"
_LOGARITHMS = (r"\ln", r"\log")
# The d of a derivative or an integral, which is no letter.
_DIFFERENTIAL = re.compile(
    r"\\i{0,2}int(?![A-Za-z])|(?:\}|\\frac\s*d)\s*\{\s*d\s*(?:[A-Za-z]|\\)|/\s*d\s*[a-z\\]"
)
# Matches the set that letters are said to be in, after a print: \quad(n\in\mathbb{N}).
_SET = re.compile(
    r"\\in\s*\\mathbb\s*\{?\s*(?P<set>[NR])\s*\}?(?P<zero>_\{?0\}?)?\s*(?P<close>\)?)\s*\Z"
)
_LETTER = r"\\?[A-Za-z]+(?:_\w)?"
_NO_INTEGER = re.compile(rf"({_LETTER})\s*\\notin\s*\\mathbb\s*\{{?\s*Z\s*\}}?")
_BREAK = r"(?<!\\)[,;]|\\q?quad(?![A-Za-z])|\\text\{\s*,?\s*(?:for(?: all)?|with|where|if)\s*\}|\A"
_LETTERS = re.compile(
    rf"(?:{_BREAK}|(?=\())(?:\s|\\[,;:! ])*(?P<open>\(?)\s*(?:\\forall\s*)?"
    rf"(?P<letters>{_LETTER}(?:\s*,\s*{_LETTER})*)\s*\Z"
)
_ENDS = (",", ";", r"\,", r"\;", r"\:", r"\!", r"\ ", r"\quad", r"\qquad")
# How many characters before a set its letters are looked for.
_NEAR = 60
# Matches a letter that approaches a value in a limit.
_APPROACHED = re.compile(r"\\lim_\{\s*([A-Za-z])\s*\\(?:to|rightarrow)(?![A-Za-z])")
# Matches the letter that a limit, a sum or a product runs over.
_RUNS = re.compile(r"\\(?:lim|sum|prod)_\{\s*([A-Za-z])(?![A-Za-z])")
# Matches an e that is an eccentricity: 1-e^2, 1+e\cos\varphi.
_ECCENTRIC = re.compile(r"1\s*[-+]\s*e\s*\^\s*\{?2|(?<![A-Za-z])e\s*\\(?:cos|sin)(?![A-Za-z])")
# Matches the interval on which a logarithm grows from 0 to 1.
_FROM_ONE = re.compile(r"\\int_\{?1\}?\^\{?e(?![A-Za-z_'])")


def find_declared(conditions: Iterable[str]) -> list[str]:
    """Return the letters that conditions put between numbers, as in 0<e<1."""
    signs = groupby((sign for text in conditions for sign in (*list_signs(text), ",")), ",".__eq__)
    found = [[x for x in part if begins_letter(x) or x == "_"] for _, part in signs]
    return [letters[0] for letters in found if len(letters) == 1]


def find_running(prints: Sequence[str]) -> set[str]:
    r"""Return the letters that must be variables: \int e\,de, \frac{d}{de}, \lim_{e\to0}."""
    approached = {letter for latex in prints for letter in _APPROACHED.findall(latex)}
    return approached | moving_letters.list_differentials(prints)


def means_euler(prints: Sequence[str]) -> bool:
    r"""Return whether an e has letters in its exponent or a logarithm before it: Euler's number.

    It is also Euler's number in \int_1^e, and if no other letter is free and the running letter is
    in an exponent or there is a factorial. It is not if any e is an eccentricity.
    """
    if any(map(_ECCENTRIC.search, prints)):
        return False
    split = map(list_signs, prints)
    is_raised = any(x == "e" and _list_letters(t, n) for t in split for n, x in enumerate(t))
    return is_raised or any(map(_FROM_ONE.search, prints)) or any(map(_is_of_numbers, prints))


def _is_of_numbers(latex: str) -> bool:
    """Return whether e is the only free letter, next to a factorial or a power of what runs."""
    running, texts = {*_RUNS.findall(latex)}, list_signs(latex)
    letters = {text for text in texts if begins_letter(text)}
    powers = (_list_letters(["e", *texts[n:]], 0) for n, text in enumerate(texts) if text == "^")
    grows = "!" in texts or any(running & {*power} for power in powers)
    return bool(running) and letters - running == {"e"} and grows


def _list_letters(texts: Sequence[str], place: int) -> list[str]:
    """Return signs that e is Euler's number: letters in its exponent, or a logarithm before it."""
    if place and texts[place - 1] in _LOGARITHMS:
        return [texts[place - 1]]
    if texts[place + 1 : place + 3] != ["^", "{"]:
        return []
    exponent = texts[place + 2 :][: find_close(texts[place + 2 :])]
    return [text for text in exponent if text[-1].isalpha() and text != "e"]


def find_gamma(prints: Iterable[str], names: Iterable[str]) -> dict[str, type[sp.gamma]]:
    r"""Return the gamma function if \Gamma only occurs before brackets, and is not a name."""
    after = [
        texts[place + 1 : place + 2]
        for texts in map(list_signs, prints)
        for place, text in enumerate(texts)
        if text == r"\Gamma"
    ]
    is_function = bool(after) and all(one == ["("] for one in after)
    return {"Gamma": sp.gamma} if is_function and r"\Gamma" not in names else {}


def has_differential(latex: str) -> bool:
    r"""Return whether a print has a d that may be that of a derivative or an integral."""
    return bool(_DIFFERENTIAL.search(latex))


def has_letter_d(latex: str) -> bool:
    """Return whether a print contains a letter d, unless d has an index anywhere."""
    texts = list_signs(latex)
    places = (place for place, text in enumerate(texts) if text == "d")
    plain = (place for place in places if texts[max(place - 2, 0)] not in ACCENTS)
    after = [texts[place + 1 : place + 2] for place in plain]
    return bool(after) and ["_"] not in after


def take_set(latex: str) -> tuple[str, tuple[str, ...], str]:
    r"""Return a print without x\in\mathbb{R} at its end, its letters, and the set's name: R, N.

    The set of whole numbers from 0 up is N_0; a print without a set is returned unchanged.
    """
    end = latex.rfind(r"\in")
    kind = _SET.match(latex, end) if end >= 0 else None
    start = max(end - _NEAR, 0)
    said = _LETTERS.search(latex[start:end]) if kind else None
    if kind is None or said is None or bool(said["open"]) != bool(kind["close"]):
        return latex, (), ""
    before = latex[: start + said.start()].rstrip()
    while before.endswith(_ENDS):
        before = before[: -max(len(one) for one in _ENDS if before.endswith(one))].rstrip()
    letters = tuple(letter.strip() for letter in said["letters"].split(","))
    return before, letters, kind["set"] + ("_0" if kind["zero"] else "")


def leave_out_integers(latex: str) -> str:
    r"""Write x\notin\mathbb{Z} as a relation: x is not its floor."""
    return _NO_INTEGER.sub(r"\1\\ne\\lfloor \1\\rfloor", latex)


_CALLED = r"(\\?[A-Za-z]+)"
_SAID = re.compile(rf"\s*{_CALLED}\s*\(\s*{_CALLED}\s*\)\s*(?==)")
# Letters taken as functions if brackets follow, in prints with derivatives or integrals.
_UNKNOWN = (*"fghuvwyFGH",)
# The argument of a function that only occurs before brackets.
_HIDDEN = sp.Dummy("x", real=True)
_RUNNING = (*"xth",)


def take_said(values: Iterable[str]) -> tuple[tuple[str, ...], dict[str, str]]:
    """Return the values, with f(x)=... written as f=..., and the variable of each function."""
    said, called = [], {}
    for text in values:
        if found := _SAID.match(text):
            letter, by = found.groups()
            called[letter] = by
            text = letter + text[found.end() :]
        said.append(text)
    return tuple(said), called


def find_unknown(prints: Sequence[str]) -> dict[str, str]:
    r"""Return letters that may be arbitrary functions, with their variables.

    A function has no variable, "", if brackets follow each one. If not, as u in \int_a^buv'\,dx,
    each has primes somewhere, and something is integrated by a single letter.
    """
    split = list(map(list_signs, prints))
    going = {"".join(t[n + 3 : n + 4]) for t in split for n, x in enumerate(t) if x == r"\lim"}
    by = sorted((moving_letters.list_differentials(prints) | going) - {"'"})
    running = [letter for letter in by if letter not in moving_letters.OTHERWISE]
    found: dict[str, list[str]] = {}
    for texts in split:
        for place in (n for n, x in enumerate(texts) if x in _UNKNOWN and x not in by):
            end = moving_letters.find_end(texts, place)
            found.setdefault(texts[place], []).append("".join(texts[place + 1 : end + 1]))
    marks = [mark for met in found.values() for mark in met]
    is_bare = not all(mark.endswith("(") for mark in marks)
    is_primed = [any("'" in mark for mark in met) for met in found.values()]
    is_integrated = r"\int" in by and len(running) == 1 and all(is_primed)
    if not (by or any(is_primed)) or (is_bare and not is_integrated):
        return {}
    return dict.fromkeys(found, running[0] if is_bare else "")


def list_names(called: Mapping[str, str], prints: Sequence[str]) -> list[str]:
    """Return letters that are functions, with their primes, and the letters they depend on."""
    names = [
        name for letter in called for name in (letter, *moving_letters.list_rates(letter, prints))
    ]
    return [name for name in dict.fromkeys((*names, *called.values())) if name]


def find_called(
    variables: Iterable[Variable], called: Mapping[str, str]
) -> dict[sp.Basic, sp.Symbol]:
    """Return the symbols of functions and of their derivatives, with their variables."""
    symbols = {latex: v.symbol for v in variables for latex in v.latex}
    bases = {latex: moving_letters.name_base(latex) for latex in symbols}
    return {symbols[x]: symbols.get(called[y], _HIDDEN) for x, y in bases.items() if y in called}


def give_unknown(
    variables: Iterable[Variable], unknown: Collection[str], called: Mapping[sp.Basic, sp.Symbol]
) -> list[tuple[sp.Basic, sp.Expr]]:
    """Return arbitrary functions as values; `ValueError` if other letters may be functions, too."""
    if not unknown:
        return []
    known = {*called, *called.values()}
    others = [v for v in variables if v.symbol not in known]
    for name, latex in ((name_symbol(v.latex[0]), v.latex[0]) for v in others):
        if not moving_letters.is_constant(name, ()) and name not in _RUNNING:
            raise ValueError(f"{latex} may be a function, like {min(unknown)}: call it c if not")
    symbols = {v.latex[0]: v.symbol for v in variables if v.latex}
    return [
        (symbols[x], AnyFunction(Str(x), sp.S.Zero, called[symbols[x]])) for x in sorted(unknown)
    ]
