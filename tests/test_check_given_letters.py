"""Pasted equations whose letters are given: by values, as counts, by conditions before arrows."""

from __future__ import annotations

import pytest

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Judgement

pytestmark = pytest.mark.usefixtures("judged_here")


def judge(latex: str, *where: str, values: tuple[str, ...] = (), natural: str = "") -> Judgement:
    pasted = Pasted(latex, where=where, values=values, natural=tuple(natural))
    (judgement,) = judge_pasted(pasted).judgements
    return judgement


# Roots, logarithms and the like have no real value for these letters.
COMPLEX = [
    (r"\sqrt{xy}=-\sqrt x\sqrt y", ("x=-1", "y=-1")),
    (r"\sqrt x\sqrt y=-1", ("x=-1", "y=-1")),
    (r"\cosh(\ln x)=-1", ("x=-1",)),
    (r"(\ln x)^2=-\pi^2", ("x=-1",)),
    (r"|\ln x|=\pi", ("x=-1",)),
    (r"|\arcsin x|>1", ("x=2",)),
    (r"\frac{\sqrt{1-x^2}}{\sqrt{1-x}}=\sqrt{1+x}", ("x=2",)),
    (r"x^a=\mathrm e^{a\ln x}", ("x=-1", "a=2")),
    (r"\left(\sqrt x\right)^a=x^{a/2}", ("x=-1", "a=4")),
    (r"\sqrt x\sqrt x=x", ("x=-a^2",)),
]


@pytest.mark.parametrize(("latex", "values"), COMPLEX)
def test_what_has_no_real_value_is_not_proved(latex: str, values: tuple[str, ...]) -> None:
    assert judge(latex, values=values).verdict == "UNDECIDED"


def test_a_root_that_a_value_cancels_needs_one() -> None:
    equation = r"\sqrt{xy}=\sqrt x\sqrt y"
    assert judge(equation, "y<0", values=("x=0",)).verdict == "UNDECIDED"
    assert judge(equation, "y>0", values=("x=0",)).verdict == "PROVED"
    assert judge(r"\sqrt x\sqrt x=x", values=("x=a^2",)).verdict == "PROVED"


# A root of a product says nothing about one factor where the other is zero.
HIDDEN = [
    (r"\frac{a+b}2\ge\sqrt{ab}", "a>=0"),
    (r"\sqrt{ab}\ge-b", "a>=0"),
    (r"\sqrt[4]{ab}+b\ge0", "a>=0"),
    (r"\sqrt{(1-a)b}+b\ge0", "a<=1"),
    (r"\sqrt{(a-b)c}+c\ge0", "a>=b"),
]


@pytest.mark.parametrize(("latex", "where"), HIDDEN)
def test_a_factor_may_be_negative_beside_a_zero(latex: str, where: str) -> None:
    assert judge(latex, where).verdict == "REFUTED"


def test_a_mean_is_not_less_than_the_root() -> None:
    assert judge(r"\frac{a+b}2\ge\sqrt{ab}", "a>=0", "b>=0").verdict == "PROVED"


# A print, its verdict for n from 1 onwards, and its verdict for n from 0 onwards.
COUNTS = [
    (r"\sum_{k=0}^n(-1)^k\binom nk=0", "PROVED", "REFUTED"),
    (r"\prod_{k=1}^n\left(1-\frac1k\right)=0", "PROVED", "REFUTED"),
    (r"\sum_{k=0}^n\binom nk=2^n", "PROVED", "PROVED"),
    (r"\sum_{k=1}^nk=\frac{n(n+1)}2", "PROVED", "PROVED"),
    (r"\sum_{k=0}^{n-1}x^k=\frac{1-x^n}{1-x}", "PROVED", "PROVED"),
    (r"\sum_{k=0}^nk=n^2", "REFUTED", "REFUTED"),
]


