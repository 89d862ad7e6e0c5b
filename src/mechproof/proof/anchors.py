"""Anchors: the numbers of a paper's rows -> stable, unique link names within its page."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable
from itertools import chain, count

EQUATION = re.compile(r"\((\w+)\)(?=$|[,\s])")


def name_anchor(number: str) -> str:
    """Return a row's anchor without regard to those of other rows."""
    equation = find_equation(number)
    if not equation:
        return f"row-{slugify(number) or 'unnamed'}"
    rest = slugify(EQUATION.sub("", number, count=1))
    return "-".join(filter(None, (name_equation(equation), rest)))


def name_anchors(numbers: Iterable[str]) -> dict[str, str]:
    """Return unique anchors: `eq-12` for (12), `eq-10-third-equals-sign`, `row-table-3-interval-3`.

    Of two numbers that differ only in punctuation, the second gets the suffix -2.
    """
    found: dict[str, str] = {}
    for number in numbers:
        taken = set(found.values())
        name = name_anchor(number)
        names = chain([name], (f"{name}-{n}" for n in count(2)))
        found[number] = next(n for n in names if n not in taken)
    return found


def find_equation(number: str) -> str:
    """Return the number of the equation that a row belongs to, or "" if it names none."""
    met = EQUATION.match(number)
    return met[1] if met else ""


def find_only_equation(number: str) -> str:
    """Return the equation that a row is about, or "" if it names none or more than one."""
    return find_equation(number) if len(set(EQUATION.findall(number))) == 1 else ""


def name_equation(equation: str) -> str:
    """Return the anchor of an equation's first row."""
    return f"eq-{slugify(equation)}"


def slugify(text: str) -> str:
    """Return a text's letters of any script and digits in lower case, separated by hyphens."""
    plain = unicodedata.normalize("NFKC", text).replace("'", "").casefold()
    return re.sub(r"[\W_]+", "-", plain).strip("-")
