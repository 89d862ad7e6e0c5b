"""The sides of a row: their letters, and whether their units are known.

If a row is judged without units, a part of it that mixes dimensions may still be judged.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy.functions.elementary.hyperbolic import HyperbolicFunction
from sympy.functions.elementary.trigonometric import (
    InverseTrigonometricFunction,
    TrigonometricFunction,
)

from mechproof.arithmetic import balls
from mechproof.document.known import Known
from mechproof.document.tasks import Role, Sign
from mechproof.record import (
    Conjunction,
    Definition,
    Equality,
    Holds,
    Paper,
    Row,
    Statement,
    ValueWhere,
)
from mechproof.statement_domains.dimension_inference import (
    DimensionError,
    dimensions_of,
    infer_common,
)
from mechproof.statement_domains.preparation import take_values

# Functions that are undefined in places, or given by different formulas.
_PARTIAL = (sp.log, sp.asin, sp.acos, sp.Abs, sp.sign, sp.Piecewise, sp.Max, sp.Min)
# Expressions that have no number here, or take long to evaluate.
SLOW = (sp.Piecewise, sp.Limit, sp.Integral, sp.Sum, sp.Product)
# Functions that are constant between their steps.
_STEPS = (sp.floor, sp.ceiling)
# Differences up to this size count as zero.
_SMALL = 1e-12
# Functions whose arguments must be numbers. The logarithm is left out: that of a length may be
# part of a difference whose other term is printed elsewhere.
_OF_NUMBERS = (TrigonometricFunction, InverseTrigonometricFunction, HyperbolicFunction, sp.exp)
_BINDING = (sp.Integral, sp.Sum, sp.Product, sp.Limit, sp.Derivative, sp.Subs, ValueWhere)
_TOLD = 3


def write_out(side: Any) -> Any:
    """Return a matrix with explicit entries, or any other side unchanged."""
    return side.doit() if isinstance(side, sp.MatrixExpr) else side


def have_same_letters(sides: Sequence[Any], by_entry: bool = False) -> bool:
    """Return whether both sides, or by entry all that differ, are functions of the same letters."""
    shown = [*map(write_out, sides)] if by_entry else []
    if shown and all(isinstance(side, sp.MatrixBase) for side in shown):
        pairs = zip(*shown, strict=False)
        return all(one == other or have_same_letters((one, other)) for one, other in pairs)
    one, other = map(_list_letters, sides)
    return bool(one == other)


def ties_letters(sides: Sequence[Any], worked_out: Sequence[bool]) -> bool:
    r"""Return whether two vectors can be equal for some values of their letters only.

    A loop closure is printed this way, $r\mathbf a+l\mathbf b=x\mathbf e$: one side has a computed
    entry that is a number where the other has a function of letters.
    """
    shown = [*map(write_out, sides)]
    are_vectors = all(isinstance(side, sp.MatrixBase) and side.shape[1] == 1 for side in shown)
    if not (are_vectors and all(side.free_symbols for side in shown)):
        return False
    pairs = (
        (shown[n], shown[1 - n]) for n, is_worked_out in enumerate(worked_out) if is_worked_out
    )
    return any(
        one.is_number and _list_letters(other)
        for side, rest in pairs
        for one, other in zip(side, rest, strict=False)
    )


def gives_entries(sides: Sequence[Any], worked_out: Sequence[bool]) -> bool:
    r"""Return whether a computed matrix is printed with its entries, \mathbf J^{-1}=….

    Such a print is meant for all values of its letters, while one of vectors may tie some.
    """
    shown = [*map(write_out, sides)]
    are_matrices = all(isinstance(side, sp.MatrixBase) and min(side.shape) > 1 for side in shown)
    return are_matrices and len(shown) > 1 and sum(worked_out) == 1


def list_related(says: Any) -> set[sp.Basic]:
    """Return the letters of relations that are not equations."""
    if isinstance(says, Conjunction):
        return {letter for part in says.parts for letter in list_related(part)}
    return set(says.relation.free_symbols) if isinstance(says, Holds) else set()


def list_sides(row: Row, sign: Sign, known: Known) -> list[Any]:
    """Return the sides that a row equates, with the values of letters put in."""
    says = row.says
    if isinstance(says, Conjunction) and sign.sides != (None, None):
        return [known.settle(side) for side in sign.sides]
    if isinstance(says, Equality):
        return [known.settle(says.printed), known.settle(says.rebuilt)]
    if isinstance(says, Definition):
        return [says.printed]
    return []


def ties_running(
    residual: sp.Expr, moving: Mapping[sp.Basic, tuple[sp.Basic, Sequence[sp.Basic]]]
) -> bool:
    """Return whether a residual has a letter that others depend on, but none of those others."""
    letters = residual.free_symbols
    met = {by for s, (by, rates) in moving.items() if letters & {s, *rates}}
    return bool(({by for by, _ in moving.values()} & letters) - met)


def raises_by_letter(side: Any) -> bool:
    """Return whether a letter is in an exponent of letters: p V^n has no known dimension."""
    return isinstance(side, sp.Expr) and any(
        power.exp.free_symbols and power.base.free_symbols for power in side.atoms(sp.Pow)
    )


def has_letters(says: Statement | None) -> bool:
    """Return whether both sides of an equation have letters; if not, it may be true by accident."""
    return isinstance(says, Equality) and all(side.free_symbols for side in says.sides)


def list_stated(says: Statement | None) -> set[sp.Basic]:
    """Return the letters of both sides as printed, some of which may have no known unit."""
    sides = says.sides if isinstance(says, Equality) else ()
    return {letter for side in sides for letter in side.free_symbols}


def is_solvable(residual: sp.Expr, letter: sp.Basic) -> bool:
    """Return whether a residual is linear in a letter or its tangent, without roots or branches."""
    has_roots = any(not power.exp.is_integer for power in residual.atoms(sp.Pow))
    if has_roots or residual.has(*_PARTIAL):
        return False
    stand_in = sp.Dummy()
    shown = residual.xreplace({sp.tan(letter): stand_in})
    unknown = letter if shown == residual else stand_in
    slope = sp.expand(shown).diff(unknown)
    return bool(slope != 0) and not slope.has(unknown, letter)


def _is_idle(side: Any, letter: sp.Basic) -> bool:
    """Return whether a side has the same value at three values of a letter, the others being fixed.

    This is no proof: it only decides which letters a side depends on, and thus which sides are
    compared. These are then proved or refuted.
    """
    symbols = sorted(getattr(side, "free_symbols", ()), key=str)
    if not isinstance(side, sp.Expr) or not all(s.is_Symbol for s in symbols):
        return False
    # SymPy does not terminate for sums of matrices.
    if isinstance(side, sp.MatrixExpr) or side.has(*SLOW, *_STEPS):
        return False
    values: dict[sp.Basic, sp.Expr] = {s: sp.Rational(7 * n + 3, 13) for n, s in enumerate(symbols)}
    # With the same denominator they might be whole periods apart.
    points = (sp.Rational(8, 13), sp.Rational(-17, 11), sp.Rational(32, 7))
    places = [{**values, letter: point} for point in points]
    # Balls are faster; SymPy evaluates what they do not support, or enclose too widely.
    with suppress(NotImplementedError):
        one, *others = (balls.evaluate(side, place, 64) for place in places)
        off = [abs(one - other) for other in others]
        if any(distance > _SMALL for distance in off):
            return False
        if all(distance < _SMALL for distance in off):
            return True
    # Exact substitution would not terminate for powers of powers.
    found = [side.evalf(subs=place) for place in places]
    return all(one.is_finite and abs(one - found[0]) < _SMALL for one in found)


def _list_letters(side: Any) -> set[sp.Basic]:
    """Return the letters that a side depends on, as far as can be seen without a proof."""
    shown = take_values(write_out(side))
    for limit in shown.atoms(sp.Limit):
        there = limit.args[0].subs(limit.args[1], limit.args[2])
        if not there.has(sp.nan, sp.zoo, sp.oo):
            shown = shown.xreplace({limit: there})
    free: set[sp.Basic] = {x for x in shown.free_symbols if not _is_idle(shown, x)}
    # SymPy lists the members of families that a sum runs over, too.
    families = (x for x in free if isinstance(x, sp.Indexed))
    return free - {x for x in families if sp.Tuple(*x.indices).free_symbols - free}


@dataclass(frozen=True)
class RowUnits:
    """Whether a row is judged with units, or why it is not, and a part that mixes dimensions."""

    are_known: bool
    lacking: str = ""
    mixed: sp.Expr | None = None


def find_units(
    row: Row,
    sign: Sign,
    sides: Sequence[Any],
    known: Known,
    papers: Mapping[bool, Paper],
    is_stated: bool,
) -> RowUnits:
    """Return whether all letters of a row have known units and no side is a bare number."""
    letters = {sign.letter}.union(*(side.free_symbols for side in sides))
    letters |= list_related(row.says) | list_stated(row.says)
    is_special = sign.role is Role.CONSTRAINT and sign.letter is not None
    is_special &= not _is_given_by_itself(sign, known)
    is_number = is_stated or sign.role is Role.SIZE or any(sign.units)
    if is_number or is_special:
        return RowUnits(False, "one side is a number")
    if any(map(raises_by_letter, sides)):
        return RowUnits(False, "a letter is raised to the power of a letter")
    bare = letters & known.symbols.bare
    if not bare:
        return RowUnits(True)
    if letters <= {*bare, None}:
        return RowUnits(False, "its letters have no units")
    names = sorted(map(str, bare))
    told = ", ".join(names[:_TOLD]) + (" and others" if len(names) > _TOLD else "")
    mixed = _find_mixed(row, known.symbols.bare, papers[True])
    return RowUnits(False, f"no unit is given for {told}", mixed)


def _is_given_by_itself(sign: Sign, known: Known) -> bool:
    """Return whether a quantity is on both sides, so that their dimensions are compared, too.

    Angles are excepted, as they would be equal up to turns.
    """
    dimension = known.symbols.find_dimension(sign.letter) if sign.letter else None
    others = [side for side in sign.sides if side is not None and side != sign.letter]
    is_within = any(sign.letter in side.free_symbols for side in others)
    return is_within and dimension is not None and not dimension.is_angle


def _find_mixed(row: Row, bare: Collection[sp.Basic], paper: Paper) -> sp.Expr | None:
    """Return a part of a side that mixes dimensions whatever the letters without a unit are."""
    says, dimensions = row.says, dimensions_of(paper)
    sides = [says.printed] if isinstance(says, Equality | Definition) else []
    sides += [says.rebuilt] if isinstance(says, Equality) else []
    known = dimensions.keys() - {*bare}
    for side in sides:
        for part in _list_parts(side, known) if isinstance(side, sp.Expr) else ():
            try:
                infer_common((part,), dimensions)
            except DimensionError:
                return part
    return None


def _list_parts(side: sp.Expr, known: Collection[sp.Basic]) -> Iterator[sp.Expr]:
    """Yield sums of terms with known units, and functions of such terms.

    Terms with a coefficient are left out, as it may have an unprinted unit; so are bound letters,
    which may be confused with others.
    """
    nodes = sp.preorder_traversal(side)
    for node in nodes:
        if isinstance(node, _BINDING):
            nodes.skip()
        elif isinstance(node, sp.Add):
            if len(terms := [term for term in node.args if _has_units(term, known)]) > 1:
                yield sp.Add(*terms)
        elif isinstance(node, _OF_NUMBERS) and _has_units(node.args[0], known):
            yield node


def _has_units(term: sp.Basic, known: Collection[sp.Basic]) -> bool:
    letters = term.free_symbols
    is_plain = isinstance(term, sp.Expr) and term.as_coeff_Mul()[0] in (1, -1)
    return is_plain and bool(letters) and letters <= {*known} and not term.has(*_BINDING)
