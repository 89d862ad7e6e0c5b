"""Tables of sizes and results: which are read, and which outcome each result has."""

from __future__ import annotations

import pytest

from mechproof.document.checking import CheckedPaper, check
from mechproof.nomenclature.cells import find_unit, finds_decimal_commas, read_numeral
from mechproof.record.unit_notation import read_unit

pytestmark = pytest.mark.usefixtures("judged_here")

LETTERS = r"""%% mechproof
%% a ; b : sides [mm] {a>0}
%% h : height [mm]
%% k : their ratio [1]
%% v : speed [m/s]
%% \beta(t) : angle [rad]
%% \delta : angle [rad]
%% \omega : speed of rotation [rad/s]
%% m ; n ; p ; q ; \gamma : numbers
%% \sigma : branch
%% branch \sigma=\pm1
%% factor b
%% end
$$k=\frac ab$$ $$h=b\sin\beta$$ $$v=a\omega$$ $$m=\sin\gamma$$ $$n=b(1+\sigma)$$ $$p=100k$$
$$q=20\gamma$$ $$\delta=\arctan\frac ab$$
"""


def run(table: str, name: str = "paper.tex") -> CheckedPaper:
    return check(name, LETTERS + table)


def outcomes(table: str) -> list[str]:
    return [row.outcome for row in run(table).rows[8:]]


def tabular(head: str, *rows: str, kind: str = "tabular", columns: str = "{cccc}") -> str:
    lines = " \\\\\n".join((head, *rows))
    return f"\\begin{{{kind}}}{columns}\n\\toprule\n{lines} \\\\\n\\bottomrule\n\\end{{{kind}}}\n"


