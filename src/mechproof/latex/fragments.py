r"""What a print consists of: LaTeX -> a tree of its signs, and back; nothing is read.

A root, a fraction, a bracket or a script holds what it encloses; any LaTeX will do.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from mechproof.latex.latex_signs import same_sign

# What opens and what closes, by its kind.
_OPENING = {"(": "b", "[": "b", "{": "{", r"\left": "l", r"\begin": "e"}
_CLOSING = {")": "b", "]": "b", "}": "{", r"\right": "l", r"\end": "e"}

SIGN = re.compile(
    r"\\(?:text|mbox|textrm|mathrm|operatorname\*?)\s*\{[^{}]*\}|\\(?:begin|end)\s*\{[^{}]*\}"
    r"|\\left\s*(?:\\[A-Za-z]+|\\.|.)|\\right\s*(?:\\[A-Za-z]+|\\.|.)|\\[A-Za-z]+\*?|\\.|\S",
    re.DOTALL,
)
# Commands whose arguments need no braces.
ARGUMENTS = {r"\frac": 2, r"\dfrac": 2, r"\tfrac": 2, r"\binom": 2, r"\sqrt": 1, r"\bar": 1}
# What is set, but says nothing: it stays with what stands before it.
SILENT = frozenset(
    (*(r"\,", r"\;", r"\:", r"\!", "\\ ", "~", r"\quad", r"\qquad"), r"\cdot", r"\limits")
)
SIZE = re.compile(r"^\\(?:left|right|[bB]igg?[lr]?)\s*")

Parts = tuple["Fragment", ...]


@dataclass(frozen=True, eq=False)
class Fragment:
    """A sign with its scripts, or what encloses other parts: `pieces` stand around them."""

    pieces: tuple[str, ...]
    inner: tuple[Parts, ...] = ()
    sub: Parts = ()
    sup: Parts = ()
    tail: str = ""

    @property
    def slots(self) -> tuple[Parts, ...]:
        """Return all that it holds: what it encloses, its index and its exponent."""
        return (*self.inner, self.sub, self.sup)

    @cached_property
    def label(self) -> tuple[str, ...]:
        r"""Return what it is by itself, alike for `\left(` and `(`."""
        return tuple(same_sign(SIZE.sub("", piece).rstrip("{")) for piece in self.pieces)

    @cached_property
    def same(self) -> tuple[object, ...]:
        """Return what is equal for parts that print alike."""
        return (self.label, *(tuple(p.same for p in slot) for slot in self.slots))

    @cached_property
    def size(self) -> int:
        """Return the number of its signs."""
        return 1 + sum(map(measure, self.slots))


def measure(parts: Parts) -> int:
    """Return the number of signs."""
    return sum(part.size for part in parts)


def join(texts: Sequence[str] | Iterator[str]) -> str:
    r"""Join pieces of LaTeX; \sin and x need a blank between them."""
    joined = ""
    for text in texts:
        apart = re.search(r"\\[A-Za-z]+$", joined) and re.match(r"[A-Za-z]", text)
        joined += f" {text}" if apart else text
    return joined


def parse(latex: str) -> Parts:
    """Return the tree of a print; brackets and braces without a partner are signs like others."""
    return _Parser(SIGN.findall(latex)).read_all()


class _Parser:
    def __init__(self, signs: Sequence[str]) -> None:
        self.signs = signs
        self.partners = dict(_match(signs))
        self.place = 0

    def read_all(self) -> Parts:
        return self._read(len(self.signs))

    def _read(self, end: int) -> Parts:
        parts: list[Fragment] = []
        while self.place < end:
            sign = self.signs[self.place]
            if sign in SILENT and parts:
                parts[-1] = replace(parts[-1], tail=join([parts[-1].tail, sign]))
                self.place += 1
            elif sign in ("_", "^", "'"):
                base = parts.pop() if parts else Fragment(("{}",))
                parts.append(self._read_script(base, sign, end))
            else:
                parts += self._read_item(end)
        return tuple(parts)

    def _read_script(self, base: Fragment, sign: str, end: int) -> Fragment:
        self.place += 1
        if sign == "'":
            return replace(base, sup=(*base.sup, Fragment((r"\prime",))))
        script = self._read_argument(end)
        if sign == "_":
            return replace(base, sub=base.sub + script)
        return replace(base, sup=base.sup + script)

    def _read_argument(self, end: int) -> Parts:
        """Read what stands in braces, or one sign."""
        if self.place >= end:
            return ()
        return self._read_braces(end) if self._peek(end) == "{" else self._read_item(end)

    def _read_braces(self, end: int) -> Parts:
        close = self.partners.get(self.place, end)
        self.place += 1
        inside = self._read(close)
        self.place = min(close + 1, end)
        return inside

    def _read_item(self, end: int) -> Parts:
        start, sign = self.place, self.signs[self.place]
        close = self.partners.get(start, end)
        if close < end:
            inside = self._read_braces(end)
            if sign != "{":
                return (Fragment((sign, self.signs[close]), (inside,)),)
            is_base = self._peek(end) in ("_", "^", "'") and len(inside) > 1
            return (Fragment(("{", "}"), (inside,)),) if is_base else inside
        self.place += 1
        return (self._read_command(sign, end),) if sign[0] == "\\" else (Fragment((sign,)),)

    def _read_command(self, sign: str, end: int) -> Fragment:
        arguments: list[Parts] = []
        opening = f"{sign}{{"
        if sign == r"\sqrt" and self._peek(end) == "[" and self.place in self.partners:
            (degree,) = self._read_item(end)
            return Fragment((r"\sqrt[", "]{", "}"), (degree.inner[0], self._read_argument(end)))
        least = ARGUMENTS.get(sign, 0)
        while len(arguments) < least or self._takes_braces(sign, end):
            if self.place >= end:
                break
            arguments.append(self._read_argument(end))
        if not arguments:
            return Fragment((sign,))
        return Fragment((opening, *["}{"] * (len(arguments) - 1), "}"), tuple(arguments))

    def _takes_braces(self, sign: str, end: int) -> bool:
        is_name = sign[1:].isalpha() and sign not in ARGUMENTS
        return is_name and self._peek(end) == "{" and self.place in self.partners

    def _peek(self, end: int) -> str:
        return self.signs[self.place] if self.place < end else ""


def _match(signs: Sequence[str]) -> Iterator[tuple[int, int]]:
    """Yield the places of what opens and of what closes it."""
    opened: list[tuple[int, str]] = []
    for place, sign in enumerate(signs):
        if kind := _find_kind(sign, _CLOSING):
            while opened and opened[-1][1] != kind and kind in "{le":
                opened.pop()
            if opened and opened[-1][1] == kind:
                yield opened.pop()[0], place
        elif kind := _find_kind(sign, _OPENING):
            opened.append((place, kind))


def _find_kind(sign: str, kinds: Mapping[str, str]) -> str:
    """Return the kind of what stands before a bracket, a bar or a name; arrows are none."""
    command = re.match(r"\\[a-z]+", sign)
    return kinds.get(command[0] if command else sign, "")
