"""Limits, values at a place, special cases, and phases: what holds, and what is refused."""

from __future__ import annotations

import pytest
from small_papers import judge_rows

from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

LETTERS = r"""%% mechproof
%% a : length [mm] {a>0}
%% b : length [mm] {b>0}
%% c ; d : lengths [mm]
%% h(\psi) : lift [mm]
%% \psi ; \alpha : angles [rad]
%% z(t) : position [mm]
%% w(t) : another position [mm]
%% \nu : frequency of rotation [rad/s]
%% v : speed [mm/s]
%% k : number {0<=k<=2}
%% p ; q : numbers
%% where c>=0
%% end
$$h=a\cos\psi+\sqrt{b^2+(c\sin\psi)^2}$$
$$z=a\sin\nu t$$
"""
CASES = {
    r"h=a\cos\psi+b\quad\text{for }c=0": ["PROVED"],
    r"h=a\cos\psi-b\quad\text{for }c=0": ["REFUTED"],
    r"h=a\cos\psi+b\quad(c=0)": ["PROVED"],
    r"h=a+b\quad\text{for }\psi=0": ["PROVED"],
    r"h=2a+b\quad\text{for }\psi=0": ["REFUTED"],
    r"h=a+b\quad\text{at}\quad\psi=0": ["PROVED"],
    r"h=2a+b\text{ at }\psi=0": ["REFUTED"],
    r"h=a+b\quad\text{for }c=\psi=0": ["PROVED"],
    r"h=a-b\quad\text{for }c=\psi=0": ["REFUTED"],
    r"h=b\quad\text{for }a=0": ["not judged"],
    r"\lim_{c\to0}h=a\cos\psi+b": ["PROVED"],
    r"\lim_{c\to0}h=a\sin\psi+b": ["REFUTED"],
    r"\lim_{\psi\to0}\frac{h-a}{b}=1": ["PROVED"],
    r"\lim_{\psi\to0}\frac{h-a}{b}=2": ["DEFINITION"],
    r"\lim_{\psi\to0}h=a+b": ["PROVED"],
    # A derivative is defined by increments.
    r"\lim_{\Delta\psi\to0}\frac{\Delta h}{\Delta\psi}=h'": ["PROVED"],
    r"\lim_{\Delta\psi\to0}\frac{\Delta h}{\Delta\psi}=-b\sin\psi": ["not judged"],
    r"\lim_{\Delta\psi\to0}\frac{\Delta h}{\Delta a}=0": ["not read"],
    r"\lim_{\psi\to0}h=a-b": ["REFUTED"],
    r"\lim_{\psi\to0}\frac{\sin\psi}{2\psi}=\frac12": ["PROVED"],
    r"\lim_{\psi\to0}\frac{\sin\psi}{2\psi}=\frac13": ["REFUTED"],
    r"h(0)=a+b": ["PROVED"],
    r"h(0)=a-b": ["REFUTED"],
    r"h\left(\frac{\pi}{2}\right)=\sqrt{b^2+c^2}": ["PROVED"],
    r"h(-\pi/2)=\sqrt{b^2-c^2}": ["REFUTED"],
    r"h'(0)=0": ["PROVED"],
    r"h'(0)=2a": ["REFUTED"],
    r"k=h(0)=a+b": ["DEFINITION", "PROVED"],
    r"h(\psi=0)=a+b,\ h'(\psi=0)=0": ["PROVED", "PROVED"],
    r"h(\psi=\pi)=a+b": ["REFUTED"],
    # After a gap it is a condition; for another letter it is not a place.
    r"h=b-a\quad(\psi=\pi)": ["PROVED"],
    r"h(c=0)=a\cos\psi+b": ["not read"],
    # A place at a distance from an arbitrary one.
    r"z(t+\frac{2\pi}\nu)=z(t)": ["PROVED"],
    r"z(t+\frac\pi\nu)=-z(t)": ["PROVED"],
    r"z(t+\frac\pi\nu)=z(t)": ["REFUTED"],
    r"k=z(t+p)": ["not read"],
    r"h|_{\psi=0}=a+b": ["PROVED"],
    r"\left.h\right|_{\psi=0}=a+b": ["PROVED"],
    r"\Bigl.\frac{dh}{d\psi}\Bigr|_{\psi=0}=0": ["PROVED"],
    r"\left.\frac{dh}{d\psi}\right|_{\psi=0}=2a": ["REFUTED"],
    r"\left.h+a\right|_{\psi=0,c=0}=2a+b": ["PROVED"],
    r"\left.h+a\right|_{\psi=0,c=0}=a+b": ["REFUTED"],
    r"ah|_{\psi=0}=a^2": ["not read"],
    r"\left.h\right|=a": ["not read"],
    # Its index says that it is the value there; what differs is no constraint.
    r"\left(\frac ha\right)_{\max}=\frac{a+b}a\quad\text{at }\psi=0": ["PROVED"],
    r"\left(\frac ha\right)_{\max}=\frac{a-b}a\quad\text{at }\psi=0": ["REFUTED"],
    r"\left(\frac ha\right)_{\max}=2\quad\text{at }b=a": ["not judged"],
    r"\left(\frac ha\right)_{\max}=\frac{a+b}a\quad\text{for }\psi=0": ["not read"],
    r"w(0)=0": ["not read"],
    r"\dot w(0)=v": ["not read"],
    r"z(0)=0": ["PROVED"],
    r"\dot z(0)=a\nu": ["PROVED"],
    r"\dot z(0)=-a\nu": ["REFUTED"],
    r"h(\alpha)=a\cos\alpha+\sqrt{b^2+(c\sin\alpha)^2}": ["PROVED"],
    r"h(\alpha)=a\sin\alpha+\sqrt{b^2+(c\sin\alpha)^2}": ["REFUTED"],
    r"h\left(\tfrac{\alpha}{2}\right)=a\cos\frac\alpha2+\sqrt{b^2+(c\sin\frac\alpha2)^2}": [
        "PROVED"
    ],
    r"h(\alpha/2)=a\sin\frac\alpha2+\sqrt{b^2+(c\sin\frac\alpha2)^2}": ["REFUTED"],
    r"h(\frac{\alpha}{\psi})=a": ["not read"],
    r"h(2\alpha)=a\cos2\alpha+\sqrt{b^2+(c\sin2\alpha)^2}": ["PROVED"],
    r"h'(\alpha)=-c\sin\alpha-\frac{ab\sin\alpha}{\sqrt{b^2+(c\sin\alpha)^2}}": ["REFUTED"],
    r"h(\alpha+\psi)=a": ["not read"],
    r"w(\alpha)=a": ["not read"],
    r"h=a+b\quad\text{for }c=0,\ \psi=0": ["PROVED"],
    r"h=a-b,\quad\text{for }c=0,\ \psi=0": ["REFUTED"],
    r"h=a+b\quad\text{for }c>0,\ \psi=0": ["PROVED"],
    r"h=a-b\quad\text{for }c>0,\ \psi=0": ["REFUTED"],
    r"z=0\quad\text{for }t=0": ["PROVED"],
    r"z=1\quad\text{for }t=0": ["REFUTED"],
    r"z=0\quad\text{for }\nu=1": ["not judged"],
    r"h=a+b\quad\text{for }c=0,\ \psi=a": ["not read"],
    r"\dot z=a\nu\cos\nu t": ["PROVED"],
    r"\dot z=-a\nu\cos\nu t": ["REFUTED"],
    r"\sin2\nu t=2\sin\nu t\cos\nu t": ["PROVED"],
    r"p=v\cos\alpha t": ["DEFINITION"],
    r"p=v\cos\nu\alpha": ["not read"],
    r"\max_\psi(a\cos\psi+c)=a+c": ["PROVED"],
    r"\min\limits_{\psi}(a\cos\psi+c)=c-a": ["PROVED"],
    r"c-a=\min_\psi(a\cos\psi+c)": ["PROVED"],
    r"\max_\psi(a\cos\psi+c)=c-a": ["REFUTED"],
    r"d=\max_\psi(a\cos\psi+c)=a+c": ["DEFINITION", "PROVED"],
    r"d=\max_\psi(a\cos\psi+c)=a-c": ["DEFINITION", "REFUTED"],
    r"d=\max_\psi(a\cos\psi+c)": ["not judged"],
    r"\min_\psi(a\cos\psi+c)=a+c": ["REFUTED"],
    r"\max_t z=a": ["PROVED"],
    r"\min_t z=a": ["REFUTED"],
    r"\max_w(aw-w^2)=\frac{a^2}{4}": ["PROVED"],
    r"\max_k(2k-k^2)=1": ["PROVED"],
    r"\max_k(2k-k^2)=0": ["REFUTED"],
    r"\max_c(a-c)=a": ["PROVED"],
    # The stationary point lies beyond the end of the range.
    r"\max_k(6k-k^2)=8": ["PROVED"],
    r"\max_k(6k-k^2)=9": ["REFUTED"],
    r"\min_k(2k-k^2)=0": ["PROVED"],
    # It holds for positive lengths only.
    r"\max_\psi(d\cos\psi)=d": ["not judged"],
    r"\max_\psi(a\cos\psi+c)=a-c": ["REFUTED"],
    r"\max_\psi(d\cos\psi)=|d|": ["PROVED"],
    r"\max_\psi(a\cos\psi+d\sin\psi)=\sqrt{a^2+d^2}": ["PROVED"],
    r"\max_\psi(a\cos\psi+d\sin\psi)=\sqrt{a^2-d^2}": ["REFUTED"],
    r"\max_\psi(2a\cos3\psi-d\sin3\psi+c)=\sqrt{4a^2+d^2}+c": ["PROVED"],
    r"\max_\psi(2a\cos3\psi-d\sin3\psi+c)=\sqrt{2a^2+d^2}+c": ["REFUTED"],
    r"\max_\psi(a\cos\psi+d\sin\psi+c)=\sqrt{a^2+d^2}": ["REFUTED"],
    r"\min_\psi(a\cos\psi+d\sin\psi+c)=c-\sqrt{a^2+d^2}": ["PROVED"],
    r"\min_\psi(a\cos\psi+d\sin\psi+c)=c+\sqrt{a^2+d^2}": ["REFUTED"],
    r"\max_\psi(a\cos(\psi+\alpha)+d\sin\psi)=\sqrt{a^2+d^2-2ad\sin\alpha}": ["PROVED"],
    r"\max_\psi(a\cos(\psi+\alpha)+d\sin\psi)=\sqrt{a^2+d^2-2ad\cos\alpha}": ["REFUTED"],
    r"\max_t\dot z=\sqrt{a^2\nu^2}": ["PROVED"],
    # Two waves, a product of waves, and waves of a letter with a range.
    r"\max_\psi(a\cos\psi+d\sin2\psi)=\sqrt{a^2+d^2}": ["UNDECIDED"],
    r"\max_\psi(a\cos\psi\sin\psi)=\frac a3": ["UNDECIDED"],
    r"\max_k(\cos k+\sin k)=\sqrt2": ["UNDECIDED"],
    # The extreme value is proved, and differs from the printed one.
    r"\max_k(2k-k^2)=2": ["REFUTED"],
    r"\max_\psi a\sin^2\psi=a": ["PROVED"],
    r"\max_\psi a\sin^2\psi=2a": ["REFUTED"],
    r"\min_\psi a\sin^2\psi=-a": ["REFUTED"],
    r"\min_\psi\sqrt{a^2+d^2-2ad\cos\psi}=a-d": ["not judged"],
    r"\min_\psi\sqrt{a^2+c^2-2ac\cos\psi}=|a-c|": ["PROVED"],
    r"p=\max_k(2k-k^2)": ["not judged"],
    r"\max_\psi h<a": ["not judged"],
    r"\max_{0<\psi<1}h=a": ["not read"],
    r"\max_\psi h=a\quad\text{for }\psi>1": ["not read"],
    r"2\max_\psi h=a": ["not read"],
    r"\max_\psi h+a=a": ["not read"],
    r"p=\cos\nu\alpha": ["not read"],
}
TURNS = r"""%% mechproof
%% N ; u : numbers of teeth [1]
%% n ; u_1 : counts
%% natural n
%% \psi ; \alpha : angles [rad]
%% \nu ; \mu : speeds [rad/s]
%% f : frequency [Hz]
%% t : time [s]
%% z(t) : position [mm]
%% r : length [mm]
%% p ; q : numbers
%% end
"""
# The arguments of functions without brackets: those that are clear, and those that are not.
PHASES = {
    r"\cos2N\psi=1-2\sin^2N\psi": ["PROVED"],
    r"\cos N\psi=\cos(\psi N)": ["PROVED"],
    r"\cos N\psi=\psi\cos(N)": ["not judged"],
    r"\cos N\cdot\psi=\psi\cos(N)": ["not read"],
    r"\cos\psi\cdot N=N\cos(\psi)": ["PROVED"],
    r"\tan\frac n3\alpha=\tan(n\alpha/3)": ["PROVED"],
    r"\sin(n+1)\psi=\sin n\psi\cos\psi+\cos n\psi\sin\psi": ["PROVED"],
    r"\sin(n+1)\psi=\psi\sin(n+1)": ["not judged"],
    r"\sin(\nu-\mu)t=\sin(\nu t-\mu t)": ["PROVED"],
    r"\cos\frac12(\psi+\alpha)=\cos(\psi/2+\alpha/2)": ["PROVED"],
    r"\cos\frac12\psi=\frac\psi2\cos1": ["not judged"],
    r"\cos n\pi=(-1)^n": ["PROVED"],
    r"\cos n\pi=(-1)^{n+1}": ["REFUTED"],
    r"z=r\sin n\nu t\quad \dot z=rn\nu\cos n\nu t": ["DEFINITION", "PROVED"],
    r"z=r\cos2\pi ft\quad \dot z=2\pi fr\sin2\pi ft": ["DEFINITION", "REFUTED"],
    r"\cos n\nu=1": ["not read"],
    r"\cos\psi N=1": ["not read"],
    r"\cos(n+1)\,\psi=1": ["not read"],
    r"\cos(N)\psi=\psi\cos(N)": ["PROVED"],
    r"\cos p\psi=1": ["not read"],
    r"\cos(n+1)r=1": ["not read"],
    r"\cos(\psi+1)N=N\cos(1+\psi)": ["PROVED"],
    r"\sin(N-1)\psi/2=1": ["not read"],
    r"\sin(2n+1)\frac\pi2=(-1)^n": ["not read"],
    r"\cos(n+1)(\psi+\alpha)=1": ["not read"],
    r"\cos(n+1)\,(p+q)=(q+p)\cos(1+n)": ["PROVED"],
    r"\cos(\psi+1)(p+q)=(q+p)\cos(1+\psi)": ["PROVED"],
}


