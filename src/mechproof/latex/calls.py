"""Functions and the reach of their arguments."""

from __future__ import annotations

from typing import TYPE_CHECKING

from mechproof.latex import atoms, calculus
from mechproof.latex.meaning import Meaning
from mechproof.latex.tree import (
    Bracket,
    Call,
    Constant,
    Entries,
    Letter,
    Node,
    Number,
    Power,
    Product,
    Quotient,
    walk,
)

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

_BRACKETS = ("(", "[")


def is_function(parser: Parser) -> bool:
    """Return whether a function stands here and not a longer declared name."""
    declared = parser.names.match(parser.tokens, parser.place)
    known = _function_sign(parser) in parser.functions
    return declared is None and (known or _is_logarithm(parser))


def _is_logarithm(parser: Parser) -> bool:
    """Return whether a logarithm stands here that says its base."""
    follows = parser.tokens[parser.place + 1 : parser.place + 2]
    return parser.text == r"\log" and bool(follows) and follows[0].text == "_"


def _function_sign(parser: Parser) -> str:
    r"""Return the sign of a function: a letter may be declared as one."""
    return parser.text if parser.text.startswith("\\") else rf"\{parser.text}"


def read_call(parser: Parser) -> Node:
    """Read a function, the power it is raised to, and its arguments."""
    start = parser.start
    if _function_sign(parser) not in parser.functions:
        return _read_logarithm(parser)
    function = parser.functions[_function_sign(parser)]
    parser.take()
    exponent = _read_exponent(parser)
    arguments = _read_arguments(parser)
    return Call(function, arguments, exponent, start=start, end=parser.end)


def _read_logarithm(parser: Parser) -> Node:
    r"""Read \log_a x, the natural logarithm of x by that of a."""
    start = parser.take().start
    base = parser.read_script("_")
    exponent = _read_exponent(parser)
    natural = parser.functions[r"\ln"]
    above = Call(natural, _read_arguments(parser), start=start, end=parser.end)
    below = Call(natural, (base,), start=start, end=parser.end)
    quotient = Quotient(above, below, start=start, end=parser.end)
    return Power(quotient, exponent, start=start, end=parser.end) if exponent else quotient


def _read_exponent(parser: Parser) -> Node | None:
    if parser.text != "^":
        return None
    start = parser.start
    exponent = parser.read_script("^")
    if _is_minus_one(exponent, parser):
        raise parser.refuse(
            "the power -1 of a function: its inverse or its reciprocal?",
            r"Print the inverse function (\arctan) or a fraction.",
            start,
        )
    return exponent


def _is_minus_one(exponent: Node, parser: Parser) -> bool:
    """Return whether an exponent is minus one, in whatever way it is printed."""
    if any(isinstance(part, Letter) for part in walk(exponent)):
        return False
    meaning = Meaning(parser.source, {}, None, parser.remedies)
    return bool(meaning.of(exponent) == -1)


def _read_arguments(parser: Parser) -> tuple[Node, ...]:
    if parser.open_group():
        return _read_grouped(parser)
    if parser.text in _BRACKETS:
        return _read_bracketed(parser)
    if parser.ends_product() or parser.text in ("/", r"\cdot"):
        return ()
    if is_function(parser):
        return (read_call(parser),)
    argument = _read_short(parser)
    _check_reach(parser)
    return (argument,)


def _read_bracketed(parser: Parser) -> tuple[Node, ...]:
    bracket = atoms.read_atom(parser)
    _refuse_power_behind(parser)
    return bracket.parts if isinstance(bracket, Entries) else (bracket,)


def _read_grouped(parser: Parser) -> tuple[Node, ...]:
    r"""Read \sin{x+1}: braces of their own behind a function hold its argument."""
    parts = parser.read_inside("{", lambda: atoms.read_list(parser), "}")
    _refuse_power_behind(parser)
    first = parts[0]
    if len(parts) == 1 and isinstance(first, Bracket | Entries):
        return first.parts if isinstance(first, Entries) else (first,)
    _check_reach(parser)
    return tuple(parts)


def _refuse_power_behind(parser: Parser) -> None:
    if parser.text == "^":
        raise parser.refuse(
            "a power after the argument: of the function or of the argument?",
            r"Print \cos^2(x), or (x^2).",
        )


def _read_short(parser: Parser) -> Node:
    """Read a number times one name, fraction or root."""
    start = parser.start
    number = parser.read_factor()
    if not isinstance(number, Number) or parser.ends_product() or is_function(parser):
        return number
    if parser.text in ("/", r"\cdot"):
        return number
    factor = parser.read_factor()
    if not isinstance(factor, Letter | Constant) and parser.text not in ("",):
        _check_reach(parser)
    return Product((number, factor), start=start, end=parser.end)


def _check_reach(parser: Parser) -> None:
    """Refuse what stands close behind an argument without brackets."""
    if parser.ends_product() or parser.text == r"\cdot" or is_function(parser):
        return
    if calculus.is_differential(parser):
        return
    raise parser.refuse(
        "does this belong to the argument of the function before it?",
        "Print brackets, or a dot before it; a product that is always meant as one can be "
        "declared as a name of a variable.",
    )
