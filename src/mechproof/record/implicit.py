"""Roots: numbers defined by an equation and a bracket, approximated by Newton's method."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.core.function import AppliedUndef

from mechproof.record.exactness import RecordError

# The start hardly matters, as each step doubles the digits.
STEPS = 5
MOST_STEPS = 20
# The distance from the root after the last step, as a share of the bracket's width.
LEFT = sp.Rational(1, 2**64)
# Functions that may be continuous, but are not smooth or have branches.
_ROUGH = (sp.Abs, sp.sign, sp.Max, sp.Min, sp.Mod, sp.floor, sp.ceiling, sp.Heaviside, sp.atan2)
_WITHIN = (*_ROUGH, sp.Piecewise, sp.Derivative, sp.Limit, ExprWithLimits, AppliedUndef)


class Implicit(ExprWithLimits):  # type: ignore[misc]
    """A number defined by an expression, an unknown with its bracket, a start and steps."""

    is_real = True

    def __new__(cls, of: sp.Basic, bracket: Any, start: Any = None, steps: int = STEPS) -> Implicit:
        """Take (unknown, low, high), or all five parts as SymPy passes them on rebuilding."""
        parts = tuple(bracket)
        if len(parts) == 3:
            low, high = map(sp.sympify, parts[1:])
            parts = (*parts, (low + high) / 2 if start is None else start, steps)
        if isinstance(of, sp.Eq):
            of = of.lhs - of.rhs
        made: Implicit = sp.Expr.__new__(cls, sp.sympify(of), sp.Tuple(*parts))
        if fault := next(_find_faults(made), ""):
            raise RecordError(f"Root of {of} = 0: {fault}")
        return made

    @property
    def unknown(self) -> sp.Symbol:
        """Return the bound symbol."""
        return self.args[1][0]

    @property
    def ends(self) -> tuple[sp.Expr, sp.Expr]:
        """Return both ends of the bracket."""
        return self.args[1][1], self.args[1][2]

    @property
    def start(self) -> sp.Expr:
        """Return the place from which the first step is taken."""
        return self.args[1][3]

    @property
    def steps(self) -> int:
        """Return the number of steps."""
        return int(self.args[1][4])

    @property
    def free_symbols(self) -> set[sp.Basic]:
        """Return the symbols that it depends on."""
        of, (unknown, *others) = self.args
        free: set[sp.Basic] = of.free_symbols - {unknown}
        return free.union(*(part.free_symbols for part in others))

    def step_from(self, place: sp.Expr) -> sp.Expr:
        """Return the place to which Newton's step from a place leads."""
        of = self.function
        return place - (of / sp.diff(of, self.unknown)).xreplace({self.unknown: place})

    def _eval_subs(self, old: sp.Basic, new: sp.Basic) -> sp.Basic:
        of, (unknown, *others) = self.args
        body = of if old == unknown else of._subs(old, new)
        return self.func(body, (unknown, *(part._subs(old, new) for part in others)))


class Root(Implicit):
    """The only place in a bracket at which an expression is zero, or an equation true.

    `Root(E - e*sin(E) - M, (E, M - 1, M + 1), start=M)`: for every kernel that computes a root, it
    is proved that there is exactly one, and that Newton's method reaches it from the start (by
    default the middle) in the given number of steps. Its derivatives are those of implicit
    functions.
    """

    def _eval_derivative(self, symbol: sp.Symbol) -> sp.Expr:
        of, unknown = self.function, self.unknown
        slope = -sp.diff(of, symbol) / sp.diff(of, unknown)
        return sp.S.Zero if symbol == unknown else slope.xreplace({unknown: self})

    def _sympystr(self, printer: Any) -> str:
        low, high = map(printer.doprint, self.ends)
        of, unknown = (printer.doprint(part) for part in (self.function, self.unknown))
        return f"Root[{unknown}={low}..{high}]({of})"

    _formula_text = _sympystr

    def _latex(self, printer: Any) -> str:
        low, high = map(printer.doprint, self.ends)
        of, unknown = (printer.doprint(part) for part in (self.function, self.unknown))
        return rf"\operatorname{{root}}_{{{unknown}\in[{low},{high}]}}\left({of}\right)"


class LastIterate(Implicit):
    """The place that Newton's method has reached after its last step towards a root."""

    @classmethod
    def towards(cls, root: Root) -> LastIterate:
        """Return the last iterate for the parts of a root."""
        return cls(*root.args)


def _find_faults(made: Implicit) -> Iterator[str]:
    of, (unknown, low, high, start, steps) = made.args
    if not (isinstance(unknown, sp.Symbol) and unknown.is_real):
        yield f"its unknown {unknown} must be a real symbol"
    if not of.has(unknown):
        yield f"it does not contain the unknown {unknown}"
    if any(part.has(unknown) for part in (low, high, start)):
        yield f"neither bracket nor start may contain the unknown {unknown}"
    if not (steps.is_Integer and 1 <= steps <= MOST_STEPS):
        yield f"steps = {steps}: must be 1 to {MOST_STEPS}"
    rough = {part for part in of.atoms(*_WITHIN) if part.has(unknown)}
    if rough or any(part.has(Implicit) for part in (of, low, high, start)):
        names = ", ".join(sorted(type(part).__name__ for part in rough)) or "another root"
        yield f"it must be smooth in {unknown}, without {names}"
