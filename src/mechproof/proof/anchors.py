"""Anchors: the numbers of a paper's rows -> names within its page, stable and unique."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable
from itertools import chain, count

EQUATION = re.compile(r"\((\w+)\)(?=$|[,\s])")


def name_anchor(number: str) -> str:
    """Name one row, whatever others are called."""
    equation = find_equation(number)
    if not equation:
        return f"row-{slugify(number) or 'unnamed'}"
    rest = slugify(EQUATION.sub("", number, count=1))
    return "-".join(filter(None, (name_equation(equation), rest)))


def name_anchors(numbers: Iterable[str]) -> dict[str, str]:
    """Name the rows: `eq-12` for (12), `eq-10-third-equals-sign`, `row-table-3-interval-3`.

    Two numbers that differ in signs alone get the same name, the second with a 2 behind it.
    """
    found: dict[str, str] = {}
    for number in numbers:
        taken = set(found.values())
        name = name_anchor(number)
        names = chain([name], (f"{name}-{n}" for n in count(2)))
        found[number] = next(n for n in names if n not in taken)
    return found


def find_equation(number: str) -> str:
    """Return the number of the equation that a row belongs to, empty if it names none."""
    met = EQUATION.match(number)
    return met[1] if met else ""


def find_only_equation(number: str) -> str:
    """Return the equation that a row is about, empty if it names none or more than one."""
    return find_equation(number) if len(set(EQUATION.findall(number))) == 1 else ""


def name_equation(equation: str) -> str:
    """Name the place at which the first row of an equation stands."""
    return f"eq-{slugify(equation)}"


def slugify(text: str) -> str:
    """Keep letters of any script and digits in lower case, and hyphens between."""
    plain = unicodedata.normalize("NFKC", text).replace("'", "").casefold()
    return re.sub(r"[\W_]+", "-", plain).strip("-")
