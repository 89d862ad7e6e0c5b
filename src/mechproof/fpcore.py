"""FPCore: from texts of FPBench's benchmarks to straight-line programs and their input boxes.

The language is FPCore 2.0 (Damouche et al. 2017), of which the straight-line part in doubles is
read: `+ - * / sqrt fma`, functions, `let` and `let*`. All else is refused by its name and line.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from inspect import signature
from itertools import pairwise
from pathlib import Path
from types import MappingProxyType

from mechproof.programs.operations import KINDS, Kind
from mechproof.programs.program import Operand, Operation
from mechproof.roundoff.boxed import Range
from mechproof.roundoff.steps import CONSTANT, StraightLineProgram, make_step, name_constant

_TOKEN = re.compile(r'(?P<skip>\s+|;[^\n]*)|(?P<text>"(?:[^"\\]|\\.)*")|(?P<mark>[()\[\]])'
                    r'|(?P<atom>[^\s()\[\];"]+)')  # fmt: skip
_CLOSING = {"(": ")", "[": "]"}
# Depth of brackets: more than any formula has, and less than Python's own stack allows.
DEEPEST = 150


class FPCoreError(ValueError):
    """A text of FPCore that cannot be read; the message says where and why."""


@dataclass(frozen=True)
class Atom:
    """A word, a number or a text in quotes, with its line."""

    text: str
    line: int


@dataclass(frozen=True)
class Group:
    """The expressions in a pair of brackets, with the line of the opening one."""

    parts: tuple[Atom | Group, ...]
    line: int


Node = Atom | Group


def read_expressions(text: str) -> tuple[Node, ...]:
    """Return the expressions of a text; raises `FPCoreError` for brackets that do not match."""
    waiting: list[tuple[str, int, list[Node]]] = [("", 1, [])]
    for mark, line in _list_tokens(text):
        if mark in _CLOSING:
            if len(waiting) > DEEPEST:
                raise FPCoreError(f"line {line}: nested more than {DEEPEST} deep")
            waiting.append((mark, line, []))
        elif mark in _CLOSING.values():
            opening, start, parts = waiting.pop()
            if not waiting or _CLOSING.get(opening) != mark:
                raise FPCoreError(f"line {line}: {mark} closes nothing")
            waiting[-1][2].append(Group(tuple(parts), start))
        else:
            waiting[-1][2].append(Atom(mark, line))
    if len(waiting) > 1:
        opening, line, _ = waiting[-1]
        raise FPCoreError(f"line {line}: {opening} is not closed")
    return tuple(waiting[0][2])


def _list_tokens(text: str) -> Iterator[tuple[str, int]]:
    place, line = 0, 1
    while place < len(text):
        found = _TOKEN.match(text, place)
        if found is None:
            raise FPCoreError(f"line {line}: a text in quotes is not closed")
        if found.lastgroup != "skip":
            yield found.group(), line
        line += found.group().count("\n")
        place = found.end()


def read_file(path: Path) -> str:
    """Return the text of a file; raises `FPCoreError` if it is not UTF-8."""
    try:
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise FPCoreError(f"it is no text in UTF-8: {error.reason}") from error


_DECIMAL = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d{1,4})?", re.IGNORECASE)
_FRACTION = re.compile(r"[+-]?\d+/0*[1-9]\d*")
_HEXADECIMAL = re.compile(r"([+-]?)0x([0-9a-f]+)(?:\.([0-9a-f]+))?(?:p([+-]?\d{1,4}))?", re.I)


def read_number(text: str) -> Fraction | None:
    """Return the value of a number, or None for any other text."""
    if _DECIMAL.fullmatch(text) or _FRACTION.fullmatch(text):
        return Fraction(text)
    if found := _HEXADECIMAL.fullmatch(text):
        sign, whole, part, power = found.groups()
        digits = int(whole + (part or ""), 16) * Fraction(2) ** (
            int(power or 0) - 4 * len(part or "")
        )
        return -digits if sign == "-" else digits
    return None


def _count_operands(row: Kind) -> int:
    """Return the number of operands of a kind's meaning, or 1 for functions without a meaning."""
    return len(signature(row.meaning).parameters) - 1 if row.meaning else 1


