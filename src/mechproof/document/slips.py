"""Slips: the equations or numbers that differ from a print by one small change."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, permutations, product

import sympy as sp

from mechproof.document.numbers.scales import agrees
from mechproof.record import PrintedNumber
from mechproof.record.parts import ARCS, TURNING
from mechproof.statement_domains.domain import Domain

_EXPONENTS = {
    **{sp.Integer(2): (1, 3), sp.Integer(3): (2,), sp.Integer(4): (2, 3)},
    **{sp.Integer(-1): (1, -2, -sp.Rational(1, 2)), sp.Integer(-2): (-1,), sp.Rational(1, 2): (1,)},
    **{sp.Rational(3, 2): (1, sp.Rational(1, 2)), sp.Rational(-1, 2): (-1,)},
}
_DIGITS = tuple(map(sp.Integer, range(1, 10)))

# Fewest digits of a number that identify it, and number of digits from which two may be wrong.
_FEWEST_DIGITS = 3
_LONG = 5

# Completes a reason if the change is in a definition.
WITHIN = " in the definition of "

Sides = tuple[sp.Expr, sp.Expr]


@dataclass(frozen=True)
class PrintedSides:
    """The sides of an equation, and which of them are printed: only these have misprints."""

    sides: Sides
    are_printed: tuple[bool, bool] = (True, True)


@dataclass(frozen=True)
class ChangedSides:
    """The sides of a print with one part of it, or of a letter's definition, changed."""

    sides: Sides
    printed: sp.Basic
    meant: sp.Basic
    within: sp.Basic | None = None

    @property
    def reason(self) -> str:
        """Return the reason, which names the misprinted part and the part meant."""
        where = f"{WITHIN}{self.within}" if self.within else ""
        return f"the two sides differ, but not with {self.meant} instead of {self.printed}{where}"


def list_alike(letters: Collection[sp.Basic], domain: Domain) -> list[sp.Basic]:
    """Return letters, and all letters that differ from one of them by an index only."""
    stems = {str(s).partition("_")[0] for s in letters}
    known = {s for s in (*domain.within, *domain.given) if s.is_Symbol}
    alike = {s for s in known if str(s).partition("_")[0] in stems}
    return sorted({*letters} | alike, key=str)


def list_changes(
    entry: PrintedSides, letters: Sequence[sp.Basic], defined: Mapping[sp.Basic, sp.Expr]
) -> Iterator[ChangedSides]:
    """Yield sides that differ in one place from those printed.

    Two letters may be exchanged. No letter is replaced in the definition of a letter, or in an
    equation of two letters: with others much would be true.
    """
    one, other = entry.sides
    if one.is_Symbol and other.is_Symbol:
        letters = ()
    if entry.are_printed[0]:
        for changed, printed, meant in _change(one, letters, is_term=True):
            yield ChangedSides((changed, other), printed, meant)
    if entry.are_printed[1]:
        for changed, printed, meant in _change(other, letters, is_term=True):
            yield ChangedSides((one, changed), printed, meant)
    if not all(entry.are_printed):
        return
    for pair in combinations(sorted(one.free_symbols | other.free_symbols, key=str), 2):
        values = dict(zip(pair, reversed(pair), strict=True))
        exchanged = one.xreplace(values), other.xreplace(values)
        yield ChangedSides(exchanged, sp.Tuple(*pair), sp.Tuple(*reversed(pair)))
    for letter, value in defined.items():
        for changed, printed, meant in _change(value, (), is_term=True):
            put_in = {letter: changed}
            yield ChangedSides(
                (one.xreplace(put_in), other.xreplace(put_in)), printed, meant, letter
            )


def _change(
    part: sp.Expr, letters: Sequence[sp.Basic], *, is_term: bool
) -> Iterator[tuple[sp.Expr, sp.Basic, sp.Basic]]:
    for meant in _exchange(part, letters, is_term=is_term):
        if meant != part:
            yield meant, part, meant
    is_sum = isinstance(part, sp.Add | sp.Function)
    inside = part.args[:1] if isinstance(part, sp.Pow) and part.exp.is_number else part.args
    for place, argument in enumerate(inside):
        if isinstance(argument, sp.Expr):
            for changed, printed, meant in _change(argument, letters, is_term=is_sum):
                arguments = [*part.args[:place], changed, *part.args[place + 1 :]]
                yield part.func(*arguments), printed, meant