TABLES = {
    "each result": (
        tabular(r"No. & $a$ & $b$ & $k$", "1 & 2 & 4 & 0.5", "2 & 2 & 3 & 0.67", "3 & 1 & 3 & 0.3"),
        ["PROVED", "PROVED", "PROVED"],
    ),
    "a wrong result": (
        tabular(r"$a$ & $b$ & $k$", "2 & 4 & 0.5", "2 & 3 & 0.76"),
        ["PROVED", "REFUTED"],
    ),
    "units in the head": (
        tabular(r"$a$, cm & $b$ (mm) & $k$ [\%]", "2 & 40 & 50", "2 & 80 & 52"),
        ["PROVED", "REFUTED"],
    ),
    "units in a row of their own": (
        tabular(r"{$a$} & {$b$} & {$k$}", r"{\si{\cm}} & {mm} & {--}", "2 & 40 & 0.5"),
        ["PROVED"],
    ),
    "units in the cells": (
        tabular(r"$b$ & $\beta$ & $h$", r"\SI{4}{cm} & $30^\circ$ & \SI{20}{\milli\metre}"),
        ["PROVED"],
    ),
    "degrees that nothing says": (
        tabular(r"$b$ & $\beta$ & $h$", "40 & 30 & 20", "40 & 90 & 40", "40 & 60 & 43.64"),
        ["PROVED", "PROVED", "REFUTED"],
    ),
    "degrees of a letter without unit": (
        tabular(r"$\gamma$ & $m$", "30 & 0.5", "90 & 1"),
        ["PROVED", "PROVED"],
    ),
    "sizes in other units than their product": (
        tabular(r"$a$ & $\omega$ & $v$", "20 & 10 & 0.2", "30 & 10 & 0.4"),
        ["PROVED", "REFUTED"],
    ),
    "decimal commas": (
        tabular("$a$ & $b$ & $k$", "0,5 & 2 & 0{,}25", "1,5 & 2 & 0,85"),
        ["PROVED", "REFUTED"],
    ),
    "powers of ten": (
        tabular(
            "$a$ & $b$ & $k$", r"$2\cdot10^3$ & 4e2 & 5", r"2 & $4\times10^{3}$ & $5\cdot10^{-4}$"
        ),
        ["PROVED", "PROVED"],
    ),
    "rounded sizes accuse nobody": (
        tabular("$a$ & $b$ & $k$", "0.33 & 2 & 0.1667", "0.33 & 2 & 0.1767"),
        ["not judged", "REFUTED"],
    ),
    "zeros that end a whole number": (
        tabular("$a$ & $b$ & $k$", "1234 & 1 & 1200", "1234 & 1 & 1300"),
        ["not judged", "REFUTED"],
    ),
    "a table on its side": (
        tabular("$a$ [mm] & 2 & 3", "$b$ [mm] & 4 & 4", "$k$ & 0.5 & 0.76"),
        ["PROVED", "REFUTED"],
    ),
    "symbols, meanings, values, units": (
        tabular(
            "Symbol & meaning & value & unit",
            "$a$ & side & 3 & cm",
            "$b$ & side & 40 & mm",
            "$k$ & ratio & 0.75 & --",
        ),
        ["PROVED"],
    ),
    "cells of several rows and columns": (
        tabular(
            r"\multicolumn{2}{c}{sizes} & result",
            "$a$ & $b$ & $k$",
            r"\multirow{2}{*}{2} & 4 & 0.5",
            " & 5 & 0.5",
        ),
        ["PROVED", "REFUTED"],
    ),
    "an environment with a width": (
        tabular("$a$ & $b$ & $k$", "2 & 4 & 0.5", kind="tabularx", columns=r"{\textwidth}{ccX}"),
        ["PROVED"],
    ),
    "either branch": (
        tabular(r"$b$ & $n$", "2 & 4", "3 & 0", "4 & 4"),
        ["PROVED", "PROVED", "REFUTED"],
    ),
    "what is measured is not compared": (
        tabular("$a$ & $b$ & measured $k$", "2 & 4 & 0.6"),
        ["not judged"],
    ),
    "a letter in two columns": (
        tabular("$a$ & $b$ & $k$ & $k$", "2 & 4 & 0.5 & 0.6"),
        ["not judged"] * 2,
    ),
    "sizes are missing": (tabular("$a$ & $k$", "2 & 0.5", "3 & 0.7"), ["not judged"]),
    "an empty result says nothing": (tabular("$a$ & $b$ & $k$", "2 & 4 & --", "2 & 4 & "), []),
    "a word for a number": (
        tabular("$a$ & $b$ & $k$", "2 & 4 & large", "2 & 4 & 0.5"),
        ["not judged", "PROVED"],
    ),
    "another dimension": (tabular("$a$ [kg] & $b$ & $k$", "2 & 4 & 0.6"), ["not judged"]),
    "units that nothing says": (tabular(r"$\gamma$ [1] & $m$ [1]", "2 & 7"), ["REFUTED"]),
    "a rounded number of the table goes into the next": (
        tabular("$a$ & $b$ & $k$ & $p$", "47 & 18 & 2.61 & 261.0", "47 & 18 & 2.61 & 262.0"),
        ["PROVED", "PROVED", "PROVED", "REFUTED"],
    ),
    "angles are meant up to turns": (
        tabular(r"$a$ & $b$ & $\delta$, $^\circ$", "1 & 1 & 45", "1 & -1 & 135", "1 & 2 & 207"),
        ["PROVED", "PROVED", "PROVED"],
    ),
    "angles are no others": (
        tabular(r"$a$ & $b$ & $\delta$, $^\circ$", "1 & 1 & 45", "1 & 2 & 33", "1 & 2 & -26.6"),
        ["PROVED", "REFUTED", "REFUTED"],
    ),
    "zeros agree in any unit": (
        tabular(r"$\gamma$ & $q$", "0 & 0", "3 & 0.06", "4 & 0.08"),
        ["not judged"],
    ),
    "turns or radians": (
        tabular(r"$a$ & $\omega$ [1/s] & $v$", "20 & 10 & 0.2", "20 & 10 & 1.26"),
        ["not judged"],
    ),
    "turns by the minute": (
        tabular(r"$a$ & $\omega$ [min$^{-1}$] & $v$", "20 & 100 & 0.209", "20 & 100 & 0.3"),
        ["PROVED", "REFUTED"],
    ),
    "a column of a formula": (
        tabular("$a$ & $b$ & $a/b$", "2 & 4 & 0.5", "2 & 5 & 0.4", "3 & 4 & 0.57"),
        ["PROVED", "PROVED", "REFUTED"],
    ),
    "a formula has the unit of its letters": (
        tabular("$a$ & $b$ & $a+b$, cm", "2 & 4 & 0.6", "2 & 5 & 0.8"),
        ["PROVED", "REFUTED"],
    ),
    "a unit behind a slash is no letter": (
        tabular("$a/$mm & $b/$mm & $k$", "2 & 4 & 0.5"),
        ["PROVED"],
    ),
    "a letter behind a slash is no unit": (
        tabular("$v/h$ & $v$ & $h$", "0.5 & 2 & 4", "0.6 & 2 & 4"),
        ["PROVED", "REFUTED", "not judged", "not judged"],
    ),
    "a formula whose letters are not there": (tabular("$a/b$ & $k$", "2 & 2"), ["not judged"]),
    "a product that few lines agree with may be a name": (
        tabular("$a$ & $b$ & $ab$", "2 & 4 & 7", "2 & 5 & 9"),
        ["not judged"],
    ),
    "meanings are no numbers": (tabular("$a$ & first side", "$k$ & ratio"), []),
}


@pytest.mark.slow
@pytest.mark.parametrize("case", TABLES)
def test_every_result_has_its_outcome(case: str) -> None:
    table, expected = TABLES[case]
    assert outcomes(table) == expected


