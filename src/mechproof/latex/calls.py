"""Functions, and how far their arguments reach."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import sympy as sp

from mechproof.latex import atoms, calculus, side_conditions, tree
from mechproof.latex.characters import is_letter
from mechproof.latex.latex_signs import DOTS, find_close, is_printed_without
from mechproof.latex.left_scripts import begins_letter
from mechproof.latex.meaning import Meaning
from mechproof.record import NUMBER, Notation

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

_BRACKETS = ("(", "[")
_SPACE = re.compile(r"\\[,:; ]|\\quad|~")


def is_function(parser: Parser) -> bool:
    """Return whether a function starts here, rather than a longer declared name."""
    declared, spelled = parser.names.match(parser.tokens, parser.place), parser.find_spelled()
    if spelled:
        return not (declared and declared.end >= parser.place + spelled[1])
    has_base = parser.text == r"\log" and parser.peek() == "_"
    return declared is None and (has_base or _function_sign(parser) in parser.functions)


def _function_sign(parser: Parser) -> str:
    """Return the command of a function here; a plain letter may be declared as a function, too."""
    return parser.text if parser.text.startswith("\\") else rf"\{parser.text}"


def read_call(parser: Parser, *, is_argument: bool = False) -> tree.Node:
    r"""Read a function, the power it is raised to, and its arguments.

    The power may follow the bracket, \cos(x)^2, unless the function is itself an argument of
    another.
    """
    start, place = parser.start, parser.place
    if spelled := parser.find_spelled():
        function, length = spelled
        parser.place += length
    elif _function_sign(parser) not in parser.functions:
        return _read_logarithm(parser)
    else:
        function = parser.functions[_function_sign(parser)]
        parser.take()
    exponent = _read_exponent(parser, function.name)
    arguments = _read_arguments(parser, place)
    if function.make is sp.atan and len(arguments) == 2:
        raise parser.refuse(
            "an arctangent of two numbers: which of them is the numerator?",
            r"Print \operatorname{atan2}(y,x) for the direction of (x,y).",
            start,
        )
    if parser.text == "^" and (exponent or is_argument):
        _refuse_power_after(parser)
    if parser.text == "^" and arguments:
        exponent = parser.read_script("^")
    return tree.Call(function, arguments, exponent, start=start, end=parser.end)


def _read_logarithm(parser: Parser) -> tree.Node:
    r"""Read \log_a x as the natural logarithm of x divided by that of a."""
    start = parser.take().start
    base = parser.read_script("_")
    exponent = _read_exponent(parser, "log")
    natural = parser.functions[r"\ln"]
    above = tree.Call(natural, _read_arguments(parser, parser.place), start=start, end=parser.end)
    _refuse_power_after(parser)
    below = tree.Call(natural, (base,), start=start, end=parser.end)
    quotient = tree.Quotient(above, below, start=start, end=parser.end)
    return tree.Power(quotient, exponent, start=start, end=parser.end) if exponent else quotient


def _read_exponent(parser: Parser, name: str) -> tree.Node | None:
    if parser.text != "^":
        return None
    start = parser.start
    exponent = parser.read_script("^")
    if _is_minus_one(exponent, parser):
        raise parser.refuse(
            "the power -1 of a function: its inverse or its reciprocal?",
            r"Print the inverse function (\arctan) or a fraction. "
            + parser.remedies.function.format(rf"{name}^{{-1}}"),
            start,
        )
    return exponent


def _is_minus_one(exponent: tree.Node, parser: Parser) -> bool:
    """Return whether an exponent equals minus one, however it is printed."""
    if any(isinstance(part, tree.Letter) for part in tree.walk(exponent)):
        return False
    meaning = Meaning(parser.source, {}, Notation(), parser.remedies)
    return bool(meaning.of(exponent) == -1)


def _read_arguments(parser: Parser, place: int) -> tuple[tree.Node, ...]:
    """Read the arguments of the function whose name begins at token `place`."""
    if parser.open_group():
        return _read_grouped(parser)
    if parser.text in _BRACKETS:
        return _read_bracketed(parser, place)
    if parser.ends_product() or parser.text in ("/", *DOTS):
        return ()
    if is_function(parser):
        return (read_call(parser, is_argument=True),)
    argument = _read_short(parser)
    if isinstance(argument, tree.Table) and len(argument.rows) == len(argument.rows[0]) == 1:
        # A bracket that is typeset as a matrix.
        argument = argument.rows[0][0]
    printed = "".join(token.text for token in parser.tokens[place : parser.place])
    if printed not in parser.factors and not _is_quantity_after(parser, argument):
        _check_bracket(parser, place)
        _check_reach(parser)
    return (argument,)


def _read_bracketed(parser: Parser, place: int) -> tuple[tree.Node, ...]:
    r"""Read a bracketed argument, with the angle after a count in the bracket: \cos(n-1)\theta."""
    start, is_square = parser.start, parser.text == "["
    bracket = atoms.read_atom(parser)
    if isinstance(bracket, tree.Entries):
        return bracket.parts
    inside = tree.strip(bracket)
    if is_square and isinstance(inside, tree.Number) and parser.text in _BRACKETS:
        raise parser.refuse(
            "a number in square brackets after a function: its power, or its argument?",
            r"Print \sin^2(x) for the power, \cdot before the next bracket for the argument.",
            start,
        )
    if not isinstance(inside, tree.Add):
        return (bracket,)
    is_phase = _goes_on(parser, bracket, parser.place)
    if is_phase and not _follows_space(parser):
        phase = _read_phase(parser, [bracket])
        _check_bracket(parser, place)
        _check_reach(parser)
        return (phase,)
    if is_phase or _may_count(parser, inside):
        raise parser.refuse(
            "after the bracket: a factor, or part of the argument?",
            "Print brackets around the argument, or a dot before a factor; declared units of the "
            "letters settle it, too.",
        )
    return (bracket,)


def _may_count(parser: Parser, inside: tree.Add) -> bool:
    r"""Return whether a number plus letters might count what follows the bracket: \cos(n-1)\theta.

    It might if a letter follows and the dimensions of all the letters are not known, or if a
    bracket or fraction follows and the letters may be counts.
    """
    known = parser.notation.dimensions.keys()
    parts = {part.symbol for part in tree.walk(inside) if isinstance(part, tree.Letter)}
    if not parts or not any(isinstance(term, tree.Number) for _, term in inside.terms):
        return False
    if match := parser.names.match(parser.tokens, parser.place):
        return not known >= {*parts, match.name.symbol}
    if parser.text not in (*_BRACKETS, r"\frac") or _follows_space(parser):
        return False
    counts = {count for count, _ in parser.notation.phases}
    return not side_conditions.is_bracketed(parser) and (parts <= counts or not known >= parts)


def _read_grouped(parser: Parser) -> tuple[tree.Node, ...]:
    r"""Read \sin{x+1}: braces right after a function enclose its argument."""
    parts = parser.read_inside("{", lambda: atoms.read_list(parser))
    _refuse_power_after(parser)
    first = parts[0]
    if len(parts) == 1 and isinstance(first, tree.Bracket | tree.Entries):
        return first.parts if isinstance(first, tree.Entries) else (first,)
    _check_reach(parser)
    return tuple(parts)


def _refuse_power_after(parser: Parser) -> None:
    if parser.text == "^":
        raise parser.refuse(
            "a power after the argument: of the function or of the argument?",
            r"Print \cos^2(x), or (x^2).",
        )


def _read_short(parser: Parser) -> tree.Node:
    """Read a number times one name, fraction, bracket or root; or a product that is an angle."""
    factors = [parser.read_factor()]
    nodes = [*tree.walk(factors[0])]
    is_number = all(isinstance(node, tree.Number | tree.Quotient) for node in nodes)
    is_last = parser.ends_product() or parser.text in ("/", *DOTS) or is_function(parser)
    if is_number and not is_last:
        factors.append(parser.read_factor())
    argument = _read_phase(parser, factors)
    if parser.text in DOTS and _goes_on(parser, factors[-1], parser.place + 1):
        raise parser.refuse(
            "a dot after the argument of a function: does the argument go on?",
            r"Print \cos(n\cdot\varphi) if it does, \varphi\cos n if not.",
        )
    if (
        len(factors) > 1
        and not isinstance(factors[-1], tree.Letter | tree.Constant)
        and parser.text
    ):
        _check_reach(parser)
    return argument


def _read_phase(parser: Parser, factors: list[tree.Node]) -> tree.Node:
    """Read on while the next letter joins the factors to form an angle; return their product."""
    while _goes_on(parser, factors[-1], parser.place):
        factors.append(parser.read_factor())
    if len(factors) == 1:
        return factors[0]
    return tree.Product(tuple(factors), start=factors[0].start, end=parser.end)


def _goes_on(parser: Parser, before: tree.Node, place: int) -> bool:
    r"""Return whether a letter at token `place`, times the node `before`, makes an angle.

    A letter that begins a phase must be followed by the rest of it: in `n\omega t` that is t.
    """
    nodes = [*tree.walk(before)]
    letters: list[sp.Basic] = [node.symbol for node in nodes if isinstance(node, tree.Letter)]
    constants = [node.value for node in nodes if isinstance(node, tree.Constant)]
    if (counts := letters or constants) and _is_counted(parser, counts, place):
        return not any(isinstance(node, tree.Call) for node in nodes)
    letters += constants
    match = parser.names.match(parser.tokens, place)
    is_turn = match is None and parser.peek(place - parser.place) == r"\pi"
    after = match.name.symbol if match else sp.pi
    phases = parser.notation.phases
    is_open = not letters or any(isinstance(node, tree.Call) for node in nodes)
    if is_open or not (match or is_turn) or any((one, after) not in phases for one in letters):
        return False
    begins = match and any(after == first and other != sp.pi for first, other in phases)
    return not (match and begins) or _goes_on(parser, tree.Letter(after, ""), match.end)


def _is_counted(parser: Parser, letters: Sequence[sp.Basic], place: int) -> bool:
    r"""Return whether letters count what follows, as in \cos nx, or what the open integral is over.

    A known angle counts nothing, and nothing known to be other than an angle is counted.
    """
    match = parser.names.match(parser.tokens, place)
    known = parser.notation.dimensions
    if match and match.name.symbol in known and not known[match.name.symbol].is_angle:
        return False
    if match and all(letter.is_integer for letter in letters):
        return bool(match.name.symbol.is_real) and not match.name.symbol.is_integer
    if parser.peek(place - parser.place) == r"\pi" and all(one.is_integer for one in letters):
        return True
    texts = [token.text for token in parser.tokens[place:]]
    is_alone = (match is None or match.end == place + 1) and "^" not in texts[1:2]
    if not (texts and is_alone and parser.integrals) or texts[0] in parser.functions:
        return False
    has_angle = any(letter in known and known[letter].is_angle for letter in letters)
    is_bare = is_printed_without([token.text for token in parser.tokens], place)
    is_near = not (has_angle or is_bare or _follows_space(parser))
    # In a fraction, the numerator with the differential in it has already been read.
    read = parser.integrals[-1].differential
    is_over = isinstance(read, tree.Letter) and read.text == texts[0]
    return is_near and (is_over or ("d", texts[0]) in pairwise(texts[1:]))


def _is_matrix_next(parser: Parser) -> bool:
    """Return whether a matrix comes next, which is not part of the argument before it."""
    match = parser.names.match(parser.tokens, parser.place)
    is_named = match is not None and isinstance(match.name.symbol, sp.MatrixSymbol)
    return is_named or parser.text.startswith(r"\begin{") or _is_bracketed_matrix(parser)


def _is_bracketed_matrix(parser: Parser) -> bool:
    """Return whether [K] comes next, K a matrix, or any letter while letters are collected."""
    match = parser.names.match(parser.tokens, parser.place + 1)
    if parser.collects and match is None:
        texts = [token.text for token in parser.rest[:3]]
        return texts[::2] == ["[", "]"] and is_letter(texts[1])
    if match is None or not isinstance(match.name.symbol, sp.MatrixSymbol):
        return False
    closing = [token.text for token in parser.tokens[match.end : match.end + 1]]
    return parser.text == "[" and closing == ["]"]


def _check_bracket(parser: Parser, place: int) -> None:
    r"""Refuse a bracket or fraction after a function with its argument: \sin q(a+b)."""
    asks = {"(": ("bracket", "the argument of a function"), r"\frac": ("fraction", "part of it")}
    if parser.text in asks and not (side_conditions.is_bracketed(parser) or _is_apart(parser)):
        what, whose = asks[parser.text]
        printed = parser.source.latex[parser.tokens[place].start : parser.end]
        remedy = parser.remedies.bracket.format(printed)
        raise parser.refuse(f"a {what} after {printed}: a factor, or {whose}?", remedy)


def _is_apart(parser: Parser) -> bool:
    r"""Return whether a space separates the next bracket, fraction or root: \cos a\,(…)."""
    return parser.text in ("(", "[", r"\frac", r"\sqrt") and _follows_space(parser)


def _follows_space(parser: Parser) -> bool:
    before = parser.tokens[parser.place - 1].end if parser.place else 0
    return bool(_SPACE.search(parser.source.latex[before : parser.start]))


def _is_quantity_after(parser: Parser, argument: tree.Node) -> bool:
    r"""Return whether what follows an argument cannot be part of its angle: \cos\theta\,x.

    That holds for a letter with a dimension, or for a bracket of such letters without a quotient.
    """
    known, nodes = parser.notation.dimensions, [*tree.walk(argument)]
    letters = [node.symbol for node in nodes if isinstance(node, tree.Letter)]
    after = {known.get(symbol) for symbol in _list_letters_after(parser)}
    is_quantity = None not in after and bool(after - {NUMBER})
    is_angle = bool(letters) or any(isinstance(node, tree.Degrees) for node in nodes)
    return is_quantity and is_angle and all(known.get(symbol) == NUMBER for symbol in letters)


def _list_letters_after(parser: Parser) -> set[sp.Basic]:
    """Return the letter here, or the letters of a bracket; nothing if that contains a quotient."""
    end = parser.place + 1
    if parser.text in _BRACKETS:
        end = parser.place + find_close([token.text for token in parser.rest])
    inside = parser.tokens[parser.place : end]
    if any(token.text in ("/", r"\frac") for token in inside):
        return set()
    matches = (parser.names.match(parser.tokens, n) for n in range(parser.place, end))
    return {match.name.symbol for match in matches if match}


def _check_reach(parser: Parser) -> None:
    """Refuse anything that directly follows an argument without brackets."""
    if parser.collects and begins_letter(parser.text):
        # Which function a letter belongs to does not matter while letters are only collected.
        return
    if parser.ends_product() or parser.text in DOTS or is_function(parser):
        return
    if calculus.is_differential(parser) or _is_matrix_next(parser) or _is_apart(parser):
        return
    raise parser.refuse(
        "does this belong to the argument of the function before it?",
        "Print brackets, or a dot before it; a product that is always one quantity can be "
        "declared as the name of a variable, or as an angle by its units.",
    )
