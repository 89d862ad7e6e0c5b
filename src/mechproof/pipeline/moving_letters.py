r"""Letters of a single equation that depend on others: \dot x next to x, u' next to u, and f(x).

Their formulas are not given: a letter and its derivatives are numbers about which nothing is known.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import sympy as sp

from mechproof.latex.left_scripts import begins_letter
from mechproof.latex.printed_commands import DOTTED, VECTORS
from mechproof.latex.tokens import tokenize
from mechproof.latex.values import OF_SIGNS, UNSMOOTH, settle_all
from mechproof.nomenclature.adjacent_letters import RUNNING
from mechproof.nomenclature.shown_letters import name_symbol
from mechproof.record import Variable

# Letters that are functions of a single letter in brackets after them; any letter may be one of
# the time.
_FUNCTIONS = (*"fghpqrsuvwyzFGH",)
# Letters, also with an index, that are mostly constants next to letters that depend on something.
_CONSTANT = (*"abcdegiklmnrABCGIJKLMNR", "delta", "lambda", "mu", "pi")
_CONSTANT_VECTORS = tuple(f"{kind[1:]}c" for kind in VECTORS)
_RATE = re.compile(
    r"(?P<primed>[^']+)(?P<primes>'+)"
    r"|\\(?P<dots>d{1,3})ot\s*\{?\s*(?P<dotted>\\?[A-Za-z]+(?:\s*\{\\?[A-Za-z]+\})?)\s*\}?"
    r"(?P<index>.*)"
)
# Signs under which a dependent letter would be treated as a constant, although it is none.
OTHERWISE = (r"\int", r"\iint", r"\lim", r"\partial")
# Orders of derivatives that have symbols, and the fewest of a dependent letter that must be
# printed.
_ORDERS = range(1, 6)
_FEWEST = 2


def find_functions(prints: Sequence[str], others: Iterable[str]) -> dict[str, str]:
    r"""Return letters with the one that they are functions of, f(x), f'(x) or \dot f(t).

    Something must be differentiated by that one. The `others`, and letters with an index, are left
    out.
    """
    found: dict[str, str] = {}
    split = list(map(_split, prints))
    indexed = {text for texts in split for text, mark in pairwise(texts) if mark == "_"}
    for texts in split:
        for place, text in enumerate(texts):
            after = texts[find_end(texts, place) :]
            by = after[1] if after[:1] == ["("] and after[2:3] == [")"] else ""
            is_letter = text in _FUNCTIONS or (by == "t" and begins_letter(text))
            if by in RUNNING and is_letter and text not in (*others, *indexed, by):
                found.setdefault(text, by)
    by_some = list_differentials(prints) | {
        by for x, by in found.items() if {*list_rates(x, prints)} != {x}
    }
    return {letter: by for letter, by in found.items() if by in by_some}


def list_differentials(prints: Iterable[str]) -> set[str]:
    r"""Return the letters after a d, by which something is differentiated or integrated.

    Those in numerators are left out, and x_1 gives x_. A prime after a bracket is listed, too, and
    so are the signs in `OTHERWISE`.
    """
    texts = [[text for text in _split(latex) if text not in "{}"] for latex in prints]
    found = {text for one in texts for text in one if text in OTHERWISE}
    for one in texts:
        for place, (d, by) in enumerate(pairwise(one)):
            mark = "".join(one[place + 2 : place + 3])
            is_above = one[max(place - 1, 0)] == r"\frac" or mark == "/"
            if (d, by) == (")", "'"):
                found.add(by)
            elif d == "d" and begins_letter(by) and not is_above:
                found.add(by + "_" * (mark == "_"))
    return found


def list_rates(letter: str, prints: Iterable[str]) -> Iterator[str]:
    """Yield a letter as it is printed, with its dots and primes."""
    for texts in map(_split, prints):
        for place in (place for place, text in enumerate(texts) if text == letter):
            start = place - 2 * (place > 1 and texts[place - 2] in DOTTED)
            yield "".join(texts[start : find_end(texts, place)])


def find_end(texts: Sequence[str], place: int) -> int:
    """Return the place after a letter, the dots above it and its primes."""
    is_dotted = place > 1 and texts[place - 2] in DOTTED and texts[place + 1 : place + 2] == ["}"]
    end = place + 1 + is_dotted
    while texts[end : end + 1] == ["'"]:
        end += 1
    return end


def _split(latex: str) -> list[str]:
    return [token.text for token in tokenize(latex)]


@dataclass(frozen=True)
class Moving:
    """Which letters depend on which, with their derivatives, and the variables of these.

    A prime after a bracket is a derivative by `primed`.
    """

    letters: Mapping[sp.Basic, tuple[sp.Basic, tuple[sp.Basic, ...]]]
    rates: tuple[Variable, ...]
    primed: sp.Symbol | None


def find_moving(
    variables: Sequence[Variable], functions: Mapping[str, str], differentials: Collection[str] = ()
) -> Moving:
    """Return the letters that depend on others: those whose derivatives occur next to them.

    A letter with dots depends on the time, one with primes on x or t, or on the only angle. A
    letter is left out if others might depend on the same one as well; if something is
    differentiated by that one, `ValueError` is raised.
    """
    shown = {name_symbol(v.latex[0]): v for v in variables if v.latex}
    kinds = (sp.Symbol, sp.MatrixSymbol)
    symbols = {name: v.symbol for name, v in shown.items() if isinstance(v.symbol, kinds)}
    met = [(v, rate) for v in shown.values() if (rate := _RATE.fullmatch(v.latex[0]))]
    primed = {name_symbol(rate["primed"]) for _, rate in met if rate["primed"]}
    of = {name_symbol(letter): name_symbol(by) for letter, by in functions.items()}
    below = {*map(name_symbol, {*differentials} - {*OTHERWISE, "'"})}
    plain = {by for by in below if not by.endswith("_")}
    by_prime = _find_running(symbols, primed, {*of.values()}, plain)
    steps = _list_steps(met, of, by_prime)
    for letter, by in ((x, by) for x, (by, _) in steps.items() if by in steps):
        raise ValueError(
            f"{letter} depends on {by}, and {by} on another letter: give them values, or print "
            r"each derivative as a fraction, \frac{d}{dx}(…)"
        )
    _refuse_others(steps, met, differentials)
    stray = below - {by for by, _ in steps.values()}
    if met and stray:
        raise ValueError(
            f"{met[0][0].latex[0]} next to a derivative by {min(stray).strip('_')}: print each "
            r"derivative as a fraction, \frac{d}{dx}(…)"
        )
    letters: dict[sp.Basic, tuple[sp.Basic, tuple[sp.Basic, ...]]] = {}
    accented = {name_symbol(v.latex[0]) for v, _ in met}
    unclear = {x for x in symbols.keys() - accented - {*steps} if not is_constant(x, primed)}
    for base, (by, known) in steps.items():
        # A letter with a single derivative and nothing else may be a constant.
        is_lone = len(known) + (base in symbols) < _FEWEST and base not in of
        others = sorted(unclear - {by}) or [base] * is_lone
        if others and (by in below or "'" in differentials):
            other = shown[others[0]].latex[0] if others[0] in shown else others[0]
            raise ValueError(
                f"{other} may depend on {by}, as others do: print its derivatives, too, or "
                "call it c if it is a constant"
            )
        if others:
            continue
        letter = _get(symbols, base)
        unnamed = {n: _make_like(letter, f"{base}^({n})") for n in _ORDERS}
        letters[letter] = _get(symbols, by), tuple({**unnamed, **known}.values())
    named = symbols.values()
    rates = (rate for _, own in letters.values() for rate in own if rate not in named)
    variables = [Variable(rate, str(rate), latex=()) for rate in rates]
    return Moving(letters, tuple(variables), _get(symbols, by_prime) if by_prime else None)


def _find_running(
    symbols: Collection[str], primed: Collection[str], by: Collection[str], named: Collection[str]
) -> str:
    """Return the letter that primes differentiate by, or "" if that is not clear.

    An angle is clear if something is differentiated by it, so that it is `named`.
    """
    angles = ({*map(name_symbol, RUNNING)} - {*"txyz"}) & {*symbols}
    alone = {"x"} - {*primed} or {"t"}
    printed = {"x", "t"} & {*symbols, *named}
    running = {*by} or (printed or {*named}) - {*primed} or angles or alone
    # An angle next to a letter with a prime may as well be a constant.
    is_clear = len(running) == 1 and not (primed and running <= angles - {*named})
    return next(iter(running)) if is_clear else ""


def _list_steps(
    met: Iterable[tuple[Variable, re.Match[str]]], of: Mapping[str, str], by_prime: str
) -> dict[str, tuple[str, dict[int, sp.Basic]]]:
    """Return letters that depend on others, with these and the derivatives that are printed."""
    steps: dict[str, tuple[str, dict[int, sp.Basic]]] = {x: (by, {}) for x, by in of.items()}
    for variable, rate in met:
        base, by = name_symbol(_name_base(rate)), "t" if rate["dotted"] else by_prime
        order = len(rate["primes"] or rate["dots"])
        if by and steps.setdefault(base, (by, {}))[0] == by:
            steps[base][1][order] = variable.symbol
    return steps


def _refuse_others(
    moving: Collection[str],
    met: Sequence[tuple[Variable, re.Match[str]]],
    differentials: Collection[str],
) -> None:
    """Refuse letters that depend on others in integrals, limits and partial derivatives.

    Dots and primes in one print are by different letters, and may belong to a letter that depends
    on both.
    """
    names = sorted({_name_base(rate) for _, rate in met} or {*moving})
    if names and (found := sorted({*OTHERWISE} & {*differentials})):
        raise ValueError(
            f"{names[0]} depends on another letter, and {found[0]} appears next to its derivative: "
            "that is not evaluated"
        )
    if moving and differentials and len({bool(rate["dots"]) for _, rate in met}) > 1:
        raise ValueError("derivatives with dots and with primes in one equation: by which letters?")


def name_base(latex: str) -> str:
    """Return the letter that a print is, or is the derivative of."""
    rate = _RATE.fullmatch(latex)
    return _name_base(rate).strip() if rate else latex


def _name_base(rate: re.Match[str]) -> str:
    """Return the letter that a derivative is of, with its index."""
    return rate["primed"] or rate["dotted"] + rate["index"]


def is_constant(name: str, primed: Collection[str]) -> bool:
    """Return whether a letter is mostly a constant, which g is unless letters have primes.

    The only such vector is c.
    """
    stem = name.partition("_")[0]
    is_constant = stem in _CONSTANT and not (primed and stem == "g")
    return is_constant or stem in _CONSTANT_VECTORS


def _make_like(letter: sp.Basic, name: str) -> sp.Basic:
    """Return a letter of another name, a vector if the letter is one."""
    if isinstance(letter, sp.MatrixSymbol):
        return sp.MatrixSymbol(name, *letter.shape)
    return sp.Symbol(name, real=True)


def _get(symbols: Mapping[str, sp.Symbol], name: str) -> sp.Symbol:
    return symbols.get(name, sp.Symbol(name, real=True))


def find_rates(
    variables: Sequence[Variable], called: Mapping[sp.Basic, sp.Symbol]
) -> dict[sp.Basic, sp.Expr]:
    r"""Return derivatives, by their accents, of letters that have values: y=x^2 makes y' 2x."""
    values = {v.symbol: v.given for v in variables if v.given is not None}
    given = {name_symbol(v.latex[0]): v.symbol for v in variables if v.given is not None}
    euler = {letter: value for letter, value in values.items() if value is sp.E}
    rates: dict[sp.Basic, sp.Expr] = {}
    for variable in variables:
        rate = _RATE.fullmatch(variable.latex[0])
        base = given.get(name_symbol(_name_base(rate))) if rate else None
        if rate and base is not None and variable.given is None:
            all_known = rate["dotted"] or base in called
            value = settle_all(base, values if all_known else {base: values[base], **euler})
            by = called.get(base)
            derivative = _differentiate(variable.latex[0], value, rate, {*values}, by)
            rates[variable.symbol] = derivative
    return rates


def _differentiate(
    latex: str,
    value: sp.Expr,
    rate: re.Match[str],
    given: set[sp.Basic],
    by: sp.Symbol | None = None,
) -> sp.Expr:
    """Return a derivative: by the time for dots, by x or the only running letter for primes."""
    letters = {s.name: s for s in value.free_symbols}
    by = by or letters.get("t" if rate["dotted"] else "x")
    if by is None and rate["primed"] and len(letters) == 1 and {*letters} <= {*RUNNING}:
        (by,) = letters.values()
    if by is None or not given.isdisjoint(letters.values()) or value.has(*UNSMOOTH, *OF_SIGNS):
        raise ValueError(
            f"{latex} is a derivative of a letter with value {value}: by which letter? Print it "
            rf"as a fraction, \frac{{d}}{{d{'t' if rate['dotted'] else 'x'}}}(…)"
        )
    order = len(rate["primes"] or rate["dots"])
    derivative: sp.Expr = value.diff(by, order)
    return derivative
