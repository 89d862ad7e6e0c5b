"""Tree -> SymPy: what a print means in the symbols of its paper."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import reduce
from operator import add
from typing import Any

import sympy as sp
from sympy.matrices.exceptions import ShapeError

from mechproof.latex import calculus_meaning, derivative_meaning, matrix_meaning, tree
from mechproof.latex.dotted import give_dotted
from mechproof.latex.errors import MeaningError, PrintedText, ReadingError, Remedies
from mechproof.latex.extrema import give_term
from mechproof.latex.matrix_exponentials import give_exponential
from mechproof.latex.printed_functions import FUNCTIONS, OF_MATRICES
from mechproof.latex.printed_relations import EQUAL, STATED
from mechproof.latex.values import QUOTIENTS, has_counts, is_root, name_turns, settle_all
from mechproof.latex.words import AND
from mechproof.record import (
    FunctionWithoutArgument,
    Notation,
    ValueWhere,
    list_divisors,
    list_partial,
)
from mechproof.record.estimates import without_estimates

LARGEST_EXPONENT = 1000
_UNFIT = "numbers, matrices or their shapes do not fit together here"
LARGEST_POWER_BITS = 100_000


class Meaning:
    """Turns the trees of one row into expressions.

    `values` gives the values of symbols that are defined by others, as this row has them: an
    integrand has to show its variable, and a matrix its entries.
    """

    def __init__(
        self,
        source: PrintedText,
        values: Mapping[sp.Basic, sp.Basic],
        notation: Notation,
        remedies: Remedies,
    ) -> None:
        self.source = source
        self.values = values
        self.lower_limit = notation.lower_limit
        self.moving = notation.moving
        self.parameters = notation.parameters
        self.is_complex = bool(notation.imaginary)
        self.remedies = remedies
        self._met: dict[sp.Basic, None] = {}
        # Number of powers of matrices to letters met so far.
        self._raised = 0
        # The divisors met, each with the expression that shows it; and those that sides have lost.
        self.divisors: dict[sp.Expr, sp.Expr] = {}
        self.lost: dict[sp.Expr, None] = {}

    @without_estimates()
    def side(self, node: tree.Node) -> Any:
        """Return the expression of a node, requiring values for the parts that SymPy has cancelled.

        A printed root, logarithm or integral must have a value, whatever it is multiplied by or
        subtracted from.
        """
        outside, self._met = self._met, {}
        divisors, self.divisors = self.divisors, {}
        value = self.of(node)
        self.lost |= dict.fromkeys(calculus_meaning.list_lost(self.divisors, value))
        self.divisors = divisors
        roots = {power.base for power in value.atoms(sp.Pow) if power.exp.is_integer is False}
        met = [p for p in self._met if not (self.is_complex and p.has(sp.I))]
        # In a quotient the divisor is a power with the opposite exponent.
        met = [p for p in met if not (value.has(p) or (p.is_Pow and value.has(1 / p)))]
        lost = [p for p in met if not (is_root(p) and p.base in roots)]
        self._met = outside
        if isinstance(value, sp.MatrixBase):
            return value.applyfunc(lambda entry: reduce(ValueWhere, lost, entry))
        return reduce(ValueWhere, lost, value)

    def of(self, node: tree.Node) -> Any:
        """Return the expression of a node; raises `ReadingError` for a division by zero, etc."""
        raised = self._raised
        try:
            found = self._find(node)
        except ReadingError:
            raise
        except (ValueError, AttributeError, NotImplementedError, ShapeError, TypeError) as error:
            told = str(error) if isinstance(error, MeaningError) else self._describe_unfit(node)
            raise self.source.refuse(node.start, told) from error
        # SymPy would evaluate such a power, for some matrices only and with those parameters.
        if self._raised > raised and not isinstance(node, tree.Power | tree.Bracket):
            raise self.source.refuse(node.start, self._describe_unfit(node))
        if isinstance(found, sp.Basic) and found.has(sp.nan, sp.zoo):
            raise self.source.refuse(node.start, "this divides by zero")
        is_scalar = isinstance(found, sp.Expr) and not isinstance(found, sp.MatrixExpr)
        if is_scalar and not self.is_complex and name_turns(found).is_extended_real is False:
            raise self.source.refuse(node.start, "this has no real value")
        if is_scalar:
            self._met |= dict.fromkeys(list_partial(found))
        return found

    def _describe_unfit(self, node: tree.Node) -> str:
        """Return a message that parts do not fit together, naming the letters that are matrices."""
        letters = [part for part in tree.walk(node) if isinstance(part, tree.Letter)]
        values = {one.text: self.values.get(one.symbol, one.symbol) for one in letters}
        shapes = {
            text: value.shape for text, value in values.items() if matrix_meaning.is_matrix(value)
        }
        told = (f"{text} is a {rows}x{columns} matrix" for text, (rows, columns) in shapes.items())
        return "; ".join((_UNFIT, *told))

    def _find(self, node: tree.Node) -> Any:
        """Return the value of a node.

        The divisors inside a node that binds a letter, or inside cases, are not passed on.
        """
        if not isinstance(node, (*calculus_meaning.BINDING, tree.Cases)):
            return _RULES[type(node)](self, node)
        divisors, lost = {**self.divisors}, {**self.lost}
        found = _RULES[type(node)](self, node)
        self.divisors = divisors
        if not isinstance(node, calculus_meaning.RUNNING):
            self.lost = lost
        return found

    def relate(self, chain: tree.Chain) -> tuple[sp.Basic, ...]:
        """Return the relations of a chain, unevaluated."""
        members = [self.side(member) for member in chain.members]
        if _any_matrix(members) and {*chain.relations} - {*EQUAL}:
            raise self.source.refuse(
                chain.members[0].start, "matrices cannot be ordered", matrix_meaning.ENTRIES
            )
        return tuple(
            STATED[sign](left, right, evaluate=False)
            for left, sign, right in zip(members, chain.relations, members[1:], strict=False)
            if sign != AND
        )

    def _number(self, node: tree.Node) -> Any:
        return self.take_number(node, self.of(node))

    def take_number(self, node: tree.Node, found: Any) -> Any:
        """Return a value that has to be a scalar; raises `ReadingError` for a matrix."""
        if matrix_meaning.is_matrix(found):
            raise self.source.refuse(
                node.start, "a matrix where a number is expected", matrix_meaning.ENTRIES
            )
        return found

    def letter(self, node: tree.Letter) -> Any:
        """Return the symbol of a letter, the member of a family, or the entries of a matrix."""
        if isinstance(node.symbol, sp.IndexedBase):
            return node.symbol[tuple(self.of(index) for index in node.indices)]
        value = self.values.get(node.symbol)
        if isinstance(value, sp.Expr) and not isinstance(value, sp.MatrixBase):
            self._met[node.symbol] = None
        return value if isinstance(value, sp.MatrixBase) else node.symbol

    def _add(self, node: tree.Add) -> Any:
        terms = [sign * self.of(term) for sign, term in node.terms]
        if not _any_matrix(terms):
            return sp.Add(*terms)
        # Next to a matrix, a zero stands for a matrix of zeros.
        return reduce(add, [term for term in terms if matrix_meaning.is_matrix(term) or term != 0])

    def _quotient(self, node: tree.Quotient) -> Any:
        below = self.of(node.below)
        if below == 0:
            raise self.source.refuse(node.below.start, "this divides by zero")
        self._divide_by(below)
        return self.of(node.above) / below

    def _divide_by(self, number: Any, shown: Any = None) -> None:
        is_scalar = isinstance(number, sp.Expr) and not matrix_meaning.is_matrix(number)
        if is_scalar and not (number.is_number and number.is_nonzero):
            self.divisors[number] = shown or 1 / number

    def _power(self, node: tree.Power) -> Any:
        base, exponent = self.of(node.base), self.of(node.exponent)
        if matrix_meaning.is_matrix(exponent):
            if settle_all(base, self.values) != sp.E:
                raise self.source.refuse(node.start, self._describe_unfit(node))
            return give_exponential(exponent)
        if exponent == 2 and matrix_meaning.is_vector(base):
            shown = matrix_meaning.show_entries(base)
            return shown.dot(shown)
        if isinstance(base, sp.MatrixBase) and not exponent.is_Integer:
            if (power := matrix_meaning.raise_matrix(base, exponent)) is None:
                raise self.source.refuse(node.start, self._describe_unfit(node))
            self._raised += 1
            return power
        if matrix_meaning.is_power(base):
            raise self.source.refuse(node.start, self._describe_unfit(node))
        if isinstance(base, sp.MatrixBase) and exponent == -1 and base.is_square:
            self._divide_by(base.det(method="berkowitz"))
            return matrix_meaning.invert(base)
        if isinstance(exponent, sp.Rational) and abs(exponent) > LARGEST_EXPONENT:
            raise self.source.refuse(
                node.exponent.start, f"an exponent beyond {LARGEST_EXPONENT} is not evaluated"
            )
        if base == 0 and exponent == 0:
            raise self.source.refuse(node.start, "zero to the power of zero has no value")
        if isinstance(base, sp.Rational) and isinstance(exponent, sp.Rational):
            bits = max(abs(base.p), base.q).bit_length() * abs(exponent)
            if bits > LARGEST_POWER_BITS:
                raise self.source.refuse(node.start, "a power with so many digits is not evaluated")
        power = base**exponent
        if exponent == 0 or exponent.could_extract_minus_sign():
            self._divide_by(base)
        return power

    def _root(self, node: tree.Radical) -> sp.Expr:
        degree = self._number(node.degree) if node.degree else sp.Integer(2)
        radicand = self._number(node.radicand)
        if degree.is_odd and not radicand.is_nonnegative:
            # The real root; SymPy's power is the principal one, which is complex.
            return sp.sign(radicand) * sp.Abs(radicand) ** (1 / degree)
        return radicand ** (1 / degree)

    def _call(self, node: tree.Call) -> sp.Expr:
        if not node.arguments:
            return FunctionWithoutArgument(sp.Symbol(node.function.name))
        is_known = node.function.name in FUNCTIONS and node.function.name not in OF_MATRICES
        read = self._number if is_known else self.of
        arguments = [read(argument) for argument in node.arguments]
        make = node.function.make
        if make in QUOTIENTS and has_counts(settle_all(arguments[0], self.values)):
            make = QUOTIENTS[make]
        value = make(*arguments)
        if isinstance(value, sp.Expr):
            below = list_divisors(value)
            above = value.atoms(sp.factorial) - {*below}
            poles = [1 / one for one in above if not one.args[0].is_nonnegative]
            for divisor in (*below, *poles):
                self._divide_by(divisor, value)
        return value ** self.of(node.exponent) if node.exponent else value

    def _cases(self, node: tree.Cases) -> sp.Basic:
        pieces, undefined = [], []
        for value, chain in node.pieces:
            relations = self.relate(chain)
            if value is None:
                undefined.append(sp.Not(sp.And(*relations)))
            else:
                condition = sp.And(*relations, *undefined, evaluate=False)
                pieces.append((self.side(value), condition))
        if node.otherwise:
            pieces.append((self.side(node.otherwise), sp.And(*undefined)))
        return sp.Piecewise(*pieces, evaluate=False)


def _any_matrix(parts: list[Any]) -> bool:
    return any(map(matrix_meaning.is_matrix, parts))


_RULES: Mapping[type, Callable[[Meaning, Any], Any]] = {
    tree.Number: lambda meaning, node: sp.Rational(node.text),
    tree.Measure: lambda meaning, node: sp.Rational(node.number.text) * node.factor,
    tree.Calculated: lambda meaning, node: node.value,
    tree.Constant: lambda meaning, node: node.value,
    tree.Letter: Meaning.letter,
    tree.Bracket: lambda meaning, node: meaning.of(node.inside),
    tree.Add: Meaning._add,
    tree.Product: matrix_meaning.give_product,
    tree.Quotient: Meaning._quotient,
    tree.Dotted: give_dotted,
    tree.Power: Meaning._power,
    tree.Radical: Meaning._root,
    tree.Call: Meaning._call,
    tree.Repeated: calculus_meaning.give_repeated,
    tree.Integration: calculus_meaning.give_integral,
    tree.Derivation: derivative_meaning.give_derivative,
    tree.Approach: calculus_meaning.give_limit,
    tree.At: calculus_meaning.give_value,
    tree.Extremum: give_term,
    tree.Table: lambda meaning, node: matrix_meaning.assemble(
        [[*map(meaning.of, row)] for row in node.rows]
    ),
    tree.Entries: lambda meaning, node: matrix_meaning.give_list([*map(meaning.of, node.parts)]),
    tree.Excerpt: matrix_meaning.give_excerpt,
    tree.Transposed: matrix_meaning.give_transposed,
    tree.Magnitude: matrix_meaning.give_magnitude,
    tree.Degrees: lambda meaning, node: meaning.of(node.number) * sp.pi / 180,
    tree.Cases: Meaning._cases,
}
