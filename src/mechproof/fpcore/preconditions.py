"""Boxes: in, a precondition; out, for each argument the numbers between which it lies."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise

from mechproof.fpcore.s_expressions import Atom, FPCoreError, Node, read_number

Range = tuple[Fraction, Fraction]
# What is the smaller side; ends that are left out are no matter to a bound.
_SMALLER_FIRST = {"<": True, "<=": True, ">": False, ">=": False}


def read_box(condition: Node | None, arguments: Sequence[str], line: int) -> Mapping[str, Range]:
    """Return the range of each argument; `FPCoreError` for what is no box, or has no end."""
    lows: dict[str, Fraction] = {}
    highs: dict[str, Fraction] = {}
    for name, number, is_low in _list_ends(condition, arguments) if condition else ():
        if is_low:
            lows[name] = max(number, lows.get(name, number))
        else:
            highs[name] = min(number, highs.get(name, number))
    for name in arguments:
        for kind, known in (("lower", lows), ("upper", highs)):
            if name not in known:
                raise FPCoreError(f"line {line}: :pre says no {kind} end of {name}")
        if lows[name] > highs[name]:
            raise FPCoreError(f"line {line}: no {name} is in [{lows[name]}, {highs[name]}]")
    return {name: (lows[name], highs[name]) for name in arguments}


def _list_ends(condition: Node, arguments: Sequence[str]) -> Iterator[tuple[str, Fraction, bool]]:
    if isinstance(condition, Atom):
        if condition.text != "TRUE":
            raise FPCoreError(f"line {condition.line}: {condition.text} in :pre is no box")
        return
    head, *sides = condition.parts
    kind = head.text if isinstance(head, Atom) else "("
    if kind == "and":
        for side in sides:
            yield from _list_ends(side, arguments)
    elif kind in _SMALLER_FIRST and len(sides) > 1:
        ordered = sides if _SMALLER_FIRST[kind] else sides[::-1]
        for small, large in pairwise(ordered):
            yield _read_end(small, large, arguments)
    else:
        raise FPCoreError(f"line {condition.line}: {kind} in :pre is no box")


def _read_end(small: Node, large: Node, arguments: Sequence[str]) -> tuple[str, Fraction, bool]:
    for one, other, is_low in ((large, small, True), (small, large, False)):
        if isinstance(one, Atom) and one.text in arguments:
            number = _find_number(other)
            if number is not None:
                return one.text, number, is_low
    raise FPCoreError(
        f"line {small.line}: :pre compares what is not an argument and a number: it is no box"
    )


def _find_number(node: Node) -> Fraction | None:
    """Return a number, also one with a sign before it or a quotient of two."""
    if isinstance(node, Atom):
        return read_number(node.text)
    head, *operands = node.parts or (Atom("", node.line),)
    numbers = [_find_number(operand) for operand in operands]
    if not isinstance(head, Atom) or None in numbers:
        return None
    if head.text == "-" and len(operands) == 1:
        return -numbers[0]  # type: ignore[operator]
    if head.text == "/" and len(operands) == 2 and numbers[1]:
        return numbers[0] / numbers[1]  # type: ignore[operator]
    return None
