r"""A pasted print -> its statement, without its surroundings, and the conditions it holds under.

A remainder in a single equation, \sin x=x+O(x^3), gives the limit of a quotient as x goes to 0.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import sympy as sp

from mechproof.latex.latex_signs import measure_depths
from mechproof.latex.several_equations import EQUIVALENCES
from mechproof.latex.tokens import tokenize
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.pipeline.special_letters import take_set
from mechproof.proof.limits import settle_limits
from mechproof.proof.signs import is_nonzero
from mechproof.record import Equality, Row
from mechproof.statement_domains.domain import Domain

_WRAPPERS = (
    *(("$$", "$$"), ("$", "$"), (r"\[", r"\]"), (r"\(", r"\)")),
    *((rf"\begin{{{x}}}", rf"\end{{{x}}}") for x in ("equation", "equation*", "displaymath")),
)
_IMPLIES = (r"\Rightarrow", r"\implies", r"\Longrightarrow")
_LABEL = re.compile(r"\\(?:tag\*?|label)\{[^{}]*\}|\\n(?:onumber|otag)")


def unwrap(latex: str) -> str:
    """Return an equation without the delimiters, labels and punctuation around it in a paper."""
    text = _LABEL.sub("", latex).strip()
    for opening, closing in _WRAPPERS:
        if len(text) > len(opening) + len(closing) and text.startswith(opening):
            text = text.removeprefix(opening).removesuffix(closing).strip()
    kept = text.rstrip(".,;").rstrip()
    return f"{kept}." if kept.endswith(r"\right") else kept


def part_equivalence(pasted: Pasted) -> tuple[Pasted, Pasted] | None:
    """Return the two implications that an equation with a single double arrow states, or None."""
    one, other = _part_at_arrow(unwrap(pasted.latex), EQUIVALENCES)
    if not other:
        return None
    sides = ((one, other), (other, one))
    first, second = (replace(pasted, latex=b, where=(*pasted.where, a)) for a, b in sides)
    return first, second


def take_condition(pasted: Pasted) -> Pasted:
    """Take the left side of an implication with a single arrow as its right side's condition."""
    condition, conclusion = _part_at_arrow(pasted.latex, _IMPLIES)
    if not conclusion:
        return pasted
    return replace(pasted, latex=conclusion, where=(*pasted.where, condition))


def _part_at_arrow(latex: str, arrows: Sequence[str]) -> tuple[str, str]:
    """Return the parts before and after the only arrow of a print; the latter is "" without one."""
    found = [token for token in tokenize(latex) if token.text in arrows]
    if len(found) != 1:
        return latex, ""
    return latex[: found[0].start].strip(), latex[found[0].end :].strip()


def take_sets(pasted: Pasted) -> Pasted:
    r"""Let letters count that are said to, n\in\mathbb{N}; all letters are real numbers anyway."""
    taken = [take_set(text) for text in (pasted.latex, *pasted.where)]
    members = [(letter, kind) for _, letters, kind in taken for letter in letters]
    counts = [letter for letter, kind in members if kind.startswith("N")]
    zeros = [rf"{letter}\ge0" for letter, kind in members if kind == "N_0"]
    where = [text for text, _, kind in taken[1:] if text or not kind]
    natural = tuple(dict.fromkeys((*pasted.natural, *counts)))
    latex = taken[0][0] or pasted.latex
    return replace(pasted, latex=latex, where=(*where, *zeros), natural=natural)


_GAP = r"(?:[\s,]|\\q?quad|\\[,;\s]|\\text\{\s*(?:as|for)?\s*\})*"
_REMAINDER = re.compile(
    r"\+\s*(?P<kind>O|o|\\mathcal\s*\{?O\}?)\s*(?:\\left|\\bigl)?\s*\(\s*"
    r"(?P<by>[A-Za-z]|\\[a-z]+)\s*(?:\^\s*\{?(?P<power>\d+)\}?)?\s*(?:\\right|\\bigr)?\s*\)"
    rf"(?:{_GAP}\(?\s*(?P=by)\s*\\to\s*0\s*\)?)?(?P<after>\s*(?:,|\\q?quad|\\text).*)?\s*\Z"
)


@dataclass(frozen=True)
class Remainder:
    """A power of the variable that goes to 0, which a remainder is compared with.

    If it `is_bounded`, their quotient may tend to any number, otherwise to 0.
    """

    power: int
    is_bounded: bool


def take_remainder(latex: str) -> tuple[str, Remainder | None]:
    r"""Return an equation with O(x^n) or o(x^n) at its end as the limit that it states."""
    found = _REMAINDER.search(latex)
    before = latex[: found.start()] if found else ""
    tokens = tokenize(before)
    depths = measure_depths([token.text for token in tokens])
    signs = [t for t, depth in zip(tokens, depths, strict=True) if t.text == "=" and not depth]
    if found is None or len(signs) != 1:
        return latex, None
    left, right = before[: signs[0].start], before[signs[0].end :]
    difference = rf"\left({left.strip()}\right)-\left({right.strip()}\right)"
    by, power = found["by"], int(found["power"] or 1)
    limit = rf"\lim_{{{by}\to0}}\frac{{{difference}}}{{{by}^{{{power}}}}}=0"
    return limit + (found["after"] or ""), Remainder(power, found["kind"] != "o")


def give_limits(
    rows: Sequence[Row], printed: str, domain: Domain, remainder: Remainder
) -> tuple[Row, ...]:
    """Return rows, with the original print, that state what can be shown about their limits.

    If the quotient by a lower power does not vanish, the row states that it does, to be refuted.
    """
    given = []
    for row in rows:
        limit = row.says.printed if isinstance(row.says, Equality) else None
        if isinstance(limit, sp.Limit):
            says = _find_bound(limit, domain) if remainder.is_bounded else None
            row = replace(row, says=says or _find_lower(limit, domain, remainder.power) or row.says)
        given.append(replace(row, printed_latex=printed))
    return tuple(given)


def _find_bound(limit: sp.Limit, domain: Domain) -> Equality | None:
    value = settle_limits(limit, domain)
    return None if value == limit or value.is_infinite else Equality(limit, value, "member")


def _find_lower(limit: sp.Limit, domain: Domain, power: int) -> Equality | None:
    body, x, *way = limit.args
    for more in range(1, power + 1):
        lower = sp.Limit(body * x**more, x, *way)
        value = settle_limits(lower, domain)
        if value != lower and is_nonzero(value, domain):
            return Equality(lower, sp.S.Zero, "member")
    return None