@pytest.mark.slow
@pytest.mark.parametrize("latex", PHASES)
def test_a_function_takes_the_letters_whose_product_is_an_angle(latex: str) -> None:
    rows = check("paper.tex", f"{TURNS}$${latex}$$").rows
    assert [row.outcome for row in rows] == PHASES[latex]


@pytest.mark.parametrize("behind", [r"\theta", r"(\theta+a)", r"\frac\theta2"])
def test_without_units_a_count_before_a_letter_is_not_read_as_the_whole_argument(
    behind: str,
) -> None:
    (row,) = check("paper.tex", rf"$$y=\cos(n-1){behind}$$").rows
    assert row.outcome == "not read"
    assert "part of the argument" in row.reason


@pytest.mark.slow
@pytest.mark.parametrize("latex", CASES)
def test_special_values_have_their_outcome(latex: str) -> None:
    rows = check("paper.tex", f"{LETTERS}$${latex}$$").rows[2:]
    assert [row.outcome for row in rows] == CASES[latex]


# The range of x, the condition on a, and whether the extreme is proved to be attained.
ATTAINED = {
    r"\max_x(ax-x^2)=\sqrt{(a-1)^2}": ("-1<=x<=1", "a>2", True),
    r"\min_x(x^2-ax)=-|a-1|": ("-1<=x<=1", "a>2", True),
    r"\max_x(2ax-x^2)=|2a-1|": ("0<=x<=1", "a>2", False),
    r"\max_x\sin(x+a)=1": ("0<=x<=7", "a<9", False),
}