# The operations of FPCore by name and number of operands, and their kinds here.
OPERATIONS: Mapping[tuple[str, int], str] = MappingProxyType(
    {(row.fpcore, _count_operands(row)): kind for kind, row in KINDS.items() if row.fpcore}
)
CONSTANTS: Mapping[str, str] = MappingProxyType({"PI": "#pi", "E": "#e"})
_FORMATS: Mapping[str, str] = MappingProxyType({":precision": "binary64", ":round": "nearestEven"})
_LETS = ("let", "let*")
# Whether the first side is the smaller one; strict or not makes no difference to a bound.
_SMALLER_FIRST = {"<": True, "<=": True, ">": False, ">=": False}


@dataclass(frozen=True)
class Core:
    """A straight-line program, the box of its arguments, and its line."""

    name: str
    straight: StraightLineProgram
    box: Mapping[str, Range]
    line: int


def read_cores(text: str) -> tuple[Core, ...]:
    """Return the cores of a text; `FPCoreError` names the line that is not straight-line."""
    cores = tuple(_read_core(node, number) for number, node in enumerate(read_expressions(text), 1))
    if not cores:
        raise FPCoreError("there is no FPCore")
    return cores


def _read_core(node: Node, number: int) -> Core:
    if isinstance(node, Atom) or _text(node.parts[:1]) != "FPCore":
        raise FPCoreError(f"line {node.line}: an FPCore begins with (FPCore")
    parts = list(node.parts[1:])
    name = ""
    if parts and isinstance(parts[0], Atom):
        name = str(_text(parts[:1]))
        parts = parts[1:]
    if len(parts) < 2 or not isinstance(parts[0], Group):
        raise FPCoreError(f"line {node.line}: an FPCore needs arguments and a body")
    arguments = _read_arguments(parts[0])
    properties = _read_properties(parts[1:-1])
    title = properties.get(":name")
    name = title.text.strip('"') if isinstance(title, Atom) else name or f"FPCore {number}"
    box = _read_box(properties.get(":pre"), arguments, node.line)
    return Core(name, _Writer(arguments).write(parts[-1]), box, node.line)


def _read_box(condition: Node | None, arguments: Sequence[str], line: int) -> Mapping[str, Range]:
    """Return the range of each argument; `FPCoreError` for a condition that is no finite box."""
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
                raise FPCoreError(f"line {line}: :pre gives no {kind} bound for {name}")
        if lows[name] > highs[name]:
            raise FPCoreError(
                f"line {line}: the range of {name}, [{lows[name]}, {highs[name]}], is empty"
            )
    return {name: (lows[name], highs[name]) for name in arguments}


def _list_ends(condition: Node, arguments: Sequence[str]) -> Iterator[tuple[str, Fraction, bool]]:
    if isinstance(condition, Atom):
        if condition.text != "TRUE":
            raise FPCoreError(f"line {condition.line}: {condition.text} in :pre is not a box")
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
        raise FPCoreError(f"line {condition.line}: {kind} in :pre is not a box")


def _read_end(small: Node, large: Node, arguments: Sequence[str]) -> tuple[str, Fraction, bool]:
    for one, other, is_low in ((large, small, True), (small, large, False)):
        if isinstance(one, Atom) and one.text in arguments:
            number = _find_number(other)
            if number is not None:
                return one.text, number, is_low
    raise FPCoreError(
        f"line {small.line}: :pre must compare an argument with a number to state a box"
    )


def _find_number(node: Node) -> Fraction | None:
    """Return a number, possibly with a sign or as a quotient of two; None for anything else."""
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


def _text(nodes: Sequence[Node]) -> str | None:
    return nodes[0].text if nodes and isinstance(nodes[0], Atom) else None


def _read_arguments(group: Group) -> tuple[str, ...]:
    names = tuple(_text((part,)) or "" for part in group.parts)
    if "" in names:
        raise FPCoreError(f"line {group.line}: an argument is a name; no other form is read")
    if twice := [name for name in names if names.count(name) > 1]:
        raise FPCoreError(f"line {group.line}: the argument {twice[0]} is repeated")
    return names


