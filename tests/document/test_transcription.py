"""The file with a paper's prints: letters and rows that a derivation takes from it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
import sympy as sp

from mechproof.derivation import DerivationError, load_paper
from mechproof.document.transcription import Transcription
from mechproof.nomenclature.block import BlockError
from mechproof.pipeline.verification import judge_derivations
from mechproof.proof.verdict import State, Verdict
from mechproof.record import ANGLE, Claim, Correction, Equation, Variable

PAPER = r"""
%% mechproof
%% \varphi_1 as phi1 : angle of the crank; positive to the left [rad]
%% R_1 as R1 : its radius [mm] {R_1>0}
%% e : eccentricity [1] {0\le e<1}
%% \lambda | \frac{e}{2} : half of it
%% factor R_1
%% where e<R_1
%% end
\begin{equation}x=R_1\cos\varphi_1,\quad y=R_1\sin\varphi_1\tag{1}\label{place}\end{equation}
\[e\ge0\tag*{the domain}\label{domain}\cite{S6,S48}\cite{S9}\]
"""
MODULE = """
from pathlib import Path
from sympy import Symbol, cos, sin
from mechproof.document.transcription import Transcription
from mechproof.record import LENGTH, Paper, Variable

PRINT = Transcription(Path(__file__).with_name("paper.tex"))
r, phi, c, s = PRINT.symbols("r phi c s")
PAPER = Paper(
    system="crank",
    citation="my notes",
    variables=PRINT.give({c: r * cos(phi)}),
    rows=(PRINT.equation("(2)", derived={s: r * sin(phi)}),),
    print=PRINT.file,
)
"""
CRANK = r"""
%% mechproof
%% r : a length [mm]
%% \varphi as phi : an angle [rad]
%% c ; s : coordinates [mm]
%% end
\[\cos^2\varphi+\sin^2\varphi=1\tag{1}\]
\[s=r\sin\varphi\tag{2}\]
\[c=r\cos\varphi\tag{3}\]
\[q=r\tag{4}\]
\[c=r\sin\varphi\tag{5}\]
"""
Write = Callable[[str], Transcription]


@pytest.fixture
def write(tmp_path: Path) -> Write:
    def make(content: str) -> Transcription:
        file = tmp_path / "paper.tex"
        file.write_text(content)
        return Transcription(file)

    return make


def test_letters_have_the_names_meanings_and_sets_of_the_block(write: Write) -> None:
    paper = write(PAPER)
    phi1, radius, e = paper.symbols("phi1 R1 e")
    angle, length, *_ = paper.variables
    assert (angle.symbol, angle.dimension) == (phi1, ANGLE)
    assert (angle.meaning, angle.sign) == ("angle of the crank", "positive to the left")
    assert (radius.is_positive, length.within) == (True, sp.Interval.open(0, sp.oo))
    assert e.is_nonnegative is None
    assert paper.where == (e < radius,)


def test_a_condition_may_have_braces_of_its_own(write: Write) -> None:
    paper = write(r"""
