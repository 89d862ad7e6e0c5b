r"""Derivatives with a slash, `dx/dt`, `d^2s/d\theta^2`, `\partial T/\partial\dot q`: as fractions.

Nobody prints a product with a d on both sides of a slash and means a letter d that is not declared.
"""

from __future__ import annotations

from collections.abc import Sequence

from mechproof.latex.latex_signs import Token, find_close
from mechproof.latex.left_scripts import begins_letter
from mechproof.latex.name_table import Names, find_brace
from mechproof.latex.printed_derivatives import PARTIAL
from mechproof.latex.undeclared import find_end

_SLASH = "/"


def fold_slashed(tokens: Sequence[Token], names: Names) -> tuple[Token, ...]:
    r"""Return signs with d…/dx as \frac{d…}{dx}; where d is declared or integrates they stay."""
    folded: list[Token] = []
    place = 0
    while place < len(tokens):
        slash, end = _find_derivative(tokens, place, names)
        if end == place or (folded and folded[-1].text == _SLASH):
            end = place + 1
            folded.append(tokens[place])
        else:
            folded += _brace(tokens[place:slash], r"\frac") + _brace(tokens[slash + 1 : end])
        place = end
    return tuple(folded)


def _find_derivative(tokens: Sequence[Token], place: int, names: Names) -> tuple[int, int]:
    """Return the slash and the end of the derivative that begins at a place, twice this without."""
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


def _begins_step(tokens: Sequence[Token], place: int, d: str) -> bool:
    texts = [token.text for token in tokens[place : place + 2]]
    return texts[:1] == [d] and len(texts) > 1 and begins_letter(texts[1])


def _skip_power(tokens: Sequence[Token], place: int) -> int:
    """Return the place behind a power, this one without one."""
    if [token.text for token in tokens[place : place + 2]] != ["^", "{"]:
        return place
    return find_brace(tokens, place + 2) + 1


def _skip_operand(tokens: Sequence[Token], place: int, names: Names) -> int:
    """Return the place behind a letter or what stands in brackets, this one without them."""
    text = tokens[place].text if place < len(tokens) else ""
    if text in ("(", "["):
        return place + find_close([token.text for token in tokens[place:]]) + 1
    return _skip_letter(tokens, place, names) if begins_letter(text) else place


def _skip_letter(tokens: Sequence[Token], place: int, names: Names) -> int:
    match = names.match(tokens, place)
    return match.end if match else find_end(tokens, place)


def _brace(inside: Sequence[Token], *before: str) -> list[Token]:
    """Return signs in braces that take no place, with these signs before them."""
    start, end = inside[0].start, inside[-1].end
    opening = [Token(text, start, start) for text in (*before, "{")]
    return [*opening, *inside, Token("}", end, end)]
