"""The LaTeX of what a row was compared with, written in the letters of its paper."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from functools import lru_cache
from typing import Any

import sympy as sp
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.logic.boolalg import BooleanAtom
from sympy.printing.latex import LatexPrinter, translate

from mechproof.arithmetic import balls
from mechproof.record import Distinct, Equality, Holds, PrintedNumber, Statement, Variable
from mechproof.record.parts import find_free, find_parts, has_parts, replace_parts
from mechproof.record.statements import list_parts
from mechproof.record.substitution import resolve
from mechproof.record.variables import list_given

_INDEX, _INDICES = "#", "i j"
_PLAIN_NAME = re.compile(r"[A-Za-z]+\d*(_\w+)?")
# Names of more than two letters are words, unless they name a Greek letter.
_WORD = re.compile(r"[A-Za-z]{3,}")
_LONG_NAME = re.compile(rf"{_WORD.pattern}(_\w+)?$")
# A dummy variable of integration as SymPy names it: with `_` at the end.
_DUMMY = re.compile(r"([A-Za-z]+)(\d*)_")
_ESCAPES = str.maketrans({"_": r"\_", "^": r"\^{}"})
_NAMED = Mapping[sp.Basic, str]
# Numbers with this many parts are written as decimals with this many digits, as are fractions of
# integers with more than twice as many.
_LONGEST_NUMBER, _DIGITS = 200, 15
# Fractions with at most this many decimals may be written as decimal numbers.
_PLACES = 6
# Our letters are written out unless that makes the formula more than this many times longer; a
# formula of few parts may always be written out.
_MOST_MORE, _FEW = 2, 30


@dataclass(frozen=True)
class _Letters:
    """A paper's letters as printed, and the values of those letters of ours that it lacks."""

    names: _NAMED
    ours: Mapping[sp.Basic, sp.Basic]

    def spell_out(self, formula: sp.Basic) -> sp.Basic:
        """Replace our letters by the paper's, unless the formula then becomes much longer."""
        if not find_free(formula) & self.ours.keys():
            return formula
        spelt = resolve(formula, self.ours)
        most = max(_FEW, _MOST_MORE * _weigh(formula))
        return formula if isinstance(spelt, BooleanAtom) or _weigh(spelt) > most else spelt


def write_compared(statement: Statement, variables: Sequence[Variable]) -> str:
    """Return the LaTeX of what a print was compared with, or "" if there was nothing."""
    ours = list_given(v for v in variables if not v.latex)
    return _compared(statement, _Letters(_name_letters(variables), ours))


def write_latex(formula: sp.Basic, variables: Sequence[Variable]) -> str:
    """Return a formula of any length in the letters of a paper; words are set upright."""
    text: str = _Printer({**_write_words(formula), **_name_letters(variables)}).doprint(formula)
    return text


def _name_letters(variables: Sequence[Variable]) -> dict[sp.Basic, str]:
    """Return the LaTeX of the symbols that a paper prints, and of our own letters."""
    shown = ((v.symbol, v.latex[0] if v.latex else v.letter) for v in variables)
    return {symbol: latex for symbol, latex in shown if latex}


def write_letter(
    symbol: sp.Basic, variables: Sequence[Variable], formulas: Iterable[sp.Basic]
) -> str:
    """Return a letter as the paper prints it; for a family, a member indexed as in `formulas`."""
    if not isinstance(symbol, sp.IndexedBase):
        return write_latex(symbol, variables)
    met = (item for formula in formulas for item in find_parts(formula, sp.Indexed))
    rank = next((len(item.indices) for item in met if item.base == symbol), 1)
    return write_latex(symbol[sp.symbols(_INDICES)[:rank]], variables)


def _write_words(formula: sp.Basic) -> dict[sp.Basic, str]:
    """Return the LaTeX of the symbols whose names are words."""
    return {s: _write_word(s) for s in find_free(formula) if _LONG_NAME.match(str(s))}


def _write_word(symbol: sp.Symbol) -> str:
    stem, _, index = str(symbol).partition("_")
    shown, below = map(_write_upright, (stem, index))
    return f"{shown}_{{{below}}}" if index else shown


def _write_upright(name: str) -> str:
    """Write a word upright, a Greek letter as its command, and anything else escaped."""
    if not _WORD.fullmatch(name):
        return name.translate(_ESCAPES)
    letter: str = translate(name)
    return letter if letter.startswith("\\") else rf"\mathrm{{{name}}}"


