"""Chosen forms: beside a derivation, the rewrites that were found for its quantities.

`system.forms.json` beside a file, `forms.json` in a folder: quantity -> names of rewrites, with
which its definition is computed. What the derivation ships otherwise is kept as a rival.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from mechproof.programs.rewrites import REWRITES
from mechproof.record import Form, Paper, Quantity
from mechproof.tools.files import write_whole

Chosen = Mapping[str, tuple[str, ...]]
# The key of the form that the derivation itself ships.
STATED = "as_stated"


def find_file(place: Path) -> Path:
    """Return where the forms of a derivation are kept."""
    place = place.parent if place.name == "__init__.py" else place
    return place / "forms.json" if place.is_dir() else place.with_suffix(".forms.json")


def read_chosen(place: Path) -> Chosen:
    """Return what is chosen; ValueError naming the file where it is not what is written there."""
    file = find_file(place)
    if not file.is_file():
        return {}
    try:
        kept = json.loads(file.read_text(encoding="utf-8"))
        chosen = {str(name): tuple(rewrites) for name, rewrites in kept.items()}
    except (ValueError, TypeError, AttributeError) as error:
        raise ValueError(f"{file}: {error}; allowed is {{quantity: [rewrites]}}") from error
    for name, rewrites in chosen.items():
        if unknown := [r for r in rewrites if r not in REWRITES]:
            raise ValueError(f"{file}: {name}: {unknown} are none of {sorted(REWRITES)}")
    return chosen


def add_chosen(place: Path, chosen: Chosen) -> Path:
    """Add to what is chosen, and return the file."""
    file, known = find_file(place), read_chosen(place)
    write_whole(file, json.dumps({**known, **chosen}, indent=1, sort_keys=True) + "\n")
    return file


def choose_forms(paper: Paper, place: Path) -> Paper:
    """Return the paper with the chosen forms shipped; ValueError for one that it does not have."""
    chosen = read_chosen(place)
    if unknown := sorted(chosen.keys() - {q.name for q in paper.quantities}):
        raise ValueError(f"{find_file(place)}: {paper.system} has no quantities {unknown}")
    if not chosen:
        return paper
    quantities = (_choose(q, chosen[q.name]) if q.name in chosen else q for q in paper.quantities)
    return replace(paper, quantities=tuple(quantities))


def describe(rewrites: tuple[str, ...]) -> str:
    """Name a form by its rewrites."""
    return ", ".join(name.replace("_", " ") for name in rewrites) or "as defined"


def rewrite_definition(quantity: Quantity, rewrites: tuple[str, ...]) -> Form:
    """Return the form of the definition with rewrites."""
    return Form(describe(rewrites), quantity.definition, rewrites)


def _choose(quantity: Quantity, rewrites: tuple[str, ...]) -> Quantity:
    stated = (replace(form, key=STATED, charts=()) for form in quantity.shipped)
    others = (form for form in quantity.rivals if form.key != STATED)
    return replace(quantity, forms=(rewrite_definition(quantity, rewrites), *stated, *others))
