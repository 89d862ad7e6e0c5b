r"""Derivatives of expressions, limits and factorials.

Derivatives with a slash, `dx/dt`, `d^2s/d\theta^2`, `\partial T/\partial\dot q`, are read as
fractions: nobody prints a product with a d on both sides of a slash and means a letter d that is
not declared.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from mechproof.latex import tree
from mechproof.latex.errors import MeaningError
from mechproof.latex.latex_signs import Token, find_close
from mechproof.latex.left_scripts import begins_letter
from mechproof.latex.name_table import Names, find_brace
from mechproof.latex.undeclared import find_end

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

LARGEST_FACTORIAL = 1000
# Work limit: the largest k for which \binom{n}{k} is written as a polynomial of n.
_MOST_FACTORS = 12
_FIRST: int | tree.Node = 1
_OPERATORS = frozenset(("+", "-", "/", "(", "[", r"\cdot", r"\times"))
PARTIAL = r"\partial"


# Derivatives ------------------------------------------------------------------------------------
_SLASH = "/"


def is_derivative(parser: Parser) -> bool:
    r"""Return whether a fraction is d…/dx: both parts begin with a d that begins no longer name.

    Two \partial make a partial derivative.
    """
    texts = [token.text for token in parser.tokens[parser.place + 1 :]]
    below = find_close(texts) + 1
    starts = (parser.place + 2, parser.place + 2 + below)
    is_d = any(
        texts[:2] == ["{", d] and texts[below : below + 2] == ["{", d] for d in ("d", PARTIAL)
    )
    # A d with an index is a letter.
    is_d &= "_" not in (texts[2:3] + texts[below + 2 : below + 3])
    is_alone = texts[below + 2 : below + 3] not in ([], ["}"])
    names = [found for s in starts if (found := parser.names.match(parser.tokens, s))]
    if all(found.end in (s + 1 for s in starts) for found in names) and names:
        # Nobody prints a quotient of two products with a common factor d.
        inside = texts[below + 2 : below + find_close(texts[below:])]
        return is_d and is_alone and begins_letter(inside[0]) and not _OPERATORS & {*inside}
    return is_d and is_alone and not names


def read_derivative(parser: Parser) -> tree.Node:
    r"""Read \frac{d}{dx}(…) or \frac{d…}{dx}, also of higher order."""
    start = parser.start
    parser.take()
    is_partial = parser.tokens[parser.place + 1].text == PARTIAL
    order, operand = parser.read_inside("{", lambda: _read_above(parser))
    steps = parser.read_inside("{", lambda: _read_below(parser))
    orders = [own for _, own in steps]
    if orders != [order] and order != sum(own for own in orders if isinstance(own, int)):
        raise parser.refuse("a derivative with two orders", place=start)
    if operand is None:
        operand = parser.read_factor()
        # For a letter, the power comes first; for a bracket, the power of its derivative may be
        # meant.
        is_raised = isinstance(operand, tree.Power) and isinstance(operand.base, tree.Bracket)
        if not parser.ends_product():
            parser.check_neighbours(operand)
        is_open = parser.collects and begins_letter(parser.text)
        if is_raised or not (parser.ends_product() or is_open):
            raise parser.refuse(
                "how far does the derivative reach?", "Print brackets around it.", start
            )
    for by, own in reversed(steps):
        operand = tree.Derivation(operand, by, own, is_partial, start=start, end=parser.end)
    return operand


def read_suffix(parser: Parser, atom: tree.Node) -> tree.Node | None:
    """Read n!, or (…)' if the variable of primes is known; None for anything else."""
    if parser.text == "!":
        return _read_factorial(parser, atom)
    by, order = parser.notation.primed, 0
    if parser.text != "'" or by is None or not isinstance(atom, tree.Bracket):
        return None
    letter = tree.Letter(by, str(by), start=parser.start, end=parser.start)
    while parser.skip("'"):
        order += 1
    return tree.Derivation(atom, letter, order, start=atom.start, end=parser.end)


def _read_above(parser: Parser) -> tuple[int | tree.Node, tree.Node | None]:
    parser.take()
    order = _read_order(parser.read_script("^"), parser) if parser.text == "^" else 1
    if parser.text == "}":
        return order, None
    operand = parser.read_factor()
    if isinstance(operand, tree.Power) or parser.text != "}":
        raise parser.refuse("what is differentiated?", "Print brackets around it.")
    return order, operand


def _read_below(parser: Parser) -> list[tuple[tree.Letter, int | tree.Node]]:
    """Read the variables of a derivative, several of a partial one, with the order in each."""
    steps: list[tuple[tree.Letter, int | tree.Node]] = []
    while not steps or parser.text == PARTIAL:
        start = parser.take().start
        by, order = parser.read_factor(), _FIRST
        if isinstance(by, tree.Power):
            order = _read_order(by.exponent, parser)
            by = by.base
        if not isinstance(by, tree.Letter):
            raise parser.refuse("a derivative with respect to no letter", place=start)
        steps.append((by, order))
    return steps


