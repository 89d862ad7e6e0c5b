"""Letters on the pages of quantities and papers: no two arguments of a quantity look alike."""

from __future__ import annotations

from collections import Counter

import pytest
from derived import SYSTEMS, paper_of

from mechproof.proof.comparison_latex import write_latex, write_letter
from mechproof.record import Quantity
from mechproof.report.paper_pages import _describe_symbol
from mechproof.report.quantity_pages import _describe_arguments

for_each_paper = pytest.mark.parametrize(
    "system", [pytest.param(s, marks=pytest.mark.xdist_group(f"verdicts {s}")) for s in SYSTEMS]
)


def list_alike(letters: list[str]) -> list[str]:
    """List the letters that occur more than once."""
    return [letter for letter, count in Counter(letters).items() if count > 1]


def find_quantity(name: str) -> Quantity:
    return next(q for q in paper_of("track_wheel").quantities if q.name == name)


@for_each_paper
def test_no_two_arguments_of_a_quantity_look_alike(system: str) -> None:
    paper = paper_of(system)
    for quantity in paper.quantities:
        views = _describe_arguments(quantity, paper.variables)
        assert list_alike([str(symbols) for _, symbols, _ in views]) == []


def test_a_family_without_its_index_looks_like_another_letter() -> None:
    variables, quantity = paper_of("track_wheel").variables, find_quantity("error_sum_thermal")
    symbols = [symbol for argument in quantity.arguments for symbol in argument.symbols]
    assert list_alike([write_latex(symbol, variables) for symbol in symbols]) == ["K"]
    shown = [write_letter(symbol, variables, [quantity.definition]) for symbol in symbols]
    assert shown == ["T_{i}", "S_{i}", "K_{i}", "K", r"\tau", "K_T"]


def test_a_family_has_as_many_indices_as_its_formulas_give_it() -> None:
    paper = paper_of("track_wheel")
    names = [str(_describe_symbol(v, paper).name) for v in paper.variables if v.latex]
    for latex in ("K", "K_{i}", "K_i(t)", "R_{ij}", "R_{ij}(t)", r"\Delta_{y,i}"):
        assert sum(f">{latex}</annotation>" in name for name in names) == 1, latex
