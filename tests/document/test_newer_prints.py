"""Letters defined again, special values and constraints of other cases: what rests on which."""

from __future__ import annotations

from functools import partial

import pytest
from small_papers import judge_parts

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = r"""%% mechproof
%% k ; k_1 ; k_2 : stiffness [N/mm] {k_1>0, k_2>0}
%% m : mass [kg] {m>0}
%% \omega : frequency
%% r_1 ; r_2 ; s ; l ; x ; a ; b ; c : lengths [mm] {r_1>0, l>0, a>0}
%% A : area [mm^2]
%% v ; u : velocities
%% \omega_1 ; \omega_2 : speeds [rad/s]
%% F ; G ; N ; R : forces [N] {G>0, N>0}
%% \mu : friction [1] {0<\mu<1}
%% \alpha ; \psi : angles [rad]
%% T : torque [N*mm]
%% M(x) : moment [N*mm]
%% R_z 2x2 : rotation
%% y(t) : position [mm]
%% \varphi(t) : angle [rad]
%% factor \mu, a, F
%% end
"""
PARALLEL = ("#Two springs in parallel have the stiffness", "k=k_1+k_2", "#and the frequency is")
SERIES = (r"\omega=\sqrt{k/m}", "#Two springs in series have", r"k=\frac{k_1k_2}{k_1+k_2}")
IN_SERIES = r"\omega=\sqrt{\frac{k_1k_2}{m(k_1+k_2)}}"
IN_PARALLEL = r"\omega=\sqrt{\frac{k_1+k_2}m}"
TURN = r"R_z=\begin{pmatrix}\cos\psi&-\sin\psi\\\sin\psi&\cos\psi\end{pmatrix}"
BACK = r"R_z=\begin{pmatrix}\cos\psi&\sin\psi\\-\sin\psi&\cos\psi\end{pmatrix}"
FIRST = r"R_z\begin{pmatrix}1\\0\end{pmatrix}=\begin{pmatrix}\cos\psi\\\sin\psi\end{pmatrix}"
HEXAGON = ("#The area of the hexagonal section is", r"A=\frac{\sqrt3}2s^2")
BEAM = (
    "M=F(l-x)",
    r"#\section{Another beam} Its moment is",
    r"M=\begin{cases}Fx&0\le x\le l/2\\F(l-x)&l/2<x\le l\end{cases}",
    "#whence",
)
PRESSED = ("#The drum turns to the right, and the moments are", r"Fa=Nb-\mu Nc")
SPRUNG = (
    "F=-kx",
    "#The stiffness can be defined as",
    r"k=\frac Fx",
    "#A rod has",
    r"k=\frac Gl",
    "#A beam has",
    r"k=\frac{3G}l",
    "#The rod again has",
)
OPEN = "not judged"
# Displays, with text before them marked by #, and the outcome of the last display.
PAPERS: dict[str, tuple[tuple[str, ...], str]] = {
    "a rate by pieces of a newer print": (
        (*BEAM, r"\frac{dM}{dx}=\begin{cases}F&x<l/2\\-F&x>l/2\end{cases}"),
        "PROVED",
    ),
    "a wrong rate by pieces of a newer print": (
        (*BEAM, r"\frac{dM}{dx}=\begin{cases}F&x<l/2\\-2F&x>l/2\end{cases}"),
        "REFUTED",
    ),
    "of two letters printed anew one may be meant as first": (
        (*SPRUNG, r"k=\frac Fx=\frac Gl"),
        OPEN,
    ),
    "what any of the prints refutes": ((*SPRUNG, r"k=\frac Fx=\frac{2G}l"), "REFUTED"),
    "what says zero beside a definition": (SPRUNG[:3], OPEN),
    "what says it without new words": ((SPRUNG[0], SPRUNG[2]), "REFUTED"),
    "a derivative beside a newer print of another letter": (
        (
            r"b=r_1\sin\varphi",
            "#Its motion is given by",
            r"\dot\varphi=\omega_1\sin\varphi+\omega_2\frac b{r_1}",
            "#Para o sistema temos agora",
            r"b=r_1\varphi",
            r"\dot\varphi=\omega_1\varphi+\omega_2\frac b{r_1}",
        ),
        OPEN,
    ),
    "hence, with the newer print": ((*PARALLEL, *SERIES, "#Hence", IN_SERIES), "PROVED"),
    "hence, with the first print": ((*PARALLEL, *SERIES, "#Hence", IN_PARALLEL), OPEN),
    "new words, with the newer print": (
        (*PARALLEL, *SERIES, "#The frequency is then", IN_SERIES),
        OPEN,
    ),
    "a letter printed again that follows": (
        (*PARALLEL, *SERIES, "#Hence", r"\omega=\sqrt{\frac{k_1k_2}{k_1m+k_2m}}"),
        "PROVED",
    ),
    "a wrong rate of a newer print behind a heading": (
        (
            r"y=b\varphi",
            r"#\section{Another path} The position is",
            r"y=a\sin\varphi",
            "#and",
            r"\dot y=b\dot\varphi\cos\varphi",
        ),
        "REFUTED",
    ),
    "a rate of the first print behind a newer one": (
        (
            r"y=b\varphi",
            r"#\section{Another path} The position is",
            r"y=a\sin\varphi",
            r"#\section{Rates} The rate is",
            r"\dot y=b\dot\varphi\cos\varphi",
        ),
        OPEN,
    ),
    "a wrong print beside what is true of any": (
        ("k=k_1+k_2", r"(k+k_1)^2=k^2+2kk_1+k_1^2", "#Hence", "k=k_1-k_2"),
        "REFUTED",
    ),
    "no words between": ((*PARALLEL, *SERIES, IN_SERIES), "PROVED"),
    "no words between, with the first print": ((*PARALLEL, *SERIES, IN_PARALLEL), OPEN),
    "with neither": ((*PARALLEL, *SERIES, "#Hence", r"\omega=\sqrt{\frac{k_1-k_2}m}"), "REFUTED"),
    "with both": ((*PARALLEL, *SERIES, "#Hence", r"\omega^2=\frac km"), "PROVED"),
    "before the newer print": ((*PARALLEL, SERIES[0], "#Hence", IN_PARALLEL), "PROVED"),
    "the print itself once more": ((*PARALLEL, *SERIES, "#or", "k=k_1+k_2"), "DEFINITION"),
    "of a case, behind the first print once more": (
        (*PARALLEL, *SERIES, "#Two springs in parallel have", "k=k_1+k_2", SERIES[-1]),
        OPEN,
    ),
    "a matrix of the first print": (
        ("#A turn is", TURN, r"#From here on $\psi$ is counted clockwise:", BACK, "#Thus", FIRST),
        OPEN,
    ),
    "a matrix without another": (("#A turn is", TURN, "#Thus", FIRST), "PROVED"),
    "a derivative of the first print": (
        (
            *("#The pin is at", r"y=a\sin\varphi", "#The pin of the other crank is at"),
            *(r"y=-a\sin\varphi", "#Therefore", r"\dot y=a\dot\varphi\cos\varphi"),
        ),
        OPEN,
    ),
    "a derivative of the newer print": (
        (
            *("#The pin is at", r"y=a\sin\varphi", "#The pin of the other crank is at"),
            *(r"y=-a\sin\varphi", "#Therefore", r"\dot y=-a\dot\varphi\cos\varphi"),
        ),
        "PROVED",
    ),
    "a derivative in which the first print was put": (
        (
            *(r"x=a\sin\varphi", "y=b+x", "#The pin of the other crank is at", r"x=-a\sin\varphi"),
            *("#Therefore", r"\dot y=a\dot\varphi\cos\varphi"),
        ),
        OPEN,
    ),
    "the last of three prints": (
        (
            *(*PARALLEL, *SERIES, "#With levers they have", "k=4k_1+k_2", "#Hence"),
            r"\omega=\sqrt{\frac{4k_1+k_2}m}",
        ),
        "PROVED",
    ),
    "a square is no word of a consequence": ((*HEXAGON, "#The square bar has", "A=s^2"), OPEN),
    "nor is a heading": ((*HEXAGON, r"#\section{Square bar}", "#Hence", "A=s^2"), OPEN),
    "nor what leads to the next": ((*HEXAGON, "#The next bar is square. Thus", "A=s^2"), OPEN),
    "but squaring is": ((*HEXAGON, "#Squaring it we get", "A=s^2"), "REFUTED"),
    "a contrast": (
        (*HEXAGON, "#The round bar, in contrast, has", r"T=F s", "#so that", r"A=\pi s^2"),
        OPEN,
    ),
}


