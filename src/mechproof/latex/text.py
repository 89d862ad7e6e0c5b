"""Tree -> "read as": one line that shows the structure without ambiguity."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import repeat
from typing import Any

import sympy as sp

from mechproof.latex import tree
from mechproof.latex.words import AND

_SIGNS = {AND: "and", r"\le": "<=", r"\ge": ">=", r"\ne": "!=", r"\approx": "~", r"\equiv": "=="}
# Nodes that never need brackets; all others get them within powers and products.
_CLOSED = (
    *(tree.Number, tree.Constant, tree.Letter, tree.Call, tree.Radical, tree.Repeated),
    *(tree.Integration, tree.Magnitude, tree.Entries, tree.Table, tree.Approach, tree.Extremum),
)
# Nodes that need brackets as factors.
_COMPOUND = (
    *(tree.Add, tree.Cases, tree.Chain, tree.Derivation, tree.Dotted),
    *(tree.Product, tree.Quotient),
)


def write(node: tree.Node) -> str:
    """Return the unambiguous text of a node."""
    return _RULES[type(node)](node)


def write_sign(sign: str) -> str:
    """Return a relation sign."""
    return _SIGNS.get(sign, sign)


def _closed(node: tree.Node) -> str:
    """Write a node so that it can be an operand of `^` or a divisor, in brackets if necessary."""
    node = tree.strip(node)
    is_plain = isinstance(node, _CLOSED) and not (isinstance(node, tree.Call) and node.exponent)
    return write(node) if is_plain else f"({write(node)})"


def _factor(node: tree.Node) -> str:
    node = tree.strip(node)
    return f"({write(node)})" if isinstance(node, _COMPOUND) else write(node)


def _letter(node: tree.Letter) -> str:
    name = str(node.symbol)
    return f"{name}[{', '.join(map(write, node.indices))}]" if node.indices else name


def _add(node: tree.Add) -> str:
    terms = [(sign, tree.strip(term)) for sign, term in node.terms]
    sums = (tree.Add, tree.Cases, tree.Dotted)
    texts = [f"({write(t)})" if isinstance(t, sums) else write(t) for _, t in terms]
    signs = [" + " if sign > 0 else " - " for sign, _ in terms]
    text = "".join(sign + part for sign, part in zip(signs, texts, strict=True))
    return text[3:] if text.startswith(" + ") else f"-{text[3:]}"


def _product(node: tree.Product) -> str:
    """Write factors, with a cross where that may differ from a dot."""
    text = _factor(node.factors[0])
    has_vectors = any(map(tree.shows_matrix, tree.walk(node)))
    for sign, factor in zip(node.signs or repeat(""), node.factors[1:], strict=False):
        text += (" x " if sign == r"\times" and has_vectors else "*") + _factor(factor)
    return text


def _quotient(node: tree.Quotient) -> str:
    above = tree.strip(node.above)
    is_sum = isinstance(above, tree.Add | tree.Cases | tree.Product | tree.Quotient)
    return (f"({write(above)})" if is_sum else write(above)) + f"/{_closed(node.below)}"


def _call(node: tree.Call) -> str:
    inside = ", ".join(write(tree.strip(a)) for a in node.arguments) or "nothing"
    power = f"^{_closed(node.exponent)}" if node.exponent else ""
    return f"{node.function.name}({inside}){power}"


def _repeated(node: tree.Repeated) -> str:
    index = node.index.symbol
    apart = "".join(f", {index} != {write(other)}" for other in node.apart)
    limits = f"{index} = {write(node.low)}..{write(node.high)}{apart}"
    return f"{node.name}[{limits}]({write(tree.strip(node.term))})"


def _dotted(node: tree.Dotted) -> str:
    if node.name == "product":
        return "*".join((*(_factor(x) for _, x in node.first), "...", _factor(node.last[1])))
    before = _add(tree.Add(node.first, start=node.start, end=node.end))
    sign, term = node.last
    last = f"({write(term)})" if isinstance(tree.strip(term), tree.Add) else write(term)
    return f"{before} + ... {'+' if sign > 0 else '-'} {last}"


def _integration(node: tree.Integration) -> str:
    limits = f"[{write(node.low)}..{write(node.high)}]" if node.low and node.high else ""
    by = f"d({write(tree.strip(node.differential))})" if node.differential else ""
    return f"integral{limits}({_factor(node.integrand)} {by or 'without differential'})"


def _derivation(node: tree.Derivation) -> str:
    shown = _factor(node.order) if isinstance(node.order, tree.Node) else str(node.order)
    order = f"^{shown}" if node.order != 1 else ""
    d = "∂" if node.is_partial else "d"
    return f"{d}{order}({write(tree.strip(node.of))})/{d}({write(node.by)}){order}"


def _approach(node: tree.Approach) -> str:
    side = {"+": " from above", "-": " from below"}.get(node.side, "")
    return f"limit[{write(node.by)} -> {write(node.point)}{side}]({write(tree.strip(node.term))})"


def _root(node: tree.Radical) -> str:
    inside = write(tree.strip(node.radicand))
    return f"root({inside}, {write(node.degree)})" if node.degree else f"sqrt({inside})"


def _excerpt(node: tree.Excerpt) -> str:
    limits = [":" if r is None else "..".join(map(str, dict.fromkeys(r))) for r in node.ranges]
    return f"{_closed(node.of)}[rows {limits[0]}, columns {', '.join(limits[1:]) or ':'}]"


def _cases(node: tree.Cases) -> str:
    pieces = [
        f"{write(value) if value else 'nothing'} if {write(condition)}"
        for value, condition in node.pieces
    ]
    pieces += [f"else {write(node.otherwise)}"] if node.otherwise else []
    return "{" + "; ".join(pieces) + "}"


def _chain(node: tree.Chain) -> str:
    text = write(node.members[0])
    for sign, member in zip(node.relations, node.members[1:], strict=True):
        text += f" {write_sign(sign)} {write(member)}"
    return text + (f" if {write(node.condition)}" if node.condition else "")


_RULES: Mapping[type, Callable[[Any], str]] = {
    tree.Number: lambda node: str(node.text),
    tree.Measure: lambda node: f"{node.number.text} {node.unit}",
    tree.Calculated: lambda node: write(node.of),
    tree.Constant: lambda node: "oo" if node.value is sp.oo else str(node.text),
    tree.Letter: _letter,
    tree.Bracket: lambda node: write(node.inside),
    tree.Add: _add,
    tree.Product: _product,
    tree.Quotient: _quotient,
    tree.Dotted: _dotted,
    tree.Power: lambda node: f"{_closed(node.base)}^{_closed(node.exponent)}",
    tree.Radical: _root,
    tree.Call: _call,
    tree.Repeated: _repeated,
    tree.Integration: _integration,
    tree.Derivation: _derivation,
    tree.Approach: _approach,
    tree.Extremum: lambda node: f"{node.name}[{write(node.by)}]({write(tree.strip(node.term))})",
    tree.At: lambda node: f"({write(node.term)} at {write(node.by)} = {write(node.point)})",
    tree.Table: lambda node: f"[{'; '.join(', '.join(map(write, row)) for row in node.rows)}]",
    tree.Entries: lambda node: f"({', '.join(map(write, node.parts))})",
    tree.Excerpt: _excerpt,
    tree.Transposed: lambda node: f"{_closed(node.of)}^T",
    tree.Magnitude: lambda node: f"|{write(node.inside)}|",
    tree.Degrees: lambda node: f"{_closed(node.number)} deg",
    tree.Cases: _cases,
    tree.Chain: _chain,
}
