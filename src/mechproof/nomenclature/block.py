r"""The block that declares a paper's letters: its lines -> what they declare.

A line is `name [| alias ...] [as symbol] [; name ...] [3x3] [(t)] : meaning [unit] {0<e<1} …`, or
begins with a word: `factor`, `function`, `where`, `let`, `claim`, `branch`, `natural`, `integer`,
`imaginary`, `from`, `sizes`, and, for single equations, `constraint`, `identity`, `modulo 2\pi`,
`follows`, `skip`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import NamedTuple

from mechproof.record.unit_notation import spell_unit
from mechproof.sources.located_text import Files, LocatedText, Place

_SHAPE = re.compile(r"\s\[?(\d+)\s*x\s*(\d+)\]?\s*\Z")
_MOVED = re.compile(r"(?P<name>\S+)\s+(?P<shape>\d+x\d+)\s*\(\s*(?P<by>[^()]+?)\s*\)\s*\Z")
_RUNNING = re.compile(r"\(\s*([^()]+?)\s*\)\s*\Z")
_COLON = re.compile(r"\s*:(?:\s+|\Z)")
_UNIT = re.compile(r"\[([^\[\]]*)\]")
_INNER = r"(?:[^{}]|\{[^{}]*\})*"
_BRACES = re.compile(rf"\{{((?:[^{{}}]|\{{{_INNER}\}})*)\}}\s*")
_CONDITIONS = re.compile(rf"(?<![^\s\]])(?:{_BRACES.pattern})+\Z")
_REFERENCES = re.compile(r"(?:\([^()]*\)|display \d+)(?:, part \d+)?|[^\s,()]+")
_FAMILY = re.compile(r"(.+?)_\{?([a-z ,]+)\}?\Z", re.DOTALL)
_MEANS = re.compile(r"\s+is\s+")
_BRANCH = re.compile(r"(.+?)\s*=\s*\\pm\s*1\Z")
_CLAIM = "claim"
_MODULO = re.compile(r"(.+?)\s+(\(.*|display \d.*|[^\s\\]+)\Z")
# Prints of Euler's number, and meanings that name it.
_E = re.compile(r"\\mathrm\s*\{?\s*e\s*\}?|e")
_EULER = re.compile(
    r"\beuler['\u2019]?s? (?:number|constant)|\bbase of (?:the )?natural log|\beulersche zahl"
    r"|\bbasis (?:der|des) nat|\bnombre d['\u2019]euler|число эйлера|основание натур",
    re.IGNORECASE,
)


class BlockError(ValueError):
    """Lines of a block that cannot be read, with their places."""

    def __init__(self, faults: Iterable[Fault]) -> None:
        """Join all faults into one message, in the order of the lines."""
        self.faults = sorted({*faults})
        super().__init__("\n".join(map(str, self.faults)))


class Fault(NamedTuple):
    """The fault of a line of a block, counted from 1; 0 if it concerns no particular line."""

    number: int
    reason: str
    place: str = ""
    line: str = ""

    def __str__(self) -> str:
        return f"{self.place}: {self.reason}\n  {self.line}" if self.number else self.reason


@dataclass(frozen=True)
class Declared:
    """A letter: its prints, meaning, unit, conditions and shape.

    `running` is the letter that it depends on and is differentiated by; a bracket after a matrix is
    part of its name instead. `symbol` is the name of its symbol, if given. A bracket with the
    letters of the index declares a family, S_i (i), whose name is printed without the index.
    """

    names: tuple[str, ...]
    meaning: str = ""
    unit: str | None = None
    conditions: tuple[str, ...] = ()
    shape: tuple[int, int] | None = None
    running: str = ""
    symbol: str = ""
    is_family: bool = False
    place: Place | None = field(default=None, compare=False)


@dataclass
class Block:
    """Everything that blocks declare; statements on equations are keyed by names or labels."""

    letters: list[Declared] = field(default_factory=list)
    factors: list[str] = field(default_factory=list)
    functions: dict[str, str] = field(default_factory=dict)
    where: list[str] = field(default_factory=list)
    values: list[str] = field(default_factory=list)
    branches: list[str] = field(default_factory=list)
    natural: list[str] = field(default_factory=list)
    integer: list[str] = field(default_factory=list)
    sizes: list[str] = field(default_factory=list)
    start: str = ""
    imaginary: str = ""
    constraints: list[str] = field(default_factory=list)
    identities: list[str] = field(default_factory=list)
    modulo: dict[str, str] = field(default_factory=dict)
    follows: dict[str, tuple[str, ...]] = field(default_factory=dict)
    skipped: dict[str, str] = field(default_factory=dict)
    scopes: list[tuple[list[str], dict[str, str]]] = field(default_factory=list)
    claims: list[LocatedText] = field(default_factory=list)
    lines: list[tuple[Place, str]] = field(default_factory=list)

    faults: list[Fault] = field(default_factory=list)

    @contextmanager
    def blame(self, text: str, place: Place | None = None) -> Iterator[None]:
        """Record a `ValueError` as a fault of the line at `place`, or the first with `text`."""
        try:
            yield
        except ValueError as error:
            whole = re.compile(rf"(?<![\w\\]){re.escape(text)}(?!\w)")
            found = (n for n, line in self.lines if (n == place if place else whole.search(line)))
            where = next(found, None)
            line = dict(self.lines)[where] if where else ""
            self.faults.append(_find_fault(error, where, line))

    def refuse_faults(self) -> None:
        """Raise `BlockError` with all faults, if there are any."""
        if self.faults:
            raise BlockError(self.faults)


def _find_fault(error: ValueError, place: Place | None, line: str) -> Fault:
    return Fault(place.line if place else 0, str(error), str(place or ""), line)


def read_block(lines: Sequence[LocatedText], files: Files) -> Block:
    """Read the lines of a block; raises `BlockError` with the places of unreadable ones."""
    block = Block()
    for line in lines:
        word, _, rest = line.string.partition(" ")
        place = files.locate(line.offsets[0])
        block.lines.append((place, line.string))
        try:
            if word == _CLAIM and rest.strip():
                block.claims.append(line[len(word) :].strip())
            elif word in _WORDS and not _COLON.search(line.string):
                _WORDS[word](block, rest.strip())
            elif word in _TOLD:
                equations, *said = _COLON.split(rest, maxsplit=1)
                enter, remedy = _TOLD[word]
                if not said or not said[0].strip():
                    raise ValueError(remedy)
                enter(block, _find_references(equations), said[0].strip())
            else:
                block.letters += [replace(x, place=place) for x in _read_letters(line.string)]
        except ValueError as error:
            block.faults.append(_find_fault(error, place, line.string))
    block.refuse_faults()
    block.values += _find_euler(block)
    return block


def _find_euler(block: Block) -> list[str]:
    """Return values for letters e whose meaning says Euler's number and that have no value yet."""
    given = {text.partition("=")[0].strip() for text in block.values}
    found = (x.names[0] for x in block.letters if _EULER.search(x.meaning))
    return [rf"{name}=\exp(1)" for name in found if _E.fullmatch(name) and name not in given]