@pytest.mark.parametrize(("latex", "from_one", "from_zero"), COUNTS)
def test_counts_begin_where_it_is_said(latex: str, from_one: str, from_zero: str) -> None:
    assert judge(latex).verdict == from_one
    assert judge(latex, r"n\ge1").verdict == from_one
    assert judge(latex, r"n\ge0").verdict == from_zero
    assert judge(rf"{latex},\quad 0\le n").verdict == from_zero


def test_a_count_may_be_given() -> None:
    assert judge(r"\sum_{k=0}^nk=0", values=("n=0",)).verdict == "PROVED"
    for value in ("-1", "1/2", "x"):
        with pytest.raises(ValueError, match="natural number"):
            judge(r"\sum_{k=0}^nk=0", values=(f"n={value}",))


IMPLIED = [
    (r"x\ge0\Rightarrow\sqrt{x^2}=x", "PROVED"),
    (r"x\le0\Rightarrow\sqrt{x^2}=x", "REFUTED"),
    (r"x\ge0\implies|x|=x", "PROVED"),
    (r"a=b\Rightarrow a^2=b^2", "PROVED"),
    (r"a=b\Rightarrow a^2=-b^2", "REFUTED"),
    (r"x=1\Longrightarrow x^2=1", "PROVED"),
    (r"a>b\Rightarrow a^2>b^2", "REFUTED"),
    (r"F=ma\Rightarrow a=\frac Fm", "PROVED"),
    (r"F=ma\Rightarrow a=Fm", "REFUTED"),
    (r"a>0,\ b>0\Rightarrow\sqrt{ab}=\sqrt a\sqrt b", "PROVED"),
]


@pytest.mark.parametrize(("latex", "verdict"), IMPLIED)
def test_what_stands_before_an_arrow_is_a_condition(latex: str, verdict: str) -> None:
    assert judge(latex).verdict == verdict


EQUIVALENT = [
    (r"x>1\iff x-1>0", ["PROVED", "PROVED"]),
    (r"x>1\iff x>0", ["PROVED", "REFUTED"]),
    (r"p=2q\Leftrightarrow q=\frac p2", ["PROVED", "PROVED"]),
    (r"p=2q\Longleftrightarrow q=2p", ["REFUTED", "REFUTED"]),
]


@pytest.mark.parametrize(("latex", "verdicts"), EQUIVALENT)
def test_a_double_arrow_is_judged_both_ways(latex: str, verdicts: list[str]) -> None:
    assert [one.verdict for one in judge_pasted(Pasted(latex)).judgements] == verdicts


OTHERS = [
    (r"\mathrm{i}^2=-1", "imaginary unit"),
    (r"{\rm j}^2=-1", "imaginary unit"),
    (r"\operatorname{rot}\operatorname{grad}f=0", "printed as an operator"),
]


