"""Entries of a block for more than plain letters: meanings valid in a range, families."""

from __future__ import annotations

import pytest
from small_papers import judge_parts

from mechproof.document.checking import check
from mechproof.nomenclature.block import BlockError

pytestmark = pytest.mark.usefixtures("judged_here")

LETTERS = r"""%% mechproof
%% \alpha ; \beta : angles [rad]
%% A : area [mm^2]
%% r ; x ; y : lengths [mm]
%% A_r 2x2 : rotation
%% m_i (i) : masses [kg]
%% x_i (i) : places [mm]
%% x_1 : first place [mm]
%% c_{ij} (i,j) : coefficients
%% S ; M : sums
%% n : their number
%% natural n
"""
ROTATION = r"A=\begin{pmatrix}\cos\alpha&-\sin\alpha\\\sin\alpha&\cos\alpha\end{pmatrix}"
AREA = r"A=\pi r^2"


def outcomes(*equations: str, block: str = "") -> list[str]:
    return judge_parts(f"{LETTERS}{block}%% end\n", *equations)


def test_a_print_means_another_letter_in_a_range_of_equations() -> None:
    equations = [
        AREA,
        ROTATION,
        r"AA^T=\begin{pmatrix}1&0\\0&1\end{pmatrix}",
        r"\det A=\cos\beta",
        r"A=\pi r^2\cos^2\beta+\pi r^2\sin^2\beta",
        r"A=\frac{\pi r^2}{4}",
    ]
    found = outcomes(*equations, block="%% in (2)-(4): A is A_r\n")
    assert found == ["DEFINITION", "DEFINITION", "PROVED", "DEFINITION", "PROVED", "REFUTED"]
    assert outcomes(*equations, block="%% in (2), (3), (4): A is A_r\n") == found
    assert outcomes(*equations)[1:4] == ["not read"] * 3


def test_the_derivative_of_a_matrix_has_a_line_of_its_own() -> None:
    with pytest.raises(BlockError, match=r"its own line, .dot q 2x1"):
        outcomes(r"x=2y", block="%% q 2x1 (t) : angles\n")
    block = "%% q 2x1 : angles\n%% \\dot q 2x1 : rates\n%% v 2x1 : speeds\n"
    assert outcomes(r"v=A_r\dot q", block=block) == ["DEFINITION"]


def test_letters_of_one_line_may_have_shapes_of_their_own() -> None:
    block = "%% B [2x3] ; v ; w 3x1 : matrices\n"
    equations = (
        r"v=(1, 0, 0)^T",
        r"w=(0, 0, n)^T",
        r"w^Tv=0",
        r"B=\begin{pmatrix}1&2&3\\0&0&n\end{pmatrix}",
    )
    assert outcomes(*equations, r"(Bw)^T=(3n, n^2)", block=block)[2:] == [
        "PROVED",
        "DEFINITION",
        "PROVED",
    ]


def test_labels_may_name_the_ends_of_a_range() -> None:
    equations = [AREA, rf"\label{{eq:turn}}{ROTATION}", r"\label{eq:last}\det A=1", r"A=2\pi r^2"]
    found = outcomes(*equations, block="%% in eq:turn - eq:last: A is A_r\n")
    assert found == ["DEFINITION", "DEFINITION", "PROVED", "REFUTED"]


# Lines of a block with a name that no print can have, and the message about it.
FAULTY = {
    r"x^{{2} | x_0 : length": "",
    r"\dot{\text}{u} : speed": r"the name \dot{\text}{u}: a { is missing here; it is left out",
    r"u | x(y) ; x(y)(t) : speed": "the name x(y) is also that of u; it is left out",
}


@pytest.mark.parametrize("line", FAULTY)
def test_a_name_that_cannot_be_read_spoils_no_other_row(line: str) -> None:
    if not FAULTY[line]:
        with pytest.raises(BlockError, match="unbalanced braces"):
            outcomes(AREA, block=f"%% {line}\n")
        return
    text = f"{LETTERS}%% {line}\n%% end\n$${AREA}$$ $${AREA}/2$$"
    found = check("paper.tex", text)
    assert [row.outcome for row in found.rows] == ["DEFINITION", "REFUTED"]
    ((place, reason),) = found.told
    assert (place.line, reason) == (13, FAULTY[line])


FAMILIES = {
    r"S=\sum_{i=1}^n m_ix_i^2": ["DEFINITION"],
    r"S=\sum_{i=1}^n m_ix_i^2=\sum_{k=1}^n x_km_kx_k": ["DEFINITION", "PROVED"],
    r"S=\sum_{i=1}^n m_ix_i^2=2\sum_{k=1}^n m_kx_k^2": ["DEFINITION", "REFUTED"],
    r"S=\sum_{i=1}^n m_ix_i^2=\sum_{k=1}^n m_ix_k^2": ["DEFINITION", "ILL_FORMED"],
    r"S=\sum_{i=1}^n\sum_{j=1}^n c_{ij}=\sum_{k=1}^n\sum_{j=1}^n c_{kj}": ["DEFINITION", "PROVED"],
    r"\sum_{k=0}^{n-1}\cos(\alpha+\frac{2\pi k}{n})=0": ["DEFINITION"],
    r"S=\sum_{k=0}^{n-1}\cos(\alpha+2\pi k)=n\sin\alpha": ["DEFINITION", "REFUTED"],
    r"M=x_1+x=x+x_1": ["DEFINITION", "PROVED"],
    r"M=x_1+x=x+2x_1": ["DEFINITION", "REFUTED"],
    r"M=x_i": ["ILL_FORMED"],
}