def _read_order(node: tree.Node, parser: Parser) -> int | tree.Node:
    """Read the order of a derivative: a number, or an expression that counts, n, n+1."""
    if isinstance(node, tree.Letter | tree.Add | tree.Product):
        return node
    if not isinstance(node, tree.Number) or node.text not in ("1", "2", "3", "4"):
        reason = "a derivative whose order is neither 1, 2, 3 or 4 nor a letter"
        raise parser.refuse(reason, place=node.start)
    return int(node.text)


def fold_slashed(tokens: Sequence[Token], names: Names) -> tuple[Token, ...]:
    r"""Return signs with d…/dx as \frac{d…}{dx}, unless d is declared or belongs to an integral.

    The limit that defines a derivative, \lim_{\Delta t\to0}\frac{\Delta x}{\Delta t}, is folded,
    too.
    """
    folded: list[Token] = []
    place = 0
    while place < len(tokens):
        if quotient := _find_quotient(tokens, place, names):
            above, below, place = quotient
            folded += _brace(above, r"\frac") + _brace(below)
            continue
        slash, end = _find_derivative(tokens, place, names)
        if end == place or (folded and folded[-1].text == _SLASH):
            end = place + 1
            folded.append(tokens[place])
        else:
            folded += _brace(tokens[place:slash], r"\frac") + _brace(tokens[slash + 1 : end])
        place = end
    return tuple(folded)


def _find_derivative(tokens: Sequence[Token], place: int, names: Names) -> tuple[int, int]:
    """Return the slash and the end of the derivative at a place, or the place twice if none."""
    d, none = tokens[place].text, (place, place)
    if d not in ("d", PARTIAL) or names.match(tokens, place):
        return none
    if d == "d" and any(token.text == r"\int" for token in tokens[:place]):
        return none
    slash = _skip_operand(tokens, _skip_power(tokens, place + 1), names)
    if [token.text for token in tokens[slash : slash + 2]] != [_SLASH, d] or names.match(
        tokens, slash + 1
    ):
        return none
    end = slash + 1
    while _begins_step(tokens, end, d) and (end == slash + 1 or d == PARTIAL):
        end = _skip_power(tokens, _skip_letter(tokens, end + 1, names))
    return (slash, end) if end > slash + 1 else none


def _find_quotient(
    tokens: Sequence[Token], place: int, names: Names
) -> tuple[list[Token], list[Token], int] | None:
    r"""Return numerator and denominator, with d for \Delta, and end of a limit of increments.

    Returns None if no such limit begins at the place.
    """
    if tokens[place].text != r"\lim":
        return None
    texts = [token.text for token in tokens[place:]]
    if texts[1:4] != ["_", "{", r"\Delta"]:
        return None
    middle = _skip_letter(tokens, place + 4, names) - place
    end = _skip_letter(tokens, min(place + middle + 6, len(tokens) - 1), names) - place
    signs = [r"\to", "0", "}", r"\frac", "{", r"\Delta", *texts[middle + 6 : end]]
    signs += ["}", "{", *texts[3:middle], "}"]
    if texts[middle : middle + len(signs)] != signs:
        return None
    d = replace(tokens[place + 3], text="d")
    above, below = tokens[place + middle + 6 : place + end], tokens[place + 4 : place + middle]
    return [d, *above], [d, *below], place + middle + len(signs)


def _begins_step(tokens: Sequence[Token], place: int, d: str) -> bool:
    texts = [token.text for token in tokens[place : place + 2]]
    return texts[:1] == [d] and len(texts) > 1 and begins_letter(texts[1])


def _skip_power(tokens: Sequence[Token], place: int) -> int:
    """Return the place after a power, or the given place if there is none."""
    if [token.text for token in tokens[place : place + 2]] != ["^", "{"]:
        return place
    return find_brace(tokens, place + 2) + 1


def _skip_operand(tokens: Sequence[Token], place: int, names: Names) -> int:
    """Return the place after a letter or bracketed expression, or the given place if none."""
    text = tokens[place].text if place < len(tokens) else ""
    if text in ("(", "["):
        return place + find_close([token.text for token in tokens[place:]]) + 1
    return _skip_letter(tokens, place, names) if begins_letter(text) else place


def _skip_letter(tokens: Sequence[Token], place: int, names: Names) -> int:
    match = names.match(tokens, place)
    return match.end if match else find_end(tokens, place)


def _brace(inside: Sequence[Token], *before: str) -> list[Token]:
    """Return signs in braces of zero width, after the signs `before`."""
    start, end = inside[0].start, inside[-1].end
    opening = [Token(text, start, start) for text in (*before, "{")]
    return [*opening, *inside, Token("}", end, end)]


