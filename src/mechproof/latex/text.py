"""Tree -> "read as": one line that shows the structure without ambiguity."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import repeat
from typing import Any

import sympy as sp

from mechproof.latex.tree import (
    Add,
    Approach,
    At,
    Bracket,
    Calculated,
    Call,
    Cases,
    Chain,
    Constant,
    Degrees,
    Derivation,
    Dotted,
    Entries,
    Excerpt,
    Extremum,
    Integration,
    Letter,
    Magnitude,
    Measure,
    Node,
    Number,
    Power,
    Product,
    Quotient,
    Radical,
    Repeated,
    Table,
    Transposed,
    shows_matrix,
    strip,
    walk,
)
from mechproof.latex.words import AND

_SIGNS = {AND: "and", r"\le": "<=", r"\ge": ">=", r"\ne": "!=", r"\approx": "~", r"\equiv": "=="}
# Nodes that never need brackets; all others get them within powers and products.
_CLOSED = (
    *(Number, Constant, Letter, Call, Radical, Repeated, Integration, Magnitude, Entries, Table),
    Approach,
    Extremum,
)


def write(node: Node) -> str:
    """Return the unambiguous text of a node."""
    return _RULES[type(node)](node)


def write_sign(sign: str) -> str:
    """Return a relation sign."""
    return _SIGNS.get(sign, sign)


def _closed(node: Node) -> str:
    """Write a node so that it can be an operand of `^` or a divisor, in brackets if necessary."""
    node = strip(node)
    is_plain = isinstance(node, _CLOSED) and not (isinstance(node, Call) and node.exponent)
    return write(node) if is_plain else f"({write(node)})"


def _factor(node: Node) -> str:
    node = strip(node)
    is_sum = isinstance(node, Add | Cases | Chain | Derivation | Dotted | Product | Quotient)
    return f"({write(node)})" if is_sum else write(node)


def _letter(node: Letter) -> str:
    name = str(node.symbol)
    return f"{name}[{', '.join(map(write, node.indices))}]" if node.indices else name


def _add(node: Add) -> str:
    terms = [(sign, strip(term)) for sign, term in node.terms]
    texts = [f"({write(t)})" if isinstance(t, Add | Cases | Dotted) else write(t) for _, t in terms]
    signs = [" + " if sign > 0 else " - " for sign, _ in terms]
    text = "".join(sign + part for sign, part in zip(signs, texts, strict=True))
    return text[3:] if text.startswith(" + ") else f"-{text[3:]}"


def _product(node: Product) -> str:
    """Write factors, with a cross where that may differ from a dot."""
    text = _factor(node.factors[0])
    has_vectors = any(map(shows_matrix, walk(node)))
    for sign, factor in zip(node.signs or repeat(""), node.factors[1:], strict=False):
        text += (" x " if sign == r"\times" and has_vectors else "*") + _factor(factor)
    return text


def _quotient(node: Quotient) -> str:
    above = strip(node.above)
    is_sum = isinstance(above, Add | Cases | Product | Quotient)
    return (f"({write(above)})" if is_sum else write(above)) + f"/{_closed(node.below)}"


def _call(node: Call) -> str:
    inside = ", ".join(write(strip(a)) for a in node.arguments) if node.arguments else "nothing"
    power = f"^{_closed(node.exponent)}" if node.exponent else ""
    return f"{node.function.name}({inside}){power}"


def _repeated(node: Repeated) -> str:
    index = node.index.symbol
    apart = "".join(f", {index} != {write(other)}" for other in node.apart)
    limits = f"{index} = {write(node.low)}..{write(node.high)}{apart}"
    return f"{node.name}[{limits}]({write(strip(node.term))})"


def _dotted(node: Dotted) -> str:
    if node.name == "product":
        return "*".join((*(_factor(x) for _, x in node.first), "...", _factor(node.last[1])))
    before = _add(Add(node.first, start=node.start, end=node.end))
    sign, term = node.last
    last = f"({write(term)})" if isinstance(strip(term), Add) else write(term)
    return f"{before} + ... {'+' if sign > 0 else '-'} {last}"


def _integration(node: Integration) -> str:
    limits = f"[{write(node.low)}..{write(node.high)}]" if node.low and node.high else ""
    d = f" d({write(strip(node.differential))})" if node.differential else " without differential"
    return f"integral{limits}({_factor(node.integrand)}{d})"


def _derivation(node: Derivation) -> str:
    shown = _factor(node.order) if isinstance(node.order, Node) else str(node.order)
    order = f"^{shown}" if node.order != 1 else ""
    d = "∂" if node.is_partial else "d"
    return f"{d}{order}({write(strip(node.of))})/{d}({write(node.by)}){order}"


def _approach(node: Approach) -> str:
    side = {"+": " from above", "-": " from below"}.get(node.side, "")
    return f"limit[{write(node.by)} -> {write(node.point)}{side}]({write(strip(node.term))})"


def _root(node: Radical) -> str:
    inside = write(strip(node.radicand))
    return f"root({inside}, {write(node.degree)})" if node.degree else f"sqrt({inside})"


def _excerpt(node: Excerpt) -> str:
    limits = [":" if r is None else "..".join(map(str, dict.fromkeys(r))) for r in node.ranges]
    return f"{_closed(node.of)}[rows {limits[0]}, columns {', '.join(limits[1:]) or ':'}]"


def _cases(node: Cases) -> str:
    pieces = [
        f"{write(value) if value else 'nothing'} if {write(condition)}"
        for value, condition in node.pieces
    ]
    pieces += [f"else {write(node.otherwise)}"] if node.otherwise else []
    return "{" + "; ".join(pieces) + "}"


def _chain(node: Chain) -> str:
    text = write(node.members[0])
    for sign, member in zip(node.relations, node.members[1:], strict=True):
        text += f" {write_sign(sign)} {write(member)}"
    return text + (f" if {write(node.condition)}" if node.condition else "")


_RULES: Mapping[type, Callable[[Any], str]] = {
    Number: lambda node: str(node.text),
    Measure: lambda node: f"{node.number.text} {node.unit}",
    Calculated: lambda node: write(node.of),
    Constant: lambda node: "oo" if node.value is sp.oo else str(node.text),
    Letter: _letter,
    Bracket: lambda node: write(node.inside),
    Add: _add,
    Product: _product,
    Quotient: _quotient,
    Dotted: _dotted,
    Power: lambda node: f"{_closed(node.base)}^{_closed(node.exponent)}",
    Radical: _root,
    Call: _call,
    Repeated: _repeated,
    Integration: _integration,
    Derivation: _derivation,
    Approach: _approach,
    Extremum: lambda node: f"{node.name}[{write(node.by)}]({write(strip(node.term))})",
    At: lambda node: f"({write(node.term)} at {write(node.by)} = {write(node.point)})",
    Table: lambda node: f"[{'; '.join(', '.join(map(write, row)) for row in node.rows)}]",
    Entries: lambda node: f"({', '.join(map(write, node.parts))})",
    Excerpt: _excerpt,
    Transposed: lambda node: f"{_closed(node.of)}^T",
    Magnitude: lambda node: f"|{write(node.inside)}|",
    Degrees: lambda node: f"{_closed(node.number)} deg",
    Cases: _cases,
    Chain: _chain,
}
