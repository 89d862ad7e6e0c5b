"""Steps: in, an expression; out, a name a reader would give it (`one_minus_e`, `sin_alpha`).

Names from a paper have no leading underscore. The functions and modules that emitted Python uses
are imported under names with one, so that the two never clash.

Subexpressions that occur twice in an evaluation get names. Compilers eliminate them from programs
(Cocke 1970); here it is done to expressions, before the order of roundings is fixed, so that
proofs, counts and every language see the same steps.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Container, Iterable, Mapping
from functools import lru_cache, partial
from keyword import iskeyword
from types import MappingProxyType

import sympy as sp

from mechproof.programs.evaluation import Evaluation, Step, map_entries
from mechproof.record.parts import find_free, replace_parts

NUMBERS = {1: "one", 2: "two", 3: "three", 4: "four"}
POWERS = {2: "squared", 3: "cubed"}
LONGEST = 24
# Names in the signatures of kernels, and names that the runtime looks up in their modules.
PUBLIC = frozenset({"out"})
PUBLIC_IN_MODULES = frozenset({"Any", "ArrayLike", "DOMAIN", "NDArray", "PUBLISHED", "annotations"})
# Modules that emitted code imports under private names, and the names that annotations use.
MODULES: Mapping[str, str] = MappingProxyType({"math": "_math", "numpy": "_np"})
ANNOTATED: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {"typing": ("Any",), "numpy.typing": ("ArrayLike", "NDArray")}
)
# The order of imports by package; "" stands for the standard library.
PACKAGES = ("", "numpy", "mechproof")


def is_free(name: str, taken: Iterable[str] = PUBLIC) -> bool:
    """Return whether a paper may give this name to a variable or a kernel."""
    is_name = name.isidentifier() and not iskeyword(name) and not name.startswith("_")
    return is_name and name not in taken


def list_imports(text: str, names: Mapping[str, Iterable[str]]) -> tuple[str, ...]:
    """List the lines that import what a text of Python uses, with blank lines between packages.

    `names` maps further modules to names they export, which are imported with an underscore.
    """
    words = frozenset(re.findall(r"\w+", text))
    found = [(m, False, f"import {m} as {name}") for m, name in MODULES.items() if name in words]
    for module in dict.fromkeys((*ANNOTATED, *names)):
        used = [name for name in ANNOTATED.get(module, ()) if name in words]
        used += [f"{name} as _{name}" for name in names.get(module, ()) if f"_{name}" in words]
        if used:
            found.append((module, True, f"from {module} import {', '.join(used)}"))
    packages = [_find_package(module) for module, _, _ in found]
    lines: list[str] = []
    for package in sorted(set(packages)):
        of_package = [line for line, own in zip(found, packages, strict=True) if own == package]
        lines += [text for _, _, text in sorted(of_package, key=lambda line: (line[1], line[0]))]
        lines.append("")
    return tuple(lines[:-1])


def _find_package(module: str) -> int:
    first = module.partition(".")[0]
    return PACKAGES.index(first) if first in PACKAGES else 0


def suggest_name(expression: sp.Expr, otherwise: str = "term") -> str:
    """Return a name that describes the expression, or `otherwise` if that would be too long."""
    name = _spell(expression)
    # Parts without a word, such as fractions, are spelled as "" and leave a stray underscore.
    readable = name.isidentifier() and name == name.strip("_")
    return name if readable and len(name) <= LONGEST else otherwise


def _spell(expression: sp.Expr) -> str:
    if isinstance(expression, sp.Symbol):
        return str(expression)
    if isinstance(expression, sp.Integer):
        return NUMBERS.get(int(expression), "")
    if isinstance(expression, sp.Pow) and expression.exp in POWERS:
        return f"{_spell(expression.base)}_{POWERS[int(expression.exp)]}"
    if isinstance(expression, sp.Pow) and expression.exp == sp.S.Half:
        return f"root_{_spell(expression.base)}"
    if isinstance(expression, sp.Mul):
        return "_".join(_spell(factor) for factor in expression.args)
    if isinstance(expression, sp.Add):
        return _spell_sum(expression)
    if isinstance(expression, sp.Function) and len(expression.args) == 1:
        return f"{expression.func.__name__.lower()}_{_spell(expression.args[0])}"
    return ""


def _spell_sum(expression: sp.Add) -> str:
    first, *others = sorted(expression.args, key=sort_positive_first)
    spelled = _spell(first)
    for term in others:
        negative = term.could_extract_minus_sign()
        spelled += f"_minus_{_spell(-term)}" if negative else f"_plus_{_spell(term)}"
    return spelled


def sort_positive_first(term: sp.Expr) -> tuple[bool, bool, object]:
    """Return the key that sorts the terms of sums as people write them: 1 - e, R - A, 1 + t**2."""
    return (
        term.could_extract_minus_sign(),
        not term.is_Number,
        sp.default_sort_key(term),
    )


def share_subexpressions(evaluation: Evaluation) -> Evaluation:
    """Name every compound subexpression that occurs more than once, largest first.

    Purely structural: sums and products are never regrouped, because a rewrite may have chosen
    their grouping for accuracy.
    """
    shared: list[Step] = []
    for repeated in _list_repeated(evaluation):
        evaluation.add_step(suggest_name(repeated), repeated, shared)
    names = {value: symbol for symbol, value in shared}
    steps = [(symbol, _rebuild(value, names)) for symbol, value in shared]
    steps += [(symbol, replace_parts(value, names)) for symbol, value in evaluation.steps]
    output = map_entries(partial(replace_parts, values=names), evaluation.output)
    return _merge_steps(evaluation.rearrange(steps, output))


def _list_repeated(evaluation: Evaluation) -> list[sp.Expr]:
    """List the repeated subexpressions without a name, the largest first."""
    named = {value for _, value in evaluation.steps}
    seen: Counter[sp.Expr] = Counter()
    for value in evaluation.expressions():
        _count(value, seen, named)
    repeated = [node for node, count in seen.items() if count > 1 and node not in named]
    return sorted(repeated, key=_count_operations, reverse=True)


def _count(expression: sp.Expr, seen: Counter[sp.Expr], named: Container[sp.Expr]) -> None:
    """Count compound nodes in order, without those inside a Sum, which depend on its index.

    Parts of a repeated expression are not counted again.
    """
    if isinstance(expression, sp.Sum) or _is_worth_naming(expression):
        seen[expression] += 1
        if isinstance(expression, sp.Sum) or (seen[expression] > 1 and expression not in named):
            return
    for argument in expression.args:
        _count(argument, seen, named)


@lru_cache(maxsize=1 << 14)
def _count_operations(expression: sp.Expr) -> int:
    return int(sp.count_ops(expression))


@lru_cache(maxsize=1 << 14)
def _is_worth_naming(expression: sp.Basic) -> bool:
    """Return whether an expression deserves a name; -x, 1/x and 2*x are cheap where they are."""
    if not isinstance(expression, sp.Expr) or expression.is_Atom or not find_free(expression):
        return False
    number, rest = expression.as_coeff_Mul()
    if number == -1:
        return False
    return not (rest.is_Atom or (rest.is_Pow and rest.exp == -1 and rest.base.is_Atom))


def _merge_steps(evaluation: Evaluation) -> Evaluation:
    """Replace other occurrences of a step's value by the step."""
    names = {value: symbol for symbol, value in evaluation.steps if not value.is_Atom}
    steps = [(symbol, _rebuild(value, names)) for symbol, value in evaluation.steps]
    output = map_entries(partial(replace_parts, values=names), evaluation.output)
    return evaluation.rearrange(steps, output)


def _rebuild(value: sp.Expr, names: Mapping[sp.Expr, sp.Symbol]) -> sp.Expr:
    if value.is_Atom:
        return value
    return value.func(*(replace_parts(argument, names) for argument in value.args))