@pytest.mark.parametrize("latex", FAMILIES)
def test_families_stand_beside_letters_and_members(latex: str) -> None:
    assert outcomes(latex) == FAMILIES[latex]


@pytest.mark.parametrize(
    ("line", "error"),
    [
        ("in (9): A is A_r", ValueError),
        ("in (1): A is B", ValueError),
        ("in (1): A", BlockError),
        ("in (1)", BlockError),
    ],
)
def test_a_scope_that_cannot_be_meant_is_refused(line: str, error: type[Exception]) -> None:
    with pytest.raises(error, match="in"):
        outcomes(AREA, block=f"%% {line}\n")


ROOTS = [r"\sqrt{a^2}=a", r"\sqrt{b^2}=b", r"\sqrt{(b-2)^2}=2-b"]
SAID = {
    "{a>0} {b>0} {b<2}": ["PROVED", "PROVED", "PROVED"],
    "{a>0}{0<b, b<2}": ["PROVED", "PROVED", "PROVED"],
    "{a>0} {b<2}": ["PROVED", "DEFINITION", "PROVED"],
    r"a length \frac{a}{b}": ["DEFINITION", "DEFINITION", "not judged"],
}


@pytest.mark.parametrize("said", SAID)
def test_all_braces_of_a_line_hold(said: str) -> None:
    assert outcomes(*ROOTS, block=f"%% a ; b : lengths [1] {said}\n") == SAID[said]


def test_factors_are_parted_by_commas_or_semicolons() -> None:
    for sign in (",", " ;"):
        assert outcomes("r=S(M+x)=M(S+x)", block=f"%% factor S{sign} M\n")[-1] == "REFUTED"
    assert outcomes("r=S(M+x)=M(S+x)", block="%% factor S\n") == ["not read"]


def test_names_may_have_what_parts_others_in_their_braces() -> None:
    lines = (
        r"x_{k|k-1} | \hat x ; V_{a;0} : lengths",
        r"V_{w,h_{10}} : length",
        r"factor x_{k|k-1}, \hat x ; V_{w,h_{10}}",
    )
    rows = [r"V_{a;0}=x_{k|k-1}(1+V_{w,h_{10}})", r"V_{a;0}=\hat x+\hat xV_{w,h_{10}}"]
    block = "".join(f"%% {line}\n" for line in lines)
    assert outcomes(*rows, block=block) == ["DEFINITION", "PROVED"]


@pytest.mark.parametrize("name", ["e", r"\mathrm{e}", r"\mathrm e"])
def test_a_letter_may_be_eulers_number_by_its_meaning(name: str) -> None:
    meanings = ("base of natural logarithms", "Euler's number", "excess")
    for meaning, outcome in zip(meanings, ("PROVED", "PROVED", "DEFINITION"), strict=True):
        block = f"%% {name} : {meaning}\n"
        assert outcomes(rf"{name}^2=\exp(2)", block=block)[-1] == outcome


DECLARED = r"""%% w(t) : position [mm]
%% t : time [s]
%% k : rate [1/s^2]
%% \dot w | v : speed [m/s] {v>0}
"""


def test_a_derivative_may_have_a_line_of_its_own() -> None:
    motion = [r"w=rkt^2", r"v=2rkt", r"\dot w=3rkt", r"\sqrt{v^2}=v"]
    assert outcomes(*motion, block=DECLARED) == ["DEFINITION", "PROVED", "REFUTED", "PROVED"]
    number = "\\dot w=2rkt={}".format
    block = DECLARED + "%% sizes r=3 mm, k=1, t=100\n"
    assert outcomes("w=rkt^2", number("0.6"), block=block)[-1] == "PROVED"
    assert outcomes("w=rkt^2", number("599"), block=block)[-1] == "REFUTED"


def test_a_unit_that_is_not_known_is_told_and_counts_as_none() -> None:
    block = "%% mechproof\n%% a ; b : lengths [furlong]\n%% c : length [mm]\n"
    block += "%% q : heat [kJ/(kg K)]\n%% w ; z : shares [\\%]\n%% end\n"
    found = check("paper.tex", block + r"\[a=2b+c\] \[\sqrt{c^2}=c^2\]")
    assert [row.outcome for row in found.rows] == ["DEFINITION", "ILL_FORMED"]
    assert [reason for _, reason in found.told] == [
        f"the unit 'furlong' of [furlong] is not known; {name} is taken to have no unit"
        for name in "ab"
    ]