@pytest.mark.parametrize("latex", ATTAINED)
def test_no_extreme_is_refuted_by_a_place_beyond_the_range(latex: str) -> None:
    within, where, is_proved = ATTAINED[latex]
    block = f"%% mechproof\n%% x : number {{{within}}}\n%% a : number {{{where}}}\n%% end\n"
    (row,) = check("paper.tex", f"{block}$${latex}$$").rows
    assert row.outcome == "PROVED" if is_proved else row.outcome != "REFUTED"


def test_a_value_may_be_printed_before_what_it_is_a_value_of() -> None:
    block, _, equations = LETTERS.partition("%% end\n")
    rows = check("paper.tex", f"{block}%% end\n$$z(0)=0$$ $$z(0)=2a$$ {equations}").rows
    assert [row.outcome for row in rows] == ["PROVED", "REFUTED", "DEFINITION", "DEFINITION"]


SIZES = r"""%% mechproof
%% r ; l ; x : lengths [mm] {r>0}
%% \alpha : angle [rad]
%% sizes r=80 mm, l=202 mm
%% end
"""
# Prints that end in a number, and its outcome.
NUMBERS = {
    r"x=r+l=28.2\,\mathrm{cm}": "PROVED",
    r"x=r+l=28.2\,\mathrm{m}": "REFUTED",
    r"\frac{r+l}2=\frac{l+r}2=14.1\,\mathrm{cm}": "PROVED",
    r"\frac{r+l}2=\frac{l+r}2=14.2\,\mathrm{cm}": "REFUTED",
    r"\frac{r+l}2=\frac{l+r}2=141.0\,\mathrm{N}": "not judged",
    r"(r+l)/2=141\,\mathrm{mm}": "PROVED",
    r"(r+l)/2=282\,\mathrm{mm}": "REFUTED",
    r"rl=161.6\,\mathrm{cm}^2": "PROVED",
    r"rl=161.6\,\mathrm{mm}^2": "REFUTED",
    r"rl=161.6\,\mathrm{mm}": "not judged",
    r"rl=80\cdot202=16160\,\mathrm{mm}^2": "PROVED",
    r"rl=80\cdot202=16170\,\mathrm{mm}^2": "REFUTED",
    # Rounded to hundreds, or wrong.
    r"rl=16200\,\mathrm{mm}^2": "not judged",
    r"rl=8080\,\mathrm{mm}^2": "REFUTED",
    r"\frac rl=0.396": "PROVED",
    r"\frac rl=2.525": "REFUTED",
    # A special position.
    r"\frac rl=1": "DEFINITION",
    r"\frac\alpha2=21.6^\circ": "DEFINITION",
    r"rx=16160\,\mathrm{mm}^2": "DEFINITION",
    r"rx=16160\,\mathrm{mm}": "not judged",
    r"\max_\alpha(l\cos\alpha)=20.2\,\mathrm{cm}": "not read",
    r"r+l=282.5\,\mathrm{mm}": "REFUTED",
    r"r+l=28.2\,\mathrm{cm}": "PROVED",
    r"r+2l=484": "PROVED",
    r"r+2l=485": "REFUTED",
    r"r+l=282000\,\mu\mathrm{m}": "PROVED",
    r"r+l=282001\,\mu\mathrm{m}": "REFUTED",
    # Without sizes for all its letters, the print states a size itself.
    r"l-x=20.2\,\mathrm{mm}": "DEFINITION",
    r"l-x=20.2": "DEFINITION",
    r"l-x=20.2\,\mathrm{N}": "not judged",
    r"l+\alpha=20.2\,\mathrm{mm}": "not judged",
    r"\alpha=\arctan\frac rl=21.61": "PROVED",
    r"\alpha=\arctan\frac rl=0.3771": "PROVED",
    r"\alpha=\arctan\frac rl=201.6": "PROVED",
    # Off by 3.14 degrees, which is not half a turn.
    r"\alpha=\arctan\frac rl=24.75": "REFUTED",
    r"\alpha=\arctan\frac rl=18.46": "REFUTED",
    r"\alpha=\arctan\frac rl=201.6^\circ": "PROVED",
    # Degrees that are printed as radians.
    r"\alpha=\arctan\frac rl=21.61\,\mathrm{rad}": "REFUTED",
    r"\alpha=\arctan\frac rl=0.3771\,\mathrm{rad}": "PROVED",
}


