r"""Letters of a single equation that are functions: f(x)=x^2 that is said, or any function f.

What stands in a bracket behind them is put for the letter that they are functions of.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence

import sympy as sp
from sympy.core.symbol import Str

from mechproof.latex.tokens import list_signs
from mechproof.nomenclature.shown_letters import name_symbol
from mechproof.pipeline.moving_letters import (
    OTHERWISE,
    find_end,
    is_constant,
    list_differentials,
    list_rates,
    name_base,
)
from mechproof.record import AnyFunction, Variable

_LETTER = r"(\\?[A-Za-z]+)"
_SAID = re.compile(rf"\s*{_LETTER}\s*\(\s*{_LETTER}\s*\)\s*(?==)")
# Letters that are functions where they stand before brackets beside derivatives or integrals.
_UNKNOWN = (*"fghuvwyFGH",)
# What a function is of where it stands before brackets only.
_HIDDEN = sp.Dummy("x", real=True)
_RUNNING = (*"xth",)


def take_said(values: Iterable[str]) -> tuple[tuple[str, ...], dict[str, str]]:
    """Return what is said, f(x)=... written as f=..., and of which letter each is a function."""
    said, called = [], {}
    for text in values:
        if found := _SAID.match(text):
            letter, by = found.groups()
            called[letter] = by
            text = letter + text[found.end() :]
        said.append(text)
    return tuple(said), called


def find_unknown(prints: Sequence[str]) -> dict[str, str]:
    r"""Return letters that any functions may be put for, and what they are functions of.

    Nothing is named where each has a bracket behind it. Those without, u in \int_a^buv'\,dx, have
    primes somewhere, and something is integrated by one letter alone.
    """
    split = list(map(list_signs, prints))
    going = {"".join(t[n + 3 : n + 4]) for t in split for n, x in enumerate(t) if x == r"\lim"}
    by = sorted((list_differentials(prints) | going) - {"'"})
    running = [letter for letter in by if letter not in OTHERWISE]
    found: dict[str, list[str]] = {}
    for texts in split:
        for place in (n for n, x in enumerate(texts) if x in _UNKNOWN and x not in by):
            end = find_end(texts, place)
            found.setdefault(texts[place], []).append("".join(texts[place + 1 : end + 1]))
    marks = [mark for met in found.values() for mark in met]
    is_bare = not all(mark.endswith("(") for mark in marks)
    is_primed = [any("'" in mark for mark in met) for met in found.values()]
    is_integrated = r"\int" in by and len(running) == 1 and all(is_primed)
    if not (by or any(is_primed)) or (is_bare and not is_integrated):
        return {}
    return dict.fromkeys(found, running[0] if is_bare else "")


def list_names(called: Mapping[str, str], prints: Sequence[str]) -> list[str]:
    """List letters that are functions, with their primes, and the letters that they are of."""
    names = [name for letter in called for name in (letter, *list_rates(letter, prints))]
    return [name for name in dict.fromkeys((*names, *called.values())) if name]


def find_called(
    variables: Iterable[Variable], called: Mapping[str, str]
) -> dict[sp.Basic, sp.Symbol]:
    """Return the symbols of functions and their derivatives, with what they are functions of."""
    symbols = {latex: v.symbol for v in variables for latex in v.latex}
    bases = {latex: name_base(latex) for latex in symbols}
    return {symbols[x]: symbols.get(called[y], _HIDDEN) for x, y in bases.items() if y in called}


def give_unknown(
    variables: Iterable[Variable], unknown: Collection[str], called: Mapping[sp.Basic, sp.Symbol]
) -> list[tuple[sp.Basic, sp.Expr]]:
    """Return functions of which nothing is known as values; `ValueError` beside what may be one."""
    if not unknown:
        return []
    known = {*called, *called.values()}
    others = [v for v in variables if v.symbol not in known]
    for name, latex in ((name_symbol(v.latex[0]), v.latex[0]) for v in others):
        if not is_constant(name, ()) and name not in _RUNNING:
            raise ValueError(f"{latex} may be a function as {min(unknown)} is: call it c if not")
    symbols = {v.latex[0]: v.symbol for v in variables if v.latex}
    return [
        (symbols[x], AnyFunction(Str(x), sp.S.Zero, called[symbols[x]])) for x in sorted(unknown)
    ]
