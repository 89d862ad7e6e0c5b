"""A draft of letters with its paper: claims made in words, and rows judged with the draft."""

import re
from pathlib import Path

import pytest
from small_papers import draft

import mechproof

MOVED = r"$$x=r\cos\varphi+l$$ with respect to $\varphi$ "
LARGEST = r"claim \max_{\varphi}x=r+l"
AT_ZERO = r"claim x=r+l\quad\text{for }\varphi=0"


@pytest.mark.parametrize(
    ("words", "claims"),
    [
        (r"The largest value of $x$ is $r+l$.", [LARGEST]),
        (r"The maximum of $x$ equals $r+l$ at $\varphi=0$.", [LARGEST, AT_ZERO]),
        (r"It reaches a maximum of $r+l$ at $\varphi=0$.", [LARGEST, AT_ZERO]),
        (r"$x$ attains its smallest value $l-r$.", [r"claim \min_{\varphi}x=l-r"]),
        (
            r"$x$ has a maximum of $28\,\mathrm{mm}$ for $\varphi=0$.",
            [r"claim x=28\,\mathrm{mm}\quad\text{for }\varphi=0"],
        ),
        (r"If it is locked, the largest value of $x$ is $r+l$.", []),
        (r"The largest value of $x$ is $r+l$ in the range considered.", []),
        (r"The largest value of $x$ is $28\,\mathrm{mm}$.", []),
        (r"The largest value of $y$ is $r+l$.", []),
        (r"The largest part of it, $x$, is $r+l$.", []),
    ],
)
def test_words_name_largest_and_smallest_values(words: str, claims: list[str]) -> None:
    found = draft(rf"{MOVED}$$x'=-r\sin\varphi$$ $$x=l+r\cos\varphi$$ {words}")
    assert re.findall(r"%% (claim .*)", found) == claims


@pytest.mark.parametrize(
    ("claim", "outcome"),
    [
        (LARGEST, "PROVED"),
        (LARGEST.replace("max", "min"), "REFUTED"),
        (AT_ZERO, "PROVED"),
        (AT_ZERO.replace("r+l", "r-l"), "REFUTED"),
    ],
)
@pytest.mark.usefixtures("judged_here")
def test_what_words_claim_is_judged_as_a_row(claim: str, outcome: str) -> None:
    letters = "x(\\varphi) : place\n%% r ; l : lengths {r>0}\n%% \\varphi : angle"
    block = f"%% mechproof\n%% {letters}\n%% {claim}\n%% end\n"
    *_, row = mechproof.check("paper.tex", block + r"$$x=r\cos\varphi+l$$").rows
    assert (row.name, row.outcome, row.place.line) == ("claim 1", outcome, 5)


PRESSURES = "$$\\pi=\\frac{p}{q}$$\n$$\\pi q=p$$\nwhere $\\pi$ is "


@pytest.mark.parametrize(
    ("words", "declared", "outcomes"),
    [
        ("the ratio of the pressures.", "", {"not read"}),
        ("the ratio of the pressures.", "\\pi", {"DEFINITION", "PROVED"}),
        ("the ratio of the circumference to the diameter.", "", {"PROVED", "DEFINITION"}),
    ],
)
@pytest.mark.usefixtures("judged_here")
def test_pi_is_a_letter_where_words_say_so(words: str, declared: str, outcomes: set[str]) -> None:
    text = f"{PRESSURES}{words}\n"
    assert ("%% \\pi : ratio" in draft(text)) == ("pressures" in words)
    letters = f"%% {declared} : ratio\n" if declared else ""
    block = f"%% mechproof\n{letters}%% p ; q : pressures\n%% end\n"
    assert {row.outcome for row in mechproof.check("paper.tex", block + text).rows} == outcomes


MASSES = r"""
$$M=\sum_{i=1}^nm_i$$
$$x_s=\frac1M\sum_{i=1}^nm_ix_i$$
$$J=\sum_{i=1}^nm_i(x_i-x_s)^2=\sum_{i=1}^nm_ix_i^2-Mx_s^2$$
$$J=\sum_{i=1}^nm_ix_i^2+Mx_s^2$$
$$M=\sum_{k=1}^{n-1}m_k+m_n$$
$$F=\sum_{i=1}^nF_i$$
$$F=g\sum_{k=1}^nm_k$$
$$F_i=m_ig$$
$$x_{i+1}=x_i+h$$
"""