def _compared(statement: Statement, letters: _Letters) -> str:
    if isinstance(statement, Equality):
        return _write(statement.rebuilt, letters)
    if isinstance(statement, PrintedNumber):
        return _write(statement.value, letters)
    parts = dict.fromkeys(list_parts(statement))
    return r",\quad ".join(filter(None, (_write_part(part, letters) for part in parts)))


def _write_part(statement: Statement, letters: _Letters) -> str:
    """Write both sides of a statement whose print is a sentence."""
    if isinstance(statement, Holds):
        return _write(statement.relation, letters)
    if isinstance(statement, Distinct):
        return rf"{_write(statement.left, letters)}\not\equiv {_write(statement.right, letters)}"
    if isinstance(statement, Equality):
        return f"{_write(statement.printed, letters)}={_write(statement.rebuilt, letters)}"
    if isinstance(statement, PrintedNumber):
        return rf"{statement.printed}\approx {_write(statement.value, letters)}"
    return ""


def _write(formula: sp.Basic, letters: _Letters) -> str:
    formula = _shorten_sums(letters.spell_out(formula))
    numbers = {part: sp.Dummy() for part in _find_numbers(formula)}
    shown = {symbol: _write_number(part, letters.names) for part, symbol in numbers.items()}
    written = {**_write_words(formula), **letters.names, **shown}
    text: str = _Printer(written).doprint(replace_parts(formula, numbers))
    return text


def _shorten_sums(formula: sp.Basic) -> sp.Basic:
    """Move deltas and rational factors out of indexed sums, and factors out of powers of sums."""
    if not has_parts(formula, sp.Sum):
        return formula
    taken = formula.replace(sp.Sum, _take_factor_out)
    return taken.replace(lambda part: part.is_Pow and part.base.is_Add, _split_power)


def _take_factor_out(term: sp.Expr, *limits: sp.Tuple) -> sp.Expr:
    factor, rest = term.as_coeff_Mul()
    return factor * sp.Sum(*_sum_once(rest, limits))


def _sum_once(term: sp.Expr, limits: Sequence[sp.Tuple]) -> tuple[sp.Basic, ...]:
    """Return the arguments of a sum with indices merged that a Kronecker delta makes equal."""
    (index, *ends), *others = limits
    for other in others:
        delta = sp.KroneckerDelta(index, other[0])
        if [*other[1:]] == ends and delta in sp.Mul.make_args(term):
            left = (limit for limit in limits if limit is not other)
            return (term / delta).xreplace({other[0]: index}), *left
    return term, *limits


def _split_power(power: sp.Pow) -> sp.Expr:
    factor, rest = power.base.primitive()
    return factor**power.exp * rest**power.exp


# Cached for each part, as a formula's parts are weighed one after another.
@lru_cache(maxsize=1 << 14)
def _weigh(formula: sp.Basic) -> int:
    """Count the parts of a formula, repeated ones as often as they occur."""
    return 1 + sum(map(_weigh, formula.args))


def _find_numbers(formula: sp.Basic) -> Iterator[sp.Expr]:
    """Find the numbers whose values SymPy would compute to order the terms around them."""
    left, met = [formula], set[sp.Basic]()
    while left:
        part = left.pop()
        if part in met:
            continue
        met.add(part)
        if _is_long_number(part):
            yield part
        else:
            left += reversed(part.args)


def _is_long_number(part: sp.Basic) -> bool:
    if not isinstance(part, sp.Expr) or find_free(part):
        return False
    is_long = isinstance(part, ExprWithLimits) or _is_long_fraction(part)
    return is_long or _weigh(part) >= _LONGEST_NUMBER


def _is_long_fraction(number: sp.Expr) -> bool:
    return isinstance(number, sp.Rational) and max(abs(number.p), number.q) >= 10 ** (2 * _DIGITS)


def _write_number(number: sp.Expr, names: _NAMED) -> str:
    """Write a number whose digits are too many to read: an integral or sum, or a decimal."""
    if isinstance(number, ExprWithLimits):
        return str(_Printer(names).doprint(number))
    return rf"{balls.evaluate_until(number, {}, 64).mid().str(_DIGITS, radius=False)}\ldots"


def _is_subtracted(term: sp.Expr) -> bool:
    return bool(term.as_coeff_Mul()[0].could_extract_minus_sign())


