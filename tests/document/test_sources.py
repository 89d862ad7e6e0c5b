"""Files of a paper: what they input, where the block of letters is, what is refused."""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path

import pytest
import sympy as sp

from mechproof.document.checking import check
from mechproof.document.drafts.draft import draft_block
from mechproof.document.source_rows import Document
from mechproof.nomenclature.block import BlockError, read_block
from mechproof.proof.verdict import Verdict
from mechproof.record import LENGTH, NUMBER, SPEED, Dimension
from mechproof.record.unit_notation import UnitError, read_unit
from mechproof.sources.paper_files import DocumentError, read_source


def test_files_are_input_inside_of_the_folder(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "one.tex").write_text("$$a=1$$")
    (tmp_path.parent / "outside.tex").write_text("$$c=1$$")
    paper = tmp_path / "paper.tex"
    paper.write_text("\\input{parts/one}\n\\input{none}\n\\input{../outside}\n% \\input{no}\n")
    source = read_source(str(paper))
    assert "$$a=1$$" in source.text.string
    assert "c=1" not in source.text.string
    told = [(place.line, reason) for place, reason in source.missing]
    assert [line for line, _ in told] == [2, 3]
    assert "no such file" in told[0][1]
    assert "outside" in told[1][1]


def test_files_in_a_circle_are_told(tmp_path: Path) -> None:
    paper = tmp_path / "paper.tex"
    paper.write_text(r"\input{paper}")
    with pytest.raises(DocumentError, match="input each other"):
        read_source(str(paper))


def test_a_file_that_cannot_be_read_is_told(tmp_path: Path) -> None:
    with pytest.raises(DocumentError, match="No such file"):
        read_source(str(tmp_path / "none.tex"))
    (tmp_path / "latin.tex").write_bytes("é".encode("latin-1"))
    with pytest.raises(DocumentError, match="UTF-8"):
        read_source(str(tmp_path / "latin.tex"))


@pytest.mark.parametrize(
    "latex", ["a+b=b+a", r"x=\frac{1}{2}", "x=0.5", "a=b\0", "a+" * 4000 + "a=b"]
)
def test_a_pasted_equation_is_told_its_function(latex: str) -> None:
    with pytest.raises(DocumentError, match=r"use mechproof\.judge_equation"):
        check(latex)


def test_a_name_of_a_paper_is_not_taken_for_an_equation() -> None:
    with pytest.raises(DocumentError, match=r"none\.tex: No such file"):
        check("none.tex")


def test_the_block_may_lie_beside_the_paper(tmp_path: Path) -> None:
    (tmp_path / "paper.tex").write_text("$$a=1$$")
    (tmp_path / "paper.letters").write_text(
        "%% mechproof\n# a comment\na : a length [mm]\n%% end\n"
    )
    source = read_source(str(tmp_path / "paper.tex"))
    assert [line.string for line in source.lines] == ["a : a length [mm]"]
    assert source.has_block


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("a.tex", "%% mechproof\n%% a : length\n%% end\n"),
        ("a.md", "<!-- mechproof\na : length\n-->\n"),
        ("a.md", "# Text\n%% mechproof\n%% a : length\n%% end\n"),
    ],
)
def test_the_block_stands_in_comments(name: str, content: str) -> None:
    source = read_source(name, content)
    assert [line.string for line in source.lines] == ["a : length"]
    assert "length" not in source.text.string
    with pytest.raises(DocumentError, match="has no end"):
        read_source(name, content.replace("%% end", "").replace("-->", ""))


WRONG = [
    ("a", "neither a letter"),
    ("7 : number", "has no letter"),
    ("skip (3)", "give the reason"),
    ("a_{b : one", "unbalanced braces"),
    ("constraint", "give the number"),
    ("factor", "nothing follows"),
    ("a : one {a>0", "a brace is not closed"),
    (r"branch \sigma=2", r"letter=\\pm1"),
]


@pytest.mark.parametrize(("line", "reason"), WRONG)
def test_a_line_that_is_not_understood_is_told_with_its_place(line: str, reason: str) -> None:
    source = read_source("paper.tex", f"%% mechproof\n%% {line}\n%% end\n")
    with pytest.raises(BlockError, match=rf"^paper\.tex:2:4: .*{reason}"):
        read_block(source.lines, source.files)


