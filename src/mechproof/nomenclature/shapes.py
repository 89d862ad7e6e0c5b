"""Sizes of vectors and matrices that follow from how a paper adds, multiplies and prints them.

A size that no table, sum, product or cross product determines stays open, as does a factor that may
be a number or a square matrix. `[R]` around a single letter is a matrix; around a vector it is the
matrix of its cross product.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import pairwise

import sympy as sp

from mechproof.latex import ReadingError, tree
from mechproof.latex.printed_functions import OF_MATRICES
from mechproof.nomenclature.shown_letters import (
    Collected,
    find_shapes,
    is_vector,
    make_reader,
    name_symbol,
)

Shape = tuple[int, int]


def _is_vector(node: tree.Node) -> bool:
    return isinstance(node, tree.Letter) and is_vector(node.text)


def _is_outer(one: tree.Node, other: tree.Node) -> bool:
    """Return whether a product is that of a vector and its own transpose."""
    of = other.of if isinstance(other, tree.Transposed) else None
    if isinstance(other, tree.Power) and getattr(other.exponent, "text", "") == "T":
        of = other.base
    if not (isinstance(one, tree.Letter) and isinstance(of, tree.Letter)):
        return False
    return _is_vector(one) and not _is_bold_capital(one) and of.symbol == one.symbol


def _is_bold_capital(node: tree.Node) -> bool:
    """Return whether a factor is a bold capital: a matrix, unless it is a vector."""
    inside = node.of if isinstance(node, tree.Transposed) else node
    return isinstance(inside, tree.Letter) and bool(_BOLD_CAPITAL.match(inside.text))


NUMBER, COLUMN, CROSS = (1, 1), (3, 1), (3, 3)
_NUMBERS = (tree.Number, tree.Constant, tree.Radical)
_BOLD_CAPITAL = re.compile(r"\\(?:mathbf|bm)\{[A-Z]\}")
# Left scripts for two frames, and the letter after them.
_CHANGES_FRAME = re.compile(r"\{\}\^\{[^{}]*\}_\{[^{}]*\}(.*)\Z")
# The prefix of the name of a rate.
_RATE = re.compile(r"\Ad*dot")
# A table with more rows or columns than this is not taken to be made of blocks.
_BLOCKS = 2


class Shapes:
    """The shapes of letters, by their symbols.

    `crosses` are the vectors whose square bracket means the matrix of their cross product,
    `unclear` are letters for which different shapes follow.
    """

    def __init__(
        self, prints: Sequence[tuple[str, Sequence[tree.Chain]]], *, has_plain_matrices: bool = True
    ) -> None:
        self.known: dict[sp.Basic, Shape] = {}
        self.crosses: dict[sp.Basic, None] = {}
        self.unclear: dict[sp.Basic, None] = {}
        self.frames: dict[str, Shape] = {}
        self._prints, self._has_plain_matrices = prints, has_plain_matrices
        self._latex = ""
        for node in self._walk_all():
            if isinstance(node, tree.Letter) and isinstance(node.symbol, sp.MatrixSymbol):
                self.known[node.symbol] = int(node.symbol.rows), int(node.symbol.cols)
        self._shows_matrices = any(
            isinstance(node, tree.Table) or self._is_matrix(node) for node in self._walk_all()
        )

    def _walk_all(self) -> Iterable[tree.Node]:
        for latex, chains in self._prints:
            self._latex = latex
            yield from tree.walk(tuple(chains))

    def find(self) -> dict[sp.Basic, Shape]:
        """Return the shapes of the letters that are not numbers."""
        before: list[int] = []
        while before != (after := [len(self.known), len(self.crosses), len(self.unclear)]):
            if before and before[-1] != after[-1]:
                # Nothing can be concluded from a letter with several shapes.
                self.known.clear()
                self.crosses.clear()
            before = after
            for node in self._walk_all():
                self._look(node)
                if isinstance(node, tree.Letter) and (shape := self._find_other_frame(node)):
                    self._push(node, shape)
        return {symbol: shape for symbol, shape in self.known.items() if shape != NUMBER}

    def _look(self, node: tree.Node) -> None:
        """Draw conclusions from a single node."""
        if isinstance(node, tree.Chain) and {*node.relations} <= {"="}:
            # A zero may stand for a matrix of any size.
            members = [
                x for x in node.members if not (isinstance(x, tree.Number) and x.text == "0")
            ]
            shape = next(filter(None, map(self.measure, members)), None)
            for member in members:
                if shape:
                    self._push(member, shape)
            self._take_determinant(node.members)
            self._take_components(node.members)
        elif isinstance(node, tree.Add) and (shape := self.measure(node)):
            self._push(node, shape)
        elif isinstance(node, tree.Product) and self._is_cross(node):
            for factor in node.factors:
                self._push(factor, COLUMN)
        elif isinstance(node, tree.Product):
            self._look_at_frames(node.factors)
        elif isinstance(node, tree.Call) and node.function.name not in OF_MATRICES:
            for argument in node.arguments:
                self._push(argument, NUMBER)
        elif isinstance(node, tree.Table) and max(len(node.rows), len(node.rows[0])) > _BLOCKS:
            for entry in (entry for row in node.rows for entry in row):
                self._push(entry, NUMBER)

    def _look_at_frames(self, factors: Sequence[tree.Node]) -> None:
        """Conclude that a letter that changes the frame of a vector is a square matrix."""
        for one, other in pairwise(factors):
            shape = self.measure(other)
            is_column = shape is not None and shape[1] == 1 != shape[0]
            if (
                shape
                and is_column
                and isinstance(one, tree.Letter)
                and _CHANGES_FRAME.match(one.text)
            ):
                self._push(one, (shape[0], shape[0]))

    def _take_components(self, members: Sequence[tree.Node]) -> None:
        """Give vectors equated with a bracket the number of its components."""
        brackets = (x.of if isinstance(x, tree.Transposed) else x for x in members)
        lists = [x.parts for x in brackets if isinstance(x, tree.Entries)]
        for parts in lists:
            for member in members:
                if _is_vector(member) and not any(map(_is_vector, tree.walk(parts))):
                    self._push(member, (len(parts), 1))

    def _take_determinant(self, members: Sequence[tree.Node]) -> None:
        """Give a letter in bars, equated with a printed determinant, the size of its table."""
        calls = (x.arguments[0] for x in members if isinstance(x, tree.Call) and x.arguments)
        for table in (x for x in calls if isinstance(x, tree.Table)):
            for member in members:
                if isinstance(member, tree.Magnitude):
                    self._push(member.inside, (len(table.rows), len(table.rows[0])))

    def _is_matrix(self, node: tree.Node) -> bool:
        """Return whether a node is a single letter in square brackets."""
        if not (isinstance(node, tree.Bracket) and isinstance(node.inside, tree.Letter)):
            return False
        return self._latex[node.start : node.end].removeprefix(r"\left").strip().startswith("[")

    def _is_cross(self, node: tree.Product) -> bool:
        """Return whether a product is the cross product of two factors that can be vectors."""
        is_open = all(
            self.measure(x) in (None, COLUMN) and not self._is_matrix(x) for x in node.factors
        )
        return self._shows_matrices and node.signs == (r"\times",) and is_open

    def measure(self, node: tree.Node) -> Shape | None:
        """Return the shape of a node, None if it is unknown."""
        if isinstance(node, tree.Letter):
            known = self.known.get(node.symbol) or self._find_other_frame(node)
            is_plain = not self._has_plain_matrices and not is_vector(node.text)
            return known or (NUMBER if is_plain else None)
        if isinstance(node, tree.Excerpt):
            sides = [limits[1] - limits[0] + 1 for limits in node.ranges if limits]
            return (sides[0], sides[1]) if len(sides) > 1 else None
        if isinstance(node, tree.Bracket):
            letter = node.inside
            is_cross = isinstance(letter, tree.Letter) and letter.symbol in self.crosses
            return CROSS if is_cross and self._is_matrix(node) else self.measure(letter)
        if isinstance(node, tree.Add):
            return next(filter(None, (self.measure(term) for _, term in node.terms)), None)
        if isinstance(node, tree.Product):
            return COLUMN if self._is_cross(node) else self._multiply(node.factors)
        if isinstance(node, tree.Quotient):
            return self.measure(node.above)
        if isinstance(node, tree.Power) and (raised := self._measure_exponent(node.exponent)):
            return raised
        if isinstance(node, tree.Call) and node.function.name == "exp" and node.arguments:
            return self._measure_exponent(node.arguments[0]) or NUMBER
        if isinstance(node, tree.Power):
            shape = self.measure(node.base)
            # The square of a vector is its product with itself.
            return NUMBER if shape and shape[0] != shape[1] else shape
        if isinstance(node, tree.Transposed):
            shape = self.measure(node.of)
            return shape and (shape[1], shape[0])
        if isinstance(node, tree.Table):
            heights, widths = self._measure_blocks(node)
            return (sum(heights), sum(widths)) if heights and widths else None
        is_number = isinstance(node, _NUMBERS) or (isinstance(node, tree.Call) and node.arguments)
        return NUMBER if is_number else None

    def _measure_exponent(self, node: tree.Node) -> Shape | None:
        """Return the shape of an exponent that is a multiple of a square matrix, else None."""
        inside = tree.strip(node)
        if isinstance(inside, tree.Add) and len(inside.terms) == 1:
            inside = inside.terms[0][1]
        factors = inside.factors if isinstance(inside, tree.Product) else (inside,)
        shapes = {shape for shape in map(self.measure, factors) if shape not in (None, NUMBER)}
        square = shapes.pop() if len(shapes) == 1 else NUMBER
        return square if square and square[0] == square[1] > 1 else None

    def _find_other_frame(self, letter: tree.Letter) -> Shape | None:
        """Return the shape of the same letter between other frames."""
        own = _CHANGES_FRAME.match(letter.text)
        return self.frames.get(own[1]) if own else None

    def _measure_blocks(self, table: tree.Table) -> tuple[list[int], list[int]]:
        """Return the heights of the rows and the widths of the columns, empty if one is open."""
        shapes = [[self.measure(entry) for entry in row] for row in table.rows]
        is_large = max(len(table.rows), len(table.rows[0])) > _BLOCKS
        if is_large or all(one == NUMBER for row in shapes for one in row):
            return [1] * len(table.rows), [1] * len(table.rows[0])
        blocks = [[one for one in row if one != NUMBER] for row in shapes]
        columns = [[one for one in column if one != NUMBER] for column in zip(*shapes, strict=True)]
        if not any(one for row in blocks for one in row):
            return [], []
        heights = [next((one[0] for one in row if one), 0 if row else 1) for row in blocks]
        widths = [next((one[1] for one in column if one), 0 if column else 1) for column in columns]
        return ([], []) if 0 in heights or 0 in widths else (heights, widths)

    def _multiply(self, factors: Sequence[tree.Node]) -> Shape | None:
        shapes = [shape for shape in map(self.measure, factors) if shape != NUMBER]
        if not shapes:
            return NUMBER
        first, last = shapes[0], shapes[-1]
        return (first[0], last[1]) if None not in shapes and first and last else None

    def _push(self, node: tree.Node, shape: Shape) -> None:
        """Pass the shape of a node on to its letters."""
        if isinstance(node, tree.Letter) and not isinstance(node.symbol, sp.IndexedBase):
            is_clear = self.known.get(node.symbol, shape) == shape
            if node.symbol not in self.unclear and is_clear:
                self.known[node.symbol] = shape
                if frames := _CHANGES_FRAME.match(node.text):
                    self.frames.setdefault(frames[1], shape)
            elif not is_clear:
                self.unclear[node.symbol] = None
        elif isinstance(node, tree.Bracket) and isinstance(node.inside, tree.Letter):
            is_column = self._is_matrix(node) and self.known.get(node.inside.symbol) == COLUMN
            if is_column and shape == CROSS:
                self.crosses[node.inside.symbol] = None
            else:
                self._push(node.inside, shape)
        elif isinstance(node, tree.Bracket):
            self._push(node.inside, shape)
        elif isinstance(node, tree.Add):
            for _, term in node.terms:
                self._push(term, shape)
        elif isinstance(node, tree.Transposed):
            self._push(node.of, (shape[1], shape[0]))
        elif isinstance(node, tree.Quotient):
            self._push(node.above, shape)
        elif isinstance(node, tree.Power) and shape[0] == shape[1] > 1:
            self._push(node.base, shape)
        elif isinstance(node, tree.Product):
            self._solve(node, shape)

    def _solve(self, node: tree.Product, shape: Shape) -> None:
        """Conclude the shape of the only unknown factor of a product."""
        shapes = list(map(self.measure, node.factors))
        if shape == NUMBER or self._is_cross(node):
            return
        for one, other in pairwise(node.factors):
            if _is_outer(one, other):
                self._push(one, (shape[0], 1))
                return
        if shapes.count(None) > 1:
            # Next to a vector, unknown letters are taken to be numbers.
            shapes = [
                NUMBER if one is None and not _is_vector(x) else one
                for x, one in zip(node.factors, shapes, strict=True)
            ]
        others = [x for x, one in zip(node.factors, shapes, strict=True) if one != NUMBER]
        if len(others) == 1:
            self._push(others[0], shape)
        if len(others) == 1 or shapes.count(None) != 1:
            return
        place = shapes.index(None)
        before = [one for one in shapes[:place] if one not in (None, NUMBER)]
        following = [one for one in shapes[place + 1 :] if one not in (None, NUMBER)]
        rows = before[-1][1] if before else shape[0]
        columns = following[0][0] if following else shape[1]
        factor = node.factors[place]
        is_bold = _is_bold_capital(factor) and r"\times" not in node.signs
        may_be_number = (before or following) and rows == columns and not is_bold
        if not may_be_number or self._is_matrix(factor):
            self._push(factor, (rows, columns))


@dataclass(frozen=True)
class MatrixSizes:
    """The sizes of letters by their names, and letters with contradictory sizes (`unclear`).

    `crosses` are the vectors whose bracket means the matrix of their cross product.
    """

    known: dict[str, Shape]
    crosses: tuple[str, ...]
    unclear: tuple[str, ...]


def find_sizes(
    prints: Sequence[str], collected: Collected, *, has_plain_matrices: bool = True
) -> MatrixSizes:
    """Return the sizes of letters; reading repeats with them, as they may determine others.

    Unless it `has_plain_matrices`, a letter is a number if neither its print nor a table of entries
    says otherwise.
    """
    letters = [*collected.letters, *collected.guessed]
    found = dict(find_shapes(prints))
    while True:
        reader, read = make_reader(letters, collected, found), []
        for latex in prints:
            with suppress(ReadingError, RecursionError):
                read.append((latex, reader.parse(latex, upper=1).chains))
        shapes = Shapes(read, has_plain_matrices=has_plain_matrices)
        known = {name_symbol(str(symbol)): shape for symbol, shape in shapes.find().items()}
        names = [*map(name_symbol, letters)]
        known |= {x: found[y] for x in names if (y := _RATE.sub("", x)) in found and x not in found}
        if known.keys() <= found.keys():
            crosses, unclear = (
                tuple(name_symbol(str(symbol)) for symbol in symbols)
                for symbols in (shapes.crosses, shapes.unclear)
            )
            return MatrixSizes(found, crosses, unclear)
        found |= known
