"""One operation, one row: operations composed of others are keys of arithmetics, not of tables."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import mechproof
from mechproof.programs.operations import KINDS

ROOT = Path(mechproof.__file__).parent
# Operations defined by others, except signs; outside these modules, their row says everything.
SIGNS = {"add", "subtract", "multiply", "divide", "negate"}
COMPOSED = {kind for kind, row in KINDS.items() if row.meaning} - SIGNS
ARITHMETICS = {
    "roundoff/running.py": "doubles, in which a meaning would be rounded away, long ones and balls",
    "roundoff/rules.py": "intervals with slopes, in which a square has one side",
    "roundoff/endpoint_rounding.py": "ends of intervals, each operation rounded once, and grids",
    "roundoff/steps.py": "factors that scale all that is computed, what NumPy does by others",
    "roundoff/specialisation.py": "facts about quarter turns",
    "roundoff/compiled_kernels.py": "what compiled kernels compute by others",
    "roundoff/elementary_errors.py": "what is proved of which function",
    "roundoff/term_sums.py": "what the sum over a set is off by",
    "coq/rounding_scripts.py": "Coq's linear forms of roundings, in which a sum may be fused",
    "lab/validation.py": "balls with the errors of doubles",
    "lab/single_precision_errors.py": "floats, fused by way of doubles",
    "tailoring/model.py": "series with the errors of doubles",
    "codegen/condition_outputs.py": "two conditions for one",
}


def list_modules() -> Iterator[Path]:
    """Yield the modules that import programs; elsewhere the same words mean other things."""
    for path in ROOT.rglob("*.py"):
        rooms = ("mechproof.programs", "mechproof.roundoff", "mechproof.arithmetic.intervals")
        if any(f"from {room}" in path.read_text("utf-8") for room in rooms):
            yield path


def list_named(source: str) -> Iterator[str]:
    """Yield the composed kinds that are keys of a table or of an arithmetic in a module."""
    for node in ast.walk(ast.parse(source)):
        keys: list[object] = []
        if isinstance(node, ast.Dict):
            keys = [key.value for key in node.keys if isinstance(key, ast.Constant)]
        elif isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "but":
            keys = [keyword.arg for keyword in node.keywords]
        yield from (str(key) for key in keys if key in COMPOSED)


def test_tables_of_composed_operations_are_arithmetics() -> None:
    found = (path for path in list_modules() if [*list_named(path.read_text("utf-8"))])
    assert {path.relative_to(ROOT).as_posix() for path in found} == ARITHMETICS.keys()


@pytest.mark.parametrize(
    ("source", "named"),
    [
        ("T = {'product_rest': 1, 'add': 2}", ["product_rest"]),
        ("T = {**{'fma': 'a'}}", ["fma"]),
        ("A = B.but(hypot=f, sqrt=g)", ["hypot"]),
        ("T = {'add': 1, 'sin': 2, 'negate': 3}", []),
    ],
)
def test_a_table_beside_the_rows_is_seen(source: str, named: list[str]) -> None:
    assert [*list_named(source)] == named