@pytest.mark.slow
@pytest.mark.parametrize("latex", NUMBERS)
def test_numbers_are_compared_in_the_unit_that_is_printed(latex: str) -> None:
    *_, row = check("paper.tex", f"{SIZES}$${latex}$$").rows
    assert row.outcome == NUMBERS[latex]


@pytest.mark.parametrize(("number", "outcome"), [("80.0", "PROVED"), ("70.2", "not judged")])
def test_the_values_of_a_condition_are_meant_and_not_the_sizes(number: str, outcome: str) -> None:
    block = SIZES.replace("l=202 mm", "\\alpha=0.5")
    text = rf"$$x=r\cos\alpha$$ $$x={number}\text{{ for }}\alpha=0$$"
    assert check("paper.tex", block + text).rows[-1].outcome == outcome


# Numbers of a law at a place.
AT_A_PLACE = {
    r"h(0)=282": "PROVED",
    r"h(0)=28.2\,\mathrm{cm}": "PROVED",
    r"h(0)=28.4\,\mathrm{cm}": "REFUTED",
    r"\left.h\right|_{\psi=\pi}=122.0": "PROVED",
    r"\left.h\right|_{\psi=\pi}=121.0": "REFUTED",
    r"h\left(\frac\pi2\right)=202.0\,\mathrm{N}": "not judged",
    r"h'(0)=0": "PROVED",
}


