"""Formulas: the prints of papers become MathML or sentences, and nothing else."""

from __future__ import annotations

import json
import re
from pathlib import Path
from xml.etree.ElementTree import fromstring

import pytest

from mechproof.latex.sentences import is_sentence
from mechproof.report.breaks import FOLDED
from mechproof.report.formulas import write_block, write_lines, write_print
from mechproof.report.mathml import ATTRIBUTES, write_formula
from mechproof.report.phrases import set_prose

LEDGER = Path(__file__).parents[2] / "generated" / "ledger.json"
FIELDS = ("print", "paraphrase", "corrected_latex", "mend_latex", "compared_with")
MATH = "{http://www.w3.org/1998/Math/MathML}"


def prints() -> set[str]:
    ledger = json.loads(LEDGER.read_text(encoding="utf-8"))
    rows = [*ledger["rows"], *ledger["findings"]]
    return {row[field] for row in rows for field in FIELDS if row.get(field)}


def shape(latex: str) -> str:
    """Return the tags and texts of a formula's MathML, without attributes."""
    root = fromstring(write_formula(latex))[0][0]
    return "".join(f"<{e.tag.removeprefix(MATH)}>{e.text or ''}" for e in root.iter())


@pytest.mark.slow
def test_every_formula_of_the_papers_is_converted() -> None:
    known = prints()
    assert len(known) > 500
    for latex in known:
        for written in (write_print(latex), write_lines(latex)):
            element = fromstring(f"<div>{written}</div>")
            assert element.find(".//code") is None, latex
            for part in element.iter():
                # The remains of a command would be shown as they are.
                is_source = part.tag.endswith("annotation")
                assert is_source or "\\" not in (part.text or ""), latex
                if part.tag.startswith(MATH) and not is_source:
                    assert set(part.attrib) - {"class"} <= ATTRIBUTES
                    assert part.get("class", FOLDED) == FOLDED


def test_a_long_left_side_ends_before_its_equals_sign() -> None:
    """It does not break in its arguments, the last of which would begin the next line."""
    arguments = ",".join(f"x_{{{n}}}" for n in range(18))
    written = write_block(rf"f({arguments})=\begin{{pmatrix}}a\\b\end{{pmatrix}}")
    last = written.rsplit("<wbr/>", 1)[-1]
    assert re.match(r'<math[^>]*><semantics><mrow><mo[^>]*form="infix"[^>]*>=</mo>', last)


def test_what_is_no_latex_is_shown_as_it_stands() -> None:
    assert write_formula(r"\left(<b>") == r'<code class="latex">\left(&lt;b&gt;</code>'


def test_text_is_never_markup() -> None:
    for latex in (r"\text{<script>}", "<script>", r"\text{&lt;script&gt;}", r"x_{<script>}"):
        assert "<script" not in write_print(latex)


def test_links_and_styles_are_dropped() -> None:
    for latex in (r"\href{javascript:alert(1)}{x}", r"\class{a}{x}", r"\style{color:red}{x}"):
        attributes = {name for e in fromstring(write_formula(latex)).iter() for name in e.attrib}
        assert attributes <= ATTRIBUTES | {"encoding"}


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\mathrm{tg}x", "<mrow><mtext>tg<mspace><mi>x"),
        (r"2\sin x", "<mrow><mn>2<mspace><mi>sin<mspace><mi>x"),
        (r"2\operatorname{erfc}x", "<mrow><mn>2<mspace><mi>erfc<mspace><mi>x"),
        (r"(a)\cos x", "<mrow><mo>(<mi>a<mo>)<mspace><mi>cos<mspace><mi>x"),
        (r"66~\mathrm{mm}", "<mrow><mn>66<mtext>\N{NO-BREAK SPACE}<mtext>mm"),
        (r"\varphi_3'", "<mrow><msubsup><mi>φ<mn>3<mi>\N{PRIME}"),
        (r"a\pm b", "<mrow><mi>a<mo>±<mi>b"),
        (r"\varphi_3''", "<mrow><msubsup><mi>φ<mn>3<mi>\N{DOUBLE PRIME}"),
        (r"\varphi_3'''", "<mrow><msubsup><mi>φ<mn>3<mi>\N{TRIPLE PRIME}"),
        (r"35^\circ", "<mrow><mrow><mn>35<mi>°"),
        (r"2~\mu\mathrm m", "<mrow><mn>2<mtext>\N{NO-BREAK SPACE}<mtext>µm"),
        (r"\mathrm{IT}6", "<mrow><mtext>IT<mn>6"),
        (r"l\colon 3", "<mrow><mi>l<mtext>:<mspace><mn>3"),
        (r"\operatorname{atan}_{2}{\left(a,b\right)}", None),
    ],
)
def test_what_the_library_leaves_open_is_mended(latex: str, expected: str | None) -> None:
    found = shape(latex)
    assert "atan2" in found if expected is None else found == expected


