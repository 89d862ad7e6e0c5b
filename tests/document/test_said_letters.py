"""What sentences say of letters, for a draft: what it proposes and what it asks."""

import pytest
from small_papers import draft


@pytest.mark.parametrize(
    ("text", "lines", "missing"),
    [
        # Of two equations that are joined, the second one may be a case as the first is.
        (
            r"It is least at $q=0$ and $q=b/2$. $$y=q^2+b$$",
            ["# let q=b/2"],
            ["let q=b/2"],
        ),
        (
            r"The solution is $p=h\cos w$ and $q=k\cos w$. $$y=pq$$",
            [r"# let q=k\cos w"],
            [r"let q=k\cos w"],
        ),
        (r"with $p=h\cos w$ and $q=k\cos w$ $$y=pq$$", [r"let q=k\cos w"], []),
        # Several equations in one formula; letters that have one size.
        (
            r"For $k=20 \mathrm{~mm}, h=3 \mathrm{~mm}$ it is $$y=kh$$",
            ["sizes k=20 mm", "sizes h=3 mm"],
            [],
        ),
        (r"For $k=0,5$ it is $$y=kh$$", [], ["sizes k=0"]),
        (r"with $k=h=3$ mm $$y=k+2h$$", ["sizes k=3 mm", "sizes h=3 mm"], ["# let k=h"]),
        (r"with $k=h=b$ $$y=k+2h$$", ["# let k=b", "# let h=b"], ["# let k=h"]),
        # What is zero in one case, or said in two ways, has a size elsewhere.
        (r"For $k=0$ it is less. With $k=20$ mm we have $$y=2k$$", ["sizes k=20 mm"], []),
        (r"With $k=10$ mm or $k=20$ mm we have $$y=2k$$", [], ["sizes k=20 mm"]),
        (r"For $q=90^\circ$, and $q=\ang{90}$ again, $$y=\cos q$$", [r"sizes q=90^\circ"], []),
        # A place at which a letter has a value is no factor, and the circle's number no letter.
        (
            r"$$y=bx^2$$ $$y(0)=0$$",
            ["# A value of y at a place: say what y depends on, y(…) :"],
            ["factor y"],
        ),
        (r"$$y=bx^2$$ $$y(\pi)=c$$ so $y(\pi)=3$ m", [], [r"y(\pi) :", "factor y"]),
        (r"$$y=b(1)+b(p+q)$$", ["factor b"], []),
        # Letters with an index, by which others are differentiated, and members of families.
        (r"$$w=\frac{dq_2}{dq_1}$$", ["q_{2}(q_1) :"], []),
        (r"$$y=\sum_{k=1}^n\theta_k$$ $$b=\theta_k+c$$", [r"\theta_{i}(i) :"], []),
        (r"$$x_0=\sum_{k=1}^nx_k$$", ["x_{0} :", "x_{i}(i) :"], []),
        (r"$$y=\sum_{k=0}^nx_k,\quad x_0=b$$", ["x_{i}(i) :"], ["x_{0} :"]),
        (r"$$b=h_{o,\mathrm{id}}$$", [r"h_{o,\mathrm{id}} :"], []),
        # Members without a common letter, if nothing gives their letters.
        (r"$$k=\frac pq=-\frac ab$$", ["# constraint display 1"], ["constraint display 1"]),
        (r"$$k=\frac pq=-\frac{a}{p}$$", [], ["# constraint display 1"]),
        (r"$$p=ac$$ $$k=\frac pq=-\frac ab$$", [], ["# constraint display 2"]),
        # Words.
        (r"the ratio of the speed $n$ to it $$y=2n$$", ["n : speed"], ["n : ratio of the speed"]),
        (r"\begin{tabular}{ll}$b$ & 80.5 \\\end{tabular} $$y=2b$$", [], ["b : 80.5"]),
        (
            r"It has $k=N-1$ lobes and the equivalent radius $b$. $$y=b\cos k\psi$$",
            ["natural k"],
            [],
        ),
        (r"Of equivalent wheels with $k=N-1$ teeth $$y=b\cos k\psi$$", [], ["natural k"]),
        # Conditions, and what is no equation.
        (r"since $|q|<\pi/2$ it is $$y=\cos q$$", [r"where |q|<\pi/2"], []),
        (r"if $q>0$ it is $$y=\cos q$$", [], ["where q>0"]),
        (r"with $\dot q=\mathrm{const}$ $$y=\dot q+q$$", [], [r"claim \dot q=\mathrm{const}"]),
        (
            r"with $\dot q=w=\mathrm{const}$ $$y=\dot q+q+w$$",
            [r"let \dot q=w"],
            [r"claim \dot q=\mathrm{const}"],
        ),
    ],
)
def test_sentences_say_what_letters_are(text: str, lines: list[str], missing: list[str]) -> None:
    found = [line.split(" : [")[0] for line in draft(text).splitlines()]
    found += draft(text).splitlines()
    assert [line for line in lines if f"%% {line}" not in found] == []
    assert [line for line in missing if f"%% {line}" in found] == []