@pytest.mark.parametrize("latex", AT_A_PLACE)
def test_numbers_at_a_place_are_compared_at_the_sizes(latex: str) -> None:
    letters = "%% h(\\psi) : lift [mm]\n%% \\psi : angle [rad]\n%% end"
    block = SIZES.replace("%% end", letters)
    *_, row = check("paper.tex", rf"{block}$$h=r\cos\psi+l$$ $${latex}$$").rows
    assert row.outcome == AT_A_PLACE[latex]


# Displays after two printed sizes, and the outcome of the last one.
PRINTED = r"$$r=80\,\mathrm{mm},\qquad l=20.2\,\mathrm{cm}$$"
AT_PRINTED = {
    r"$$(r+l)/2=141\,\mathrm{mm}$$": "PROVED",
    r"$$(r+l)/2=142\,\mathrm{mm}$$": "REFUTED",
    r"$$r/l=0.396$$": "PROVED",
    r"$$r/l=0.369$$": "REFUTED",
    r"$$x=\frac{rl}{r+l}=57.3\,\mathrm{mm}$$": "PROVED",
    r"$$x=\frac{rl}{r+l}=53.7\,\mathrm{mm}$$": "REFUTED",
    # 20.2 cm may be rounded from 201.6 mm.
    r"$$r/l=0.3968$$": "not judged",
    # After a new formula, the number may belong to another example.
    r"$$x=2r$$ $$r/l=0.396$$": "PROVED",
    r"$$x=2r$$ $$r/l=0.369$$": "not judged",
    r"$$r+l=282\,\mathrm{mm}$$ $$r/l=0.369$$": "REFUTED",
    # Two sizes of one letter count as none.
    r"$$r=70\,\mathrm{mm}$$ $$r/l=0.369$$": "DEFINITION",
    r"$$r=8\,\mathrm{cm}$$ $$r/l=0.369$$": "REFUTED",
}