# Rows about which a later special value, limit or arrangement says nothing: the displays, the
# index of the row, and its outcome.
SPECIAL: dict[str, tuple[tuple[str, ...], int, str]] = {
    "a value at a place does not accuse what stands before it": (
        (
            *("#Equilibrium requires", r"Fl\sin\alpha=\frac{Gl}2\cos\alpha"),
            *(r"#At $\alpha=45^\circ$ the thrust is half the weight,", r"F=\frac G2"),
        ),
        0,
        OPEN,
    ),
    "a law of another beam": (
        (
            *("#The moment below the load is", r"M(a)=\frac{Fa(l-a)}l"),
            *("#If the beam is clamped on the left,", "M=-F(l-x)"),
        ),
        0,
        OPEN,
    ),
    "what letters mean proves": (
        ("#The area is", r"A=\frac{\pi s^2}4", "#that is", r"A=\pi l^2", "#with", "s=2l"),
        1,
        "PROVED",
    ),
    "a condition and its limit": (
        ("#As long as it rests,", r"R<\mu N", "#At the limit of adhesion", r"R=\mu N"),
        0,
        OPEN,
    ),
    "a condition that the limit makes true": (
        ("#As long as it rests,", r"R\ge\mu N", "#At the limit of adhesion", r"R=\mu N"),
        0,
        OPEN,
    ),
    "what is printed again with another sign holds instead": (
        (
            *PRESSED,
            *("#so that", r"T=\mu Nr_1", "#If the drum turns to the left,", r"Fa=Nb+\mu Nc"),
            *("#and hence", r"T=\frac{\mu Far_1}{b-\mu c}"),
        ),
        -1,
        OPEN,
    ),
    "without another sign": (
        (*PRESSED, "#so that", r"T=\mu Nr_1", "#and hence", r"T=\frac{\mu Far_1}{b-\mu c}"),
        -1,
        "PROVED",
    ),
    "teeth inside": (
        (
            *("#With external teeth we have", r"r_1\omega_1+r_2\omega_2=0"),
            *("#With internal teeth", r"r_1\omega_1-r_2\omega_2=0", "#so that"),
            r"\frac{\omega_2}{\omega_1}=-\frac{r_1}{r_2}",
        ),
        -1,
        "DEFINITION",
    ),
    "what is said in general follows from no special case": (
        ("#In a plastic impact", "u=v", "#In general", r"\frac{u-v}s=5(v-u)"),
        -1,
        "DEFINITION",
    ),
    "a special case written as a ratio": (
        ("#In a plastic impact", r"\frac uv=1", "#In general", r"\frac{u-v}s=5(v-u)"),
        -1,
        "DEFINITION",
    ),
    "what follows from a special case": (
        ("#In a plastic impact", "u=v", "#so that", r"\frac{u-v}s=5(v-u)"),
        -1,
        "PROVED",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", SPECIAL)
def test_a_case_says_nothing_of_others(name: str) -> None:
    parts, place, expected = SPECIAL[name]
    assert judge(*parts)[place] == expected


judge = partial(judge_parts, BLOCK)


@pytest.mark.slow
@pytest.mark.parametrize("name", PAPERS)
def test_no_verdict_rests_on_the_first_print_alone(name: str) -> None:
    parts, expected = PAPERS[name]
    assert judge(*parts)[-1] == expected
