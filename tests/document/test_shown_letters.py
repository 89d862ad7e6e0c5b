"""Answers show letters as they are printed, whatever their accents, scripts and alphabets."""

from __future__ import annotations

import json
import re

import pytest

from mechproof.document.checked_rows import rows_to_json
from mechproof.document.checking import check
from mechproof.nomenclature.shown_letters import name_symbol

pytestmark = pytest.mark.usefixtures("judged_here")

LETTERS = (
    *(r"\hat a", r"\tilde{b}_1", r"\bar c'", r"\vec q", r"\mathcal L", r"\boldsymbol\alpha"),
    *(r"\omega_{12}", r"\lambda_{\mathrm{max}}", r"{}^0_1g", r"\overline{AB}", r"E^*", r"\varphi"),
)
# Letters k, m, n and u, and @ for the letter under test; t is the time.
PAPERS = {
    "a letter is printed again": (r"k=2@", r"k=3@"),
    "a letter is used once": (r"@=2k+1",),
    "constraints contradict each other": (r"@k=m\sin n", r"@k=m\sin n+1"),
    "a constraint is a misprint": (
        r"m\cos @=k-n\cos u",
        r"m\sin @=n\sin u",
        r"\tan @=\frac{n\sin @}{k-n\cos u}",
    ),
    "it holds for some values": (r"k=\sqrt{@^2}", r"k=@"),
    "sides with other letters": (r"k=\sin @", r"k=m+@"),
    "a number beside sizes": (r"k=2@", r"@=0.5", r"k=1.2"),
    "a limit": (r"k=\frac{\sin @}@", r"\lim_{@\to0}k=2"),
    "a maximum": (r"k=2@-@^2", r"\max_@k=2"),
    "a law by pieces": (r"k=@\quad\text{for }0\le @\le1", r"k=3@\quad\text{for }1<@\le2"),
    "an integral": (r"k=\int_0^{@}@^2\,d@",),
}
MOVING = {
    "a derivative": (r"k=\sin @", r"\dot k=@'\cos @", r"\ddot k=-@'^2\cos @"),
    "a derivative beside constraints": (r"m\sin @=n\sin k", r"@'=\frac{n}{m}\dot k"),
}
TABLE = "\\begin{tabular}{cc}$m$&$m/@$\\\\1&2\\\\3&4\\end{tabular}"
BLOCK = "%% mechproof\n%% @ : one letter\n%% k ; m ; n ; u : others\n%% end\n"


# Fields in which answers quote the paper.
QUOTED = ("latex", "printed", "printed_latex", "name", "number", "id")


def list_texts(part: object) -> list[str]:
    """Return all texts of an answer, except those of the fields in `QUOTED`."""
    if isinstance(part, dict):
        said = {key: value for key, value in part.items() if key not in QUOTED}
        return [*said, *(text for value in said.values() for text in list_texts(value))]
    if isinstance(part, list):
        return [text for value in part for text in list_texts(value)]
    return [str(part)]


def describe(letter: str, block: str, *lines: str) -> str:
    """Return all that is said about a paper in which `letter` replaces each @."""
    found = check("paper.tex", (block + "\n".join(lines)).replace("@", letter))
    said = [text for _, text in found.told]
    return "\n".join([*list_texts(json.loads(rows_to_json(found.rows))), *said])


def find_inner(letter: str, text: str) -> list[str]:
    name = re.escape(name_symbol(letter))
    return re.findall(rf"(?<![\\A-Za-z{{}}]){name}|\bd2?{name}", text)


@pytest.mark.slow
@pytest.mark.parametrize("letter", LETTERS)
@pytest.mark.parametrize("name", PAPERS)
def test_answers_show_a_letter_as_it_is_printed(name: str, letter: str) -> None:
    displays = [f"\\begin{{equation}}{latex}\\end{{equation}}" for latex in PAPERS[name]]
    assert not find_inner(letter, describe(letter, BLOCK, *displays, TABLE))


@pytest.mark.parametrize("name", MOVING)
def test_answers_show_a_derivative_as_it_is_printed(name: str) -> None:
    block = BLOCK.replace("@ :", r"\bar\theta_2(t) :").replace("k ;", "k(t) ;")
    displays = [f"$${latex}$$" for latex in MOVING[name]]
    displays = [x.replace("@'", r"\dot{\bar\theta}_2") for x in displays]
    text = describe(r"\bar\theta_2", block, *displays)
    assert r"\dot{\bar" in text
    assert not find_inner(r"\bar\theta_2", text)
    assert not re.search(r"\bd2?k\b", text)


def test_a_name_within_is_found() -> None:
    assert find_inner(r"\hat a", "at hata = 2, dhata = 1") == ["hata", "dhata"]
    assert not find_inner(r"\hat a", r"at \hat a = 2")