@pytest.mark.parametrize(("latex", "reason"), OTHERS)
def test_what_is_no_real_number_is_refused(latex: str, reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        judge(latex)
    name = r"\mathrm{rot}" if "rot" in latex else r"\mathrm{i}"
    assert judge_pasted(Pasted(rf"{name}=-1", names=(name,))).judgements


# Powers with counts as exponents, and multiples of half turns, each with a false twin.
POWERS = [
    (r"\frac{d}{dx}x^n=nx^{n-1}", r"\frac{d}{dx}x^n=nx^n"),
    (r"\frac{d}{dx}x^2=2x", r"\frac{d}{dx}x^2=2"),
    (r"\frac{d}{dx}\mathrm e^{2x}=2\mathrm e^{2x}", r"\frac{d}{dx}\mathrm e^{2x}=\mathrm e^{2x}"),
    (r"\cos n\pi=(-1)^n", r"\cos n\pi=(-1)^{n+1}"),
    (r"\sin 2n\pi=0", r"\cos 2n\pi=-1"),
]


@pytest.mark.parametrize(("latex", "twin"), POWERS)
def test_powers_and_half_turns_are_counted(latex: str, twin: str) -> None:
    assert judge(latex, natural="n").verdict == "PROVED"
    assert judge(twin, natural="n").verdict == "REFUTED"


def test_a_letter_of_a_value_may_be_introduced() -> None:
    assert judge("a=2x", values=("k=a/b",)).verdict == "DEFINITION"


# Letters given by a decimal: one that is a rounding of the other side, and one that is not.
ROUNDED = [
    (r"\omega=2\pi n/60", ("n=1500",), r"\omega=%s", "157.08", "157.18"),
    (r"2\pi n/60=\omega", ("n=1500",), r"\omega=%s", "157.1", "157.0"),
    (r"v=\omega r", ("r=0.05", r"\omega=157.08"), "v=%s", "7.85", "7.84"),
    ("a=b", ("b=1.5",), "a=%s", "1.50", "1.52"),
    ("b=a", ("b=1.52",), "a=%s", "1.52", "1.5"),
]


@pytest.mark.parametrize(("latex", "values", "rounded", "true", "wrong"), ROUNDED)
def test_a_decimal_is_what_the_other_side_rounds_to(
    latex: str, values: tuple[str, ...], rounded: str, true: str, wrong: str
) -> None:
    assert judge(latex, values=(*values, rounded % true)).verdict == "PROVED"
    assert judge(latex, values=(*values, rounded % wrong)).verdict == "REFUTED"


def test_a_decimal_within_an_expression_is_exact() -> None:
    assert judge("v=2r", values=("r=0.333", "v=0.666")).verdict == "PROVED"
    assert judge("3r=1", values=("r=0.333",)).verdict == "REFUTED"
    assert judge(r"v=\omega r", values=("r=0.05", "v=7.85")).verdict == "REFUTED"
    assert judge(r"\omega=\omega\cos0.1", values=(r"\omega=0.5",)).verdict == "REFUTED"
    assert judge(r"a=\frac12b\cos0.1", values=("a=0.5", "b=2a")).verdict == "REFUTED"


@pytest.mark.parametrize("value", ["F=117.7 N", r"F=2\,\mathrm{kN}", "F=100~Nmm"])
def test_a_value_with_a_unit_is_refused(value: str) -> None:
    with pytest.raises(ValueError, match="units are not read"):
        judge(r"F=12\cdot9.81", values=(value,))


def test_a_letter_of_the_equation_is_no_unit() -> None:
    assert judge("d-m=m", values=("d=2 m",)).verdict == "PROVED"


# A condition that is an equation is solved for one of its letters, or for a reciprocal.
TIED = [
    (r"\frac1p+\frac1q=1", "p+q=%s", "pq", "2pq"),
    (r"\frac1p+\frac1q=1", "(p-1)(q-1)=%s", "1", "2"),
    (r"\frac1f=\frac1a+\frac1b", r"f=\frac{ab}{%s}", "a+b", "a-b"),
    (r"\frac2x+y=3", r"x\ne%s", "0", "1"),
    (r"\frac a{\sin A}=\frac b{\sin B}", r"a\sin B=%s", r"b\sin A", r"b\cos A"),
    (r"A+B+C=\pi", r"\sin(A+B)=%s", r"\sin C", r"\cos C"),
    ("x+y=c", r"\dot y=%s", r"-\dot x", r"\dot x"),
    ("x+y=c", r"\dot x%s\dot y=0", "+", "-"),
]


@pytest.mark.parametrize(("where", "latex", "true", "wrong"), TIED)
def test_an_equation_gives_a_letter(where: str, latex: str, true: str, wrong: str) -> None:
    assert judge(latex % true, where).verdict == "PROVED"
    assert judge(latex % wrong, where).verdict == "REFUTED"


def test_a_letter_may_have_a_nonzero_factor() -> None:
    assert judge(r"w=\frac{Av}B", "Av=Bw", "B>0").verdict == "PROVED"
    assert judge(r"w=\frac{Bv}A", "Av=Bw", "A>0", "B<0").verdict == "REFUTED"


def test_a_letter_that_is_not_negative_may_be_a_root() -> None:
    where = (r"c^2=a^2+b^2-2ab\cos\gamma", "a>0", "b>0", "c>0")
    assert judge(r"\cos\gamma=\frac{a^2+b^2-c^2}{2ab}", *where).verdict == "PROVED"
    assert judge(r"\cos\gamma=\frac{a^2+b^2+c^2}{2ab}", *where).verdict == "REFUTED"
    with pytest.raises(ValueError, match="it cannot be solved for a letter"):
        judge(r"\cos\gamma=\frac{a^2+b^2-c^2}{2ab}", where[0], "c<0", r"a\notin\mathbb Z")


def test_an_equation_that_gives_no_letter_is_refused() -> None:
    with pytest.raises(ValueError, match="it cannot be solved for a letter"):
        judge(r"w=\frac{Av}B", "Av=Bw")
    with pytest.raises(ValueError, match="it cannot be solved for a letter"):
        judge("x=y", "x^2=y^2")
    with pytest.raises(ValueError, match="c would depend on what others depend on"):
        judge(r"x\dot x+y\dot y=0", "x^2+y^2=c")


def test_what_a_value_says_in_other_words_is_compared() -> None:
    assert judge("p+q=pq", values=(r"q=\frac p{p-1}",)).verdict == "PROVED"
    assert judge(r"q=\frac p{p-1}", values=(r"q=\frac p{p-1}",)).verdict == "DEFINITION"
    assert judge("y=x", values=("x=2y",)).verdict == "REFUTED"
    assert judge(r"\dot x=\dot y", values=("x=2y",)).verdict == "REFUTED"


# Derivatives of letters whose values depend on moving letters: the values, the print, a true
# insertion and a wrong one.
RATES = [
    ((r"x=r\cos\varphi",), r"\dot x=%s", r"-r\dot\varphi\sin\varphi", r"r\dot\varphi\sin\varphi"),
    (
        (r"x_1=r\cos\varphi",),
        r"\ddot x_1=%s",
        r"-r\ddot\varphi\sin\varphi-r\dot\varphi^2\cos\varphi",
        r"-r\ddot\varphi\sin\varphi+r\dot\varphi^2\cos\varphi",
    ),
    (
        (r"x=r\cos\varphi+\frac r\lambda\sqrt{1-\lambda^2\sin^2\varphi}",),
        r"\dot x=-r\dot\varphi\left(\sin\varphi+\frac{\lambda\sin\varphi\cos\varphi}{%s}\right)",
        r"\sqrt{1-\lambda^2\sin^2\varphi}",
        r"\sqrt{1+\lambda^2\sin^2\varphi}",
    ),
    (
        (r"x=r\cos\varphi", r"y=r\sin\varphi"),
        r"\dot x^2+\dot y^2=%s",
        r"\dot r^2+r^2\dot\varphi^2",
        r"\dot r^2+r\dot\varphi^2",
    ),
    (
        (r"x=A\cos(t+\varphi)",),
        r"\dot x\dot\varphi=-A\sin(t+\varphi)%s\dot\varphi",
        r"(1+\dot\varphi)",
        "",
    ),
    ((r"y=\sin(x+u)",), r"y'u'=\cos(x+u)u'%s", "(1+u')", ""),
    (("y=u^2",), "y'=%s", "2uu'", "uu'"),
    (
        (r"x=r\cos\varphi",),
        r"\frac{d}{dt}(x^2)=-2xr%s\sin\varphi",
        r"\dot\varphi",
        r"\dot\varphi^2",
    ),
    ((r"x=r\cos\varphi", r"\dot\varphi=c"), r"\ddot x=%s", "-c^2x", "-cx"),
    ((r"\dot x=c",), r"\frac{d^2}{dt^2}(x^2)=%s", "2c^2", "2c"),
]


@pytest.mark.parametrize(("values", "latex", "true", "wrong"), RATES)
def test_letters_in_values_may_move(
    values: tuple[str, ...], latex: str, true: str, wrong: str
) -> None:
    assert judge(latex % true, values=values).verdict == "PROVED"
    assert judge(latex % wrong, values=values).verdict == "REFUTED"


# Values with other letters, of which it is not stated whether they move.
OPEN_RATES = [
    (r"x=s\cos\varphi", r"\dot x=-s\dot\varphi\sin\varphi"),
    (r"x=A\cos(\omega t+\varphi)", r"\dot x\dot\varphi=-A\omega\sin(\omega t+\varphi)\dot\varphi"),
    (r"x=r\cos\varphi", r"\dot x=-r\omega\sin\varphi"),
    (r"x=\sin\varphi", r"x'=\varphi'\cos\varphi"),
    (r"\dot\varphi=\omega", r"\frac{d}{dt}(r\dot\varphi)=0"),
]


@pytest.mark.parametrize(("value", "latex"), OPEN_RATES)
def test_what_may_move_in_a_value_is_asked(value: str, latex: str) -> None:
    with pytest.raises(ValueError, match=r"by which letter|may depend"):
        judge(latex, values=(value,))


def test_a_derivative_of_a_value_is_told() -> None:
    taken = judge_pasted(
        Pasted(r"\dot x=-r\dot\varphi\sin\varphi", values=(r"x=r\cos\varphi",))
    ).taken
    assert taken[r"\dot{x}"] == r"= -\dot{\varphi}*r*sin(\varphi)"
    assert (taken["r"], taken[r"\varphi"]) == ("real, a constant", "real, depends on t")


@pytest.mark.parametrize(
    ("latex", "value", "told"),
    [
        ("y'=2xu", "y=x^2u", {"u": "real, a constant", "x": "real"}),
        (r"\dot x=v", "x=vt", {"v": "real, a constant", "t": "real"}),
        (r"y'=2\theta", r"y=\theta^2", {r"\theta": "real"}),
    ],
)
def test_what_is_taken_as_a_constant_is_told(latex: str, value: str, told: dict[str, str]) -> None:
    taken = judge_pasted(Pasted(latex, values=(value,))).taken
    assert {letter: taken[letter] for letter in told} == told


# A curve, a derivative along it, its true value and a wrong one.
CURVES = [
    (
        (r"x=r(t-\sin t)", r"y=r(1-\cos t)"),
        r"\frac{dy}{dx}=%s",
        r"\cot\frac t2",
        r"\tan\frac t2",
    ),
    (
        (r"x=r(t-\sin t)", r"y=r(1-\cos t)"),
        r"\frac{d^2y}{dx^2}=%s",
        r"-\frac1{r(1-\cos t)^2}",
        r"-\frac1{r(1-\cos t)}",
    ),
    (
        (r"x=r\cos\varphi", r"y=b\sin\varphi"),
        r"\frac{dy}{dx}=%s",
        r"-\frac br\cot\varphi",
        r"\frac br\cot\varphi",
    ),
]


@pytest.mark.parametrize(("values", "latex", "true", "wrong"), CURVES)
def test_a_derivative_goes_along_a_curve(
    values: tuple[str, ...], latex: str, true: str, wrong: str
) -> None:
    assert judge(latex % true, "r>0", values=values).verdict == "PROVED"
    assert judge(latex % wrong, "r>0", values=values).verdict == "REFUTED"


@pytest.mark.parametrize(
    "values", [("x=|t|", "y=t^2"), (r"x=t+\varphi", "y=t"), ("x=2", "y=t"), ("x=t^2", "y=r")]
)
def test_a_derivative_along_no_single_letter_is_refused(values: tuple[str, ...]) -> None:
    with pytest.raises(ValueError, match="a derivative with respect to x"):
        judge(r"\frac{dy}{dx}=1", values=values)
