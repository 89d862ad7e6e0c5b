r"""Remainders and congruences: a\bmod n, and a\equiv b\pmod n, where both leave the same one."""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sp

from mechproof.latex.tree import Add, Call, Node, PrintedFunction

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

_BESIDE = (r"\bmod", r"\mod")
_AFTER = (r"\pmod", r"\pod")
_BRACKETED = (*_BESIDE, r"\text{mod}")
SIGNS = (*_AFTER, *_BRACKETED)
_REMAINDER = PrintedFunction("mod", lambda number, by: number - by * sp.floor(number / by))


def is_next(parser: Parser) -> bool:
    r"""Return whether a modulus comes next: \bmod n, \pmod n, (\text{mod }n)."""
    is_bracketed = parser.text == "(" and parser.peek() in _BRACKETED
    return is_bracketed or parser.text in (*_BESIDE, *_AFTER)


def read_remainder(parser: Parser, number: Node, before: str) -> Node:
    r"""Read a\bmod n after a; in a congruence, a\equiv b+c\bmod n, a sum needs no brackets."""
    if parser.text not in _BESIDE:
        return number
    is_sum = isinstance(number, Add) and before != r"\equiv"
    parser.take()
    by = parser.read_product()
    if is_sum or parser.text in parser.signs:
        raise parser.refuse(
            "a remainder next to a sum: of the whole sum, or of its last term?",
            r"Print brackets: (a+b)\bmod n, a+(b\bmod n).",
            number.start,
        )
    return Call(_REMAINDER, (number, by), start=number.start, end=parser.end)


def read_congruence(parser: Parser, members: list[Node], relations: list[str]) -> list[Node]:
    """Return the remainders that a congruence equates, or the members unchanged if it is none."""
    last = members[-1]
    if is_next(parser) and {*relations} <= {"=", r"\equiv"}:
        by = _read_after(parser)
    elif relations[-1:] == [r"\equiv"] and isinstance(last, Call) and last.function is _REMAINDER:
        members[-1], by = last.arguments
    else:
        return members
    ends = [*(one.end for one in members[:-1]), parser.end]
    return [
        Call(_REMAINDER, (one, by), start=one.start, end=end)
        for one, end in zip(members, ends, strict=True)
    ]


def _read_after(parser: Parser) -> Node:
    if parser.skip(*_AFTER):
        return parser.read_group()
    parser.take("(")
    parser.take()
    by = parser.read_sum()
    parser.take(")")
    return by