def _read_letters(line: str) -> list[Declared]:
    left, *rest = _COLON.split(line, maxsplit=1)
    if not rest or not left.strip():
        raise ValueError(
            "neither a letter, `name : meaning [unit] {relation}`, nor one of the words "
            + ", ".join((*_WORDS, *_TOLD, _CLAIM))
        )
    (right,) = rest
    if right.count("{") != right.count("}"):
        raise ValueError("after the colon a brace is not closed, or not opened")
    braces = _CONDITIONS.search(right)
    right = right[: braces.start()] if braces else right
    found = _UNIT.search(right)
    unit = spell_unit(found[1]) if found else None
    meaning = " ".join(_UNIT.sub("", right).split())
    said, last = tuple(_BRACES.findall(braces[0])) if braces else (), _SHAPE.search(left)
    found_letters = []
    for text in _split(left, ";"):
        if moved := _MOVED.search(text):
            raise ValueError(
                f"a matrix that depends on {moved['by']}: leave ({moved['by']}) out, and declare "
                f"its derivative on its own line, \\dot {moved['name']} {moved['shape']}"
            )
        # The shape of the last letter applies to all letters of the line without a shape of their
        # own.
        shape = _SHAPE.search(text) or last
        size = (int(shape[1]), int(shape[2])) if shape else None
        found_letters.append(_read_letter(_SHAPE.sub("", text), meaning, unit, said, size))
    return found_letters


def _read_letter(
    text: str,
    meaning: str,
    unit: str | None,
    conditions: tuple[str, ...],
    shape: tuple[int, int] | None,
) -> Declared:
    text, _, symbol = text.partition(" as ")
    names = _split(text, "|")
    if any(name.count("{") != name.count("}") for name in names):
        raise ValueError(f"the name {text.strip()!r} has unbalanced braces")
    if not all(any(sign.isalpha() for sign in name) for name in names):
        raise ValueError(f"the name {text.strip()!r} has no letter")
    running = None if shape else _RUNNING.search(names[0])
    by = running[1] if running else ""
    stem = names[0][: running.start()].strip() if running else names[0]
    family = _FAMILY.match(stem) if by and len(names) == 1 else None
    signs, own = _list_signs(family[2]) if family else [], _list_signs(by)
    if family and own and signs[-len(own) :] == own:
        # Signs in front of the index letters belong to the name: d_{bi} (i).
        before = "".join(signs[: -len(own)])
        printed = f"{family[1]}_{{{before}#}}" if before else family[1]
        name = symbol.strip() or stem
        return Declared((printed,), meaning, unit, conditions, symbol=name, is_family=True)
    # A letter that depends on several others is not differentiated by any.
    by = "" if "," in by else by
    names[0] = stem if by else names[0]
    return Declared(tuple(names), meaning, unit, conditions, shape, by, symbol.strip())


