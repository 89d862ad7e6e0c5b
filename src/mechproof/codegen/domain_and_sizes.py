"""Facts: in, a paper; out, its domain and published sizes as a kernel module holds them."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from mechproof.codegen.formula_text import chain_relations, write_formula
from mechproof.codegen.languages import NUMPY
from mechproof.codegen.syntax import write_program
from mechproof.programs.argument_conditions import checked_relations
from mechproof.programs.evaluation import input_symbols
from mechproof.programs.kernel import input_names
from mechproof.programs.lowering import lower_conditions
from mechproof.record import Paper, Toleranced
from mechproof.record.relations import find_slack


@dataclass(frozen=True)
class ConditionText:
    """What is printed of a condition: the parameter to blame, words, names, the test."""

    parameter: str
    text: str
    names: tuple[str, ...]
    test: str
    quantities: tuple[str, ...]


@dataclass(frozen=True)
class SizesText:
    """What is printed of published sizes: doubles, with limit deviations where there are any."""

    source: str
    sizes: tuple[tuple[str, float | tuple[float, float, float]], ...]
    marks: tuple[str, ...]


def list_conditions(paper: Paper) -> tuple[ConditionText, ...]:
    """List the conditions on parameters, each once, with the quantities that need it."""
    needed: dict[tuple[tuple[str, ...], tuple[sp.Basic, ...]], list[str]] = {}
    for quantity in paper.quantities:
        names = input_names(quantity)
        grouped: dict[tuple[str, ...], list[sp.Basic]] = {}
        for relation in checked_relations(quantity, paper):
            used = {names[s] for s in input_symbols(relation)}
            if relation.has(sp.Indexed):
                continue
            grouped.setdefault(tuple(n for n in names.values() if n in used), []).append(relation)
        for key, relations in grouped.items():
            needed.setdefault((key, tuple(relations)), []).append(quantity.name)
    spelled = {s: n for q in paper.quantities for s, n in input_names(q).items()}
    return tuple(
        _describe(names, relations, tuple(quantities), spelled)
        for (names, relations), quantities in needed.items()
    )


def _describe(
    names: tuple[str, ...],
    relations: tuple[sp.Basic, ...],
    quantities: tuple[str, ...],
    spelled: dict[sp.Basic, str],
) -> ConditionText:
    text = ", ".join(chain_relations([write_formula(r, spelled) for r in relations]))
    (test,) = write_program(lower_conditions(spelled, names, relations), NUMPY).outputs
    is_order = len(names) > 1 and find_slack(relations[0]) is not None
    smaller = relations[0].lts.free_symbols if is_order else set()
    blamed = sorted(spelled[s] for s in smaller) or list(names)
    return ConditionText(blamed[0], text, names, test, quantities)


def list_sizes(paper: Paper) -> tuple[SizesText, ...]:
    """List the published sizes by the names of the kernels' arguments, rounded once."""
    spelled = {s: n for q in paper.quantities for s, n in input_names(q).items()}
    return tuple(
        SizesText(
            published.source,
            tuple(
                (spelled[s], _round(size)) for s, size in published.sizes.items() if s in spelled
            ),
            published.marks,
        )
        for published in paper.published
    )


def _round(size: sp.Expr | Toleranced) -> float | tuple[float, float, float]:
    if isinstance(size, Toleranced):
        nominal, upper, lower = (float(sp.N(v, 40)) for v in (size.nominal, size.upper, size.lower))
        return nominal, upper, lower
    return float(sp.N(size, 40))