def test_the_derivatives_of_a_letter_that_means_another_are_those_of_that() -> None:
    block = r"""%% mechproof
%% p(\psi) ; q(\psi) : two lifts
%% \psi(t) : angle
%% a ; b : lengths
%% in (2)-(5): p is q
%% end
"""
    equations = (r"p=a\sin\psi", r"p=b\cos2\psi", r"p'=-2b\sin2\psi")
    turned = (r"\frac{dp}{d\psi}=-2b\sin2\psi", r"p'=2b\sin2\psi", r"p'=a\cos\psi")
    found = judge_parts(block, *equations, *turned)
    assert found == ["DEFINITION", "DEFINITION", "PROVED", "PROVED", "REFUTED", "PROVED"]


@pytest.mark.parametrize(
    ("value", "found"), [("N-1", ["PROVED", "REFUTED"]), ("-N", ["REFUTED", "REFUTED"])]
)
def test_what_counts_may_be_given_by_what_counts(value: str, found: list[str]) -> None:
    block = f"%% N : pins\n%% natural N\n%% z : lobes\n%% natural z\n%% let z={value}\n"
    equations = (r"\cos z\alpha=\cos(N\alpha-\alpha)", r"\sin z\alpha=\sin2N\alpha")
    assert outcomes(*equations, block=block) == found


def test_what_is_given_by_counts_stands_in_chains_and_sums() -> None:
    block = "%% N : pins\n%% natural N\n%% z ; q : lobes\n%% natural z\n%% let z=N-1\n"
    equations = (r"q=\frac xy=-z=1-N", r"\sum_{k=1}^zk=\frac{N(N-1)}2")
    wrong = r"\sum_{k=1}^zk=\frac{N(N+1)}2"
    found = outcomes(*equations, wrong, block=block)
    assert found == ["DEFINITION", "not judged", "PROVED", "PROVED", "REFUTED"]


FAULTS = {
    "m : number\n%% integer m\n%% let m=r/2": "m is a whole number, which r/2 is not shown to be",
    "factor x ; factor y": "a line has one word: 'factor y' needs its own line",
    "natural n ; claim x=y": "a line has one word: 'claim x=y' needs its own line",
    "where x^2+y^2=1": r"x\^2 \+ y\^2=1 is an equation, not a condition: declare its display",
    r"let x=\begin{pmatrix}r\\r\end{pmatrix}": "it is a matrix, so declare its size: x 2x1",
    "where x=y": "x=y is a value, not a condition: declare let x=y",
}


@pytest.mark.parametrize("line", FAULTS)
def test_a_line_that_says_what_it_cannot_is_refused(line: str) -> None:
    with pytest.raises(ValueError, match=FAULTS[line]):
        outcomes(AREA, block=f"%% {line}\n")


ADVICE = {
    r"\dot x=2r": "If it is a derivative, declare what x depends on: x(t) : its meaning. ",
    r"\ddot x_1=2r": "If it is a derivative, declare what x_1 depends on: x_1(t) : its meaning. ",
    "x=2r'": "If it is a derivative, declare what r depends on: r(…) : its meaning. Otherwise: ",
    r"\frac{dx}{dr}=2r": "If x depends on r, say so in the block of letters: x(r) : its meaning. ",
    # These depend on another letter, or are not declared as letters.
    r"\dot u=2r": r"Declare it in the block of letters: \dot u : its meaning",
    r"\dot w=2r": r"Declare it in the block of letters: \dot w : its meaning",
}


@pytest.mark.parametrize("latex", ADVICE)
def test_a_derivative_of_a_letter_that_depends_on_nothing_is_no_letter(latex: str) -> None:
    found = check("paper.tex", f"{LETTERS}%% u(\\alpha) : lift [mm]\n%% end\n$${latex}$$")
    (row,) = found.rows
    assert row.outcome == "not read"
    assert row.remedy.startswith(ADVICE[latex])


MEMBERS = """%% mechproof
%% d_i (i) ; z_i (i) : [1]
%% d_{bi} (i) : [1]
%% m ; c : [1]
%% end
"""


@pytest.mark.parametrize(
    ("latex", "reason"),
    [
        # An equation that holds for each index is not a fault of the print.
        ("d_i=mz_i", "for each i"),
        ("d_{bi}=cd_i", "for each i"),
        ("d_{b1}=cd_1", "d_{b1}, a member of a family: declare it as a separate letter"),
    ],
)
def test_members_of_families_are_accused_of_nothing(latex: str, reason: str) -> None:
    (row,) = check("paper.tex", f"{MEMBERS}$${latex}$$").rows
    assert row.outcome == "not judged"
    assert reason in row.reason


def test_a_family_of_times_is_not_the_time() -> None:
    block = "%% q(t) : way\n%% t_i (i) :\n%% a :\n"
    rows = [r"q=at^2", r"\dot q=2at", r"\sum_{i=1}^2t_i=t_1+t_2"]
    assert outcomes(*rows, block=block) == ["DEFINITION", "PROVED", "PROVED"]


def test_a_family_may_have_more_in_its_index() -> None:
    sums = r"$$c=\sum_{i=1}^2d_{bi}=d_{b1}+d_{b2}=d_{b1}+d_2$$"
    found = [row.outcome for row in check("paper.tex", MEMBERS + sums).rows]
    assert found == ["DEFINITION", "PROVED", "not judged"]
