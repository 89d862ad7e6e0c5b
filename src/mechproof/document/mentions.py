"""Refusals and notices about an equation: its units, its characters, the block's mentions of it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import pairwise
from typing import TypeVar

import sympy as sp

from mechproof.document.known import Known
from mechproof.latex import tree
from mechproof.latex.characters import find_disguised, find_replaced, name_character, write_plain
from mechproof.latex.matrix_meaning import is_matrix
from mechproof.latex.measures import is_number
from mechproof.latex.printed_relations import EQUAL
from mechproof.latex.reader import Print
from mechproof.latex.words import OPENS_WORDS
from mechproof.nomenclature.block import Block
from mechproof.nomenclature.cells import find_unit
from mechproof.nomenclature.said import Said
from mechproof.nomenclature.shown_letters import name_symbol
from mechproof.record import Dimension
from mechproof.sources.displays import Printed
from mechproof.sources.located_text import Files, Place
from mechproof.statement_domains.dimension_inference import DimensionError, infer

T = TypeVar("T")
_COMMAND = re.compile(r"\\[A-Za-z]+")
_NUMBER = re.compile(r"\(\s*\d+\s*(?:\\right\s*)?\)")
_CONSTANT = re.compile(
    rf"=\s*(?:{OPENS_WORDS}|\{{\\rm)?\s*[ck]onst(?:ant)?\.?\s*\}}?"
    r"(?:\\[,;]|\s)*[.,;]?\s*\Z"
)
# A number or a bracket, and what may be its unit in italics; some units are spelled as no product
# is.
_QUANTITY = re.compile(
    r"[-+]?\s*(?:\d[\d.]*|\d*\\pi|.*\))(?P<gap>(?:\s|~|\\[,;: ])*)"
    r"(?P<unit>[A-Za-z](?:[\w/ ^]*\w)?)",
    re.ASCII,
)
_NO_PRODUCT = re.compile(r"\b(?:mm|rad|rpm|k?Hz|[kMG]Pa)\b")
# A differential in an integral, or a letter in a limit.
_DIFFERENTIAL = re.compile(
    r"\\(?:int|lim)(?![A-Za-z]).*?(?<![A-Za-z\\])d\s*(\\[A-Za-z]+|[A-Za-z])", re.DOTALL
)
# Signs of order, equality and the like: all those that are read, and others.
_RELATION = re.compile(
    r"[=<>\u2200-\u22ff]|\\(?:n?[lg](?:e|eq|eqq|eqslant|t)|ne|neq|not|ll|gg|approx|equiv|n?sim|simeq"
    r"|cong|propto|in|notin|ni|triangleq|coloneqq?|doteq|asymp|n?mid|perp|n?parallel|[ps]\w*eq)(?![A-Za-z])"
)
# Nodes next to which a number is not the size of a letter.
_NO_SIZE = (tree.Approach, tree.Derivation, tree.Extremum, tree.Table)
_Find = Callable[[str], Mapping[str, str]]
# Words within a display.
_WORDS = re.compile(rf"(?:{OPENS_WORDS}|\\(?:text[a-z]*|intertext)\s*\{{)[^{{}}]*\}}")


def refuse_units(read: Print) -> None:
    """Refuse a unit that no letter can have: the other side says nothing about units."""
    for chain in read.chains:
        # A number that is converted into another unit needs no letter.
        is_turned = chain.relations and all(is_number(node) for node in chain.members[:2])
        is_limit = chain.relations and chain.relations[0] not in (*EQUAL, r"\approx")
        beside = set() if is_turned or is_limit else {0}
        if any(isinstance(node, _NO_SIZE) for node in tree.walk(chain.members[0])):
            beside |= {*range(len(chain.members))}
        for part in (chain.condition, *(m for n, m in enumerate(chain.members) if n in beside)):
            for node in tree.walk(part):
                if isinstance(node, tree.Measure) and node.factor == 1 and not node.is_settled:
                    raise read.source.refuse(
                        node.start,
                        f"a unit, {node.unit}, but no letter whose unit it could be",
                        "Declare the unit of the letter, or print the number alone, in that unit.",
                    )


def refuse_units_in_italics(read: Print) -> None:
    r"""Refuse 66 mm without \mathrm, whose letters may be factors, if it looks like a quantity.

    It does if no product is spelled like this; if another member of the chain is a quantity of the
    same dimension, both with a gap before the unit; or if the first member has the dimension of the
    unit but not of the product.
    """
    for chain in read.chains:
        members = [read.cut(chain, n, n) for n in range(len(chain.members))]
        matches = [(n, _QUANTITY.fullmatch(member)) for n, member in enumerate(members)]
        units = {n: (m, unit) for n, m in matches if m and (unit := find_unit(m["unit"]))}
        dimensions = [unit.dimension for match, unit in units.values() if match["gap"]]
        for n, (match, unit) in units.items():
            shown = match["unit"]
            is_alike = bool(match["gap"]) and dimensions.count(unit.dimension) > 1
            is_unit = _NO_PRODUCT.search(shown) or is_alike
            if is_unit or (n and _fits_only(unit.dimension, read, chain, n)):
                raise read.source.refuse(
                    chain.members[n].start,
                    f"{shown} after a number: a unit, or a product of letters?",
                    rf"Print \mathrm{{{shown}}} for the unit, \cdot between letters.",
                )


def _fits_only(unit: Dimension, read: Print, chain: tree.Chain, number: int) -> bool:
    """Return whether the first member of a chain has the dimension of a unit but not of a member.

    Nothing is known if a letter has no unit, or of matrices.
    """
    known = read.reader.notation.dimensions
    first, product = (read.meaning().of(chain.members[n]) for n in (0, number))
    are_scalars = not (is_matrix(first) or is_matrix(product))
    with suppress(DimensionError):
        if are_scalars and first.free_symbols | product.free_symbols <= known.keys():
            return infer(first, known) == unit != infer(product, known)
    return False


def refuse_powers_of_zero(read: Print) -> None:
    """Refuse r^0 of a letter: nobody prints 1 that way, but an upper index may name a frame."""
    for node in (node for node in tree.walk(read.chains) if isinstance(node, tree.Power)):
        if isinstance(node.base, tree.Letter) and node.exponent == tree.Number("0"):
            printed = read.source.latex[node.start : node.end]
            raise read.source.refuse(
                node.start,
                f"{printed}: a power that equals one, or an upper index?",
                f"Declare it in the block of letters: {printed} : its meaning",
            )


def refuse_differentials(read: Print, printed: Sequence[Printed]) -> None:
    """Refuse dT as a product of declared letters if an integral has a dT, too."""
    pairs = (
        pair
        for node in tree.walk(read.chains)
        if isinstance(node, tree.Product)
        for pair in pairwise(node.factors)
        if all(isinstance(one, tree.Letter) for one in pair)
    )
    integrated = _list_integrated(printed)
    for one, other in pairs:
        shown = read.source.latex[one.start : other.end]
        if shown[:1] == "d" and shown[1:].strip() in integrated:
            raise read.source.refuse(
                one.start,
                f"{shown}: a differential, as elsewhere, or a product?",
                r"Print \cdot for the product. Derivatives and integrals show differentials.",
            )


def _list_integrated(printed: Sequence[Printed]) -> set[str]:
    """Return the letters whose differentials integrals and limits print."""
    return {name for one in printed for name in _DIFFERENTIAL.findall(one.latex.string)}


def refuse_pi(read: Print, said: Said | None) -> None:
    r"""Refuse \pi as a number if the text says that it is a letter."""
    found = (node for node in tree.walk(read.chains) if isinstance(node, tree.Constant))
    if said and (node := next((node for node in found if node.value == sp.pi), None)):
        raise read.source.refuse(
            node.start,
            rf"\pi: line {said.line} says that it is a letter: {said.meaning}",
            rf"Declare it in the block of letters: \pi : {said.meaning}",
        )


def refuse_numbers_of_equations(read: Print, printed: Sequence[Printed]) -> None:
    r"""Refuse \theta_1=\frac\pi T-2(4) if an equation (4) exists: its value may be meant."""
    if not _NUMBER.search(read.source.latex):
        return
    names = {one.name for one in printed}
    for member in (member for chain in read.chains for member in chain.members):
        nodes = [*tree.walk(member)]
        terms = [term for node in nodes if isinstance(node, tree.Add) for _, term in node.terms]
        # Without letters, (2)(3) is a product of numbers that are put in, but nobody adds (2).
        is_formula = any(isinstance(node, tree.Letter) for node in nodes)
        found = [n for n in (nodes if is_formula else terms) if isinstance(n, tree.Bracket)]
        inside = [node.inside for node in found]
        numbers = [x for x in inside if isinstance(x, tree.Number) and f"({x.text})" in names]
        if numbers:
            raise read.source.refuse(
                numbers[0].start,
                f"({numbers[0].text}): the number, or the equation with that number?",
                r"Print \cdot before the number, or refer to the equation in the text.",
            )


def says_constant(latex: str) -> bool:
    r"""Return whether a print only says that a quantity is constant, m=\text{const.}."""
    return bool(_CONSTANT.search(latex))


def find_assignment(read: Print) -> str:
    r"""Return the letter of an assignment such as x = x + d, "" if there is none.

    A number that is added, q = q + 2\pi, may be a whole turn.
    """
    for chain in read.chains:
        first, *others = chain.members
        terms = others[0].terms if others and isinstance(others[0], tree.Add) else ()
        is_equal = bool(terms) and isinstance(first, tree.Letter) and chain.relations[0] == "="
        rest = [node for one in terms if one != (1, first) for node in tree.walk(one[1])]
        if is_equal and (1, first) in terms and any(isinstance(x, tree.Letter) for x in rest):
            return read.cut(chain, 0, 0)
    return ""


def may_relate(latex: str) -> bool:
    """Return whether a print contains what may be a relation sign; an arrow is none."""
    return bool(_RELATION.search(latex))


def refuse_unknown(block: Block, printed: Sequence[Printed]) -> None:
    """Refuse entries of the block about equations that do not exist."""
    known = {name for one in printed for name in (one.name, *one.labels)}
    said = (*block.skipped, *block.constraints, *block.identities, *block.modulo)
    said = (*said, *block.follows, *(name for names in block.follows.values() for name in names))
    for name in said:
        with block.blame(name):
            if name not in known:
                raise ValueError(f"no equation has the name or label {name}")


def look_up(printed: Printed, said: Mapping[str, T]) -> T | None:
    """Return the entry about an equation, by its name or a label."""
    return next((said[key] for key in (printed.name, *printed.labels) if key in said), None)


def is_listed(printed: Printed, names: Sequence[str]) -> bool:
    """Return whether an equation is among those named."""
    return any(key in names for key in (printed.name, *printed.labels))


def is_met_once(symbol: sp.Basic, known: Known, *, with_rates: bool = True) -> bool:
    """Return whether a letter, with derivatives, occurs in one equation and in no unread text."""
    steps = known.symbols.find_steps(symbol)[1] if with_rates else (symbol,)
    names = {name for v in known.symbols.variables if v.symbol in steps for name in v.latex}
    unread = write_plain(known.unread)
    plain = _COMMAND.sub(" ", unread)
    texts = ((write_plain(name), unread if "\\" in name else plain) for name in names)
    if any(name_symbol(name) in name_symbol(text) for name, text in texts):
        return False
    return sum(known.met[step] for step in steps) == 1


def describe_characters(displays: Sequence[Printed], files: Files) -> Iterator[tuple[Place, str]]:
    """Yield a notice for replaced characters and one for look-alikes, at the first of each.

    No verdict depends on these.
    """
    if met := _find(find_replaced, displays, files):
        shown = ", ".join(f"{x} (U+{ord(x):04X}) as {sign}" for x, (_, sign) in met.items())
        yield _find_first(met), f"read as other signs: {shown}"
    if met := _find(find_disguised, displays, files):
        shown = ", ".join(f"{name_character(x)} like {sign}" for x, (_, sign) in met.items())
        yield _find_first(met), f"letters that look like others: {shown}"


def _find(find: _Find, displays: Sequence[Printed], files: Files) -> dict[str, tuple[Place, str]]:
    met: dict[str, tuple[Place, str]] = {}
    for printed in displays:
        latex = _WORDS.sub(lambda words: " " * len(words[0]), printed.latex.string)
        for sign, other in find(latex).items():
            met.setdefault(sign, (printed.locate(files, latex.index(sign)), other))
    return met


def _find_first(met: Mapping[str, tuple[Place, str]]) -> Place:
    place, _ = next(iter(met.values()))
    return place
