"""Letters that prints show: which there are, which are the same, which look like matrices."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain
from types import MappingProxyType

import sympy as sp

from mechproof.latex import Reader, ReadingError
from mechproof.latex.errors import TOO_DEEP
from mechproof.latex.left_scripts import LEFT
from mechproof.latex.name_table import INDEX, strip_braces
from mechproof.latex.printed_commands import VECTORS
from mechproof.latex.printed_functions import FUNCTIONS
from mechproof.latex.tokens import tokenize
from mechproof.latex.words import ELSE, IF, OPENS_TEXT, to_text
from mechproof.nomenclature.cells import name_unit
from mechproof.nomenclature.defined_functions import find_defined
from mechproof.nomenclature.guessed_letters import BRACKET, NAMES, NO_LETTER, REMEDIES, Guesses
from mechproof.record import Notation, Variable

# Contents of a bracket that nobody multiplies by: a place where a letter has a value, x(0), i(\pi).
_PLACE = re.compile(
    r"(?:[-+\s\d/]|\\pi(?![A-Za-z])|\\infty(?![A-Za-z]))*(?:0|\\pi|\\infty)[\s\d/]*"
)
# Letters that mostly run through families.
INDICES = "ijklmn"
# A sum whose lower limit is 0.
_FROM_ZERO = re.compile(r"=\s*0\s*\}\s*\^")
# The letter T, except as a sign of transposition or with an index.
_PLAIN_T = re.compile(
    r"(?<![A-Za-z\\^])(?<!\^\{)(?<!\\mathrm\{)(?<!\\mathrm )(?<!\\text\{)T(?![A-Za-z]|\s*_)"
)
_RAISED_T = re.compile(
    r"(?P<letter>(?:\\[A-Za-z]+\s*(?:\{[^{}]*\})?|[A-Za-z])(?:_(?:\w|\{[^{}]*\}))?)\s*\^\s*"
    r"(?:T|\{\s*T\s*\})"
)
# The prefix of the print of a rate.
_RATE = re.compile(r"\A\\d*dot\{")
_MATRIX = re.compile(
    r"(?P<name>[^=&]{1,40}?)\s*=\s*(?:\\left[\[(])?\s*"
    r"\\begin\{(?P<kind>[bpvBV]?matrix|array)\}(?:\{[lcr|]+\})?(?P<body>.*?)\\end\{(?P=kind)\}"
    # With a factor after it, its shape is not that of the letter.
    r"\s*(?:\\right\s*[\])]\s*)?(?=\Z|[=+,;.&-]|\\(?:q?quad|text|end|\\|[,;]))",
    re.DOTALL,
)
# Separators of equations in a line.
_BEFORE = re.compile(r"\A(?:\s|,|;|\\q?quad|\\[,;: ])+")

# A matrix letter with an index, and a superscript that may be a second one: T_0^1.
_FRAMED = re.compile(
    r"(?<![A-Za-z\\])(?P<stem>[A-Z]|\\(?:mathbf|mathrm|boldsymbol|bm)\s*\{[A-Z]\})"
    r"_(?:\d|[a-z]|\{[a-z\d+-]+\})(?:\^(?P<to>\d|[a-z]|\{[a-z\d][a-z\d+-]*\})(?![\d^]))?"
)
# The beginning of a table of equations.
_TABLE = re.compile(
    r"\\begin\{(?:array|matrix|aligned)\}(?:\{[lcr|]+\})?(?=[^&\\]*(?:_\{[^{}]*\}\s*)?=)"
)
_WORDS = re.compile(rf"{OPENS_TEXT}([^{{}}]*)\}}")


def name_symbol(latex: str) -> str:
    """Return the name of a letter, the same for all its prints: without braces."""
    return strip_braces(latex).replace("*", "star")


def show_letter(latex: str) -> str:
    """Return a letter as answers show it: as printed, with a star in braces."""
    return " ".join(latex.replace("^*", "^{*}").split())


def group_alike(letters: Iterable[str]) -> list[tuple[str, ...]]:
    r"""Return letters grouped by those that print alike, \dot{x}_1 and \dot{x_1}."""
    groups: dict[str, dict[str, None]] = {}
    for letter in letters:
        groups.setdefault(name_symbol(letter), {})[letter] = None
    return [tuple(group) for group in groups.values()]


@dataclass(frozen=True)
class Collected:
    """Undeclared letters, letters in front of a bracket, and functions with the power -1.

    `guessed` are letters that the reader asks for, including whole prints such as f(x); `families`
    are those with members in sums, `a` for `a_i`, `d_{b#}` for `d_{bi}`. `unread` maps a print that
    could not be read to the refusal.
    """

    letters: list[str]
    factors: list[str]
    functions: Mapping[str, str]
    unread: Mapping[str, ReadingError]
    guessed: list[str] = field(default_factory=list)
    imaginary: str = ""
    families: list[str] = field(default_factory=list)


def collect_letters(
    printed: Iterable[str], *, guess: bool = False, imaginary: str = "", said: Collection[str] = ()
) -> Collected:
    """Return the letters of prints; with `guess`, also those that the reader would ask for.

    `imaginary` is the letter of the imaginary unit; `said` are letters that the text explains.
    """
    prints = list(printed)
    displays: list[list[str]] = []
    guesses = Guesses("\n".join(prints), declares=guess, imaginary=imaginary, said=said)
    guesses.letters |= dict.fromkeys(find_framed(prints))
    unread: dict[str, ReadingError] = {}
    tables = {name for name, _ in find_shapes(prints)}
    for printed_latex in prints:
        latex = _mark_transposed(printed_latex, tables)
        found = _collect_from(latex, guesses)
        if isinstance(found, ReadingError):
            unread[printed_latex] = found
            named = NAMES.search(found.remedy)
            # A letter next to one that may not be a letter is still asked for.
            beside = [named[1]] if guess and named and named[1] in NO_LETTER else []
            found = _collect_from(latex, guesses, beside) if beside else []
        if not isinstance(found, ReadingError):
            displays.append(found)
    letters = dict.fromkeys(chain.from_iterable(displays))
    families = _find_families(displays, prints) if guess else {}
    of_families = re.compile("|".join(families.values()) or r"(?!)")
    kept = [x for x in letters if INDEX not in x and not of_families.fullmatch(strip_braces(x))]
    names = {*map(name_symbol, kept)}
    guessed = [x for x in guesses.letters if name_symbol(x) not in names]
    called = {name_symbol(x) for x, _ in find_defined(prints)}
    factors = [x for x in guesses.factors if name_symbol(x) not in called]
    return Collected(kept, factors, guesses.functions, unread, guessed, imaginary, [*families])


def _mark_transposed(latex: str, tables: Collection[str]) -> str:
    """Set the T raised above letters of printed matrices upright: it is not an exponent."""
    return _RAISED_T.sub(
        lambda found: (
            rf"{found['letter']}^{{\mathrm{{T}}}}"
            if name_symbol(found["letter"]) in tables
            else found[0]
        ),
        latex,
    )


def _find_families(displays: Sequence[Collection[str]], prints: Sequence[str]) -> dict[str, str]:
    """Return families, each with a pattern without braces that matches the prints of its members.

    The index of a family runs through a sum somewhere. In F_k = m_k a, all are members of families
    if one of them has an index that runs in this way.
    """
    families = {x.removesuffix(f"_{INDEX}"): None for one in displays for x in one if INDEX in x}
    summed = {*map(strip_braces, families)}
    for letters in displays:
        indexed = [(x.rpartition("_")[0], strip_braces(x).partition("_")) for x in letters]
        running = {index for _, (stem, _, index) in indexed if stem in summed} & {*INDICES}
        families |= {shown: None for shown, (_, _, index) in indexed if index in running}
    # The last member has its number as index: m_n, x_N. If no sum begins with 0, x_0 is no member.
    is_from_one = not any(map(_FROM_ZERO.search, prints))
    index = rf"{'(?!0(?:$|}}))' if is_from_one else ''}[-+\d{INDICES}MN]+"
    names = ((x, strip_braces(print_member(x, INDEX))) for x in families)
    return {x: re.escape(name).replace(re.escape(INDEX), index) for x, name in names}


def print_member(family: str, index: str) -> str:
    """Return the print of a member of a family."""
    return family.replace(INDEX, index) if INDEX in family else f"{family}_{{{index}}}"


def make_reader(
    letters: Iterable[str],
    said: Collected | Guesses,
    sizes: Mapping[str, tuple[int, int]] = MappingProxyType({}),
) -> Reader:
    """Return a reader that knows these letters, their sizes, and the other guesses about prints."""
    symbols = {x: sp.Symbol(x) for x in letters}
    symbols |= {
        x: sp.MatrixSymbol(x, *sizes[name_symbol(x)]) for x in letters if name_symbol(x) in sizes
    }
    names = tuple(Variable(symbol, "", latex=(x,)) for x, symbol in symbols.items())
    functions = {x.removeprefix("\\"): FUNCTIONS[is_[1:]] for x, is_ in said.functions.items()}
    notation = Notation(
        factors=tuple(said.factors),
        functions=functions,
        name_unit=name_unit,
        imaginary=said.imaginary,
    )
    return Reader(names, notation, REMEDIES)


def _collect_from(
    latex: str, guesses: Guesses, beside: Sequence[str] = ()
) -> list[str] | ReadingError:
    """Return the letters of a print besides known ones, or the error why it cannot be read."""
    while True:
        try:
            found = make_reader([*guesses.letters, *beside], guesses).collect(latex)
            for letter in found:
                # A name may have scripts that no print has, such as a second index after a power.
                tokenize(letter)
            return found
        except ReadingError as error:
            if not guesses.take(error):
                return error
        except RecursionError:
            return ReadingError(latex, 0, TOO_DEEP)


def find_places(letters: Iterable[str], prints: Sequence[str]) -> list[str]:
    """Return the letters after which brackets contain only places, 0 or parts of pi."""
    found = []
    for letter in letters:
        after = re.compile(rf"(?<![A-Za-z\\]){re.escape(letter)}\s*{BRACKET.pattern}")
        inner = [match["inner"] for latex in prints for match in after.finditer(latex)]
        if inner and all(map(_PLACE.fullmatch, inner)):
            found.append(letter)
    return found


def is_vector(letter: str) -> bool:
    """Return whether a letter is printed as a vector, or in a frame, and so is not a number.

    A rate of a vector is a vector, too.
    """
    return _RATE.sub("", letter).startswith((*VECTORS, LEFT))


def find_framed(prints: Sequence[str]) -> Iterator[str]:
    """Yield the matrices between two frames, T_0^1, whose superscripts are not powers.

    A matrix with that name must be printed, and none of that letter without a superscript.
    """
    found = [match for latex in prints for match in _FRAMED.finditer(latex)]
    tables = {name for name, _ in find_shapes(prints)}
    plain = {one["stem"] for one in found if not one["to"]}
    first = {
        one["stem"]
        for one in found
        if one["to"] and strip_braces(one["to"]) == "1" and name_symbol(one[0]) in tables
    }
    yield from (one[0] for one in found if one["stem"] in first - plain)


def find_shapes(prints: Iterable[str]) -> Iterator[tuple[str, tuple[int, int]]]:
    """Yield the letters that are printed equal to a matrix, with its numbers of rows and columns.

    A table with conditions lists cases and is left out.
    """
    for latex in prints:
        for match in _MATRIX.finditer(_TABLE.sub("", latex)):
            if not {*IF, *ELSE}.isdisjoint(map(to_text, _WORDS.findall(match["body"]))):
                continue
            rows = [row for row in match["body"].split(r"\\") if row.strip()]
            columns = rows[0].count("&") + 1 if rows else 1
            yield name_symbol(_BEFORE.sub("", match["name"])), (len(rows), columns)


def drop_transposition(letters: Iterable[str], prints: Sequence[str]) -> list[str]:
    """Return the letters without T if it appears only as a superscript and there are matrices."""
    letters = [*letters]
    has_matrices = any(find_shapes(prints)) or any(map(is_vector, letters))
    is_sign = has_matrices and not any(map(_PLAIN_T.search, prints))
    return [letter for letter in letters if not (is_sign and letter == "T")]