@pytest.mark.parametrize("latex", AT_PRINTED)
@pytest.mark.parametrize("unit", [" [mm]", ""])
def test_numbers_are_compared_at_the_sizes_that_are_printed(latex: str, unit: str) -> None:
    block = SIZES.replace(" [mm]", unit).replace("%% sizes r=80 mm, l=202 mm\n", "")
    *_, row = check("paper.tex", f"{block}{PRINTED}{latex}").rows
    assert row.outcome == AT_PRINTED[latex]


@pytest.mark.parametrize(("unit", "outcome"), [(" [mm]", "PROVED"), ("", "not judged")])
def test_a_number_without_a_unit_counts_in_that_of_its_letter(unit: str, outcome: str) -> None:
    block = SIZES.replace(" [mm]", unit).replace("%% sizes r=80 mm, l=202 mm\n", "")
    *_, row = check("paper.tex", rf"{block}{PRINTED}$$x=\frac{{rl}}{{r+l}}=57.3$$").rows
    assert row.outcome == outcome


UNKNOWN = r"""%% mechproof
%% \varphi : angle [rad]
%% i(\varphi) ; R(\varphi) ; q(\varphi) : ratios
%% A ; B ; u ; v ; N : numbers
%% end
"""


@pytest.mark.parametrize(
    "equations",
    [
        ("R=q+N", r"A=R|_{\varphi=0}-N", r"B=R|_{\varphi=\pi}-N", "A=B"),
        (r"i=\frac uv", r"A=i|_{\varphi=0}", r"B=i|_{\varphi=\pi}", "A=B"),
    ],
)
def test_what_depends_on_a_letter_has_no_value_where_nothing_says_how(
    equations: tuple[str, ...],
) -> None:
    rows = judge_rows(UNKNOWN, *equations)
    assert [row.outcome for row in rows] == ["DEFINITION", "not read", "not read", "DEFINITION"]
    assert "the text does not say what" in rows[1].reason