def _is_at_a_place(one: sp.Basic, other: sp.Basic) -> bool:
    """Return whether one of two letters is the other with an index.

    It is often its value at one place, so neither counts as a slip for the other.
    """
    (stem, _, index), (other_stem, _, other_index) = (str(s).partition("_") for s in (one, other))
    return stem == other_stem and bool(index) != bool(other_index)


def _exchange(part: sp.Expr, letters: Sequence[sp.Basic], *, is_term: bool) -> Iterator[sp.Expr]:
    """Yield expressions that may have been meant by a printed part."""
    yield -part
    yield 2 * part
    yield part / 2
    if part.is_Symbol:
        yield part**2
        yield from (letter for letter in letters if not _is_at_a_place(part, letter))
        yield from (part + letter for letter in letters)
    elif isinstance(part, TURNING):
        yield part**2
        # SymPy does not preserve the order in which a difference is printed.
        terms = sp.Add.make_args(part.args[0])
        is_difference = len({term.could_extract_minus_sign() for term in terms}) > 1
        signs = (1, -1) if is_difference else (1,)
        yield from (sign * other(*part.args) for other in TURNING for sign in signs)
    elif isinstance(part, ARCS):
        yield from (other(*part.args) for other in ARCS)
    elif isinstance(part, sp.atan2):
        yield sp.atan2(*reversed(part.args))
    elif isinstance(part, sp.Pow):
        yield from (part.base**exponent for exponent in _EXPONENTS.get(part.exp, ()))
        yield from (part / part.base * letter for letter in letters)
    elif part.is_Integer:
        yield from _DIGITS
    elif isinstance(part, sp.Mul):
        # A factor that is left out, or is on the wrong side of the fraction bar.
        yield from (part / factor for factor in part.args)
        yield from (part / factor**2 for factor in part.args if not factor.is_number)
        yield from _move_bracket(part)
    elif isinstance(part, sp.Add):
        yield part**2
        yield from _enter_bracket(part)
    if is_term:
        yield from (part * letter for letter in letters)
        yield from (part / letter for letter in letters)


def _move_bracket(part: sp.Mul) -> Iterator[sp.Expr]:
    """Yield a b + c for a (b + c)."""
    for factor in part.args:
        for term in factor.args if isinstance(factor, sp.Add) else ():
            yield part / factor * term + factor - term


def _enter_bracket(part: sp.Add) -> Iterator[sp.Expr]:
    """Yield a (b + c) for a b + c."""
    for term in part.args:
        for factor in term.args if isinstance(term, sp.Mul) else ():
            yield factor * (part - term + term / factor)


def find_slip(says: PrintedNumber, value: sp.Expr) -> str:
    """Return a rounding of a value that differs from the printed number by a slip, or "".

    A slip is another digit, two exchanged digits, or one moved digit; in long numbers also two
    other digits. Numbers of fewer than three digits are not examined.
    """
    text = says.printed
    number = text.partition("e")[0]
    places = [n for n, sign in enumerate(number) if sign.isdigit()]
    # Zeros at the end of a decimal count as digits.
    leading = number.lstrip("-0.")
    count = len(leading.replace(".", "") if "." in number else leading.rstrip("0"))
    if count < _FEWEST_DIGITS:
        return ""
    digits = [text[n] for n in places]
    slips = {tuple(changed) for changed in _change_digits(digits, 1 + (count >= _LONG))}
    for one, other in permutations(range(len(digits)), 2):
        moved = digits[:one] + digits[one + 1 :]
        slips.add((*moved[:other], digits[one], *moved[other:]))
        exchanged = [*digits]
        exchanged[one], exchanged[other] = digits[other], digits[one]
        slips.add(tuple(exchanged))
    written = (_write(text, places, slip) for slip in slips)
    return next((slip for slip in sorted(written) if agrees(PrintedNumber(slip, value))), "")


def _change_digits(digits: Sequence[str], count: int) -> Iterator[list[str]]:
    """Yield digits with at most `count` of them changed."""
    for places in combinations(range(len(digits)), count):
        for new in product("0123456789", repeat=count):
            changed = [*digits]
            for place, digit in zip(places, new, strict=True):
                changed[place] = digit
            yield changed


def _write(text: str, places: Sequence[int], digits: Sequence[str]) -> str:
    written = [*text]
    for place, digit in zip(places, digits, strict=True):
        written[place] = digit
    return "".join(written)
