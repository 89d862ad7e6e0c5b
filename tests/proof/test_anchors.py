"""Anchor names of a report's rows, and the typesetting of its prose."""

from __future__ import annotations

from mechproof.proof.anchors import find_equation, find_only_equation, name_anchors, slugify
from mechproof.proof.verdict import Verdict
from mechproof.report.phrases import LOOKS, set_numbers, set_prose, set_reason, set_value


def test_rows_are_named_by_their_numbers() -> None:
    assert name_anchors(
        ["(12)", "(10), third equals sign", "table 3, interval 3", "(2a)", "(1)-(11), sense"]
    ) == {
        "(12)": "eq-12",
        "(10), third equals sign": "eq-10-third-equals-sign",
        "table 3, interval 3": "row-table-3-interval-3",
        "(2a)": "eq-2a",
        "(1)-(11), sense": "row-1-11-sense",
    }


def test_names_are_unique_whatever_the_numbers_are() -> None:
    numbers = ["(1)", "(1) ", "(1)!", "***", "!!!", "a 2", "a", "a!", "(1) 2"]
    names = name_anchors(numbers)
    assert len(set(names.values())) == len(numbers)
    assert names["(1)"] == "eq-1"


def test_letters_of_any_script_stay() -> None:
    assert slugify("Größe Ω, Формула (3)") == "grösse-ω-формула-3"


def test_the_equation_of_a_row() -> None:
    assert [find_equation(n) for n in ("(3)", "(3), Ox", "(3) over all", "(3)-(5)", "x")] == [
        *("3", "3", "3", "", "")
    ]


def test_a_row_about_several_equations_is_about_none_alone() -> None:
    rows = ("(3), Ox", "(1), (3), (7), substituted", "(7) and (8), R", "table 1")
    assert [find_only_equation(row) for row in rows] == ["3", "", "", ""]


def test_every_verdict_has_its_look() -> None:
    assert set(LOOKS) == set(Verdict)
    assert len({look.sign for look in LOOKS.values()}) == len(LOOKS)


def test_numbers_are_set_as_people_write_them() -> None:
    assert set_numbers("[2.30789 +/- 4.01e-12] (132°)") == "2.30789 ± 4.01·10⁻¹² (132°)"
    assert set_numbers("|x| <= 2**26, 1e-290, 11e3") == "|x| ≤ 2²⁶, 10⁻²⁹⁰, 11·10³"
    assert set_numbers("K_i[1] = 2") == "K_i[1] = 2"
    assert set_value("pi/6*x (30°)") == "π/6·x (30°)"


def test_names_in_sentences_are_set_as_letters_with_indices() -> None:
    assert set_prose("x_5 at phi1 = 12 um, beta_DE; a rod R2") == (
        "x<sub>5</sub> at φ<sub>1</sub>\N{NO-BREAK SPACE}=\N{NO-BREAK SPACE}12\N{NO-BREAK SPACE}"
        "\N{MICRO SIGN}m, β<sub>DE</sub>; "
        "a rod R<sub>2</sub>"
    )
    assert set_prose("cos^2(x/2) <= (12), IT8, C99, tan_alpha, Delta h") == (
        "cos²(x/2)\N{NO-BREAK SPACE}≤ (12), IT8, C99, tan_alpha, Δ h"
    )
    assert set_prose("Delta_n**2*K, tau**2, x1**2, C99") == (
        "Δ<sub>n</sub>²·K, τ², x<sub>1</sub>², C99"
    )
    assert set_prose("<b_1> & pi") == "&lt;b<sub>1</sub>&gt; &amp; π"
    assert set_prose("dphi3/dphi1, dy9, dS, K^T p, T^-1, e**nu") == (
        "dφ<sub>3</sub>/dφ<sub>1</sub>, dy<sub>9</sub>, dS, K<sup>T</sup> p, T⁻¹, "
        "e<sup>\N{GREEK SMALL LETTER NU}</sup>"
    )


def test_signs_roots_and_quotes_in_sentences_are_set_as_people_write_them() -> None:
    minus, left, right = (
        "\N{MINUS SIGN}",
        "\N{LEFT SINGLE QUOTATION MARK}",
        "\N{RIGHT SINGLE QUOTATION MARK}",
    )
    assert set_prose("-3 at [-40, -E_c], A-C, 4-5, --out, x - 1") == (
        f"{minus}3 at [{minus}40, {minus}E<sub>c</sub>], A-C, 4-5, --out, "
        f"x\N{NO-BREAK SPACE}{minus} 1"
    )
    assert set_prose("u sqrt(n), sqrt(2*x) of (13)-(16)") == ("u √n, √(2·x) of (13)\N{EN DASH}(16)")
    assert set_prose("the paper's 'Table 1, (b)' of x5'") == (
        f"the paper{right}s {left}Table 1, (b){right} of x<sub>5</sub>\N{PRIME}"
    )
    assert set_reason("both hold") == "Both hold."
    assert set_reason("j has no value.") == "j has no value."
    assert set_reason("a constraint") == "A constraint."