TRAIN = r"""%% mechproof
%% n_1 ; n_2 ; n_3 : speeds [1/min]
%% z_1 ; z_2 : teeth [1] {z_1>0}
%% i_0 ; i ; k : ratios [1]
%% factor i_0, n_3
%% end
\begin{equation}i_0=\frac{n_1-n_3}{n_2-n_3}=-\frac{z_2}{z_1}\end{equation}
"""
HELD = r"With the ring held ($n_2=0$), the ratio becomes"


@pytest.mark.parametrize(
    ("latex", "expected"), [(r"M=c\dot\varphi", "PROVED"), (r"M=m\dot\varphi", "not judged")]
)
def test_a_rate_may_be_zero_of_what_moves_at_constant_speed(latex: str, expected: str) -> None:
    block = "%% mechproof\n%% \\varphi(t) : angle\n%% M ; c ; m : others\n%% end\n"
    text = rf"$$M=m\ddot\varphi+c\dot\varphi$$ At constant speed $\ddot\varphi=0$ it is $${latex}$$"
    assert check("paper.tex", block + text).rows[-1].outcome == expected


@pytest.mark.parametrize(
    ("words", "latex", "expected"),
    [
        (HELD, r"i=\frac{n_1}{n_3}=1-i_0", "PROVED"),
        (HELD, r"i=\frac{n_1}{n_3}=1+i_0", "REFUTED"),
        ("Otherwise", r"i=\frac{n_1}{n_3}=1-i_0", "not judged"),
        # Words before another equation apply to that one.
        (
            rf"{HELD} $$n_1=\left(1-i_0\right)n_3$$ In general",
            r"i=\frac{n_1}{n_3}=1-i_0",
            "not judged",
        ),
        ("Then", r"i=\frac{n_1}{n_3}=1-i_0,\qquad n_2=0", "PROVED"),
        ("Then", r"i=\frac{n_1}{n_3}=1+i_0,\qquad n_2=0", "REFUTED"),
        # It follows from the constraint in that case.
        (HELD, r"i=\frac{n_1}{n_3}=1+\frac{z_2}{z_1}", "PROVED"),
        (HELD, r"i=\frac{n_1}{n_3}=1-\frac{z_2}{z_1}", "not judged"),
        # A letter that is printed again.
        ("With the arm held ($n_3=0$)", r"i=\frac{n_1}{n_2}=i_0", "PROVED"),
        ("With the arm held ($n_3=0$)", r"i=\frac{n_1}{n_2}=-i_0", "REFUTED"),
        # It holds in general, not only in the case stated.
        (HELD, r"i=1-i_0=\frac{n_2-n_1}{n_2-n_3}", "PROVED"),
    ],
)
def test_a_row_is_meant_at_what_is_said_to_be_zero_beside_it(
    words: str, latex: str, expected: str
) -> None:
    rows = check("paper.tex", rf"{TRAIN}{words} \begin{{equation}}{latex}\end{{equation}}").rows
    steps = [row for row in rows if row.role in ("step", "printed again") and row.name[1] == "2"]
    assert steps[-1].outcome == expected, steps[-1].reason


@pytest.mark.parametrize(
    ("words", "outcome"),
    [
        (r"At $\psi=0$ we obtain", "REFUTED"),
        (r"At $\psi=0$ and $\psi=\pi$ we obtain", "not judged"),
        (r"At $\psi=0$ or $\pi/2$ we obtain", "not judged"),
        (r"At $\psi=0$ and with the length $a$ we obtain", "REFUTED"),
    ],
)
def test_of_two_values_that_words_say_none_is_meant(words: str, outcome: str) -> None:
    rows = check("paper.tex", rf"{LETTERS}{words} $$h=b-a$$").rows
    assert rows[-1].outcome == outcome, rows[-1].reason


