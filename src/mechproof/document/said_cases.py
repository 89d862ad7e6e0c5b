r"""Values that the words around an equation give letters for one case: for $a=b$ it becomes.

They may prove what is printed for the case, but refute nothing: the words may mean something else.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import sympy as sp

from mechproof.document.known import Known, Values
from mechproof.document.tasks import Sign
from mechproof.nomenclature.inline import Inline, find_inline
from mechproof.nomenclature.said_relations import read_relations
from mechproof.sources.displays import DISPLAY, Printed
from mechproof.sources.paper_files import Source

# Words that introduce a case in the sentence before a formula, or right after a display.
_CASE = re.compile(
    r"(?<!solved )(?<!solve )\b(?:for|if|when|in the case)\b[^.;:]*\Z", re.IGNORECASE
)
_AFTER = re.compile(r"[\s.,;]*(?:if|for|when|provided(?:\s+that)?)\s+\Z")


@dataclass(frozen=True)
class SaidCase:
    """A value said of a letter, its place in the text, and the display it follows, if any."""

    letter: sp.Basic
    value: sp.Expr
    place: int
    display: tuple[int, int] | None


class SaidCases:
    """The cases that the words of a paper mention, in their order."""

    def __init__(self, source: Source, printed: Sequence[Printed], known: Known) -> None:
        """Find the values that sentences give letters for a case."""
        self.printed, self.known = printed, known
        self.order = {offset: place for place, offset in enumerate(source.text.offsets)}
        self.displays = [match.span() for match in DISPLAY.finditer(source.text.string)]
        self.text = source.text.string
        names = {name: v.symbol for v in known.symbols.variables for name in v.latex}
        self.found = [case for one in find_inline(source, names) for case in self._read(one)]

    def _read(self, one: Inline) -> Iterator[SaidCase]:
        place = self.order[one.offset]
        span = next((x for x in reversed(self.displays) if x[1] <= place), None)
        words = self.text[span[1] if span else 0 : place]
        is_after = bool(span and _AFTER.fullmatch(words))
        is_angle = one.number is not None and one.unit in ("", "rad", "deg")
        if not (is_after or _CASE.search(words)) or not (one.number is None or is_angle):
            return
        try:
            (relation,) = read_relations(f"{one.letter}={one.value}", self.known.symbols.reader())
            letter, value = relation.args
        except ValueError:
            return
        is_value = isinstance(letter, sp.Symbol) and isinstance(value, sp.Expr)
        if is_value and letter not in {*self.known.values, *value.free_symbols}:
            yield SaidCase(letter, value, place, span if is_after else None)

    def list_at(self, printed: Printed, signs: Sequence[Sign]) -> Values:
        """Return the values that words around an equation give letters, if unique for the letter.

        Zeros before it are found elsewhere. Numbers are left out for letters that the equation
        prints: it does not hold for that case only.
        """
        if printed.announced.is_general:
            return {}
        place, scope = self._find_place(printed), printed.announced.scope
        before = self.printed[: self.printed.index(printed)]
        last = next((x for x in reversed(before) if x.announced.scope != scope), None)
        first = self._find_place(last) if last else -1
        met = {letter for sign in signs for letter in sign.printed}
        said: dict[sp.Basic, set[sp.Expr]] = {}
        for one in self.found:
            is_before = one.display is None and first < one.place < place and one.value != 0
            is_after = one.display is not None and one.display[0] <= place < one.display[1]
            if is_before or is_after:
                said.setdefault(one.letter, set()).add(one.value)
        values = {s: next(iter(ones)) for s, ones in said.items() if len(ones) == 1}
        return {s: v for s, v in values.items() if v.free_symbols or s not in met}

    def _find_place(self, printed: Printed) -> int:
        return self.order.get(printed.latex.offsets[printed.taken], -1)