def test_markdown_has_tables() -> None:
    letters = "\n".join(line.removeprefix("%% ") for line in LETTERS.splitlines() if "%%" in line)
    block = letters.replace("mechproof\n", "<!-- mechproof\n", 1).replace("\nend", "\n-->")
    table = "| $a$ | $b$ | $k$ |\n|---|:-:|--:|\n| 2 | 4 | 0.5 |\n| 2 | 5 | 0.5 |\n"
    rows = check("paper.md", f"{block}\n\n$$k=\\frac ab$$\n\n{table}").rows
    assert [row.outcome for row in rows] == ["DEFINITION", "PROVED", "REFUTED"]


def test_results_say_where_they_stand_and_what_gives_them() -> None:
    row = run(tabular("$a$ & $b$ & $k$", "2 & 4 & 0.7")).rows[-1]
    assert row.name == "table 1, line 1, k"
    assert (row.place.line, row.latex) == (19, "k=0.7")
    assert row.reason.endswith("compared with display 1")


def test_another_table_is_told() -> None:
    found = run(tabular("Material & Price", "steel & 12"))
    assert len(found.rows) == 8
    ((place, reason),) = found.told
    assert (place.line, "its head has fewer than two letters" in reason) == (16, True)


@pytest.mark.parametrize("head", ["$a/w$", "$b/m$", "a/b"])
def test_a_column_that_is_not_read_is_told_beside_one_that_is_compared(head: str) -> None:
    found = run(tabular(f"No. & $a$ & $b$ & $k$ & {head}", "1 & 2 & 4 & 0.5 & 0.5"))
    assert found.rows[-1].outcome == "PROVED"
    ((place, reason),) = found.told
    assert (place.line, f"the column {head} is not compared" in reason) == (18, True)


def test_a_column_of_a_formula_whose_letters_are_not_there_is_told() -> None:
    found = run(tabular("$a$ & $b$ & $k$ & $b/q$", "2 & 4 & 0.5 & 0.5"))
    assert [row.outcome for row in found.rows[8:]] == ["PROVED"]
    ((_, reason),) = found.told
    assert reason.startswith(
        r"the column b/q is not compared: the formula needs \gamma: found neither in"
    )


def test_sizes_of_the_block_that_are_not_those_of_the_table_accuse_nobody() -> None:
    with_size = LETTERS.replace("%% end", "%% sizes b=4 mm\n%% end")
    right = check("paper.tex", with_size + tabular("$a$ & $k$", "2 & 0.5", "3 & 0.9")).rows[8:]
    assert [row.outcome for row in right] == ["PROVED", "REFUTED"]
    other = check("paper.tex", with_size + tabular("$a$ & $k$", "2 & 0.4", "3 & 0.6")).rows[8:]
    assert [row.outcome for row in other] == ["not judged"]


NUMERALS = {
    "1.25": "5/4",
    "$-0.5$": "-1/2",
    "\u22120.5": "-1/2",
    r"\num{1.5e-3}": "3/2000",
    r"1\,234.5": "2469/2",
    "+3": "3",
}


@pytest.mark.parametrize("text", NUMERALS)
def test_cells_are_numbers(text: str) -> None:
    found = read_numeral(text, decimal_comma=False)
    assert found is not None
    assert str(found.value) == NUMERALS[text]


@pytest.mark.parametrize("text", ["n/a", "", "1.2 ± 0.1", "2--3", "1.23(4)", "3 apples", "1/2"])
def test_other_cells_are_none(text: str) -> None:
    assert read_numeral(text, decimal_comma=False) is None


def test_commas_are_decimal_or_part_thousands() -> None:
    assert finds_decimal_commas(["0,5", "1,234"]) is True
    assert finds_decimal_commas(["1,234", "0.5"]) is False
    assert finds_decimal_commas(["1,234", "2,345"]) is None
    assert finds_decimal_commas(["1", "2"]) is False


UNITS = {
    r"\milli\metre\per\second": "mm/s",
    r"\kilo\gram\per\cubic\milli\metre": "kg/mm^3",
    r"\square m\per\kN": "m^2/kN",
    r"\metre\per\second\squared": "m/s^2",
    r"$\mathrm{mm}$": "mm",
    r"$^\circ$": "°",
    r"\%": "%",
    r"\kilo\ohm": "kΩ",
    r"{\rm m/s}": "m/s",
}


@pytest.mark.parametrize("text", UNITS)
def test_units_are_read_as_they_are_printed(text: str) -> None:
    assert find_unit(text) == read_unit(UNITS[text])


@pytest.mark.parametrize("text", ["", "cm2x", "apples", "k"])
def test_other_texts_are_no_units(text: str) -> None:
    assert find_unit(text) is None


