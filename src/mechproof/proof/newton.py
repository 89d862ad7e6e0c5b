"""Rung: Newton's method converges from its start to a bracket's only root, on a whole box.

On each part of the box the bracket has one root, of which an enclosure is known. If an iterate is
off by d, and f' has one sign everywhere within d of the root, the next iterate is off by at most
d**2 |f''|/(2 |f'|): Kantorovich's bound (1948), with the enclosures for constants. Parts therefore
need not be small for the error to be small.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache, reduce
from itertools import product

import numpy as np
import sympy as sp
from flint import arb

from mechproof.arithmetic import balls
from mechproof.arithmetic.ball_evaluation import compile_expression
from mechproof.arithmetic.cover import Box, Boxes, as_box, cover_below
from mechproof.arithmetic.intervals import Array
from mechproof.arithmetic.layout import Values
from mechproof.arithmetic.roots import Bracketed, frame, has_sign
from mechproof.record.implicit import MOST_STEPS, LastIterate, Root
from mechproof.record.parts import find_free
from mechproof.statement_domains.domain import Domain

RUNG = "Newton's method in balls"
# Work limit: parts into which a box is cut.
_MOST = 2**12
_BITS = 128
# Height of a part without an enclosure: above any that an error gives, so it is cut first.
_UNKNOWN = 1e100
_TURN = 2 * sp.pi
# Just more than pi: from minus this to this is a whole turn and a little.
_HALF_TURN = sp.Rational(355, 113)


@dataclass(frozen=True)
class _Task:
    """The claim that the last iterate is within a bound of its root, on a box of symbols."""

    root: Root
    bound: sp.Expr
    symbols: tuple[sp.Symbol, ...]
    where: tuple[sp.Basic, ...]

    def enter(self, box: Box) -> dict[sp.Basic, balls.Ball]:
        """Return balls over the sides of a box."""
        return {
            s: arb(low).union(arb(high)) for s, (low, high) in zip(self.symbols, box, strict=False)
        }

    def bracket(self, values: dict[sp.Basic, balls.Ball]) -> Bracketed:
        """Return the bracketed root for balls of its symbols."""
        return Bracketed(frame(self.root), values, _run)


def _run(expression: sp.Basic, values: Values) -> balls.Ball:
    return compile_expression(expression)(values)


def converges(relation: sp.Basic, domain: Domain) -> bool:
    """Return True if a bound on the distance of a last iterate from its root is proved."""
    claim = _read(relation)
    return claim is not None and not _find_obstacle(*claim, domain)


def explain(relation: sp.Basic, domain: Domain) -> str:
    """Report what was not shown of a bound on a distance to a root; "" for other relations."""
    claim = _read(relation)
    return "" if claim is None else _find_obstacle(*claim, domain)


def _read(relation: sp.Basic) -> tuple[Root, sp.Expr] | None:
    """Return the root and the bound of |last iterate - root| <= bound; None for others."""
    roots, iterates = (relation.atoms(kind) for kind in (Root, LastIterate))
    if len(roots) != 1 or len(iterates) != 1 or not isinstance(relation, sp.Le):
        return None
    (root,), (iterate,) = roots, iterates
    is_distance = relation.lhs in (sp.Abs(iterate - root), sp.Abs(root - iterate))
    return (root, relation.rhs) if is_distance and root.args == iterate.args else None


@lru_cache(maxsize=64)
def _find_obstacle(root: Root, bound: sp.Expr, domain: Domain) -> str:
    """Report what was not shown and where, or return "" for a proof."""
    symbols = sorted(find_free(root) | find_free(bound), key=str)
    where = tuple(r for r in domain.where if find_free(r) <= set(symbols))
    sets = {s: domain.set_of(s) for s in symbols}
    varying = tuple(s for s in symbols if not isinstance(sets[s], sp.FiniteSet))
    sides = [_find_side(s, sets[s], root, where) for s in varying]
    if endless := [str(s) for s, side in zip(varying, sides, strict=True) if side is None]:
        names = ", ".join(endless)
        return f"{names} is not bounded: state a closed interval for it, or `on` for the quantity"
    box = tuple(side for side in sides if side is not None)
    finite = [s for s in symbols if s not in varying]
    for chosen in product(*(sets[s].args for s in finite)):
        given = dict(zip(finite, chosen, strict=True))
        one, limit, *relations = (part.subs(given) for part in (root, bound, *where))
        task = _Task(one, limit, varying, tuple(r for r in relations if r != sp.true))
        if sp.false in relations:
            continue
        if obstacle := _cover(task, box):
            return obstacle
    return ""


def _find_side(
    symbol: sp.Symbol, values: sp.Set, root: Root, where: tuple[sp.Basic, ...]
) -> tuple[float, float] | None:
    """Return doubles around an interval, one turn if that is enough; None if unbounded."""
    if values == sp.S.Reals and _is_periodic(symbol, root, where):
        values = sp.Interval(-_HALF_TURN, _HALF_TURN)
    if not (isinstance(values, sp.Interval) and values.start.is_finite and values.end.is_finite):
        return None
    low, high = (balls.evaluate(end, {}, _BITS) for end in (values.start, values.end))
    return _round(low.lower(), -np.inf), _round(high.upper(), np.inf)


def _round(number: balls.Ball, towards: float) -> float:
    near = float(number)
    return near if arb(near) == number else float(np.nextafter(near, towards))


def _is_periodic(symbol: sp.Symbol, root: Root, where: tuple[sp.Basic, ...]) -> bool:
    seen = frame(root)
    parts = (seen.of, seen.width, seen.start)
    turned = (sp.expand(part.subs(symbol, symbol + _TURN)) for part in parts)
    stays = all(after == sp.expand(before) for before, after in zip(parts, turned, strict=True))
    return stays and not any(relation.has(symbol) for relation in where)


def _cover(task: _Task, whole: Box) -> str:
    """Report what was not shown on a part of the box; "" for a proof on all of it."""

    def bound(boxes: Boxes) -> Array:
        with balls.working_precision(_BITS):
            return np.array([_find_height(task, as_box(box)) for box in boxes])

    # Without symbols the box is a single point.
    cover = cover_below(bound, whole or ((0.0, 0.0),), 1.0, _MOST, 0)
    if cover.open is None:
        return ""
    with balls.working_precision(_BITS):
        return _describe(task, cover.open)


def _find_height(task: _Task, box: Box) -> float:
    """Return the error after the last step divided by the bound; more than 1 if not enclosed.

    Without an enclosure it grows with the uncertainty at the start, to show which side to cut.
    """
    values = task.enter(box)
    # A part on which a relation is false does not belong to the domain.
    if any(balls.truth(relation, values, _BITS) is False for relation in task.where):
        return 0.0
    given, limit = task.bracket(values), _run(task.bound, values)
    if limit > 0 and not _name_fault(given):
        *_, last = _list_errors(given, task.root.steps)
        height = float(np.nextafter(float((last / limit).abs_upper()), np.inf))
        if np.isfinite(height):
            return height
    return _UNKNOWN * (1 + float(given.of(given.start).rad()))


def _name_fault(given: Bracketed) -> str:
    """Report why a bracket is not shown to contain exactly one root; "" if it is."""
    if not (given.width.is_finite() and given.width > 0):
        return "the bracket has no width"
    isolated = given.isolate()
    if not isolated.parts:
        return "there is no root in the bracket"
    if not isolated.is_one:
        return _describe_parts(given, isolated.parts)
    return "" if given.changes_sign() else "no change of sign is shown between the bracket's ends"


def _describe_parts(given: Bracketed, parts: tuple[balls.Ball, ...]) -> str:
    """Report roots shown by changes of sign, or else where the derivative has no one sign."""
    kept = [parts[0]]
    for part in parts[1:]:
        kept[-1:] = [kept[-1].union(part)] if part.overlaps(kept[-1]) else [kept[-1], part]
    crossed = [p for p in kept if (given.of(p.lower()) * given.of(p.upper())) < 0]
    places = " and ".join((given.low + part).str(4, radius=False) for part in crossed or kept)
    if len(crossed) > 1:
        return f"there are {len(crossed)} roots in the bracket, near {places}"
    return f"the derivative may change sign near {places}"


def _list_errors(given: Bracketed, steps: int) -> Iterator[balls.Ball]:
    """Yield bounds on the error of the start and after each step; NaN if unknown."""
    root, place = given.narrow(given.isolate()), given.start
    off = (place - root).abs_upper()
    yield off
    for _ in range(steps):
        place = place - given.of(place) / given.slope(place)
        direct, bounded = (place - root).abs_upper(), _square(given, root + arb(0, off), off)
        known = [error for error in (direct, bounded) if error.is_finite()]
        off = reduce(arb.min, known, arb("nan") if not known else known[0])
        around = root + arb(0, off)
        place = around.intersection(place) if place.is_finite() else around
        yield off


def _square(given: Bracketed, near: balls.Ball, off: balls.Ball) -> balls.Ball:
    """Return Kantorovich's bound on the error of the next iterate."""
    slope = given.slope(near)
    if not has_sign(slope):
        return balls.NOT_FINITE
    return (given.curvature(near) / (2 * slope)).abs_upper() * off * off


def _describe(task: _Task, box: Box) -> str:
    """Report what is not shown at the middle of a box, or else on the box."""
    middle: Box = tuple(((low + high) / 2,) * 2 for low, high in box)
    shown = _find_height(task, middle) <= 1
    values = task.enter(box if shown else middle)
    named = zip(task.symbols, middle, strict=False)
    at = ", ".join(f"{symbol} = {place:.6g}" for symbol, (place, _) in named)
    where = f"{'around' if shown else 'at'} {at}: " if at else ""
    given = task.bracket(values)
    return f"{where}{_name_fault(given) or _describe_errors(given, task, values)}"


def _describe_errors(given: Bracketed, task: _Task, values: dict[sp.Basic, balls.Ball]) -> str:
    steps, limit = task.root.steps, _run(task.bound, values)
    errors = list(_list_errors(given, MOST_STEPS))
    enough = [k for k, error in enumerate(errors) if error <= limit]
    if enough:
        left = errors[steps].str(2, radius=False)
        return f"after {steps} Newton steps the error may be {left}; {enough[0]} are enough there"
    start = (given.low + given.start).str(4, radius=False)
    return f"Newton's steps from the start {start} are not shown to approach the root"
