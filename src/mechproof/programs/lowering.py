"""Lowering: in, SymPy expressions; out, programs. The order of roundings is decided here.

Sums add positive terms first, as people write them. Products take the factors of parameters alone
first, so that these are computed once and not once per point, and divide before they multiply by
the running variable: a tiny variable times a tiny numerator would underflow before a tiny
denominator brings it back. Squares are one operation; other whole powers are squares and products.
In the term of a sum, squares of factors become one square of their product; a term x[i]*x[j]*M[i,
j] becomes a quadratic form of the vector x, which under a root is taken to be nonnegative.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping
from functools import partial, reduce
from itertools import chain
from types import MappingProxyType

import sympy as sp

from mechproof.programs import program
from mechproof.programs.evaluation import KeepsShape, unused_name
from mechproof.programs.operations import KINDS, SYMBOLIC, Kind
from mechproof.programs.program import TEMPORARY, Operand, Operation, Program
from mechproof.programs.step_names import sort_positive_first, suggest_name
from mechproof.record.relations import is_strict
from mechproof.record.substitution import MOST_TERMS, STEPS, write_steps


def _name_head(row: Kind) -> str:
    """Return the name by which expressions call a kind of function; "" for operators."""
    if isinstance(row.sympy, type) and issubclass(row.sympy, sp.Function):
        return str(row.sympy.__name__)
    return row.head


FUNCTIONS: Mapping[str, str] = MappingProxyType(
    {head: kind for kind, row in KINDS.items() if (head := _name_head(row))}
)
# Functions that papers may use, by SymPy's own names.
_PLAIN = [head for head, kind in FUNCTIONS.items() if not KINDS[kind].head]
KNOWN = ", ".join(sorted([*_PLAIN, *(kind.__name__ for kind in STEPS), "Root"]))
CONSTANTS: Mapping[sp.Basic, str] = MappingProxyType({v: n for n, v in program.CONSTANTS.items()})


class Lowering:
    """Turns expressions into operations; `names` spells inputs, `large` ones vary by point."""

    def __init__(self, names: Mapping[sp.Basic, str], large: frozenset[sp.Basic]) -> None:
        self.operations: list[Operation] = []
        self._names = names
        self._large = large
        self._axes: tuple[sp.Basic, ...] = ()
        self._taken = set(names.values())

    def lower_step(self, name: str, value: sp.Expr) -> None:
        """Add the operations of a named step."""
        self._taken.add(name)
        result = self.lower(value)
        if isinstance(result, str) and result.startswith(TEMPORARY):
            last = self.operations.pop()
            self.operations.append(Operation(name, last.kind, last.operands))
        else:
            self.operations.append(Operation(name, "copy", (result,)))

    def lower_relation(self, relation: sp.Basic) -> Operand:
        """Add the operations of a relation, true if it holds for all values of its indices."""
        items = relation.atoms(sp.Indexed)
        self._axes = tuple(sorted({i for item in items for i in item.indices}, key=str))
        result = self.lower(write_steps(relation))
        axes, self._axes = self._axes, ()
        return self._add("every", result, len(axes)) if axes else result

    def lower(self, expression: sp.Basic) -> Operand:
        """Add an expression's operations; NotImplementedError for a function without a kind."""
        for kind, method in _METHODS:
            if isinstance(expression, kind):
                return method(self, expression)
        raise NotImplementedError(f"no operation for {expression.func.__name__}: {expression}")

    def join(self, relations: Iterable[sp.Basic]) -> Operand:
        """Add the operations that test whether all relations hold."""
        return self._fold("both", map(self.lower_relation, relations))

    def _add(self, kind: str, *operands: Operand) -> str:
        # Numbered by the length of the list, which never shrinks: no two temporaries share a
        # number.
        result = f"{TEMPORARY}{len(self.operations) + 1}"
        self.operations.append(Operation(result, kind, operands))
        return result

    def _fold(self, kind: str, operands: Iterable[Operand]) -> Operand:
        """Add operations that combine operands from the left, each one as soon as it is known."""
        return reduce(partial(self._add, kind), operands)

    def _name_last(self, operand: Operand, suggestion: str) -> Operand:
        """Give the last result a name if it is a temporary, as it is used more than once."""
        if not (isinstance(operand, str) and operand.startswith(TEMPORARY)):
            return operand
        name = unused_name(suggestion, self._taken)
        self._taken.add(name)
        last = self.operations.pop()
        self.operations.append(Operation(name, last.kind, last.operands))
        return name

    def _symbol(self, symbol: sp.Symbol) -> Operand:
        return self._names.get(symbol, str(symbol.name))

    def _number(self, number: sp.Rational | sp.Float) -> Operand:
        exact = sp.Rational(number)
        if max(abs(exact.p), exact.q) > sys.float_info.max:
            raise NotImplementedError("a constant beyond the range of doubles")
        if exact.is_Integer:
            return int(exact)
        if sp.Rational(float(exact)) == exact:
            return float(exact)
        # As a quotient, it remains the exact number for readers of the program.
        return self._add("divide", int(exact.p), int(exact.q))

    def _constant(self, constant: sp.Basic) -> Operand:
        return CONSTANTS[constant]

    def _function(self, function: sp.Function) -> Operand:
        name = function.func.__name__
        if name not in FUNCTIONS:
            raise NotImplementedError(f"no operation for {name}: {function}")
        row = KINDS[FUNCTIONS[name]]
        if row.is_composed:
            assert row.meaning is not None
            return self.lower(row.meaning(SYMBOLIC, *function.args))
        return self._add(row.name, *map(self.lower, function.args))

    def _alongside(self, alongside: KeepsShape) -> Operand:
        # Adding zero times the argument gives the value its shape and its NaN.
        value, argument = map(self.lower, alongside.args)
        return self._add("add", value, self._add("multiply", 0, argument))

    def _extreme(self, extreme: sp.Max | sp.Min) -> Operand:
        kind = "maximum" if isinstance(extreme, sp.Max) else "minimum"
        return self._fold(kind, map(self.lower, extreme.args))

    def _sum(self, total: sp.Add) -> Operand:
        first, *others = sorted(total.args, key=sort_positive_first)
        result = self.lower(first)
        for term in others:
            negative = term.could_extract_minus_sign()
            kind = "subtract" if negative else "add"
            result = self._add(kind, result, self.lower(-term if negative else term))
        return result

    def _product(self, product: sp.Mul) -> Operand:
        negative = product.could_extract_minus_sign()
        numerator, denominator = sp.fraction(-product if negative else product)
        factors = sp.Mul.make_args(numerator)
        small = [f for f in factors if not f.has(*self._large)]
        large = [f for f in factors if f.has(*self._large)]
        if denominator == 1:
            return self._multiply(small + large, negative)
        first, last = (small, large) if small else (large, [])
        above = self._multiply(first, negative)
        result = self._add("divide", above, self.lower(denominator))
        return self._fold("multiply", chain([result], map(self.lower, last)))

    def _multiply(self, factors: list[sp.Expr], negative: bool) -> Operand:
        first, *others = factors
        result = self.lower(first)
        if negative:
            result = self._add("negate", result) if isinstance(result, str) else -result
        return self._fold("multiply", chain([result], map(self.lower, others)))

    def _power(self, power: sp.Pow) -> Operand:
        base, exponent = power.as_base_exp()
        if exponent.could_extract_minus_sign():
            return self._add("divide", 1, self.lower(base**-exponent))
        if exponent == sp.S.Half:
            is_sum = isinstance(base, sp.Sum)
            under = self._total(base, "nonnegative_form") if is_sum else self.lower(base)
            return self._add("sqrt", under)
        if exponent.is_Integer:
            return self._whole_power(base, int(exponent))
        if (2 * exponent).is_Integer:
            root = self._name_last(self.lower(sp.sqrt(base)), suggest_name(sp.sqrt(base), "root"))
            return self._raise(root, int(2 * exponent))
        if exponent == sp.Rational(1, 3) and base.is_nonnegative:
            return self._add("cbrt", self.lower(base))
        return self._add("power", self.lower(base), self.lower(exponent))

    def _whole_power(self, base: sp.Expr, exponent: int) -> Operand:
        operand = self.lower(base)
        if exponent > 2 and exponent & (exponent - 1):
            operand = self._name_last(operand, suggest_name(base, "base"))
        return self._raise(operand, exponent)

    def _raise(self, operand: Operand, exponent: int) -> Operand:
        """Add the squares and products of a whole power, as x**3 = x*x**2."""
        if exponent == 1:
            return operand
        if exponent % 2:
            return self._add("multiply", operand, self._raise(operand, exponent - 1))
        half = self._raise(operand, exponent // 2)
        return self._add("square", half)

    def _relation(self, relation: sp.Basic) -> Operand:
        if isinstance(relation, sp.Eq):
            return self._add("equal", self.lower(relation.lhs), self.lower(relation.rhs))
        if isinstance(relation, sp.Ne):
            raise NotImplementedError(f"no operation for {relation} within a condition")
        low, high = relation.lts, relation.gts
        strict = is_strict(relation)
        if sp.oo in (-low, high):
            return self._add("is_finite", self.lower(low if high == sp.oo else high))
        if low.is_number:
            kind = "greater" if strict else "greater_equal"
            return self._add(kind, self.lower(high), self.lower(low))
        kind = "less" if strict else "less_equal"
        return self._add(kind, self.lower(low), self.lower(high))

    def _logical(self, joined: sp.And | sp.Or) -> Operand:
        parts = sorted(joined.args, key=sp.default_sort_key)
        return self._fold(
            "both" if isinstance(joined, sp.And) else "either", map(self.lower, parts)
        )

    def _piecewise(self, piecewise: sp.Piecewise) -> Operand:
        (value, condition), *rest = piecewise.args
        if condition == sp.true:
            return self.lower(value)
        parts = condition, value, sp.Piecewise(*rest) if rest else sp.nan
        if isinstance(condition, sp.Ne):
            parts = sp.Eq(*condition.args), parts[2], value
        return self._add("choose", *map(self.lower, parts))

    def _total(self, total: sp.Sum, form: str = "quadratic_form") -> Operand:
        if not total.has(sp.Indexed):
            raise NotImplementedError(
                f"no operation for {total}: sums must run over axes of arguments or have up to "
                f"{MOST_TERMS} terms"
            )
        # The outermost index of a double sum is last in `limits` and first among the axes.
        self._axes = tuple(index for index, *_ in reversed(total.limits))
        parts = _split_quadratic(total.function, self._axes)
        if parts is None:
            result = self._add("sum", self._term(total.function), len(self._axes))
        else:
            vector, matrix = parts
            entries = self.lower(matrix)
            self._axes = self._axes[1:]
            result = self._add(form, self._term(vector), entries)
        self._axes = ()
        return result

    def _term(self, term: sp.Expr) -> Operand:
        factors = sp.Mul.make_args(term)
        if len(factors) > 1 and all(f.is_Pow and f.exp == 2 for f in factors):
            return self._add("square", self.lower(sp.Mul(*(f.base for f in factors))))
        return self.lower(term)

    def _element(self, item: sp.Indexed) -> Operand:
        name = self._names[item.base]
        indices, axes = item.indices, self._axes
        if indices == axes:
            return name
        views = {
            (2, indices == axes[::-1] and len(axes) == 2): "transpose",
            (2, len(axes) == 1): "diagonal",
            (1, len(axes) == 2 and indices[0] == axes[0]): "along_first",
            (1, len(axes) == 2 and indices[0] == axes[-1]): "along_last",
        }
        if (len(indices), True) not in views:
            raise NotImplementedError(f"no view for {item} among the axes {axes}")
        return self._add(views[(len(indices), True)], name)


def _split_quadratic(term: sp.Expr, axes: tuple[sp.Basic, ...]) -> tuple[sp.Expr, sp.Expr] | None:
    """Return x[j] and M[i, j] for a term x[i]*x[j]*M[i, j]; None for any other term."""
    parts: dict[frozenset[sp.Basic], sp.Expr] = {}
    for factor in sp.Mul.make_args(term):
        used = frozenset(i for item in factor.atoms(sp.Indexed) for i in item.indices)
        parts[used] = parts.get(used, sp.S.One) * factor
    singles = [frozenset({index}) for index in axes]
    if len(axes) != 2 or parts.keys() != {*singles, frozenset(axes)}:
        return None
    first, last = (parts[single] for single in singles)
    return (last, parts[frozenset(axes)]) if first.xreplace({axes[0]: axes[1]}) == last else None


_METHODS: tuple[tuple[type, Callable[[Lowering, sp.Basic], Operand]], ...] = (
    (sp.Symbol, Lowering._symbol),
    (sp.Rational, Lowering._number),
    (sp.Float, Lowering._number),
    *((type(constant), Lowering._constant) for constant in CONSTANTS),
    (sp.Add, Lowering._sum),
    (sp.Mul, Lowering._product),
    (sp.Pow, Lowering._power),
    (sp.Max, Lowering._extreme),
    (sp.Min, Lowering._extreme),
    (sp.Piecewise, Lowering._piecewise),
    (sp.Sum, Lowering._total),
    (sp.Indexed, Lowering._element),
    (sp.core.relational.Relational, Lowering._relation),
    (sp.And, Lowering._logical),
    (sp.Or, Lowering._logical),
    (KeepsShape, Lowering._alongside),
    (sp.Function, Lowering._function),
)


def lower_steps(
    names: Mapping[sp.Basic, str],
    large: frozenset[sp.Basic],
    inputs: tuple[str, ...],
    steps: Iterable[tuple[sp.Symbol, sp.Expr]],
    outputs: Iterable[sp.Basic],
) -> Program:
    """Return the program of named steps and outputs."""
    lowering = Lowering(names, large)
    for symbol, value in steps:
        lowering.lower_step(str(symbol), value)
    results = tuple(map(lowering.lower, outputs))
    return Program(inputs, tuple(lowering.operations), results).normal_form()


def lower_conditions(
    names: Mapping[sp.Basic, str], inputs: tuple[str, ...], relations: Iterable[sp.Basic]
) -> Program:
    """Return the program that tests whether all relations hold."""
    lowering = Lowering(names, frozenset())
    result = lowering.join(relations)
    return Program(inputs, tuple(lowering.operations), (result,)).normal_form()
