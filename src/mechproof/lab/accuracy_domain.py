"""Where an accuracy bound is stated: the points at which its relations hold for certain."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import sympy as sp

from mechproof.arithmetic import balls
from mechproof.lab.oracle import PRECISIONS, count_points, give_balls, list_values
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Arguments, Array, list_columns
from mechproof.record.relations import is_comparison


def mark_accuracy_domain(subject: Subject, arguments: Arguments) -> Array:
    """Mark the points where all relations of the bound hold; undecided ones are not among them.

    What is computed, a difference near zero, is decided by balls: the rounding of doubles would
    decide it at the very points that the relation is to keep out. A relation on elements holds
    where it holds for all of them.
    """
    accuracy = subject.quantity.accuracy
    relations = accuracy.within if accuracy else ()
    computed = [r for r in relations if not is_comparison(subject.domain.resolve(r))]
    held = np.ones(count_points(subject, arguments), bool)
    for relation in relations:
        if relation not in computed:
            held &= _compare(subject, relation, arguments)
    for index, values in enumerate(list_values(subject, arguments)) if computed else ():
        held[index] &= all(_is_true(subject, relation, values) for relation in computed)
    return held


def _is_true(subject: Subject, relation: sp.Basic, values: Mapping[sp.Basic, Any]) -> bool:
    for bits in PRECISIONS:
        known = give_balls(relation, subject.domain.given, values, bits)
        found = balls.truth(relation, known, bits)
        if found is not None:
            return found
    return False


def _compare(subject: Subject, relation: sp.Basic, arguments: Arguments) -> Array:
    """Decide a relation in doubles."""
    symbols = subject.quantity.symbols
    plain = {s: sp.Symbol(str(s)) for s in symbols if isinstance(s, sp.IndexedBase)}
    elements = {item: plain[item.base] for item in relation.atoms(sp.Indexed)}
    test = sp.lambdify([plain.get(s, s) for s in symbols], relation.xreplace(elements), "numpy")
    columns = list_columns(subject.quantity, arguments)
    if not plain:
        # SymPy's code for "or" joins its parts into one array.
        columns = list(np.broadcast_arrays(*columns))
    with np.errstate(all="ignore"):
        found: Array = np.asarray(test(*columns), bool)
    return np.asarray(found.all(axis=-1)) if elements else found