TWICE = [
    ("a : one\n%% a : two", "declared twice"),
    ("a : one\n%% {a} : two", "too similar"),
    ("a(t) : one\n%% \\dot a : two\n%% \\dot{a} : three", "declared twice"),
    ("a(t) : one [mm]\n%% t : time [s]\n%% \\dot a : two [mm]", r"derivative .* cannot be \[mm\]"),
    ("a : one {a>1}\n%% where a<0", "no value of a"),
    ("a : one\n%% sizes a>1", "letter=number"),
    ("a : one [mm]\n%% sizes a=1 s", r"declared in \[mm\]"),
    ("a : one\n%% sizes a=1 m", r"declared in \[\]"),
    ("a : one\n%% let a=a+1", "defined by itself"),
    ("a : one\n%% let a>1", "letter=expression"),
    ("a : one\n%% branch b=\\pm1", "not declared"),
    ("a : one\n%% natural n", "not declared"),
    ("a : one\n%% where a<", "something must follow"),
    ("a : one\n%% let b=1", "b is not declared"),
    ("a : one\n%% from b", "b is not declared"),
    ("a : one\n%% skip (7): no", r"no equation has the name or label \(7\)"),
    ("a : one\n%% in (7): A is a", "no equation"),
    ("a : one\n%% in (7): A is b", "b is not declared"),
]


def test_all_faults_of_a_block_are_told_at_once() -> None:
    lines = ["a : one", "a : two", "where a<", "natural k", "skip (7): no"]
    block = "".join(f"%% {line}\n" for line in lines)
    with pytest.raises(BlockError) as refused:
        check("paper.tex", f"%% mechproof\n{block}%% end\n$$a=1$$")
    told = re.findall(r"^paper\.tex:(\d+):4: ", str(refused.value), re.MULTILINE)
    assert told == ["3", "4", "5", "6"]


def test_a_line_of_a_block_may_begin_with_one_sign_of_percent() -> None:
    content = "%% mechproof\n% a ; b : lengths [m]\n%% end\n$$(a+b)(a-b)=a^2-b^2$$"
    assert [row.judgement.verdict for row in check("paper.tex", content).rows] == [Verdict.PROVED]


@pytest.mark.parametrize(("lines", "reason"), TWICE)
def test_letters_that_do_not_go_together_are_told(lines: str, reason: str) -> None:
    source = read_source("paper.tex", f"%% mechproof\n%% {lines}\n%% end\n")
    last = 2 + lines.count("\n")
    with pytest.raises(ValueError, match=rf"(?s)^paper\.tex:{last}:4: .*{reason}"):
        Document(source)


UNITS = {
    "mm": LENGTH,
    "": NUMBER,
    "1": NUMBER,
    "mm/s": SPEED,
    "m s^-1": SPEED,
    "1/s": Dimension(time=-1),
    "m/s^2": Dimension(length=1, time=-2),
    "N m": Dimension(length=2, mass=1, time=-2),
    "kg·m^{2}": Dimension(length=2, mass=1),
    "V/A": Dimension(length=2, mass=1, time=-3, current=-2),
    "N m/A": Dimension(length=2, mass=1, time=-2, current=-1),
    "Ns/m": Dimension(mass=1, time=-1),
    "N m^{-3/2}": Dimension(length=Fraction(-1, 2), mass=1, time=-2),
    "J/(mol K)": Dimension(length=2, mass=1, time=-2, temperature=-1, amount=-1),
}
# Pairs of equal units.
ALIKE = {
    "V A": "W",
    "Ω": "V/A",
    "kΩ": "k\u2126",
    "F V": "A s",
    "H A": "Wb",
    "T m^2": "Wb",
    "S": "1/Ω",
    "V s/rad": "N m/A",
}


@pytest.mark.parametrize("text", UNITS)
def test_units_have_dimensions(text: str) -> None:
    assert read_unit(text).dimension == UNITS[text]


@pytest.mark.parametrize(("one", "other"), ALIKE.items())
def test_electrical_units_are_those_of_the_others(one: str, other: str) -> None:
    assert read_unit(one) == read_unit(other)


def test_units_have_sizes() -> None:
    assert read_unit("mH").scale == read_unit("A/V ms").scale / read_unit("S^2").scale
    assert read_unit("µF").scale == read_unit("uF").scale == sp.Rational(1, 10**6)
    assert read_unit("N mm").scale == sp.Rational(1, 1000)
    assert read_unit("km/h").scale == sp.Rational(5, 18)
    assert read_unit("deg/s").scale == sp.pi / 180
    assert read_unit("rpm").scale == sp.pi / 30


def test_an_unknown_unit_is_told() -> None:
    with pytest.raises(UnitError, match="'mile'"):
        read_unit("mile/h")


@pytest.mark.parametrize("name", ["a.tex", "a.md"])
def test_a_draft_is_read_as_it_comes(name: str, tmp_path: Path) -> None:
    text = "\nThe radius $r$ of the wheel.\n$$u=2\\pi r$$\n"
    block = draft_block(read_source(name, text))
    assert any("radius" in line.string for line in read_source(name, f"{block}{text}").lines)
    # The same holds in a file of its own.
    (tmp_path / name).write_text(text)
    (tmp_path / "a.letters").write_text(block)
    beside = read_source(str(tmp_path / name))
    assert [x.string for x in beside.lines] == [x.string for x in read_source(name, block).lines]