# Cached, as terms are turned to be ordered and then to be written.
@lru_cache(maxsize=1 << 12)
def _turn(product: sp.Mul) -> sp.Expr:
    """Write (a - 1)/(b - 1) and (-a - b)*c as people do: (1 - a)/(1 - b) and -(a + b)*c."""
    found: dict[bool, list[sp.Expr]] = {True: [], False: []}
    for factor in product.args:
        base, power = factor.as_base_exp()
        if power.is_odd and _falls_short(base):
            found[power > 0].append(factor)
    turned = [factor for pair in zip(found[True], found[False], strict=False) for factor in pair]
    if not turned and product.as_coeff_Mul()[0] < 0:
        turned = [*found[False], *found[True]][:1]
    turned += [f for f in product.args if f.is_Add and all(map(_is_subtracted, f.args))]
    sign = sp.S.NegativeOne ** len(turned)
    others = [factor for factor in product.args if factor not in turned]
    return sp.Mul(sign, *others, *((-f.base) ** f.exp if f.is_Pow else -f for f in turned))


def _falls_short(base: sp.Expr) -> bool:
    """Return whether a sum subtracts a number and nothing else."""
    if not isinstance(base, sp.Add):
        return False
    number, others = base.as_coeff_add()
    return bool(number < 0) and not any(map(_is_subtracted, others))


def _is_decimal(number: sp.Rational) -> bool:
    """Return whether people write a fraction as a decimal: 0.7284, but 2/5 and 1/8."""
    return bool(number.q > 5 and number.q % 5 == 0 and 10**_PLACES % number.q == 0)


def _split_product(product: sp.Mul) -> tuple[sp.Expr, ...]:
    """Split off a product's leading decimal, or its one trailing integral or cases; else ()."""
    number, rest = product.as_coeff_Mul()
    if isinstance(number, sp.Rational) and _is_decimal(number) and not rest.is_Add:
        return number, rest
    last = [f for f in product.args if isinstance(f, sp.Integral | sp.Piecewise)]
    before = sp.Mul(*(f for f in product.args if f not in last)) if len(last) == 1 else sp.S.One
    return () if before.is_Add or abs(before) == 1 else (before, last[0])


class _Printer(LatexPrinter):  # type: ignore[misc]
    """Writes the symbols of a paper as the paper prints them."""

    def __init__(self, names: _NAMED) -> None:
        super().__init__({"inv_trig_style": "full"})
        self._names = names
        # Caches written parts: a matrix of derivatives repeats its parts.
        self._written: dict[sp.Basic, str] = {}

    def _print(self, part: Any, **settings: Any) -> str:
        if settings or not isinstance(part, sp.Basic):
            return self._print_anew(part, **settings)
        if part not in self._written:
            self._written[part] = self._print_anew(part)
        return self._written[part]

    def _print_anew(self, part: Any, **settings: Any) -> str:
        if isinstance(part, sp.Indexed):
            return self._print_element(part)
        if isinstance(part, sp.Basic) and part in self._names:
            return self._names[part]
        if isinstance(part, sp.Symbol) and (name := _DUMMY.fullmatch(part.name)):
            index = f"_{{{name[2]}}}" if name[2] else ""
            return rf"\tilde{{{translate(name[1])}}}{index}"
        if isinstance(part, sp.Symbol) and not _PLAIN_NAME.fullmatch(part.name):
            return rf"\text{{{part.name.translate(_ESCAPES)}}}"
        if isinstance(part, sp.betainc_regularized) and part.args[2] == 0:
            first, second, _, end = map(self._print, part.args)
            return rf"I_{{{end}}}\left({first}, {second}\right)"
        if isinstance(part, sp.Rational) and _is_decimal(part):
            return f"{Decimal(int(part.p)) / Decimal(int(part.q)):f}"
        turned = _turn(part) if isinstance(part, sp.Mul) else part
        if isinstance(turned, sp.Mul) and (pieces := _split_product(turned)):
            return " ".join(map(self._print, pieces))
        written: str = super()._print(turned, **settings)
        return written

    def _as_ordered_terms(self, expr: sp.Add, order: str | None = None) -> list[sp.Expr]:
        """Order terms as people do: 1 + e^2 - 2 e cos(x), with no leading minus if avoidable."""
        found = sorted(expr.args, key=lambda term: term.has(sp.Function))
        terms = [_turn(term) if isinstance(term, sp.Mul) else term for term in found]
        first = next((t for t in terms if not _is_subtracted(t)), terms[0])
        return [first, *(term for term in terms if term is not first)]

    def _print_element(self, element: sp.Indexed) -> str:
        name = self._print(element.base)
        gap = "" if all(index.is_Symbol for index in element.indices) else ","
        indices = gap.join(map(self._print, element.indices))
        return name.replace(_INDEX, indices) if _INDEX in name else f"{name}_{{{indices}}}"
