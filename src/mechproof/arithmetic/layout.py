"""Layouts: an expression of SymPy -> its steps on slots, to be run in an arithmetic.

Equal parts share a slot, and a symbol given by others is its definition, so nothing is expanded.
Such lists are the tapes of automatic differentiation (Griewank and Walther 2008), here for balls,
series and slopes alike: the arithmetic's plan says what each step does.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from types import MappingProxyType
from typing import Any

import sympy as sp

from mechproof.record.implicit import Implicit
from mechproof.record.substitution import resolve

Values = Mapping[sp.Basic, Any]
# Takes the values of symbols, then the operands.
Operation = Callable[..., Any]
Plan = tuple[Operation, tuple[sp.Basic, ...]]
Given = Mapping[sp.Basic, sp.Basic]
NOTHING: Given = MappingProxyType({})
# Nodes with bound symbols or branches, each of which is one step together with its parts.
WHOLE = (sp.Sum, sp.Product, sp.Integral, sp.Piecewise, Implicit)


class Layout:
    """The steps of an expression, each after those that it needs; the last one is its value.

    A node of a kind in `whole` is one step that runs everything inside, bound symbols included.
    """

    def __init__(
        self,
        expression: sp.Basic,
        plan: Callable[[sp.Basic], Plan],
        given: Given = NOTHING,
        whole: tuple[type[sp.Basic], ...] = WHOLE,
    ) -> None:
        self.nodes: list[sp.Basic] = []
        self.operands: list[tuple[int, ...]] = []
        self._steps: list[tuple[int, Operation, tuple[int, ...]]] = []
        self._settled: list[Any] = []
        self._slots: dict[sp.Basic, int] = {}
        self._plan, self._given, self._whole = plan, given, whole
        self._place(expression)

    def run(self, values: Values) -> list[Any]:
        """Return the results of all steps."""
        results = self._settled.copy()
        for slot, operation, operands in self._steps:
            results[slot] = operation(values, *[results[k] for k in operands])
        return results

    def settle(self, values: Values, keep: Callable[[Any], Any] = lambda value: value) -> None:
        """Compute once the steps that need only these symbols; store what `keep` makes of each."""
        left = []
        for slot, operation, operands in self._steps:
            if self.needs[slot] <= values.keys():
                given = [self._settled[k] for k in operands]
                self._settled[slot], self.operands[slot] = keep(operation(values, *given)), ()
            else:
                left.append((slot, operation, operands))
        self._steps = left

    @cached_property
    def needs(self) -> list[frozenset[sp.Basic]]:
        """List the symbols whose values each step needs."""
        found: list[frozenset[sp.Basic]] = []
        for node, operands in zip(self.nodes, self.operands, strict=True):
            if isinstance(node, sp.Symbol | sp.Indexed):
                own = frozenset({node})
            else:
                own = frozenset(node.free_symbols if isinstance(node, self._whole) else ())
            found.append(own.union(*(found[k] for k in operands)))
        return found

    def _place(self, node: sp.Basic) -> int:
        # SymPy keeps equal parts apart; here they become one step, by their hash.
        if node not in self._slots:
            inner = self._given.get(node)
            self._slots[node] = self._append(node) if inner is None else self._place(inner)
        return self._slots[node]

    def _append(self, node: sp.Basic) -> int:
        if isinstance(node, self._whole):
            node = resolve(node, self._given)
        operation, arguments = self._plan(node)
        operands = tuple(map(self._place, arguments))
        self.nodes.append(node)
        self.operands.append(operands)
        self._steps.append((len(self._settled), operation, operands))
        self._settled.append(None)
        return len(self.nodes) - 1