@pytest.mark.slow
def test_sums_over_families_are_judged_with_a_draft() -> None:
    rows = mechproof.check("paper.tex", draft(MASSES) + MASSES).rows
    expected = ["DEFINITION", "DEFINITION", "DEFINITION", "PROVED", "REFUTED"]
    expected += ["PROVED", "DEFINITION", *3 * ["not judged"]]
    assert [row.outcome for row in rows] == expected
    assert "has other letters" in rows[-3].reason
    assert all("for each i" in row.reason for row in rows[-2:])


def test_what_a_draft_names_is_read(tmp_path: Path) -> None:
    text = (
        "$$\\sum N_k=\\mu b$$\n$$W(p,q)=pq$$\n$$s_2=s_1+v\\,\\Delta t$$\n$$\\mathcal K=b-c$$\n"
        "$$h\\_k=b+c$$\n"
    )
    file = tmp_path / "paper.md"
    file.write_text(text)
    file.with_suffix(".letters").write_text(draft(text, "paper.md"))
    assert {row.outcome for row in mechproof.check(file).rows} == {"DEFINITION"}


TURNED = r"""
$$Q(\psi)=\begin{pmatrix}\cos\psi&\sin\psi\\-\sin\psi&\cos\psi\end{pmatrix}$$
$$Z=Q(\mu)Q(\nu)=\begin{pmatrix}\cos(\mu+\nu)&\sin(\mu+\nu)\\-\sin(\mu+\nu)&\cos(\mu+\nu)\end{pmatrix}$$
$$|D|=\left|\begin{array}{cc}h&k\\l&m\end{array}\right|=hm-kl$$
"""

FRAMED = r"""
$$Q_0^1=\begin{pmatrix}\cos\psi&\sin\psi\\-\sin\psi&\cos\psi\end{pmatrix}$$
$$Q_1^2=\begin{pmatrix}\cos\nu&\sin\nu\\-\sin\nu&\cos\nu\end{pmatrix}$$
$$Q_0^2=Q_0^1Q_1^2=\begin{pmatrix}\cos(\psi+\nu)&\sin(\psi+\nu)\\-\sin(\psi+\nu)&\cos(\psi+\nu)\end{pmatrix}$$
"""
# Without the first superscripts, the remaining ones may be powers.
SQUARED = FRAMED.replace("_0^1", "_0")

CALLED = r"""
$$Q=\begin{pmatrix}\cos\psi&\sin\psi\\-\sin\psi&\cos\psi\end{pmatrix}$$
$$Q(\psi)=Q$$
$$Q(\psi)Q(\psi)=Q(2\psi)$$
$$Q^{-1}(\psi)=Q^T(\psi)=Q(-\psi)=\begin{pmatrix}\cos\psi&-\sin\psi\\\sin\psi&\cos\psi\end{pmatrix}$$
"""


@pytest.mark.parametrize(
    ("text", "outcomes"),
    [
        (CALLED, {"DEFINITION", "PROVED"}),
        (CALLED.replace(r"=Q(-\psi)", r"=Q(\psi)"), {"DEFINITION", "PROVED", "REFUTED"}),
        (FRAMED, {"DEFINITION", "PROVED"}),
        (FRAMED.replace(r"&\sin(\psi+", r"&\cos(\psi+"), {"DEFINITION", "REFUTED"}),
        (SQUARED, {"DEFINITION", "not judged"}),
        (TURNED, {"DEFINITION", "PROVED"}),
        (TURNED.replace(r"&\sin(\mu+", r"&\cos(\mu+"), {"DEFINITION", "PROVED", "REFUTED"}),
        (TURNED.replace("hm-kl", "hm+kl"), {"DEFINITION", "PROVED", "REFUTED"}),
    ],
)
@pytest.mark.usefixtures("judged_here")
def test_matrices_are_read_with_the_sizes_of_a_draft(text: str, outcomes: set[str]) -> None:
    assert {
        row.outcome for row in mechproof.check("paper.tex", draft(text) + text).rows
    } == outcomes


def test_a_table_is_compared_in_the_units_of_its_head() -> None:
    text = (
        "\\begin{tabular}{ccc}\n$r$ [mm] & $l$ / mm & $\\lambda$\\\\ \\hline\n"
        "66 & 200 & 0.33\\\\\n60 & 180 & 0.35\\\\\n\\end{tabular}\n"
        "\\begin{equation}\\lambda=r/l\\end{equation}\n"
    )
    rows = mechproof.check("paper.tex", f"{draft(text)}{text}").rows
    assert [row.outcome for row in rows] == ["DEFINITION", "PROVED", "REFUTED"]