def _read_properties(nodes: Sequence[Node]) -> Mapping[str, Node]:
    properties: dict[str, Node] = {}
    for key, value in _pair(nodes):
        said = _text((value,))
        if key.text in _FORMATS and said != _FORMATS[key.text]:
            raise FPCoreError(
                f"line {key.line}: {key.text} {said}: only {_FORMATS[key.text]} is bounded"
            )
        properties[key.text] = value
    return properties


def _pair(nodes: Sequence[Node]) -> Iterator[tuple[Atom, Node]]:
    waiting = list(nodes)
    while waiting:
        key = waiting.pop(0)
        if not isinstance(key, Atom) or not key.text.startswith(":") or not waiting:
            raise FPCoreError(f"line {key.line}: a property is :key value")
        yield key, waiting.pop(0)


class _Writer:
    """Writes the steps of an expression in the order in which FPCore evaluates them."""

    def __init__(self, arguments: tuple[str, ...]) -> None:
        self._arguments = arguments
        self._operations: list[Operation] = []

    def write(self, node: Node) -> StraightLineProgram:
        output = self._find(node, {name: name for name in self._arguments})
        steps = tuple(map(make_step, self._operations))
        return StraightLineProgram(self._arguments, steps, (output,))

    def _find(self, node: Node, known: Mapping[str, Operand]) -> Operand:
        if isinstance(node, Atom):
            return self._find_atom(node, known)
        if not node.parts:
            raise FPCoreError(f"line {node.line}: () computes nothing")
        head = _text(node.parts[:1]) or "("
        if head in _LETS:
            return self._bind(node, known, one_by_one=head == "let*")
        kind = OPERATIONS.get((head, len(node.parts) - 1))
        if kind is None:
            raise FPCoreError(f"line {node.line}: {self._refuse(head, len(node.parts) - 1)}")
        return self._add(kind, *(self._find(part, known) for part in node.parts[1:]))

    def _refuse(self, head: str, count: int) -> str:
        if any(head == other for other, _ in OPERATIONS):
            return f"{head} does not take {count} operands"
        known = " ".join(dict.fromkeys(name for name, _ in OPERATIONS))
        return f"{head} is not straight-line arithmetic of doubles; known are {known}, let and let*"

    def _find_atom(self, atom: Atom, known: Mapping[str, Operand]) -> Operand:
        if atom.text in known:
            return known[atom.text]
        number = read_number(atom.text)
        if number is None and atom.text not in CONSTANTS:
            raise FPCoreError(f"line {atom.line}: {atom.text} is neither an argument nor a number")
        if number is None:
            return self._add(CONSTANT, CONSTANTS[atom.text])
        return self._find_number(number, atom)

    def _find_number(self, number: Fraction, atom: Atom) -> Operand:
        try:
            double = float(number)
        except OverflowError:
            raise FPCoreError(
                f"line {atom.line}: {atom.text} is beyond the range of doubles"
            ) from None
        if number == double:
            return double
        return self._add(CONSTANT, name_constant(number))

    def _bind(self, node: Group, known: Mapping[str, Operand], *, one_by_one: bool) -> Operand:
        if len(node.parts) != 3 or not isinstance(node.parts[1], Group):
            raise FPCoreError(f"line {node.line}: a let has ([name value] ...) and a body")
        inside = dict(known)
        for binding in node.parts[1].parts:
            name = _text(binding.parts[:1]) if isinstance(binding, Group) else None
            if name is None or not isinstance(binding, Group) or len(binding.parts) != 2:
                raise FPCoreError(f"line {binding.line}: a binding is [name value]")
            inside[name] = self._find(binding.parts[1], inside if one_by_one else known)
        return self._find(node.parts[2], inside)

    def _add(self, kind: str, *operands: Operand) -> Operand:
        # No name in FPCore has a space.
        result = f"step {len(self._operations) + 1}"
        self._operations.append(Operation(result, kind, operands))
        return result