@pytest.mark.parametrize(
    ("latex", "forms"),
    [
        ("x=-1", [None, "prefix"]),
        ("a-b", [None]),
        (r"[-37,-2]", [None, "prefix", None, "prefix", None]),
        (r"|a|-|b|", ["prefix", "postfix", None, "prefix", "postfix"]),
        (r"a|b", [None]),
    ],
)
def test_signs_and_bars_are_set_close_to_what_they_belong_to(
    latex: str, forms: list[str | None]
) -> None:
    operators = fromstring(write_formula(latex)).iter(f"{MATH}mo")
    assert [part.get("form") for part in operators] == forms


def test_brackets_around_low_things_are_not_stretched() -> None:
    assert 'stretchy="false"' in write_formula(r"\left(a+b\right)")
    assert 'stretchy="false"' not in write_formula(r"\left(\frac ab\right)")


@pytest.mark.parametrize(
    ("latex", "is_one"),
    [
        (r"\text{the two agree}", True),
        (r"e\le1\text{ lets (11) divide by }\sqrt{2}", True),
        (r"0.6\text{ ms}", True),
        (r"D_{\text{printed}}=1", False),
        (r"\left(\text{printed one}\right)", False),
        (r"\int d\text{x\_}", False),
        (r"66~\mathrm{mm}", False),
    ],
)
def test_sentences_are_told_from_formulas(latex: str, is_one: bool) -> None:
    assert is_sentence(latex) is is_one
    assert ("<p " in write_print(latex)) is is_one


def test_a_sentence_keeps_its_blanks_and_escapes() -> None:
    written = write_print(r"\text{the 95 \% interval of x\_1 is }\bar q\pm 2u,\ n=198")
    assert '<p class="sentence">the 95\N{NO-BREAK SPACE}% interval of x_1 is <math' in written


def test_long_formulas_within_words_break_at_commas_and_signs_and_else_scroll() -> None:
    letters = [f"l_{{{a}{b}}}" for a in "ABCDE" for b in "DEF"]
    for sign in (",+", "+"):
        written = write_print(rf"\text{{upper boundary: }}{sign.join(letters)}")
        assert written.count("<math") == 15
        assert 'class="long"' not in written
    assert 'class="long"' in write_print(rf"\text{{as in }}{''.join(letters)}")


@pytest.mark.parametrize(
    ("latex", "pieces"),
    [
        ("a=b+c", ["a=b", "+c"]),
        ("abcdef=-b", ["abcdef", "=\N{MINUS SIGN}b"]),
        (r"f(x,y)=\frac{a+b}{c}", ["f(x,y)", "=a+bc"]),
        (r"a,\ b", ["a,", "b"]),
        (r"a=b,\ c=d", ["a=b,", "c=d"]),
        ("|a-b|<c", ["|a\N{MINUS SIGN}b|", "<c"]),
        (r"\left(\frac ab+c\right)d", ["(ab+c)d"]),
        (r"\sqrt{a+b}", ["a+b"]),
        # Wide brackets may break inside, as long as nothing in them is high.
        (
            "z=2(" + "+".join(f"a_{{{i}}}" for i in range(15)) + ")",
            ["z=2(a0", *(f"+a{i}" for i in range(1, 14)), "+a14)"],
        ),
    ],
)
def test_formulas_break_at_relations_terms_and_commas(latex: str, pieces: list[str]) -> None:
    written = fromstring(write_block(latex))
    found = written.findall(f"{MATH}math")
    rows = [math.find(f".//{MATH}mrow") for math in found]
    assert ["".join(row.itertext()).strip() for row in rows if row is not None] == pieces
    # The first piece carries the LaTeX of the whole formula.
    assert [n.text for n in written.iter(f"{MATH}annotation")] == [latex]
    # Signs at the beginning of the other pieces are spaced like signs between members.
    first = [row[0] for row in rows[1:] if row is not None and row[0].tag == f"{MATH}mo"]
    assert {sign.get("form") for sign in first} <= {"infix"}


@pytest.mark.parametrize(
    ("latex", "signs"),
    [
        ("a=bcdefg", 9),
        ("e+abcd=efghi", 7),
        (r"\frac{abc}{d}", 3),
        ("a^{bcde}", 4),
        (r"\sqrt{a}", 2),
        (r"\begin{pmatrix}a&b\\ab&c\end{pmatrix}", 5),
    ],
)
def test_the_widest_piece_says_how_small_a_formula_is(latex: str, signs: int) -> None:
    assert f'style="--signs:{signs}"' in write_block(latex)


TERMS = [f"a_{{{i}}}" for i in range(15)]
SUM = "+".join(TERMS)


