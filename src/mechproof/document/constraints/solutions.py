r"""Prints with a double sign on one side, T = (-F ± \sqrt{…}) / …: both signs give roots.

The letter, or the one of whose fraction it is the tangent, is put into the constraints that have
it. If it satisfies none, the print may still have one of its two values wherever the others hold;
a change of one part of the print that achieves this reveals a misprint. Angles are compared up to
whole turns.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import sympy as sp

from mechproof.document.misprints import Misprint, find_misprint
from mechproof.document.slips import PrintedSides, Sides
from mechproof.document.special_cases import state_angles
from mechproof.document.tasks import Role, Sign, Task
from mechproof.latex import Reader
from mechproof.nomenclature.shown_letters import name_symbol
from mechproof.nomenclature.symbol_names import find_stem
from mechproof.proof.judge import judge
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Conjunction, Equality, Row, Statement
from mechproof.statement_domains.dimension_inference import Dimensions, is_angle
from mechproof.statement_domains.domain import Domain

SIGN = sp.Symbol("±", real=True)
SUBSTITUTION = "substitution"
# Completes the reason for angles that are equal by their directions.
_TURNS = ", up to whole turns"
# The two constraints on the letters of x_{1,2}, whichever of them has the upper sign.
_JOINED: dict[str, type[sp.Expr]] = {"sum": sp.Add, "product": sp.Mul}


def read_signs(reader: Reader) -> Reader:
    """Return a reader that reads a double sign as a letter."""
    return Reader(reader.variables, replace(reader.notation, branch=SIGN), reader.remedies)


def state_signs(row: Row, sign: Sign, dimensions: Dimensions) -> Row:
    """State that a row has one of its two values, or that a step holds with both signs."""
    says: Statement = Solutions(*sign.sides).state(dimensions)
    if sign.role is Role.STEP:
        left, right = map(_choose, sign.sides)
        says = _state_step(left, right, dimensions)
    return replace(row, says=says, read_as=write_sign(row.read_as))


def tie_pair(row: Row, sign: Sign, dimensions: Dimensions) -> Iterator[tuple[Row, Sign]]:
    r"""Yield a row and, for x_{1,2}=a\pm b, the constraints on the sum and product of x_1 and x_2.

    Angles, which are equal only up to whole turns, are not tied.
    """
    yield row, sign
    if not sign.halves or is_angle(sign.sides, dimensions):
        return
    left, value = sign.sides
    _, power = left.as_base_exp()
    for name, join in _JOINED.items():
        sides = join(*(one**power for one in sign.halves)), sp.expand(join(*_choose(value)))
        own = Sign(Role.CONSTRAINT, None, row.number, sides, worked_out=(True, True))
        says = Equality(*sides, "member")
        yield replace(row, number=f"{row.number}, {name}", says=says), own


def join_values(sign: Sign, sides: Sides) -> Sides:
    """Return the sides of a row; for a tie of two letters, the sum or product of both values."""
    if not sign.is_tied:
        return sides
    return sign.sides[0], sp.expand(sign.sides[0].func(*_choose(sides[1])))


def _state_step(
    left: Sequence[sp.Expr], right: Sequence[sp.Expr], dimensions: Dimensions
) -> Conjunction:
    """State that the values of both sides are equal one by one, angles up to whole turns."""
    pairs = [Equality(a, b, "member") for a, b in zip(left, right, strict=True)]
    if is_angle((*left, *right), dimensions):
        return Conjunction(tuple(part for pair in pairs for part in state_angles(pair).parts))
    return Conjunction(tuple(pairs))


def are_exchanged(task: Task) -> bool:
    """Return whether the values of a step with double signs match in the opposite order."""
    sides = task.sign.sides
    if task.sign.role is not Role.STEP or not all(isinstance(s, sp.Expr) for s in sides):
        return False
    if not any(side.has(SIGN) for side in sides):
        return False
    domain = task.domain
    left, right = map(_choose, sides)
    return (
        decide(_state_step(left, right[::-1], domain.dimensions), domain).verdict is Verdict.PROVED
    )


def judge_angles(task: Task) -> Judgement | None:
    """Judge two unequal angles by their directions; None if these differ."""
    says, domain = task.row.says, task.domain
    if not isinstance(says, Equality) or task.sign.role is not Role.CONSTRAINT:
        return None
    if not is_angle(says.sides, domain.dimensions):
        return None
    found = judge(replace(task.row, says=state_angles(says)), task.paper)
    if found.verdict is not Verdict.PROVED:
        return None
    return replace(found, reason=f"{found.reason}{_TURNS}")


def judge_signs(task: Task, found: Judgement) -> Judgement | str:
    """Judge a print with a double sign of which one sign or the other holds everywhere."""
    domain = task.domain
    each = Solutions(*task.sign.sides).state_each(domain.dimensions)
    if any(decide(says, domain).verdict in (Verdict.PROVED, Verdict.DEFINITION) for says in each):
        return "one of its signs is printed elsewhere; nothing is known about the other"
    turns = _TURNS if isinstance(each[0], Conjunction) else ""
    return replace(found, reason=f"{found.reason}, with one sign or the other{turns}")


def write_sign(text: str) -> str:
    """Return the text of an expression with the factor SIGN written as a double sign."""
    return text.replace("+ ±*", "± ").replace("- ±*", "∓ ").replace("±*", "±")


@dataclass(frozen=True)
class Solutions:
    """A side, mostly a letter, and the print of its values with both values of SIGN."""

    left: sp.Expr
    value: sp.Expr

    def state(self, dimensions: Dimensions) -> Equality:
        """State that the left side has one of the two values, angles up to whole turns."""
        one, other = _choose(self.value)
        if is_angle((self.left, self.value), dimensions):
            # With cos a - cos b = -2 sin((a + b)/2) sin((a - b)/2).
            turned = self.left - (one + other) / 2
            return Equality(sp.cos(turned), sp.cos((one - other) / 2), "member")
        # The root in both values cancels in their sum and in their product.
        total, times = (sp.cancel(sp.expand(x)) for x in (one + other, one * other))
        rest = self.left**2 - total * self.left + times
        return Equality(rest, sp.S.Zero, "member")

    def state_each(self, dimensions: Dimensions) -> list[Statement]:
        """Return the statements with the upper and with the lower sign."""
        says = [Equality(self.left, value, "member") for value in _choose(self.value)]
        if is_angle((self.left, self.value), dimensions):
            return [state_angles(one) for one in says]
        return [*says]

    @property
    def is_pair(self) -> bool:
        """Return whether two letters are printed together, x_{1,2}, that occur in no constraint."""
        return bool(find_stem(name_symbol(str(self.left.as_base_exp()[0]))))

    def name_root(self, letters: Iterable[sp.Basic]) -> Solutions:
        """Return a print of both roots, x_{1,2}, as one of x, if x is among the letters."""
        base, power = self.left.as_base_exp()
        stem = find_stem(name_symbol(str(base)))
        named = next((s for s in letters if name_symbol(str(s)) == stem), base)
        return replace(self, left=named**power)

    def find_met(self, given: Mapping[str, sp.Expr], domain: Domain) -> tuple[sp.Basic, str] | None:
        """Return the letter put in and the name of the first constraint that both values meet."""
        unknown, value = _invert(self.left, self.value, domain)
        alone = replace(domain, given={s: v for s, v in domain.given.items() if s != unknown})
        where = (*domain.where, *_list_conditions(alone.resolve(self.value)))
        value = alone.resolve(value)
        if not unknown.is_Symbol or unknown in value.free_symbols:
            return None
        for name, residual in given.items():
            if unknown not in residual.free_symbols or not self._has_each(unknown, residual):
                continue
            rests = (residual.xreplace({unknown: one}) for one in _choose(value))
            says = Conjunction(tuple(Equality(sp.expand_trig(r), sp.S.Zero) for r in rests))
            if decide(says, replace(domain, where=where)).verdict is Verdict.PROVED:
                return unknown, name
        return None

    def _has_each(self, unknown: sp.Basic, residual: sp.Expr) -> bool:
        """Return whether a residual is the same for both roots of a letter's printed power."""
        is_power = self.left.is_Pow and self.left.base == unknown
        return not is_power or sp.expand(residual - residual.xreplace({unknown: -unknown})) == 0

    def find_misprint(
        self, given: Sequence[sp.Expr], domain: Domain, printed: Collection[sp.Basic]
    ) -> Misprint | None:
        """Return a change of the print with which one of its values satisfies the constraints."""

        def state(sides: Sides) -> Sides:
            says = Solutions(*sides).state(domain.dimensions)
            return says.sides

        entry = PrintedSides((self.left, self.value), (not self.left.is_Symbol, True))
        # A mended print solves its constraint, so repeating the constraint is no objection.
        return find_misprint(entry, given, domain, printed, state=state)

    def name_half(self, value: sp.Expr) -> Solutions:
        """Return the print as a statement about `value`, that of one of two letters, x_1 or x_2."""
        return replace(self, left=value ** self.left.as_base_exp()[1])

    def is_met(self, domain: Domain) -> bool:
        """Return whether the left side is one of the values."""
        conditions = _list_conditions(domain.resolve(self.left))
        where = (*domain.where, *conditions)
        says = self.state(domain.dimensions)
        return decide(says, replace(domain, where=where)).verdict is Verdict.PROVED


def _invert(left: sp.Expr, value: sp.Expr, domain: Domain) -> tuple[sp.Basic, sp.Expr]:
    """Return the letter, and its value, whose square or whose fraction's tangent is printed."""
    known = domain.given.get(left, left)
    if isinstance(known, sp.Pow) and known.base.is_Symbol and known.exp == 2:
        return known.base, sp.sqrt(value)
    if isinstance(known, sp.tan) and len(known.free_symbols) == 1:
        (unknown,) = known.free_symbols
        part = known.args[0] / unknown
        if part.is_number:
            return unknown, sp.atan(value) / part
    return left, value


def _choose(value: sp.Expr) -> list[sp.Expr]:
    return [value.xreplace({SIGN: sp.Integer(sign)}) for sign in (1, -1)]


def _list_conditions(value: sp.Expr) -> Iterator[sp.Basic]:
    """Yield the conditions under which roots are real and divisors are not zero."""
    for power in value.atoms(sp.Pow):
        if power.exp.is_number and not power.exp.is_integer:
            yield sp.Ge(power.base, 0)
        if power.exp.is_negative:
            yield sp.Ne(power.base, 0)