def _split(text: str, at: str = ",;") -> list[str]:
    """Return the parts of a line between the separators `at` outside brackets and braces."""
    parts, depth = [""], 0
    for before, sign in pairwise(f" {text}"):
        depth += (sign in "([{") - (sign in ")]}")
        if sign in at and depth == 0 and before != "\\":
            parts.append("")
        else:
            parts[-1] += sign
    return [part.strip() for part in parts]


def _list_signs(index: str) -> list[str]:
    return [sign for sign in index if sign.isalpha()]


def _add(name: str) -> Callable[[Block, str], None]:
    """Return a reader that adds the parts of a line, separated by , or ;, to a block's list."""

    def enter(block: Block, rest: str) -> None:
        if not rest:
            raise ValueError("nothing follows the word")
        parts = _split(rest)
        for part in parts:
            if part.partition(" ")[0] in (*_WORDS, *_TOLD, _CLAIM):
                raise ValueError(f"a line has one word: {part!r} needs its own line")
        getattr(block, name).extend(parts)

    return enter


def _refer(name: str) -> Callable[[Block, str], None]:
    def enter(block: Block, rest: str) -> None:
        getattr(block, name).extend(_find_references(rest))

    return enter


def _find_references(rest: str) -> list[str]:
    found = _REFERENCES.findall(rest)
    if not found:
        raise ValueError("give the number or label of an equation: (4)")
    return found


def _branch(block: Block, rest: str) -> None:
    for part in _split(rest):
        found = _BRANCH.match(part)
        if found is None:
            raise ValueError(rf"a branch is written letter=\pm1, not {part}")
        block.branches.append(found[1])


def _modulo(block: Block, rest: str) -> None:
    found = _MODULO.match(rest)
    if found is None:
        raise ValueError(r"write modulo 2\pi (5)")
    block.modulo |= dict.fromkeys(_find_references(found[2]), found[1])


def _skip(block: Block, equations: list[str], reason: str) -> None:
    block.skipped |= dict.fromkeys(equations, reason)


def _follow(block: Block, equations: list[str], others: str) -> None:
    block.follows |= dict.fromkeys(equations, tuple(_find_references(others)))


def _function(block: Block, rest: str) -> None:
    pairs = _read_pairs(rest)
    if not pairs:
        raise ValueError(r"state which function the print is: function \tan^{-1} is \arctan")
    block.functions |= pairs


def _read_pairs(text: str) -> dict[str, str]:
    """Read prints and what they stand for, A is A_r, B is B_r; {} if a part has no "is"."""
    pairs = [_MEANS.split(part) for part in _split(text)]
    return {} if any(len(pair) != 2 for pair in pairs) else dict(pairs)


def _scope(block: Block, equations: list[str], said: str) -> None:
    pairs = _read_pairs(said)
    if not pairs:
        raise ValueError(_SAY_WHICH)
    block.scopes.append((equations, pairs))


def _imaginary(block: Block, rest: str) -> None:
    letter = rest.removeprefix(r"\mathrm{").removesuffix("}")
    if not (len(letter) == 1 and letter.isalpha()):
        raise ValueError("name the imaginary unit: imaginary j")
    block.imaginary = rest


_WORDS: dict[str, Callable[[Block, str], None]] = {
    "factor": _add("factors"),
    "function": _function,
    "where": _add("where"),
    "let": _add("values"),
    "branch": _branch,
    "natural": _add("natural"),
    "integer": _add("integer"),
    "imaginary": _imaginary,
    "from": lambda block, rest: setattr(block, "start", rest),
    "sizes": _add("sizes"),
    "constraint": _refer("constraints"),
    "identity": _refer("identities"),
    "modulo": _modulo,
}
_SAY_WHICH = "state which declared letter each print is: in (8)-(13): A is A_r"
# Words whose equations are followed by a colon, and the remedy if it is missing.
_TOLD: dict[str, tuple[Callable[[Block, list[str], str], None], str]] = {
    "follows": (_follow, "name the equations it follows from: follows (5): (3), (4)"),
    "skip": (_skip, "give the reason: skip (3): reason"),
    "in": (_scope, _SAY_WHICH),
}