QUARTER = r"h=\sqrt{b^2+c^2}"


@pytest.mark.parametrize(
    ("before", "latex", "behind", "outcome"),
    [
        (r"For $\psi=90^\circ$ this becomes", QUARTER, "", "PROVED"),
        (r"For $\psi=\pi/2$ this becomes", QUARTER, "", "PROVED"),
        # Words may be meant otherwise: they accuse nothing.
        (r"For $\psi=\pi/2$ this becomes", r"h=\sqrt{b^2-c^2}", "", "not judged"),
        (r"If the wheel is steep, $\psi=\pi/2$, we have", QUARTER, "", "PROVED"),
        ("We have", QUARTER, r"if $\psi=\pi/2$.", "PROVED"),
        ("We have", QUARTER, r". The angle is $\psi=\pi/2$.", "not judged"),
        (r"For $c=b$ it is", r"h=a\cos\psi+b\sqrt{1+\sin^2\psi}", "", "PROVED"),
        (r"For $c=b$ it is", r"h=a\cos\psi+b\sqrt{1-\sin^2\psi}", "", "not judged"),
        (r"For $c=d=b$ it is", r"h=a\cos\psi+d\sqrt{1+\sin^2\psi}", "", "PROVED"),
        # Two values, one that the words do not say of it, and what is said of all values.
        (r"For $\psi=\pi/2$ or $\psi=\pi$ it is", QUARTER, "", "not judged"),
        (r"For $\psi=\pi/2$ it is $$k=1$$ In general the lift is", QUARTER, "", "not judged"),
        (r"With $\psi=\pi/2$ known, we have", QUARTER, "", "not judged"),
        (r"Solve for $\psi=\pi/2$. We have", QUARTER, "", "not judged"),
        # An equation that prints the letter is not meant for one number.
        (r"For $k=1$ it is", r"h=ka\cos\psi+\sqrt{b^2+(c\sin\psi)^2}", "", "not judged"),
    ],
)
def test_words_say_of_which_case_an_equation_is(
    before: str, latex: str, behind: str, outcome: str
) -> None:
    rows = check("paper.tex", rf"{LETTERS}{before} $${latex}$$ {behind}").rows
    assert rows[-1].outcome == outcome, rows[-1].reason


def test_what_holds_in_a_case_proves_nothing_else() -> None:
    text = rf"{LETTERS}For $\psi=\pi/2$ it is $${QUARTER}$$ The length is $$d^2=b^2+c^2,$$ hence"
    rows = check("paper.tex", rf"{text} $$h=d,\qquad h^2=d^2$$").rows
    assert [row.outcome for row in rows[2:]] == ["PROVED", "DEFINITION", "not judged", "DEFINITION"]


@pytest.mark.parametrize(
    ("latex", "expected"),
    [(r"1+\frac{z_1}{z_2}", "PROVED"), (r"1+\frac{z_2}{z_1}", "it differs from the third member")],
)
def test_a_member_with_the_same_letters_that_differs_is_told(latex: str, expected: str) -> None:
    row = check(
        "paper.tex", rf"{TRAIN}\begin{{equation}}i=1-\frac1{{i_0}}={latex}\end{{equation}}"
    ).rows[-1]
    assert expected in (row.outcome, row.reason[: len(expected)])


RESONANCE = (r"r=\frac{k\eta^2}{1-\eta^2}", r"\eta=\frac uv", r"s=\frac{\eta+u}u")


@pytest.mark.parametrize(
    ("latex", "outcome"),
    [
        (r"\lim_{\eta\to\infty}r=-k", "PROVED"),
        (r"\lim_{\eta\to\infty}r=k", "REFUTED"),
        # The letter that defines it appears next to it.
        (r"\lim_{\eta\to0}s=1", "not read"),
        (r"\lim_{\eta\to0}(k+u)=k", "not read"),
    ],
)
def test_a_letter_that_is_given_goes_to_a_limit_if_what_gives_it_is_not_there(
    latex: str, outcome: str
) -> None:
    block = "%% mechproof\n%% r ; s ; k ; u ; v ; \\eta : numbers\n%% end\n"
    found = check("paper.tex", block + "".join(f"$${one}$$\n" for one in (*RESONANCE, latex)))
    assert found.rows[-1].outcome == outcome, found.rows[-1].reason
