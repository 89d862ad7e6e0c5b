"""The command that judges one pasted equation."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result
from weights import first_of

import mechproof
from mechproof.cli import app


def run(*arguments: str) -> Result:
    return CliRunner().invoke(app, ["check", *arguments])


STROKE = r"\sqrt{{l^2-r^2\sin^2\varphi}}=l\sqrt{{1-{}\sin^2\varphi}}"
CRANK = ("--let", r"\lambda=r/l", "--where", "l>r", "--where", "r>0", "--where", "l>0")
CARDAN = r"\frac{{c}}{{\cos^2\varphi+c^2\sin^2\varphi}}=\frac{{\cos\beta}}{{1-\sin^2\beta{}}}"
JOINT = ("--let", r"c=\cos\beta")
INVOLUTE = r"x^2+y^2=r^2{}r^2t^2"
CURVE = ("--let", r"x=r\cdot(\cos t+t\sin t)", "--let", r"y=r\cdot(\sin t-t\cos t)")

CHECKED = [
    # Three formulas from textbooks, the third with a misprint, then uses of the options.
    ([r"\int_0^x \frac{dt}{1+t^2} = \mathrm{arctg}\,x"], ["PROVED"]),
    ([r"\sin\alpha+\sin\beta=2\sin\frac{\alpha+\beta}{2}\cos\frac{\alpha-\beta}{2}"], ["PROVED"]),
    ([r"\cos 3x=4\cos^3 x-3\sin x"], ["REFUTED"]),
    ([r"\sin^2x+\cos^2x=1=\mathrm{tg}\,x\,\mathrm{ctg}\,x"], ["PROVED", "PROVED"]),
    ([r"\sqrt{x^2}=x"], ["REFUTED"]),
    ([r"\sqrt[3]{-8}=-2"], ["PROVED"]),
    ([r"\sqrt{x^2}=x", "--where", "x>0"], ["PROVED"]),
    ([r"\frac{AC}{BD}\cdot BD=AC", "--name", "AC", "--name", "BD"], ["PROVED"]),
    (["a(1+x)=a+ax", "--factor", "a"], ["PROVED"]),
    (["x^a-1<=a(x-1)", "--where", "x>0", "--where", "0<a<1"], ["PROVED"]),
    (["x^a-1<=a(x+1)", "--where", "x>0", "--where", "1<a<2"], ["REFUTED"]),
    (["k^2=x^4", "--let", "k=x^2"], ["PROVED"]),
    (["y=2x"], ["DEFINITION"]),
    ([r"\int\cos x=\sin x"], ["ILL_FORMED"]),
    ([r"\int\cos x\,dx=\sin x+C", "--from", "0", "--let", "C=0"], ["PROVED"]),
    (
        [
            r"\sum_{k=1}^n(q_k-\bar q)^2=\sum_{k=1}^n q_k^2-n\bar q^2",
            "--let",
            r"\bar q=\frac1n\sum_{k=1}^n q_k",
        ],
        ["PROVED"],
    ),
    ([r"(-1)^{2m}=1", "--natural", "m"], ["PROVED"]),
    ([r"x+a>x", "--where", "a>0"], ["PROVED"]),
    (["x^2=1", "--where", "x=1"], ["PROVED"]),
    ([r"\tan A+\tan B+\tan C=\tan A\tan B\tan C", "--where", r"A+B+C=\pi"], ["PROVED"]),
    ([r"\sin A+\sin B=\sin C", "--where", r"A+B+C=\pi"], ["REFUTED"]),
    ([r"s(s-a)=\frac{(b+c)^2-a^2}4", "--where", r"s=\frac{a+b+c}2"], ["PROVED"]),
    # From three textbooks on mechanisms, each as printed and with one misprint: the stroke of a
    # slider-crank, the sides of a Cardan joint, an involute's distance from the centre.
    ([STROKE.format(r"\lambda^2"), *CRANK], ["PROVED"]),
    ([STROKE.format(r"\lambda"), *CRANK], ["REFUTED"]),
    ([CARDAN.format(r"\sin^2\varphi"), *JOINT], ["PROVED"]),
    ([CARDAN.format(r"\cos^2\varphi"), *JOINT], ["REFUTED"]),
    ([INVOLUTE.format("+"), *CURVE], ["PROVED"]),
    ([INVOLUTE.format("-"), *CURVE], ["REFUTED"]),
    ([r"\sum_{k=1}^n k=n(n+1)/2"], ["PROVED"]),
    ([r"\sum_{k=1}^{n-1}k=\frac{n(n-1)}{2}"], ["PROVED"]),
    ([r"$\sin^2x+\cos^2x=1.$"], ["PROVED"]),
    ([r"\begin{equation}\sin 30°=\tfrac12,\label{eq}\end{equation}"], ["PROVED"]),
    ([r"\left|x\left|y\right|z\right|=\left|xyz\right|"], ["PROVED"]),
    ([r"\left|xy\right|=\left|x\right|\left|y\right|"], ["PROVED"]),
    ([r"\left|xy\right|=\left|x\right|y"], ["REFUTED"]),
    ([r"\left|\frac xy\right|=\frac{\left|x\right|}{\left|y\right|}"], ["PROVED"]),
    ([r"\left|\frac xy\right|=\frac{x}{\left|y\right|}"], ["REFUTED"]),
    ([r"\sqrt{x^2y^2}=\left|xy\right|"], ["PROVED"]),
    ([r"\sqrt{x^2y^2}=xy"], ["REFUTED"]),
    ([r"\mathop{\mathrm{ch}}\nolimits x+\operatorname{sh}x=\mathrm{e}^x"], ["PROVED"]),
    ([r"\mathrm{ch}^2x+\mathrm{sh}^2x=1"], ["REFUTED"]),
    ([r"\exp(x+y)=\exp x\exp y"], ["PROVED"]),
    ([r"\exp(x-y)=\exp x\exp y"], ["REFUTED"]),
    ([r"\mathrm{ch}\frac x2=\sqrt{\frac{1+\mathrm{ch}\,x}{2}}"], ["PROVED"]),
    ([r"\operatorname{inv}\alpha=\operatorname{tg}\alpha-\alpha"], ["PROVED"]),
    ([r"\int_0^1 x^n\,dx=\frac{1}{n+1}", "--natural", "n"], ["PROVED"]),
    ([r"\int_0^{2\pi}\mathrm{e}^{\cos x}\cos(\sin x)\,dx=2\pi"], ["ENCLOSED"]),
    ([r"\prod_{k=1}^nk=n!"], ["PROVED"]),
    ([r"\prod_{k=1}^nk=(n+1)!"], ["REFUTED"]),
    ([r"\max(x,-10^9)=x"], ["REFUTED"]),
    ([r"z_1d_1=d_1z_1"], ["PROVED"]),
    # Braces after a function, conditions after an equation, bars around a matrix.
    ([r"\exp{-x}=\frac1{\exp{x}}"], ["PROVED"]),
    ([r"\exp{x+y}=\exp{x}\exp{y}"], ["PROVED"]),
    ([r"\cos{-x}=\cos{x}"], ["PROVED"]),
    ([r"\arccos{-1}=\pi"], ["PROVED"]),
    ([r"\sin{x+1}=1+\sin x"], ["REFUTED"]),
    ([r"\arctan x+\arctan\frac1x=\frac\pi2,\quad x>0"], ["PROVED"]),
    ([r"\arctan x+\arctan\frac1x=\frac\pi2,\quad x<0"], ["REFUTED"]),
    ([r"|x|=x,\ x\ge0"], ["PROVED"]),
    ([r"|x|=-x\quad(x\ge0)"], ["REFUTED"]),
    ([r"|xy|=xy\text{ for }x,y>0"], ["PROVED"]),
    ([r"x+y\ge2\sqrt{xy},\ x,y>0"], ["PROVED"]),
    ([r"|x|=x=\sqrt{x^2},\ x>0"], ["PROVED", "PROVED"]),
    ([r"\left|\begin{matrix}a&b\\c&f\end{matrix}\right|=af-bc"], ["PROVED"]),
    ([r"\left|\begin{matrix}a&b\\c&f\end{matrix}\right|=|af-bc|"], ["REFUTED"]),
    # An empty index prints nothing.
    ([r"\int_0^y(x-x_{})\,dx=0"], ["PROVED"]),
    ([r"\lim_{x\to0}(x+x_{})=0"], ["PROVED"]),
    ([r"\lim_{x\to0}(x+x_{}+1)=0"], ["REFUTED"]),
    ([r"\int_0^1\max(t,0)\,dt=\frac12"], ["PROVED"]),
    ([r"\int_0^1\max(t,0)\,dt=\frac13"], ["REFUTED"]),
    (["\\sin²\u03b1+\\cos²\u03b1=1"], ["PROVED"]),
    (["\u03b1+\\alpha=2\\alpha"], ["PROVED"]),
    ([r"\det A=1", "--let", r"A=\begin{pmatrix}1&x\\0&1\end{pmatrix}"], ["PROVED"]),
    (["=".join("abcfghklmopq")], ["DEFINITION"] * 11),
    ([r"r_b(x+1)=r_bx+r_b", "--factor", "r_b"], ["PROVED"]),
]


def test_the_answer_says_where_it_is_judged(tmp_path: Path) -> None:
    file = tmp_path / "rows.json"
    print_ = r"\sqrt{(x-y)^2}=x-y\text{ for }y>0"
    done = run(print_, "--where", "x>y", "--json", str(file))
    (row,) = json.loads(file.read_text(encoding="utf-8"))["rows"]
    assert (row["verdict"], row["on"]) == ("PROVED", "y > 0 and x>y")
    assert "where y > 0 and x>y" in done.output


@pytest.mark.slow
@pytest.mark.usefixtures("judged_here")
@pytest.mark.parametrize(("arguments", "verdicts"), CHECKED, ids=[c[0][0] for c in CHECKED])
def test_an_equation_is_judged(arguments: list[str], verdicts: list[str], tmp_path: Path) -> None:
    file = tmp_path / "rows.json"
    done = run(*arguments, "--json", str(file))
    good = all(verdict in ("PROVED", "DEFINITION", "CONVENTION") for verdict in verdicts)
    assert done.exit_code == (0 if good else 1), done.output
    rows = json.loads(file.read_text(encoding="utf-8"))["rows"]
    assert [row["verdict"] for row in rows] == verdicts
    assert all(f"read as   {row['read_as']}" in done.output for row in rows)
    assert "Unless you say otherwise" in done.output


@pytest.mark.usefixtures("judged_here")
def test_what_a_letter_is_taken_for_is_told() -> None:
    done = run(r"\frac1n\sum_{k=1}^n x=x", "--where", "0<x<1")
    assert "taken as  n: a natural number" in done.output
    assert "taken as  x: in Interval.open(0, 1)" in done.output


REFUSED = [
    (["f(x)=1"], "--factor 'f'"),
    (["f(g(x))=1"], "--factor 'f'"),
    (["x^a-1<=a(x-1)", "--where", "x>0"], "--factor 'a'"),
    (["v(t-t_0)=v", "--where", "v>0"], "--factor 'v'"),
    (["y(x+h)>y", "--where", "y>0"], "--factor 'y'"),
    (["a(t)=a(x-1)", "--where", "a>0"], "--factor 'a'"),
    ([r"\int_0^1f(x)\,dx=f(x)", "--name", "f(x)"], "but x runs"),
    ([r"\lim_{x\to0}f(x)=f(x)", "--name", "f(x)"], "but x runs"),
    ([r"\sum_{k=1}^nf(k)=nf(k)", "--name", "f(k)"], "but k runs"),
    (["e^2=1"], "--name 'e'"),
    ([r"r=\frac p{1+e\cos\varphi}"], "--name 'e'"),
    ([r"\sqrt{1-e^2}e^x=1"], "--name 'e'"),
    (["j^2=-1"], "--name 'j'"),
    ([r"s'=h", "--let", r"s=h\sin\varphi"], "as a fraction"),
    ([r"\dot x=x", "--let", "x=2s"], "as a fraction"),
    ([r"\lim_{x\to0}x+1=x"], "another letter"),
    ([r"x\pm y=1"], "both signs, or either"),
    ([r"x=\pm a", "--let", "x=2y"], "both signs, or either"),
    ([r"y=\int\cos x\,dx"], "--from 0"),
    ([r"\int\cos x\,dx=\sin x+C", "--from", "0"], "--let 'C=0'"),
    (["9^{9^{9^9}}=1"], "not evaluated"),
    (["x+1"], "no relation sign"),
    (["x=1", "--let", "x^2=1"], "letter=expression"),
    (["x=1", "--where", "x"], "no relation sign"),
    (["2x=x", "--where", r"x>\begin{pmatrix}1&2\end{pmatrix}"], "cannot be ordered"),
    ([r"\begin{pmatrix}1&2\end{pmatrix}<1"], "matrices cannot be ordered"),
    ([r"\sum_{k=1}^n\begin{pmatrix}1&k\end{pmatrix}=1"], "a matrix where a number is expected"),
    ([r"\int_0^1\begin{pmatrix}1&t\end{pmatrix}dt=1"], "a matrix where a number is expected"),
    ([r"\max(\begin{pmatrix}x&y\end{pmatrix},1)=1"], "a matrix where a number is expected"),
    (["2x=x", "--where", "y<z", "--where", "z<y"], "is it empty?"),
    (["2x=x", "--let", "y=x^2", "--where", "y<0"], "the domain is empty"),
    (["9^{9^{9^{9}}}=1"], "not evaluated"),
    (["{" * 5000 + "x" + "}" * 5000 + "=x"], "nested too deeply"),
    (["(" * 5000 + "x=x"], "nested too deeply"),
    ([""], "must follow"),
    (["x\0=x"], "U+0000"),
    (["1" * 20000 + "=x"], "300 digits"),
    (["cosx=1"], "in italics"),
    ([r"\delta x=x_2-x_1"], r"--name '\delta x'"),
    ([r"\vec v=wr+v_x"], "components"),
    ([r"e^2=1"], r"\mathrm{e}"),
    ([r"A^TA=1"], "transpose of a matrix"),
    ([r"|x|y|z|=1"], r"\left|"),
    ([r"\tan^{-1}x=\arctan x"], "inverse or its reciprocal"),
    ([r"\sqrt{-1}^2=-1"], "no real value"),
    ([r"\sum_{i<j}x_ix_j=1"], "first value"),
    ([r"y=2x,\ y=3x"], "defined twice"),
    ([r"x=-1", "--where", "x>0"], "--where restricts it"),
    (["x^2=1", "--where", "xy=1"], "by --let"),
    (["x+y=1", "--where", "x=1-y", "--where", "y=1-x"], "defined by itself"),
    (["x+y=1", "--where", "x=1-y", "--let", "x=2"], "already has a value"),
    (["x^2=1", "--where", "x<0", "--where", "x>1"], "no value of x"),
    (["x^2=1", "--let", "x=y", "--let", "y=x"], "defined by itself"),
    (["x^2=1", "--let", "x=1", "--let", "x=2"], "already has a value"),
    (["x+y=1", "--name", "+"], "no letter"),
    ([r"\int x\,dx=1", "--from", "0=1"], "single expression"),
    (["\\sin^{\u22121}x=\\arcsin x"], "inverse or its reciprocal"),
    (["\u0445+x=1"], "look alike"),
    (["\u0445=1", "--where", "x>0"], "look alike"),
    (["1.5E-3=x"], "power of ten"),
    (["x=y", "--where", "x"], "no relation sign"),
    ([r"|x|=x\text{ for }x=1"], "by --let"),
    ([r"|x|=x,\ x>0,\ x<0"], "no value of x"),
    ([r"y=2x,\ y>0"], "its condition"),
    ([r"|x|=x,\ x\in\mathbb Z"], "--natural"),
    ([r"x_{\alpha}=x_{alpha}"], "too similar"),
    ([r"\int_0^1x_{\alpha}x_{alpha}\,dx_{alpha}=1"], "would be confused with"),
    ([r"\overline{x+y}=\bar x+\bar y"], r"--name '\overline{x+y}'"),
    ([r"\Sigma_{k=1}^nk=1"], r"\sum"),
    (["(1, 2)<3"], "cannot be ordered"),
    ([r"|x|=x\text{ for }x>(1, 2)"], "matrices cannot be ordered"),
]


LEFT_OPEN = [
    (r"\int_0^1\int_0^1\frac1{x-y}\,dx\,dy=0", "an integral of an integral cannot be enclosed"),
    (r"\int_0^1\operatorname{arth}\frac t2\,dt=1", "is not shown to be zero"),
]


@pytest.mark.usefixtures("judged_here")
@pytest.mark.parametrize(("latex", "told"), first_of(LEFT_OPEN))
def test_what_is_left_open_says_why_in_a_sentence(latex: str, told: str) -> None:
    done = run(latex)
    assert done.exit_code == 1
    assert told in " ".join(done.output.split())
    assert "Error" not in done.output


@pytest.mark.slow
@pytest.mark.usefixtures("judged_here")
@pytest.mark.parametrize(("arguments", "told"), REFUSED, ids=[" ".join(r[0]) for r in REFUSED])
def test_what_cannot_be_read_without_a_guess_is_refused(arguments: list[str], told: str) -> None:
    done = run(*arguments)
    assert done.exit_code == 2
    assert told in done.output


@pytest.mark.usefixtures("judged_here")
def test_what_refuted_means_is_told() -> None:
    done = run(r"c^2=a^2+b^2-2ab\cos\gamma")
    assert "REFUTED means: not true for all values of its letters" in done.output
    assert "REFUTED means" not in run("x=x").output


def test_what_takes_too_long_fails() -> None:
    done = run(r"\sin x=x", "--limit", "0")
    assert done.exit_code == 1
    assert "no answer within the time limit" in done.output


def test_an_equation_is_judged_from_python() -> None:
    (found,) = mechproof.judge_equation(r"\cos 2x=2\cos^2x-1").judgements
    assert found.verdict == "PROVED"
    (found,) = mechproof.judge_equation(r"\cos 2x=2\cos^2x+1", where=["0<x<1"]).judgements
    assert found.verdict == "REFUTED"
    with pytest.raises(TypeError, match="where"):
        mechproof.judge_equation("a=b", where="a<b")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="not declared"):
        mechproof.judge_equation("a=b+e")
