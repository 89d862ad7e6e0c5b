"""Values given in a worked example hold only there, and general rows remain general."""

import pytest
from small_papers import draft, judge_parts

from mechproof.sources.announcements import NOTHING

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = r"""%% mechproof
%% r ; l : lengths [mm] {r>0, l>0}
%% x(t) : position [mm]
%% \varphi(t) : angle [rad]
%% \omega : speed [rad/s]
%% F ; G : forces [N]
%% M : moment [N mm]
%% i : ratio [1]
%% factor r, l
%% end
"""
GENERAL = (r"x=r\cos\varphi+l", "#The force gives the moment", r"M=Fr\sin\varphi")
LONG, SHORT = r"x=r(\cos\varphi+3)", r"x=r(\cos\varphi+2)"
STEADY = r"\ddot x=-r\dot\varphi^2\cos\varphi"
HEADING = r"#\section{Numerical example} The rod has"
OPEN = "not judged"


@pytest.mark.parametrize(
    ("parts", "outcomes"),
    [
        ((HEADING, "l=3r", "#Hence", LONG), ["DEFINITION", "PROVED"]),
        ((HEADING, "l=3r", "#Hence", SHORT), ["DEFINITION", OPEN]),
        ((r"#\begin{example} It has", "l=3r", "#Hence", LONG), ["DEFINITION", "PROVED"]),
        ((r"#For example, with $l=3r$", LONG), ["PROVED"]),
        ((r"#For example, with $l=3r$ it follows that", SHORT), [OPEN]),
        ((r"#If, for example, $l=3r$", LONG), ["PROVED"]),
        ((r"#If, for example, $l=3r$", SHORT), [OPEN]),
        ((r"#For example, with $l=2r$ beside one with $l=3r$", LONG), [OPEN]),
        # After its end, only rows that hold in general are proved.
        ((HEADING, "l=3r", r"#\section{Speed} Hence", LONG), ["DEFINITION", OPEN]),
        ((HEADING, "l=3r", r"#\subsection{Speed} Hence", LONG), ["DEFINITION", "PROVED"]),
        ((HEADING, "l=3r", "#In general, hence,", LONG), ["DEFINITION", OPEN]),
        ((r"#\begin{example} It has", "l=3r", r"#\end{example} Hence", LONG), ["DEFINITION", OPEN]),
        (
            (r"#\paragraph{Example.} It has", "l=3r", r"#\paragraph{Rod}", LONG),
            ["DEFINITION", OPEN],
        ),
        ((r"#\textbf{Example 2.} It has", "l=3r", r"#\section{Rod}", LONG), ["DEFINITION", OPEN]),
        ((r"#For example, with $l=3r$", LONG, "#In general", LONG), ["PROVED", OPEN]),
        (("#For example, it has", "l=3r", "#\n\nThe place is", LONG), ["DEFINITION", OPEN]),
        (
            (HEADING, r"\dot\varphi=\omega", r"#\section{Motion} Hence", STEADY),
            ["DEFINITION", OPEN],
        ),
        # Sizes with units begin an example, too.
        ((r"#For $r=66$ mm it has", "l=3r", r"#\section{Rod}", LONG), ["DEFINITION", OPEN]),
        ((r"#For $r=66$ it has", "l=3r", r"#\section{Rod}", LONG), ["DEFINITION", "PROVED"]),
        ((r"#For $r=6\,\mathrm{mm}$ we have", "l=3r", "#Hence", SHORT), ["DEFINITION", "REFUTED"]),
        ((HEADING, r"\varphi=\omega t", "#Hence", STEADY), ["DEFINITION", "PROVED"]),
        (
            (HEADING, r"\varphi=\omega t", "#Hence", r"\dot\varphi=2\omega"),
            ["DEFINITION", "REFUTED"],
        ),
        # The values of an example are its own.
        (
            (
                HEADING,
                "F=2G",
                r"#\section{Load} The load is",
                "F=3G",
                "#Hence",
                r"M=3Gr\sin\varphi",
            ),
            ["DEFINITION", "DEFINITION", "PROVED"],
        ),
        (
            (HEADING, "F=2G", "#Hence", r"M=2Gr\sin\varphi", r"#\section{Load} It is", "F=3G"),
            ["DEFINITION", "PROVED", "DEFINITION"],
        ),
        (
            (HEADING, "l=3r", "#A shorter one has", "l=2r", "#Hence", LONG),
            ["DEFINITION", OPEN, OPEN],
        ),
        (
            (r"#\section{Example} With $i=2$", "F=iG", "#Hence", "F=2G", r"M=2Gr\sin\varphi"),
            ["DEFINITION", "PROVED", "PROVED"],
        ),
        (
            (r"#\section{Example} With $i=2$", "F=iG", "#Hence", r"M=3Gr\sin\varphi"),
            ["DEFINITION", OPEN],
        ),
    ],
)
def test_examples_say_what_letters_are_there(parts: tuple[str, ...], outcomes: list[str]) -> None:
    assert judge_parts(BLOCK, *GENERAL, *parts) == ["DEFINITION", "DEFINITION", *outcomes]


@pytest.mark.parametrize(
    ("words", "is_example"),
    [
        ("For example, we have", True),
        ("Consider, for instance, the rod", True),
        ("Hence, as an example, the rod has", True),
        ("It is long. As an example, the rod has", True),
        ("Zum Beispiel ist", True),
        (r"\subsection*{Worked example}", True),
        ("## Rechenbeispiel", True),
        ("In this example", True),
        ("Gears are used, for example, in cars. They have", False),
        (r"\section{Exemplary drives} They have", False),
        (r"\paragraph{Example} It has. \paragraph{Force} It has", False),
    ],
)
def test_words_begin_and_end_examples(words: str, is_example: bool) -> None:
    assert bool(NOTHING.go_on(words).example.number) is is_example


@pytest.mark.parametrize(
    ("words", "is_asked"),
    [
        ("With $b=3c+k$", False),
        ("For example, with $b=3c+k$", True),
        ("Let $b=3c+k$. For example", False),
    ],
)
def test_what_an_example_says_is_asked_in_a_draft(words: str, is_asked: bool) -> None:
    found = draft(f"{words} $$h=b+c+k$$").splitlines()
    assert ("%% # let b=3c+k" in found, "%% let b=3c+k" in found) == (is_asked, not is_asked)
