"""The sizes that the equations of a paper print: in, equations with their signs; out, `Sizes`."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from mechproof.document.known import Known
from mechproof.document.printed_sizes import PrintedSize, list_numbers, read_size
from mechproof.document.restated_sizes import RestatedSizes
from mechproof.document.roles import Role, Sign
from mechproof.document.sizes import Sizes
from mechproof.proof.verdict import Left
from mechproof.sources.displays import Printed


def collect_sizes(
    equations: Iterable[tuple[Printed, Sequence[Sign] | Left]],
    known: Known,
    restated: RestatedSizes,
) -> Sizes:
    """Collect the sizes that are printed; a letter that is printed with two of them has none."""
    read = [(one, [] if isinstance(signs, Left) else signs) for one, signs in equations]
    found: dict[sp.Basic, list[PrintedSize]] = {}
    numbers: dict[sp.Basic, list[PrintedSize]] = {}
    groups: dict[int, bool] = {}
    for printed, signs in read:
        is_numeric = bool(signs) and bool(signs[-1].number)
        groups[printed.group] = groups.get(printed.group, True) and is_numeric
        for sign in signs:
            if sign.role is Role.SIZE and sign.letter is not None and sign.number:
                found.setdefault(sign.letter, []).append(read_size(sign, printed, known))
        for letter, one in list_numbers(printed, signs, known):
            numbers.setdefault(letter, []).append(one)
    sizes = {s: {one.size.value * one.unit for one in ones} for s, ones in found.items()}
    kept = {s: ones[0] for s, ones in found.items() if len(sizes[s]) == 1}
    numeric = frozenset(group for group, is_all in groups.items() if is_all)
    return Sizes(known, kept, numeric, numbers, [one.name for one, _ in read], restated)
