"""Letters that are said to depend on others and have no value: what must not be taken as fixed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import sympy as sp

from mechproof.latex.values import Moving, list_reached

if TYPE_CHECKING:
    from mechproof.latex.meaning import Meaning


def refuse_unknown(meaning: Meaning, place: int, said: tuple[Any, str], by: sp.Basic) -> None:
    """Refuse a term in which what is said to depend on a letter has no value."""
    term, where = said
    if unknown := _list_unknown(meaning, term, _list_moving(by, meaning.moving)):
        told = "depends on {}, and is" if len(unknown) == 1 else "depend on {}, and are"
        raise meaning.source.refuse(
            place,
            f"{', '.join(unknown)} {where} {told.format(by)} not printed",
            "Say in the block of letters what it is, let name=value, or that it is constant.",
        )


def list_beside(meaning: Meaning, term: Any, by: sp.Basic) -> list[str]:
    """Return what has no value in a term and depends on what a letter depends on."""
    carrier = _find_carrier(by, meaning.moving)
    beside = {carrier} | _list_moving(carrier, meaning.moving)
    return _list_unknown(meaning, term, beside) if by in beside - {carrier} else []


def _list_unknown(meaning: Meaning, term: Any, moving: set[sp.Basic]) -> list[str]:
    known = meaning.values.keys()
    return sorted(map(str, list_reached(term.free_symbols, meaning.values) & moving - known))


def _list_moving(by: sp.Basic, moving: Moving) -> set[sp.Basic]:
    """Return the letters that depend on another, also through others, and their derivatives."""
    met, new = set[sp.Basic](), {by}
    while new:
        met |= new
        steps = ((s, *rates) for s, (other, rates) in moving.items() if other in new)
        new = {step for one in steps for step in one} - met
    return met - {by}


def _find_carrier(symbol: sp.Basic, moving: Moving) -> sp.Basic:
    """Return on what a letter or a derivative depends in the end, itself if on nothing."""
    carriers = (other for s, (other, rates) in moving.items() if symbol in (s, *rates))
    carrier = next(carriers, None)
    return symbol if carrier is None else _find_carrier(carrier, moving)