@pytest.mark.parametrize(
    ("latex", "lines"),
    [
        (rf"\sqrt{{{SUM}}}", ["a0+a1+a2+a3+a4+a5+a6", "+a7+a8+a9+a10+a11+a12", "+a13+a14"]),
        (rf"\frac{{{SUM}}}{{b}}", ["a0+a1+a2+a3+a4+a5+a6", "+a7+a8+a9+a10+a11+a12", "+a13+a14"]),
        (
            rf"\left(\frac ab,{SUM}\right)",
            ["ab,a0+a1+a2+a3+a4+a5+a6", "+a7+a8+a9+a10+a11+a12", "+a13+a14"],
        ),
        (r"\begin{pmatrix}a+b+c&d\\e&f\end{pmatrix}", []),
        (rf"\begin{{pmatrix}}{SUM}&d\\e&f\end{{pmatrix}}", 6 * [""]),
        (rf"\left({SUM}\right)^2", ["a0+a1+a2+a3+a4+a5+a6", "+a7+a8+a9+a10+a11+a12", "+a13+a14"]),
        # A numerator is folded no narrower than its denominator.
        (
            rf"abcdefghijklmnop\frac{{{SUM}}}{{{''.join(TERMS[:14])}}}",
            ["a0+a1+a2+a3+a4+a5+a6", "+a7+a8+a9+a10+a11", "+a12+a13+a14"],
        ),
        (rf"\sqrt{{{''.join(TERMS)}}}", []),
        (r"\sqrt{a+b}", []),
    ],
)
def test_what_is_wide_within_a_root_a_fraction_or_brackets_is_folded(
    latex: str, lines: list[str]
) -> None:
    written = fromstring(write_block(latex))
    tables = [t for t in written.iter(f"{MATH}mtable") if t.get("class") == FOLDED]
    cells = [cell for table in tables for cell in table.iter(f"{MATH}mtd")]
    assert [len(cell) for cell in cells] == [1 for _ in lines]
    if any(lines):
        assert ["".join(cell.itertext()) for cell in cells] == lines
    # Nothing is lost, and the style gives the folded width if there is one.
    plain = "".join(fromstring(write_formula(latex))[0][0].itertext())
    assert "".join(written.itertext()).removesuffix(latex) == plain
    assert ("--folded:" in written.attrib["style"]) is bool(lines)


def test_lists_of_formulas_stand_below_each_other_and_once() -> None:
    written = write_lines(
        r"a=b,\quad \text{(too long to be shown)},\quad \text{(too long to be shown)}"
    )
    assert written.count('class="formula"') == 1
    assert written.count("too long") == 1


def test_marked_words_stand_within_their_sentence() -> None:
    written = write_print(
        r"\text{the interval of }{\color{green}{\text{the mean of }}}\text{errors}"
    )
    assert '<span class="put">the mean of </span>errors' in written
    # Only our own colours are marks.
    other = write_print(r"\text{the interval of }{\color{blue}{\text{the mean of }}}\text{errors}")
    assert "<span" not in other


def test_a_comma_between_words_and_a_formula_stays() -> None:
    long = r"M=1.08^\circ(1+\max\varphi)=10.1^\circ,\ 14.7^\circ"
    written = write_print(rf"\text{{as in variants 1 and 2}},\ {long}")
    assert "variants 1 and 2, <" in written


def test_marked_decimals_stand_close_to_their_point() -> None:
    assert shape(r"0.{\color{red}{28}}").startswith("<mrow><mn>0<mn>.<")


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("K_i[2] = 1/3", "K<sub>2</sub>\N{NO-BREAK SPACE}= 1/3"),
        ("Delta_n^2*K_i[i]^2 has L^2", "Δ<sub>n</sub>²·K<sub>i</sub>² has L²"),
        ('see "step 3", sqrt(2)', "see “step 3”, √2"),
        ("25 um of 5 mm", "25\N{NO-BREAK SPACE}µm of 5\N{NO-BREAK SPACE}mm"),
        ("Max(a, b) <= 2", "max(a, b)\N{NO-BREAK SPACE}≤ 2"),
        (
            "x_1*y = phi1 < 2",
            "x<sub>1</sub>·y\N{NO-BREAK SPACE}= φ<sub>1</sub>\N{NO-BREAK SPACE}&lt; 2",
        ),
        ("R_1 phi_1", "R<sub>1</sub>\N{NO-BREAK SPACE}φ<sub>1</sub>"),
        (
            "the link 5' and x_5' of it, not 'step 5'",
            "the link 5\N{PRIME} and x<sub>5</sub>\N{PRIME} of it, "
            "not \N{LEFT SINGLE QUOTATION MARK}step 5\N{RIGHT SINGLE QUOTATION MARK}",
        ),
        ("(Abs(a) + 2)", "(|a|\N{NO-BREAK SPACE}+ 2)"),
        ("D^XYZ**2", "D<sup>XYZ²</sup>"),
        ("d phi3/d phi1", "dφ<sub>3</sub>/dφ<sub>1</sub>"),
        (
            r"-\dot{\psi}*l*cos(\psi)^3 of x_{1}, \hat{n}",
            "\N{MINUS SIGN}\N{GREEK SMALL LETTER PSI}\N{COMBINING DOT ABOVE}·l·"
            "cos(\N{GREEK SMALL LETTER PSI})³ of x<sub>1</sub>, n\N{COMBINING CIRCUMFLEX ACCENT}",
        ),
        ("variants 1 and 2 a year", "variants 1 and 2 a year"),
        (
            "tg 20 deg of 3 sigma",
            "tg\N{NO-BREAK SPACE}20° of 3\N{NO-BREAK SPACE}\N{GREEK SMALL LETTER SIGMA}",
        ),
    ],
)
def test_formulas_within_words_are_set_as_people_write_them(text: str, shown: str) -> None:
    assert str(set_prose(text)) == shown
