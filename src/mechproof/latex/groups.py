"""Braces print nothing: what they enclose has to be one thing in what is read, too."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from mechproof.latex.tree import Add, Node, walk

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser


def refuse_cut(parser: Parser, nodes: Sequence[Node]) -> None:
    r"""Refuse {a+b}^2, 2{x+1}, a-{b+c} and the like: what is printed says something else."""
    found = [node for node in walk(tuple(nodes)) if node.start < node.end]
    for group in parser.groups:
        if any(_cuts(node, *group) for node in found):
            raise parser.refuse(
                "braces print nothing, but what stands in these is read as parts of other things",
                r"Print \left( and \right) around what belongs together, or leave the braces out.",
                group[0],
            )


def _cuts(node: Node, start: int, end: int) -> bool:
    """Return whether a node takes a part of a group in, or a sign before it counts for a part."""
    if node.start < start < node.end < end or start < node.start < end < node.end:
        return True
    if not isinstance(node, Add):
        return False
    inside = [(sign, t) for sign, t in node.terms if start <= t.start and t.end <= end]
    if not inside:
        return False
    (sign, first), is_sign_inside = inside[0], inside[0][1].start > start
    is_behind = first is not node.terms[0][1]
    return (is_sign_inside and is_behind) or (len(inside) > 1 and sign < 0 and not is_sign_inside)
