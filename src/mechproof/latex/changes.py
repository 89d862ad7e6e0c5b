r"""What a correction changes: two prints in, both with what only one of them has marked, out.

The trees of their signs are laid beside each other so that the least has to be taken out of one
and put into the other; a root that goes leaves what it enclosed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby

from mechproof.latex.fragments import Fragment, Parts, join, measure, parse

# Signs that part the cells of a table are no part of a formula that can be marked.
PARTING = ("&", r"\\")
# Beyond so many signs nothing is compared, and beyond this share of changes nothing is marked.
LONGEST, MOST = 450, 0.5
# What opening costs besides its signs: only what largely stays is worth it.
OPENING = 2


@dataclass(frozen=True)
class Marked:
    """A part, whether the other print lacks it, and all that it holds likewise."""

    part: Fragment
    changed: bool
    slots: tuple[tuple[Marked, ...], ...]


@dataclass(frozen=True)
class Style:
    """How a change is written, and what stays within what is changed."""

    change: Callable[[str], str]
    keep: Callable[[str], str]


@dataclass(frozen=True)
class _Edit:
    cost: int
    left: tuple[Marked, ...]
    right: tuple[Marked, ...]

    def after(self, cost: int, left: Sequence[Marked], right: Sequence[Marked]) -> _Edit:
        """Return this edit behind what was done before it."""
        return _Edit(self.cost + cost, (*left, *self.left), (*right, *self.right))


def mark_changes(printed: str, mend: str, taken: Style, put: Style) -> tuple[str, str]:
    """Return both with marks: what the print alone has as `taken`, what the mend alone as `put`.

    Two that have little in common, or are very long, are returned as they are.
    """
    left, right = parse(printed), parse(mend)
    total = measure(left) + measure(right)
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
        """Return the cheapest way from one sequence to the other."""
        if (a, b) not in self.known:
            self.known[a, b] = self._find(a, b)
        return self.known[a, b]

    def _find(self, a: Parts, b: Parts) -> _Edit:
        if not a or not b:
            return _Edit(measure(a) + measure(b), _mark(a, changed=True), _mark(b, changed=True))
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
                cost = edit.cost + part.size - measure(held) + OPENING
                both = (opened, edit.right) if is_left else (edit.left, opened)
                yield _Edit(cost, *both)


def _mark(parts: Parts, *, changed: bool) -> tuple[Marked, ...]:
    return tuple(
        Marked(part, changed, tuple(_mark(slot, changed=changed) for slot in part.slots))
        for part in parts
    )


def _open(part: Fragment, place: int, held: tuple[Marked, ...]) -> Marked:
    """Mark a part as changed, but for what stands at one place in it."""
    slots = [_mark(slot, changed=True) for slot in part.slots]
    slots[place] = held
    return Marked(part, True, tuple(slots))


def _write(parts: Sequence[Marked], style: Style, *, within: bool = False) -> str:
    """Write parts that stand in what is changed, or in what is kept."""
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
