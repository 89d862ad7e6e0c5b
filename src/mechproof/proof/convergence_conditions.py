"""What has to be said of letters so that integrals, sums and limits have values.

Conditions are proposed by the forms that converge: powers at zero and at infinity, exponentials,
geometric series, the rows of the table of integrals; sums go up. That the sides are equal where
they hold is proved by the rungs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

import sympy as sp

from mechproof.proof.definedness import narrow_to, tell
from mechproof.proof.endless_sums import read_endless
from mechproof.proof.known_integrals import list_needed as list_of_table
from mechproof.proof.refutation import BALLS
from mechproof.proof.signs import is_shown
from mechproof.proof.verdict import Answer, Verdict
from mechproof.record import RecordError, Slack
from mechproof.record.parts import find_parts
from mechproof.statement_domains.domain import Domain

# Work limit: so many sets of conditions are tried.
_MOST_TRIED = 3
_ENDLESS = (sp.Integral, sp.Sum, sp.Limit)
_Decide = Callable[[Any, Any, Domain], Answer]


def find_condition(sides: tuple[Any, Any], domain: Domain, decide: _Decide) -> Answer | None:
    """Answer by a condition under which sides are proved equal, or differ; None for none."""
    for needs in _list_tried(sides, domain):
        # Of a part that has no point nothing is said.
        with suppress(RecordError, NotImplementedError):
            part = narrow_to(domain, needs)
            answer = decide(*sides, part) if part is not None else None
            if answer is not None and (found := _report(answer, needs)):
                return found
    return None


def _report(answer: Answer, needs: Sequence[Slack]) -> Answer | None:
    if answer.verdict is Verdict.REFUTED and answer.rung.endswith(BALLS):
        return answer
    if answer.verdict is not Verdict.PROVED:
        return None
    where = " and ".join(map(_write, needs))
    reason = f"both sides agree where {where}, which is not said"
    return replace(answer, verdict=Verdict.UNDECIDED, reason=reason)


def _write(need: Slack) -> str:
    """Write a need as one says it of a letter, where a term is linear in one."""
    number, strict = need
    letters = sorted(number.free_symbols, key=str)
    slope = sp.diff(number, letters[0])
    if not slope.is_number or len(sp.Add.make_args(number)) > 2:
        return tell(need)
    bound = sp.cancel(letters[0] - number / slope)
    sign = ">" if slope > 0 else "<"
    return f"{letters[0]} {sign}{'' if strict else '='} {bound}"


def _list_tried(sides: Sequence[Any], domain: Domain) -> list[list[Slack]]:
    nodes = {node for side in sides for node in find_parts(domain.resolve(side), *_ENDLESS)}
    nodes = {node for node in nodes if node.free_symbols}
    ordered = sorted(nodes, key=sp.default_sort_key)
    letters = {s for node in ordered for s in node.free_symbols if not s.is_integer}
    positive = [Slack(s, True) for s in sorted(letters, key=str)]
    proposed = [_join(ordered, _list_by_form), _join(ordered, list_of_table), positive]
    open_ones = (list(dict.fromkeys(n for n in p if not is_shown(n, domain))) for p in proposed)
    return list({frozenset(needs): needs for needs in open_ones if needs}.values())[:_MOST_TRIED]


def _join(nodes: Sequence[Any], find: Callable[[Any], Iterator[Slack]]) -> list[Slack]:
    return [need for node in nodes for need in find(node)]


def _list_by_form(node: Any) -> Iterator[Slack]:
    """List what is positive where powers and exponentials of what runs come to nothing."""
    if isinstance(node, sp.Sum):
        _, low, high = node.limits[0]
        if low.free_symbols and high.is_finite is not False:
            yield Slack(high - low, False)
        if (read := read_endless(node)) is not None:
            yield from _list_at_infinity(*read[:2], sp.oo)
    elif isinstance(node, sp.Limit):
        yield from _list_at_infinity(*node.args[:3])
    elif len(node.limits) == 1:
        variable, *ends = node.limits[0]
        powers = [p.exp for p in node.function.atoms(sp.Pow) if p.base == variable]
        for end in ends:
            yield from _list_at_infinity(node.function, variable, end)
            signs = {sp.S.Zero: 1, sp.oo: -1}
            yield from (Slack(signs[end] * (1 + p), True) for p in powers if end in signs)


def _list_at_infinity(function: sp.Expr, x: sp.Symbol, end: sp.Expr) -> Iterator[Slack]:
    if not end.is_infinite:
        return
    for node in sorted(function.atoms(sp.exp), key=sp.default_sort_key):
        if node.has(x) and node.args[0].is_polynomial(x):
            exponent = sp.Poly(node.args[0].subs(x, sp.sign(end) * x), x)
            yield Slack(-exponent.LC(), True)
    for power in sorted(function.atoms(sp.Pow), key=sp.default_sort_key):
        if power.exp.has(x) and power.exp.is_polynomial(x) and not power.base.has(x):
            yield from (Slack(1 - power.base, True), Slack(1 + power.base, True))