LOOP = r"""%% mechproof
%% x(t) : position [mm]
%% r ; l ; c : lengths [mm] {r>0}
%% F : force [N]
%% k : stiffness [N/mm]
%% \varphi(t) ; \beta(t) : angles [rad] RANGE
%% where l>r
%% sizes r=40 mm, l=160 mm, k=2 N/mm
%% end
"""
RANGE = r"{-\pi/2<\beta<\pi/2}"
ROD = r"$$x=r\cos\varphi+l\cos\beta$$ $$l\sin\beta=r\sin\varphi$$ "
POSITION = r"Hence $$x=r\cos\varphi+\sqrt{l^2-r^2\sin^2\varphi}$$ "
WRONG = POSITION.replace("l^2-", "l^2+")
X = tabular(r"$\varphi$ [$^\circ$] & $x$ [mm]", "0 & 200.0", "30 & 193.4", "60 & 176.3")
FORCE = tabular(r"$\varphi$ [$^\circ$] & $F$ [N]", "0 & 400.0", "30 & 386.8", "60 & 352.9")
# The position by an angle that is in no table, and by the crank's alone: the outcomes of a column.
RESTATED = {
    "what is proved": (RANGE, ROD + POSITION + X, ["PROVED", "PROVED", "REFUTED"]),
    "of another letter": (
        RANGE,
        ROD + POSITION + "$$F=kx$$" + FORCE,
        ["PROVED", "PROVED", "REFUTED"],
    ),
    "the definition alone": (RANGE, ROD + X, ["not judged"]),
    "a misprint": (RANGE, ROD + WRONG + X, ["not judged"]),
    "a root whose sign nothing tells": ("", ROD + POSITION + X, ["not judged"] * 3),
    "a case": (
        RANGE,
        ROD + POSITION.replace("Hence", "At the dead centre") + X,
        ["not judged"] * 3,
    ),
    "a special position": (
        RANGE,
        ROD + r"At the dead centre $$\beta=0.$$ Hence $$x=r\cos\varphi+l.$$" + X,
        ["not judged"],
    ),
}


@pytest.mark.slow
def test_a_column_from_which_another_is_computed_needs_no_formula() -> None:
    block = LOOP.replace("%% sizes", "%% t : time [s]\n%% let \\varphi=kt\n%% sizes").replace(
        "RANGE", ""
    )
    block = block.replace("stiffness [N/mm]", "speed [rad/s]").replace(", k=2 N/mm", "")
    table = tabular(r"$\varphi$ [$^\circ$] & $c$ [mm]", "0 & 40.0", "60 & 20.0", "90 & 1.0")
    rows = check("paper.tex", block + r"$$c=r\cos\varphi$$" + table).rows[1:]
    assert [row.outcome for row in rows] == ["PROVED", "PROVED", "REFUTED"]
    alone = check("paper.tex", block + r"$$c=rk$$" + table).rows[1:]
    assert [row.name for row in alone] == ["table 1, c", r"table 1, \varphi"]


@pytest.mark.slow
@pytest.mark.parametrize("name", RESTATED)
def test_a_column_is_compared_with_what_is_proved_of_its_letter(name: str) -> None:
    within, text, expected = RESTATED[name]
    rows = check("paper.tex", LOOP.replace("RANGE", within) + text).rows
    found = [row for row in rows if row.name.startswith("table")]
    assert [row.outcome for row in found] == expected, found[0].reason
    if "REFUTED" in expected:
        assert "compared with display 3" in found[-1].reason


OFFSET = r"""%% mechproof
%% r ; l ; e : lengths [mm] {r>0} {l>0}
%% x : way [mm]
%% \varphi ; \psi : angles [rad] {-\pi/2<\psi<\pi/2}
%% sizes r=50 mm, l=160 mm, e=20 mm
%% end
$$r\sin\varphi-l\sin\psi=e$$
$$x=r\cos\varphi+l\cos\psi$$
$$x=r\cos\varphi+\sqrt{l^2-(r\sin\varphi-e)^2}$$
"""


@pytest.mark.parametrize(
    ("change", "outcomes"),
    [
        (("", ""), ["DEFINITION", "DEFINITION", "PROVED", "PROVED", "PROVED"]),
        (("183.294", "138.294"), ["DEFINITION", "DEFINITION", "PROVED", "PROVED", "REFUTED"]),
        # Without a size of its own the letter on the right is given by the others.
        ((", e=20 mm", ""), ["DEFINITION", "DEFINITION", "PROVED", "not judged"]),
    ],
)
def test_a_letter_on_the_right_with_a_size_is_given(
    change: tuple[str, str], outcomes: list[str]
) -> None:
    table = "| $\\varphi$ [°] | $x$ [mm] |\n|---|---|\n| 0 | 208.745 |\n| 60 | 183.294 |\n"
    rows = check("paper.md", f"{OFFSET}\n{table}".replace(*change)).rows
    assert [row.outcome for row in rows] == outcomes, [row.reason for row in rows]
