r"""Signs -> tree, by precedence; what could be read in two ways is refused with its remedies.

Sums contain products, products powers, powers atoms. A function without brackets applies to a
number times one name, a fraction or a root: `\cos 2\varphi`, `\cos\frac x2`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from operator import itemgetter
from typing import TypeVar

import sympy as sp

from mechproof.latex import (
    atoms,
    calculus,
    calls,
    dotted,
    extrema,
    letters,
    modulo,
    places,
    printed_derivatives,
    several_equations,
    side_conditions,
    tree,
)
from mechproof.latex.characters import EITHER, find_alike, is_digit, name_character
from mechproof.latex.errors import MODULE, PrintedText, ReadingError, Remedies
from mechproof.latex.latex_signs import CLOSED_BY, CLOSING, DOTS, NARROW, WIDE, Token
from mechproof.latex.measures import is_unit
from mechproof.latex.name_table import Names, to_signs
from mechproof.latex.numerals import is_number_fraction, may_follow
from mechproof.latex.printed_derivatives import fold_slashed
from mechproof.latex.printed_functions import FUNCTIONS
from mechproof.latex.printed_relations import RELATIONS
from mechproof.latex.tokens import read_signs
from mechproof.record import Notation

T = TypeVar("T")
ENDING = (
    *(*RELATIONS, "+", "-", *CLOSING, ",", ";", "&", r"\\", r"\right.", ".", ""),
    *(WIDE, NARROW, r"\in", r"\forall"),
)


LONGEST_NAME = 40


def _spell(notation: Notation) -> Mapping[tuple[str, ...], tree.PrintedFunction]:
    """Return the declared functions that are printed as several signs: `cos^{-1}`, `Inv`."""
    two = tree.PrintedFunction("atan2", FUNCTIONS["atan2"])
    names = ("atan", "arctan", "arctg")
    spelled: dict[tuple[str, ...], tree.PrintedFunction] = {(rf"\{x}", "2"): two for x in names}
    for name, make in notation.functions.items():
        for latex in (name, rf"\{name}"):
            if len(signs := to_signs(latex)) > 1:
                spelled[signs] = tree.PrintedFunction(name, make)
    return spelled


class Parser:
    """Reads one print with the names of its row.

    `collected` gathers undeclared letters, if those are allowed. `upper` is 1 to read the upper
    signs of ± and ∓, -1 to read the lower ones, 0 to let a declared letter decide; without such a
    letter, 0 allows no double signs.
    """

    def __init__(
        self,
        latex: str,
        names: Names,
        notation: Notation,
        remedies: Remedies = MODULE,
        collected: list[str] | None = None,
        upper: int = 0,
    ) -> None:
        self.source = PrintedText(latex)
        tokens, self.groups = read_signs(latex)
        self.lines = several_equations.split(tokens)
        self.names = names
        self.begin(tokens, len(latex))
        self.notation = notation
        self.factors = {"".join(to_signs(latex)) for latex in notation.factors}
        makes: Mapping[str, Callable[..., sp.Expr]] = {**FUNCTIONS, **notation.functions}
        self.functions = {
            rf"\{name}": tree.PrintedFunction(name, make) for name, make in makes.items()
        }
        self._spelled = _spell(notation)
        self.remedies = remedies
        self.collects = collected is not None
        self.collected = [] if collected is None else collected
        self.branch = None if upper else notation.branch
        first = upper or int(self.branch is not None)
        double = {r"\pm": first, r"\mp": -first} if first else {}
        self.signs = {"+": 1, "-": -1, **double}
        self.bound: list[str] = []
        self.sums: list[tuple[str, int]] = []
        self.integrals: list[calculus.OpenIntegral] = []
        self.brackets: tuple[tree.Bracket, ...] = ()
        self._refuse_alike()

    def begin(self, tokens: Sequence[Token], last: int) -> None:
        """Begin to read these signs, which end at `last` in the source."""
        self.tokens: Sequence[Token] = fold_slashed(side_conditions.keep_gaps(tokens), self.names)
        self.last = last
        self.place = self.depth = 0
        # Open upright bars, single and double, at this depth.
        self.bars = Counter[str]()
        # The place of a bracket -> whether it multiplies the letter before it.
        self.multiplied: dict[int, bool] = {}

    # Walking --------------------------------------------------------------------------------

    @property
    def text(self) -> str:
        """Return the next sign, "" at the end."""
        return self.peek(0)

    def peek(self, count: int = 1) -> str:
        """Return the sign `count` places after the next one, "" beyond the end."""
        place = self.place + count
        return self.tokens[place].text if place < len(self.tokens) else ""

    @property
    def start(self) -> int:
        """Return the place of the next sign in the source."""
        at_end = self.place >= len(self.tokens)
        return self.last if at_end else self.tokens[self.place].start

    @property
    def end(self) -> int:
        """Return the end of the last sign read, in the source."""
        return self.tokens[self.place - 1].end if self.place else 0

    def take(self, text: str = "") -> Token:
        """Return the next sign and move past it; if `text` is given, it must be that sign."""
        if self.place >= len(self.tokens) or (text and self.text != text):
            raise self.refuse(f"expected {text}" if text else "the print ends too early")
        self.place += 1
        return self.tokens[self.place - 1]

    def skip(self, *texts: str) -> bool:
        """Move past the next sign if it is one of these; return whether it was."""
        if self.text in texts and self.text:
            self.place += 1
            return True
        return False

    @property
    def rest(self) -> Sequence[Token]:
        """Return the remaining signs."""
        return self.tokens[self.place :]

    def rest_of_member(self) -> list[str]:
        """Return the signs up to the next relation sign, comma or closing bracket of this level."""
        found: list[str] = []
        depth = 0
        for token in self.tokens[self.place :]:
            depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(token.text, 0)
            if depth < 0 or (depth == 0 and token.text in (*RELATIONS, ",", ";", "&")):
                break
            if depth == 0:
                found.append(token.text)
        return found

    def find_spelled(self) -> tuple[tree.PrintedFunction, int] | None:
        """Return the longest declared function of several signs here, and its number of signs."""
        texts = tuple(token.text for token in self.tokens[self.place : self.place + LONGEST_NAME])
        found = [(f, len(s)) for s, f in self._spelled.items() if texts[: len(s)] == s]
        found = [one for one in found if one[0].name != "atan2" or atoms.is_pair(self, one[1])]
        return max(found, key=itemgetter(1), default=None)

    def open_group(self) -> bool:
        """Return whether a group in braces comes next, restoring braces that were dropped."""
        ends = [end for start, end in self.groups if start == self.start]
        if not ends or self.text in ("{", ""):
            return self.text == "{"
        start, end = self.start, max(ends)
        last = next((n for n, t in enumerate(self.tokens) if t.start >= end), len(self.tokens))
        inside = (Token("{", start, start), *self.tokens[self.place : last], Token("}", end, end))
        self.tokens = (*self.tokens[: self.place], *inside, *self.tokens[last:])
        return True

    def _refuse_alike(self) -> None:
        """Refuse letters of two alphabets that print alike, here or among the names."""
        signs = {token.text: token.start for token in self.tokens[::-1]}
        signs |= {sign: n for n, sign in enumerate(self.source.latex) if sign in EITHER}
        if alike := find_alike(signs, self.names.signs):
            found = [signs[sign] for sign in sorted(alike, key=str.isascii) if sign in signs]
            raise self.refuse(
                f"{' and '.join(map(name_character, alike))} look alike: one letter or two?",
                "Print the same letter for one quantity, letters that look different for two.",
                found[0],
            )

    def refuse(self, reason: str, remedy: str = "", place: int | None = None) -> ReadingError:
        """Return the error at a place of the source, by default at the next sign."""
        return self.source.refuse(self.start if place is None else place, reason, remedy)

    # Expressions ----------------------------------------------------------------------------

    def read_sum(self) -> tree.Node:
        """Read terms with their signs."""
        start, before = self.start, self.peek(-1) if self.place else ""
        terms = [self.read_term()]
        while self.text in self.signs:
            if dotted.is_dotted_sum(self):
                terms = [(1, dotted.read_dotted_sum(self, terms, start))]
            else:
                terms.append(self.read_term())
        return modulo.read_remainder(self, self.add_up(terms, start), before)

    def add_up(self, terms: Sequence[tuple[int, tree.Node]], start: int) -> tree.Node:
        """Return the sum of terms with their signs, or the term itself if it is the only one."""
        if len(terms) == 1 and terms[0][0] == 1:
            return terms[0][1]
        return tree.Add(tuple(terms), start=start, end=self.end)

    def read_term(self) -> tuple[int, tree.Node]:
        """Read a product and its sign; a double sign multiplies it by the letter selecting it."""
        start, is_double = self.start, self.text in (r"\pm", r"\mp")
        sign, term = self.read_sign(), self.read_product()
        if self.branch is None or not is_double:
            return sign, term
        which = tree.Letter(self.branch, r"\pm", start=start, end=start)
        return sign, tree.Product((which, term), start=start, end=self.end)

    def read_sign(self) -> int:
        """Read the sign in front of a term, 1 if there is none."""
        return self.signs[self.take().text] if self.text in self.signs else 1

    def read_product(self) -> tree.Node:
        """Read factors side by side, with dots, or divided by a slash."""
        start = self.start
        factors = [self.read_factor()]
        signs: list[str] = []
        while not self.ends_product():
            if dotted.is_dotted_product(self):
                factors = [dotted.read_dotted_product(self, factors, start)]
                signs = []
            elif self.text == "/":
                factors = [self._divide(factors, signs, start)]
                signs = []
            else:
                signs.append(self._read_dot(factors[-1]))
                factors.append(self.read_factor())
        if len(factors) == 1:
            return factors[0]
        return tree.Product(tuple(factors), tuple(signs), start=start, end=self.end)

    def _read_dot(self, left: tree.Node) -> str:
        """Read the sign between two factors, "" if there is none."""
        if self.text in DOTS:
            return self.take().text
        self.check_neighbours(left)
        return ""

    def ends_product(self) -> bool:
        """Return whether no factor follows."""
        if self.text in ("|", r"\|"):
            return self.bars[self.text] > 0
        is_word = self.text.startswith((r"\text", r"\end")) and not is_unit(self)
        ends = self.text in ENDING or self.text in self.signs
        ends = ends or calculus.is_over(self) or calculus.is_double_sum(self)
        return is_word or ends or side_conditions.is_bracketed(self) or modulo.is_next(self)

    def _divide(self, factors: list[tree.Node], signs: list[str], start: int) -> tree.Node:
        slash = self.take("/")
        below = self.read_factor()
        if not self.ends_product() and self.text not in DOTS:
            raise self.refuse(
                "a slash is followed by several factors: are all of them in the denominator?",
                r"Print \frac{…}{…}, or brackets.",
                slash.start,
            )
        above = factors[0]
        if len(factors) > 1:
            above = tree.Product(tuple(factors), tuple(signs), start=start, end=slash.start)
        return tree.Quotient(above, below, start=start, end=self.end)

    def check_neighbours(self, left: tree.Node) -> None:
        """Refuse adjacent factors that could mean something else."""
        if is_digit(self.text) and not may_follow(self, left):
            raise self.refuse(
                "a number follows without a sign between: a factor, an index or a decimal place?",
                r"Print \cdot, or the number first.",
            )
        if isinstance(left, tree.Number) and self.text == r"\frac" and is_number_fraction(self):
            raise self.refuse(
                "a number before a fraction of numbers: a product or a mixed number?",
                r"Print \cdot between them.",
            )
        letters.check_bracket_after(self, left)

    def read_factor(self) -> tree.Node:
        """Read an atom and the power it is raised to, with a bar after it."""
        place, factor = self.place, self._read_power()
        return places.read_bar(self, factor, place) if places.is_bar(self) else factor

    def _read_power(self) -> tree.Node:
        if extrema.is_extremum(self):
            return extrema.read_extremum(self)
        if calls.is_function(self):
            return calls.read_call(self)
        start, atom = self.start, self.read_atom()
        if atoms.is_excerpt(self):
            atom = atoms.read_excerpt(self, atom, start)
        if self.text == "_" and isinstance(atom, tree.Bracket):
            return places.read_indexed(self, atom)
        if suffixed := printed_derivatives.read_suffix(self, atom):
            return suffixed
        if self.text == "^" and isinstance(atom, tree.Quotient):
            raise self.refuse("a power of a fraction without brackets", r"Print \left(…\right)^n.")
        return self._raise(atom, start) if self.text == "^" else atom

    def read_atom(self) -> tree.Node:
        """Read the operand at the current place, up to the next operator."""
        return atoms.read_atom(self)

    def _raise(self, base: tree.Node, start: int) -> tree.Node:
        raised = atoms.read_special_power(self, base, start)
        raised = raised or tree.Power(base, self.read_script("^"), start=start, end=self.end)
        if not isinstance(raised, tree.Power | tree.Transposed):
            return raised
        return letters.read_argument_after(self, raised)

    def read_script(self, mark: str) -> tree.Node:
        """Read the expression in a script."""
        self.take(mark)
        return self.read_group()

    def read_group(self) -> tree.Node:
        """Read an expression in braces."""
        return self.read_inside("{", self.read_sum)

    def read_inside(self, opening: str, read: Callable[[], T]) -> T:
        r"""Read with `read`, a level deeper, up to the closing sign; that of \left. is a bar."""
        self.take(opening)
        self.depth += 1
        bars, self.bars = self.bars, Counter()
        inside = read()
        self.bars = bars
        self.depth -= 1
        self.take(CLOSED_BY.get(opening, r"\rvert"))
        return inside
