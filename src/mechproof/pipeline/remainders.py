r"""Remainders of a single equation: \sin x=x+O(x^3) says what a quotient comes to for x to 0."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import sympy as sp

from mechproof.latex.latex_signs import measure_depths
from mechproof.latex.tokens import tokenize
from mechproof.proof.limits import settle_limits
from mechproof.proof.signs import is_nonzero
from mechproof.record import Equality, Row
from mechproof.statement_domains.domain import Domain

_GAP = r"(?:[\s,]|\\q?quad|\\[,;\s]|\\text\{\s*(?:as|for)?\s*\})*"
_REMAINDER = re.compile(
    r"\+\s*(?P<kind>O|o|\\mathcal\s*\{?O\}?)\s*(?:\\left|\\bigl)?\s*\(\s*"
    r"(?P<by>[A-Za-z]|\\[a-z]+)\s*(?:\^\s*\{?(?P<power>\d+)\}?)?\s*(?:\\right|\\bigr)?\s*\)"
    rf"(?:{_GAP}\(?\s*(?P=by)\s*\\to\s*0\s*\)?)?(?P<behind>\s*(?:,|\\q?quad|\\text).*)?\s*\Z"
)


@dataclass(frozen=True)
class Remainder:
    """A power of what goes to 0, with which a remainder is compared.

    If it `is_bounded`, their quotient comes to any number, else to 0.
    """

    power: int
    is_bounded: bool


def take_remainder(latex: str) -> tuple[str, Remainder | None]:
    r"""Return an equation with O(x^n) or o(x^n) behind it as the limit that this says."""
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
    return limit + (found["behind"] or ""), Remainder(power, found["kind"] != "o")


def give_limits(
    rows: Sequence[Row], printed: str, domain: Domain, remainder: Remainder
) -> tuple[Row, ...]:
    """Return rows with their print, which say what is shown of their limits.

    Where the quotient by a lower power does not vanish, it is refuted that it does.
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