# Limits -----------------------------------------------------------------------------------------


def read_limit(parser: Parser) -> tree.Node:
    r"""Read \lim_{x\to a}, from one side if a^+, a+0, a- and the like say so."""
    start = parser.take().start
    if parser.text != "_":
        raise parser.refuse("a limit as which letter tends to what?", r"Print \lim_{x\to a}.")
    parser.take("_")
    by, point, side = parser.read_inside("{", lambda: _read_way(parser))
    term = parser.read_product()
    return tree.Approach(term, by, point, side, start=start, end=parser.end)


def _read_way(parser: Parser) -> tuple[tree.Letter, tree.Node, str]:
    by = parser.read_atom()
    if not isinstance(by, tree.Letter) or by.indices or parser.text != r"\to":
        raise parser.refuse("a limit needs one letter that tends to it", r"Print \lim_{x\to a}.")
    parser.take(r"\to")
    start, side = parser.start, _take_side(parser)
    # After +0 and -0 lose their sign, nothing or a zero remains.
    point = tree.Number("0", start=start, end=start) if parser.text == "}" else parser.read_sum()
    return by, point, side


def _take_side(parser: Parser) -> str:
    """Return the side that a script ends with, taking its signs out; "+-" if there is none."""
    texts = [token.text for token in parser.tokens]
    close = parser.place + find_close(["{", *texts[parser.place :]]) - 1
    for sign in ("+", "-"):
        for mark in (["^", "{", sign, "}"], [sign, "0"], [sign]):
            first = close - len(mark)
            if first >= parser.place and texts[first:close] == mark:
                parser.tokens = (*parser.tokens[:first], *parser.tokens[close:])
                return sign
    return "+-"


# Factorials -------------------------------------------------------------------------------------


def _read_factorial(parser: Parser, atom: tree.Node) -> tree.Node:
    """Read the factorial, n!, or double factorial, n!!, of a letter, a number or a bracket.

    n!^2 is the square of n!.
    """
    sign = parser.take("!")
    name, make = ("factorial", _make_factorial)
    if parser.skip("!"):
        name, make = ("factorial2", _make_double_factorial)
    if parser.text == "!" or not isinstance(atom, tree.Letter | tree.Number | tree.Bracket):
        raise parser.refuse("a factorial of what?", "Print brackets around it.", sign.start)
    found = tree.Call(tree.PrintedFunction(name, make), (atom,), start=atom.start, end=parser.end)
    if parser.text != "^":
        return found
    return tree.Power(found, parser.read_script("^"), start=atom.start, end=parser.end)


def read_binomial(parser: Parser) -> tree.Node:
    r"""Read \binom{n}{k}, a polynomial in n for a number k, else a quotient of factorials."""
    start = parser.start
    parser.take()
    numbers = (parser.read_group(), parser.read_group())
    return tree.Call(
        tree.PrintedFunction("binomial", _make_binomial), numbers, start=start, end=parser.end
    )


def _make_binomial(whole: sp.Expr, part: sp.Expr) -> sp.Expr:
    for count in (part, whole - part):
        if count.is_Integer and 0 <= count <= _MOST_FACTORS:
            return sp.Mul(*(whole - n for n in range(count))) / sp.factorial(count)
    if whole.is_integer and whole.is_negative and part.is_nonnegative:
        return (-1) ** part * _make_binomial(part - whole - 1, part)
    if whole.is_number and not whole.is_integer:
        raise MeaningError(
            rf"\binom of {whole} is read only over numbers from 0 to {_MOST_FACTORS}: over others, "
            "print its product or its gamma functions"
        )
    above, *below = map(_make_factorial, (whole, part, whole - part))
    return above / sp.Mul(*below)


def _make_double_factorial(argument: sp.Expr) -> sp.Expr:
    """Return 2*4*...*argument or 1*3*...*argument; raises `MeaningError` if it is unclear which."""
    for half in (argument / 2, (argument + 1) / 2):
        if half.is_integer:
            product = 2**half * _make_factorial(half)
            return product if 2 * half == argument else _make_factorial(2 * half) / product
    raise MeaningError(f"a double factorial: is {argument} even or odd?")


def _make_factorial(argument: sp.Expr) -> sp.Expr:
    """Return a factorial; raises `MeaningError` unless the argument counts and is not too large."""
    if argument.is_number and not 0 <= argument <= LARGEST_FACTORIAL:
        allowed = f"only for whole numbers from 0 to {LARGEST_FACTORIAL}"
        raise MeaningError(f"a factorial is read {allowed}, not for {argument}")
    if not argument.is_integer:
        raise MeaningError(
            f"a factorial of something that is not a whole number, {argument}: "
            rf"print the gamma function, \Gamma({argument + 1}), "
            "or declare its letter as a natural number"
        )
    return sp.factorial(argument)