%% mechproof
%% l_{AB} as l : length of \vec{AB} [mm] {l_{AB}>0}
%% \alpha_{1} as alpha : angle [rad] {0<\alpha_{1}<\frac{\pi}{\sqrt{4}}}
%% v : velocity of \vec{AB}
%% end
""")
    length, angle, velocity = paper.variables
    assert (length.meaning, length.symbol.is_positive) == (r"length of \vec{AB}", True)
    assert angle.within == sp.Interval.open(0, sp.pi / 2)
    assert velocity.meaning == r"velocity of \vec{AB}"


def test_rows_have_the_whole_print_of_their_display(write: Write) -> None:
    paper = write(PAPER)
    row = paper.equation("(1)", note="both")
    assert isinstance(row, Equation)
    assert row == Equation("(1)", r"x=R_1\cos\varphi_1,\quad y=R_1\sin\varphi_1", note="both")
    assert paper.equation("place").printed_latex == row.printed_latex
    cites = ("S6", "S48", "S9")
    assert paper.claim("the domain") == Claim("the domain", r"e\ge0", cites=cites)
    assert paper.claim("domain", cites=()) == Claim("domain", r"e\ge0")
    assert paper.find("(1)") == row.printed_latex


def test_members_of_displays_are_read_in_letters_of_the_block_or_given_ones(write: Write) -> None:
    paper = write(PAPER.replace(r"e\ge0", r"e=\lambda"))
    e, half = paper.symbols("e lambda")
    assert paper.reader()("the domain") == (e, half)
    other = sp.Symbol("other")
    read = paper.reader(
        [Variable(other, "", latex=("e",)), Variable(half, "", latex=(r"\lambda",))]
    )
    assert read("the domain") == (other, half)
    with pytest.raises(ValueError, match=r"it has no display \(2\)$"):
        read("(2)")


def test_a_correction_is_a_print_with_something_else_in_it(write: Write) -> None:
    paper = write(PAPER + r"\[r=\rho+r_0\tag{9}\]")
    assert paper.mend("the domain", "0", "1") == Correction(r"e\ge1")
    assert paper.mend("(9)", "r", "q") == Correction(r"q=\rho+q_0")
    assert paper.mend("(9)", r"\rho", "q") == Correction("r=q+r_0")


@pytest.mark.parametrize(("old", "new"), [("2", "1"), ("", "1"), ("0", "0"), ("g", "h")])
def test_a_correction_changes_what_is_printed(write: Write, old: str, new: str) -> None:
    paper = write(PAPER)
    with pytest.raises(
        ValueError, match=rf"'{new}' for '{old}' does not change display the domain"
    ):
        paper.mend("the domain", old, new)


def test_values_are_given_to_letters_of_the_block_only(write: Write) -> None:
    paper = write(PAPER)
    e, half = paper.symbols("e lambda")
    given = {v.symbol: v.given for v in paper.give({half: e / 2})}
    assert given[half] == e / 2
    assert given[e] is None
    with pytest.raises(ValueError, match=r"its block does not declare k$"):
        paper.give({sp.Symbol("k"): e})


@pytest.mark.parametrize(
    ("ask", "told"),
    [
        (lambda paper: paper.symbols("phi1 psi k"), r"its block does not declare psi, k$"),
        (lambda paper: paper.equation("(2)"), r"it has no display \(2\)$"),
    ],
)
def test_what_is_not_there_is_refused(
    write: Write, ask: Callable[[Transcription], object], told: str
) -> None:
    with pytest.raises(ValueError, match=told):
        ask(write(PAPER))


def test_two_displays_of_one_name_are_refused(write: Write) -> None:
    with pytest.raises(ValueError, match=r"two displays are called \(1\)"):
        write(r"$$a=b\tag{1}$$ $$b=c\tag{1}$$")
    with pytest.raises(BlockError, match="neither a letter"):
        write("%% mechproof\n%% no colon\n%% end\n")


def test_what_the_module_has_no_row_for_is_judged_without_mechanics(tmp_path: Path) -> None:
    (tmp_path / "paper.tex").write_text(CRANK)
    module = tmp_path / "crank.py"
    module.write_text(MODULE)
    (ledger,) = judge_derivations([module], use_cache=False)
    assert [(row.number, row.verdict) for row in ledger.judgements] == [
        ("(1)", Verdict.PROVED),
        ("(2)", Verdict.PROVED),
        ("(3)", Verdict.DEFINITION),
        ("(5)", Verdict.REFUTED),
    ]
    assert [row.number for row in ledger.paper.rows] == ["(1)", "(2)", "(3)", "(4)", "(5)"]
    assert [(row.number, row.state) for row in ledger.left] == [("(4)", State.NOT_READ)]
    assert [finding.number for finding in ledger.findings] == ["(5)"]
    assert {row.system for row in ledger.judgements} == {"crank"}


def test_rows_of_the_module_alone_stay_where_they_are(tmp_path: Path) -> None:
    (tmp_path / "paper.tex").write_text(CRANK)
    row = 'PRINT.equation("(2)", derived={s: r * sin(phi)})'
    fifth = row.replace("(2)", "(5)").replace("s: r * sin", "c: r * cos")
    first, last = (f'Claim("{name}", "", says=Holds(r**2 >= 0))' for name in ("first", "last"))
    module = tmp_path / "crank.py"
    text = MODULE.replace("LENGTH,", "LENGTH, Claim, Holds,")
    module.write_text(text.replace(row, f"{first}, {fifth}, {row}, {last}"))
    (ledger,) = judge_derivations([module], use_cache=False)
    numbers = [judged.number for judged in ledger.judgements]
    assert numbers == ["first", "(1)", "(5)", "(2)", "(3)", "last"]


def test_a_row_of_another_name_is_known_by_its_print(tmp_path: Path) -> None:
    (tmp_path / "paper.tex").write_text(CRANK)
    module = tmp_path / "crank.py"
    row = 'PRINT.equation("(2)", derived={s: r * sin(phi)})'
    renamed = f'replace({row}, number="(2), as meant")'
    module.write_text("from dataclasses import replace" + MODULE.replace(row, renamed))
    (ledger,) = judge_derivations([module], use_cache=False)
    numbers = [judged.number for judged in ledger.judgements]
    assert sorted(numbers) == ["(1)", "(2), as meant", "(3)", "(5)"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("row", "numbers"),
    [
        ("", ["sizes, first equals sign", "sizes, second equals sign"]),
        (
            'PRINT.datum("sizes", all_of(Definition(r, 2 * r), Definition(phi, 3 * phi))),',
            ["sizes"],
        ),
        (
            'PRINT.datum("sizes", Definition(r, 2 * r)),',
            ["sizes, first equals sign", "sizes", "sizes, second equals sign"],
        ),
    ],
)
def test_what_states_as_many_things_judges_all_signs_of_a_display(
    tmp_path: Path, row: str, numbers: list[str]
) -> None:
    (tmp_path / "paper.tex").write_text(CRANK + r"\[r=2~\mathrm{mm},\ \varphi=3\tag*{sizes}\]")
    module = tmp_path / "crank.py"
    text = MODULE.replace("LENGTH,", "LENGTH, Definition, all_of,")
    module.write_text(text.replace("rows=(", f"rows=({row}"))
    (ledger,) = judge_derivations([module], use_cache=False)
    found = [one.number for one in ledger.paper.rows if one.number.startswith("sizes")]
    assert sorted(found) == sorted(numbers)


def test_a_print_that_cannot_be_read_is_an_error_of_the_derivation(tmp_path: Path) -> None:
    (tmp_path / "paper.tex").write_text("%% mechproof\n%% no colon\n%% end\n")
    (tmp_path / "crank.py").write_text(MODULE)
    with pytest.raises(DerivationError, match=r"paper\.tex:2:4"):
        load_paper(tmp_path / "crank.py")
