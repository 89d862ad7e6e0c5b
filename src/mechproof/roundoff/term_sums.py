"""Term sums: in, a kernel that adds up the terms of a set; out, the same with a number for the sum.

If terms are never negative, each with its own relative error, their sum is off by at most the
largest of these errors and (n - 1)*u/(1 - (n - 1)*u) more, in whatever order n of them are added
(Higham 2002, section 4.2); if the rests of all additions are added too, by u and the square of that
instead (Ogita, Rump and Oishi 2005). So one number with such an error can replace the whole set.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from itertools import product
from typing import Any

import numpy as np
import sympy as sp

from mechproof.arithmetic.intervals import Array, Interval
from mechproof.programs.kernel import Kernel
from mechproof.programs.operations import Arithmetic
from mechproof.programs.program import NOTHING, Operation, Program, Stage
from mechproof.programs.scalar import ADDED, TermLoop, fold_sums
from mechproof.record import Argument, Chart, Form, Quantity, Scale
from mechproof.roundoff.bound import ErrorAnalysis
from mechproof.roundoff.elementary_errors import prove
from mechproof.roundoff.error_sums import ErrorScale
from mechproof.roundoff.interval_monomials import BoxVariables
from mechproof.roundoff.running import IN_DOUBLES, Values, run
from mechproof.roundoff.steps import HALF, Expansion, flatten_stage

# The most terms of a set, as an exponent of two.
MOST = 20
PLACE = f"n <= 2**{MOST}"
# Bounds all products of roundings, both in eps and as a share: s = (n - 1)*u is at most
# 2**(MOST - 53), its square 2**(2*MOST - 54)*eps, and the scale moves by a share of s.
MARGIN = 2.0 ** (2 * MOST - 50)
# Size of the sets searched for the worst input; NumPy adds up so few terms in order.
SEARCHED = 5
# Number of octaves that elements are drawn from.
OCTAVES = 4.0


@dataclass(frozen=True)
class TermSum:
    """The loop that adds up, and the loops that test whether a set is in the domain.

    The value is proportional to the sum to the power `degree`. `keeps_rests` states whether the
    rests that additions round off are added at the end.
    """

    loop: TermLoop
    tests: tuple[TermLoop, ...]
    degree: float
    keeps_rests: bool

    @property
    def each(self) -> float:
        """Return how much each term after the first adds to the bound, in eps."""
        return 0.0 if self.keeps_rests else self.degree * HALF

    def widen(self, found: Array) -> Array:
        """Return the bounds enlarged to cover products of roundings."""
        return found * (1 + MARGIN) + MARGIN

    def put_exact(self, given: Mapping[str, Any], arithmetic: Arithmetic) -> Values:
        """Return the given values with the arrays of elements, and their sum in an arithmetic."""
        return self._put(given, arithmetic, drop_rest)

    def put_rounded(self, given: Mapping[str, Any]) -> Values:
        """Return the given values with the arrays of elements and the sum as kernels compute it."""
        return self._put(given, IN_DOUBLES, IN_DOUBLES[ADDED] if self.keeps_rests else drop_rest)

    def _put(
        self, given: Mapping[str, Any], arithmetic: Arithmetic, rest: Callable[..., Any]
    ) -> Values:
        arrays = {
            name: np.array([given[_name_element(name, i)] for i in range(SEARCHED)])
            for name in self.loop.arrays
        }
        values = {**given, **arrays}
        taken = [values[name] for name in self.loop.parameters]
        return {**values, self.loop.name: run_loop(self.loop, arithmetic, rest, *taken)}

    @property
    def asking(self) -> Arithmetic:
        """Return the arithmetic in doubles that can run the tests of a set's domain."""
        return IN_DOUBLES.but(
            **{test.name: partial(run_loop, test, IN_DOUBLES, drop_rest) for test in self.tests}
        )

    def draw(self, points: Mapping[str, Array], rng: np.random.Generator) -> Mapping[str, Array]:
        """Return the points with randomly drawn elements in place of the sum."""
        count = len(points[self.loop.name])
        names = (_name_element(name, i) for name in self.loop.arrays for i in range(SEARCHED))
        drawn = {name: 2 ** rng.uniform(0, OCTAVES, count) for name in names}
        return {**drawn, **{n: column for n, column in points.items() if n != self.loop.name}}


def _name_element(name: str, number: int) -> str:
    return f"{name}[{number}]"


def drop_rest(one: Any, other: Any, total: Any) -> Any:
    """Return 0 for what an addition rounds off."""
    return 0


def run_loop(loop: TermLoop, arithmetic: Arithmetic, rest: Callable[..., Any], *arrays: Any) -> Any:
    """Run a loop as it is printed: return the sum of its terms, or whether all of them hold."""
    known = dict(zip(loop.parameters, arrays, strict=True))
    terms, zero = len(known[loop.arrays[0]]), arithmetic.number(0)
    high, low, holds = zero, zero, True
    for indices in product(range(terms), repeat=loop.axes):
        elements = (known[name][tuple(indices[i] for i in at)] for name, at in loop.elements)
        (term,) = run(loop.term, dict(zip(loop.term.inputs, elements, strict=True)), arithmetic)
        if loop.kind == "every":
            holds = holds & term
            continue
        total = arithmetic.add(high, term)
        low = low + rest(high, term, total)
        high = total
    if loop.kind == "every":
        return holds
    return arithmetic.choose(arithmetic.is_finite(low), high + low, high)


