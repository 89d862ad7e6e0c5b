"""A print as parsed, before it becomes mathematics: nodes that keep its brackets and order."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, fields, replace
from typing import Any

import sympy as sp


@dataclass(frozen=True)
class Node:
    """A part of a print and its place in the source."""

    start: int = field(default=0, kw_only=True, compare=False)
    end: int = field(default=0, kw_only=True, compare=False)


@dataclass(frozen=True)
class Number(Node):
    """Digits, possibly with a decimal point."""

    text: str


@dataclass(frozen=True)
class Measure(Node):
    """A number with its printed unit, which is a factor next to letters.

    Without letters next to it, its expression does not show the unit. If it `is_settled`, `factor`
    turns it into a size in the unit of its letter.
    """

    number: Number
    unit: str
    factor: sp.Expr = sp.S.One
    is_settled: bool = False


@dataclass(frozen=True)
class Calculated(Node):
    """A calculation with units, the number that results, and its unit."""

    of: Node
    value: sp.Expr
    unit: str


@dataclass(frozen=True)
class Constant(Node):
    """A number with a name: pi, infinity."""

    value: sp.Expr
    text: str


@dataclass(frozen=True)
class Letter(Node):
    """A declared symbol, a bound one (an index, a variable of integration) or a family's member."""

    symbol: sp.Basic
    text: str
    indices: tuple[Node, ...] = ()


@dataclass(frozen=True)
class Bracket(Node):
    """A bracketed expression."""

    inside: Node


@dataclass(frozen=True)
class Add(Node):
    """Terms with their signs, 1 or -1."""

    terms: tuple[tuple[int, Node], ...]


@dataclass(frozen=True)
class Product(Node):
    """Factors in printed order, and the signs between them, "" if there is none."""

    factors: tuple[Node, ...]
    signs: tuple[str, ...] = field(default=(), compare=False)


@dataclass(frozen=True)
class Dotted(Node):
    """A sum or a product with dots before its last term; the terms have their signs, 1 or -1."""

    name: str
    first: tuple[tuple[int, Node], ...]
    last: tuple[int, Node]


@dataclass(frozen=True)
class Quotient(Node):
    """A fraction, upright or with a slash."""

    above: Node
    below: Node


@dataclass(frozen=True)
class Power(Node):
    """A base and its exponent."""

    base: Node
    exponent: Node


@dataclass(frozen=True)
class Radical(Node):
    """A root, by default the square root."""

    radicand: Node
    degree: Node | None = None


@dataclass(frozen=True)
class PrintedFunction:
    """A function: its printed name, and how its value is made."""

    name: str
    make: Callable[..., sp.Expr]


@dataclass(frozen=True)
class Call(Node):
    """A function of arguments, possibly raised to a power; () if no argument is printed."""

    function: PrintedFunction
    arguments: tuple[Node, ...]
    exponent: Node | None = None


@dataclass(frozen=True)
class Repeated(Node):
    """A sum or product of a term over an index; the index skips the values `apart`."""

    name: str
    term: Node
    index: Letter
    low: Node
    high: Node
    apart: tuple[Node, ...] = ()


@dataclass(frozen=True)
class Integration(Node):
    """An integral; its differential is None if it is missing in print."""

    integrand: Node
    differential: Node | None
    low: Node | None = None
    high: Node | None = None


@dataclass(frozen=True)
class Derivation(Node):
    """A derivative of some order by a letter, total or partial."""

    of: Node
    by: Letter
    order: int | Node = 1
    is_partial: bool = False


@dataclass(frozen=True)
class Approach(Node):
    """A limit: a letter goes to a point, from above ("+"), from below ("-") or both ("+-")."""

    term: Node
    by: Letter
    point: Node
    side: str


@dataclass(frozen=True)
class Extremum(Node):
    """The largest ("max") or the smallest ("min") value of an expression while a letter moves."""

    term: Node
    by: Letter
    name: str


@dataclass(frozen=True)
class At(Node):
    """The value of an expression at a value of a letter, which is printed or found."""

    term: Node
    by: Letter
    point: Node
    is_found: bool = False


@dataclass(frozen=True)
class Table(Node):
    """A matrix."""

    rows: tuple[tuple[Node, ...], ...]


@dataclass(frozen=True)
class Entries(Node):
    """Several expressions in one bracket: components, or arguments."""

    parts: tuple[Node, ...]


@dataclass(frozen=True)
class Excerpt(Node):
    """Rows and columns of a matrix, each as first and last number; None means all."""

    of: Node
    ranges: tuple[tuple[int, int] | None, ...]


@dataclass(frozen=True)
class Transposed(Node):
    """A matrix or a bracket of components with a T."""

    of: Node


@dataclass(frozen=True)
class Magnitude(Node):
    """An expression between upright bars."""

    inside: Node


@dataclass(frozen=True)
class Degrees(Node):
    """A number of degrees."""

    number: Node


@dataclass(frozen=True)
class Cases(Node):
    """Values under conditions (None: undefined), and the value elsewhere."""

    pieces: tuple[tuple[Node | None, Chain], ...]
    otherwise: Node | None = None


@dataclass(frozen=True)
class Chain(Node):
    """Members and the relation signs between them; a condition restricts where they are claimed.

    In a condition, `AND` may separate two relations.
    """

    members: tuple[Node, ...]
    relations: tuple[str, ...]
    condition: Chain | None = None


def shows_matrix(node: Node) -> bool:
    """Return whether a node itself is a matrix or a vector, as printed or as declared."""
    is_named = isinstance(node, Letter) and isinstance(node.symbol, sp.MatrixSymbol)
    return is_named or isinstance(node, Entries | Table)


def strip(node: Node) -> Node:
    """Return a node without the brackets around it."""
    return strip(node.inside) if isinstance(node, Bracket) else node


def exchange(part: Any, change: Callable[[Node], Node | None]) -> Any:
    """Return a part of a print with nodes replaced where `change` returns one, outermost first."""
    if isinstance(part, Node):
        if (other := change(part)) is not None:
            return other
        return replace(part, **{f.name: exchange(vars(part)[f.name], change) for f in fields(part)})
    return tuple(exchange(one, change) for one in part) if isinstance(part, tuple) else part


def walk(part: object, closed: type[Node] | tuple[()] = ()) -> Iterator[Node]:
    """Yield all nodes of a print, except those inside `closed` ones."""
    if isinstance(part, Node):
        yield part
        part = () if isinstance(part, closed) else tuple(vars(part).values())
    if isinstance(part, tuple):
        for inner in part:
            yield from walk(inner, closed)
