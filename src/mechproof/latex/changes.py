"""What a correction changes: takes two prints, returns both with their differences marked.

The trees of their signs are aligned at the least cost of removals and insertions; removing a root
leaves what it enclosed. The prints are not read as mathematics: a root, a fraction, a bracket or a
script merely holds what it encloses, so any LaTeX will do.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import groupby

from mechproof.latex.latex_signs import join, same_sign
from mechproof.latex.words import OPENS_WORDS

# Cell and row separators, which cannot be marked as parts of a formula.
PARTING = ("&", r"\\")
# Greatest number of signs of two prints that are compared, and greatest share of changed signs that
# is marked.
LONGEST, MOST = 450, 0.5
# Extra cost of changing what encloses parts that stay: worth it only if most of them do.
OPENING = 2
# Opening and closing signs -> their kinds; those of the same kind match.
_OPENERS = {"(": "b", "[": "b", "{": "{", r"\left": "l", r"\begin": "e"}
_CLOSERS = {")": "b", "]": "b", "}": "{", r"\right": "l", r"\end": "e"}

SIGN = re.compile(
    OPENS_WORDS + r"[^{}]*\}|\\(?:begin|end)\s*\{[^{}]*\}"
    r"|\\left\s*(?:\\[A-Za-z]+|\\.|.)|\\right\s*(?:\\[A-Za-z]+|\\.|.)|\\[A-Za-z]+\*?|\\.|\S",
    re.DOTALL,
)
# Commands whose arguments need no braces.
ARGUMENTS = {r"\frac": 2, r"\dfrac": 2, r"\tfrac": 2, r"\binom": 2, r"\sqrt": 1, r"\bar": 1}
# Signs without a meaning of their own: they stay with the part before them.
SILENT = frozenset(
    (*(r"\,", r"\;", r"\:", r"\!", "\\ ", "~", r"\quad", r"\qquad"), r"\cdot", r"\limits")
)
SIZE = re.compile(r"^\\(?:left|right|[bB]igg?[lr]?)\s*")

Parts = tuple["Fragment", ...]


@dataclass(frozen=True)
class Marked:
    """A part, whether the other print lacks it, and all the parts it holds, marked likewise."""

    part: Fragment
    changed: bool
    slots: tuple[tuple[Marked, ...], ...]


@dataclass(frozen=True)
class Style:
    """How a change is written, and how parts are written that are kept inside a change."""

    change: Callable[[str], str]
    keep: Callable[[str], str]


@dataclass(frozen=True)
class _Edit:
    cost: int
    left: tuple[Marked, ...]
    right: tuple[Marked, ...]

    def after(self, cost: int, left: Sequence[Marked], right: Sequence[Marked]) -> _Edit:
        """Return the edit that makes the given step first and then this edit."""
        return _Edit(self.cost + cost, (*left, *self.left), (*right, *self.right))


def mark_changes(printed: str, mend: str, taken: Style, put: Style) -> tuple[str, str]:
    """Return both prints, `taken` marking what only the first has, `put` what only the second has.

    Prints that have little in common, or are very long, are returned unchanged.
    """
    left, right = _parse(printed), _parse(mend)
    total = _measure(left) + _measure(right)
    if not 0 < total <= LONGEST:
        return printed, mend
    edit = _Alignment().align(left, right)
    if edit.cost > MOST * total:
        return printed, mend
    return _write(edit.left, taken), _write(edit.right, put)


class _Alignment:
    def __init__(self) -> None:
        self.known: dict[tuple[Parts, Parts], _Edit] = {}

    def align(self, a: Parts, b: Parts) -> _Edit:
        """Return the cheapest edit that turns one sequence into the other."""
        if (a, b) not in self.known:
            self.known[a, b] = self._find(a, b)
        return self.known[a, b]

    def _find(self, a: Parts, b: Parts) -> _Edit:
        if not a or not b:
            return _Edit(_measure(a) + _measure(b), _mark(a, changed=True), _mark(b, changed=True))
        if a[0].same == b[0].same:
            kept = _mark(a[:1], changed=False), _mark(b[:1], changed=False)
            return self.align(a[1:], b[1:]).after(0, *kept)
        return min(self._list_edits(a, b), key=lambda edit: edit.cost)

    def _list_edits(self, a: Parts, b: Parts) -> Iterator[_Edit]:
        first, second = a[0], b[0]
        if first.label == second.label:
            within = [self.align(x, y) for x, y in zip(first.slots, second.slots, strict=True)]
            left = Marked(first, False, tuple(edit.left for edit in within))
            right = Marked(second, False, tuple(edit.right for edit in within))
            cost = sum(edit.cost for edit in within)
            yield self.align(a[1:], b[1:]).after(cost, [left], [right])
        yield self.align(a[1:], b).after(first.size, _mark(a[:1], changed=True), ())
        yield self.align(a, b[1:]).after(second.size, (), _mark(b[:1], changed=True))
        for is_left, part in ((True, first), (False, second)):
            for place, held in enumerate(part.inner):
                edit = self.align(held + a[1:], b) if is_left else self.align(a, held + b[1:])
                own = edit.left if is_left else edit.right
                opened = _open(part, place, own[: len(held)]), *own[len(held) :]
                cost = edit.cost + part.size - _measure(held) + OPENING
                both = (opened, edit.right) if is_left else (edit.left, opened)
                yield _Edit(cost, *both)


def _mark(parts: Parts, *, changed: bool) -> tuple[Marked, ...]:
    return tuple(
        Marked(part, changed, tuple(_mark(slot, changed=changed) for slot in part.slots))
        for part in parts
    )


def _open(part: Fragment, place: int, held: tuple[Marked, ...]) -> Marked:
    """Mark a part as changed, except for the parts `held` in its slot number `place`."""
    slots = [_mark(slot, changed=True) for slot in part.slots]
    slots[place] = held
    return Marked(part, True, tuple(slots))


def _write(parts: Sequence[Marked], style: Style, *, within: bool = False) -> str:
    """Write parts; `within` says whether the part that encloses them is changed."""
    texts = []
    kinds = groupby(parts, key=lambda one: (one.changed, one.part.pieces[0] in PARTING))
    for (changed, is_parting), run in kinds:
        text = join(_write_part(marked, style) for marked in run)
        wrap = style.change if changed else style.keep
        texts.append(text if is_parting or changed is within else wrap(text))
    return join(texts)


def _write_part(marked: Marked, style: Style) -> str:
    *inner, sub, sup = (_write(slot, style, within=marked.changed) for slot in marked.slots)
    first, *others = marked.part.pieces
    text = join([first, *(t for pair in zip(inner, others, strict=True) for t in pair)])
    index = f"_{{{sub}}}" if sub else ""
    power = f"^{{{sup}}}" if sup else ""
    return join([text + index + power, marked.part.tail])


@dataclass(frozen=True, eq=False)
class Fragment:
    """A sign with its scripts, or a sign that encloses parts: those are put between `pieces`."""

    pieces: tuple[str, ...]
    inner: tuple[Parts, ...] = ()
    sub: Parts = ()
    sup: Parts = ()
    tail: str = ""

    @property
    def slots(self) -> tuple[Parts, ...]:
        """Return all that it holds: the parts it encloses, its index and its exponent."""
        return (*self.inner, self.sub, self.sup)

    @cached_property
    def label(self) -> tuple[str, ...]:
        r"""Return its signs without their contents, alike for `\left(` and `(`."""
        return tuple(same_sign(SIZE.sub("", piece).rstrip("{")) for piece in self.pieces)

    @cached_property
    def same(self) -> tuple[object, ...]:
        """Return a key that is equal for parts that print alike."""
        return (self.label, *(tuple(p.same for p in slot) for slot in self.slots))

    @cached_property
    def size(self) -> int:
        """Return the number of its signs, including those that it holds."""
        return 1 + sum(map(_measure, self.slots))


def _measure(parts: Parts) -> int:
    """Return the number of signs in all parts."""
    return sum(part.size for part in parts)


def _parse(latex: str) -> Parts:
    """Return the tree of a print; brackets and braces without a partner are plain signs."""
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
        """Read the content of braces, or a single sign."""
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
    """Yield the places of each opening sign and of the sign that closes it."""
    opened: list[tuple[int, str]] = []
    for place, sign in enumerate(signs):
        if kind := _find_kind(sign, _CLOSERS):
            while opened and opened[-1][1] != kind and kind in "{le":
                opened.pop()
            if opened and opened[-1][1] == kind:
                yield opened.pop()[0], place
        elif kind := _find_kind(sign, _OPENERS):
            opened.append((place, kind))


def _find_kind(sign: str, kinds: Mapping[str, str]) -> str:
    """Return the kind of a bracket or of the command in front of one, "" for other signs."""
    command = re.match(r"\\[a-z]+", sign)
    return kinds.get(command[0] if command else sign, "")