def take_sum(
    kernel: Kernel, expansions: Mapping[str, Expansion], *, keeps_rests: bool
) -> tuple[TermSum, Kernel, Mapping[str, Expansion]]:
    """Return the sum in a kernel, the kernel of a number in its place, and the expansions.

    The expansions include `approximate`, with the error of that number. Raises ValueError unless
    there is one sum, of terms that are never negative, and the value is a factor times a power of
    it.
    """
    (folded,), loops = fold_sums([kernel])
    sums = [loop for loop in loops if loop.kind == "sum"]
    if len(sums) != 1 or sums[0].axes != 1:
        raise ValueError("more than one sum, or one over two indices: leave out the charts")
    (loop,) = sums
    off = _bound_term(loop, expansions) + (HALF if keeps_rests else 0.0)
    (form,), (stage,) = kernel.forms, folded.code.stages
    quantity, reduced, degree = _put_number(kernel.quantity, form, loop.name)
    code = replace(folded.code, stages=(_take_number(stage, loop),))
    number = Program(("a",), (Operation("q", "approximate", ("a",)),), ("q",))
    tests = tuple(one for one in loops if one.kind == "every")
    return (
        TermSum(loop, tests, degree, keeps_rests),
        replace(folded, quantity=quantity, forms=(reduced,), code=code),
        {**expansions, "approximate": Expansion(number, {"q": off})},
    )


def _bound_term(loop: TermLoop, expansions: Mapping[str, Expansion]) -> float:
    """Bound the error of a term in eps of itself, whatever its elements."""
    names = loop.term.inputs
    straight = flatten_stage(Stage(None, names, (), NOTHING, loop.term), expansions)
    anything = Interval(np.float64(-np.inf), np.float64(np.inf))
    variables = BoxVariables([anything] * len(names), [False] * len(names))
    given = {name: variables.variable(i) for i, name in enumerate(names)}
    (output,) = straight.outputs
    with np.errstate(all="ignore"):
        analysis = ErrorAnalysis(straight, variables, given, {}, None, prove)
        off = float(analysis.sum_errors(output, ErrorScale(None, True)))
    if analysis.value(output).decide_sign() != 1:
        raise ValueError("terms of either sign, whose sum may cancel: leave out the charts")
    if not np.isfinite(off):
        raise ValueError("terms whose roundings are not bounded: leave out the charts")
    return off


def _take_number(stage: Stage, loop: TermLoop) -> Stage:
    """Return the stage with an approximate number as input in place of the sum."""
    assert stage.evaluate is not None
    operations = tuple(
        replace(step, kind="approximate", operands=(loop.name,)) if step.kind == loop.name else step
        for step in stage.evaluate.operations
    )
    running = (loop.name, *(name for name in stage.running if name not in loop.arrays))
    evaluate = replace(stage.evaluate, inputs=running, operations=operations)
    return replace(stage, running=running, evaluate=evaluate)


def _put_number(quantity: Quantity, form: Form, name: str) -> tuple[Quantity, Form, float]:
    """Return quantity and form with a number in place of the sum, and the power of it they have."""
    accuracy = quantity.accuracy
    scale = accuracy.scale if accuracy else None
    size = scale.written_out() if scale else quantity.definition
    number = sp.Symbol(name, positive=True)
    totals = set().union(*(e.atoms(sp.Sum) for e in (quantity.definition, form.expression, size)))
    values = dict.fromkeys(totals, number)
    value, size = (e.xreplace(values) for e in (quantity.definition, size))
    degree, other = (sp.simplify(number * e.diff(number) / e) for e in (value, size))
    if len(totals) != 1 or not (degree == other and degree.is_Rational and 0 < degree <= 1):
        raise ValueError("not a power of at most 1 of a sum, times a factor: leave out the charts")
    if accuracy and scale:
        accuracy = replace(accuracy, scale=Scale(scale.name, size))
    charts = tuple(_add_number(chart, number) for chart in form.charts)
    reduced = replace(form, expression=form.expression.xreplace(values), charts=charts)
    single = Argument(name, (number,), "sum of the terms")
    others = (a for a in quantity.arguments if not isinstance(a.symbols[0], sp.IndexedBase))
    changed = replace(
        quantity,
        arguments=(single, *others),
        definition=value,
        forms=tuple(reduced if one is form else one for one in quantity.forms),
        accuracy=accuracy,
    )
    return changed, reduced, float(degree)


def _add_number(chart: Chart, number: sp.Symbol) -> Chart:
    """Return a chart with the sum as an argument and its root as a coordinate."""
    root = sp.Symbol(f"root of {number}", positive=True)
    return replace(
        chart,
        text=f"{PLACE} and {chart.text}" if chart.text else PLACE,
        arguments={number: root**2, **chart.arguments},
        within={root: sp.Interval(0, sp.oo), **chart.within},
    )
