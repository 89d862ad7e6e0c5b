"""What a draft of letters proposes: names as they must be declared, and meanings from the text."""

import pytest
from small_papers import draft


@pytest.mark.parametrize(
    ("display", "lines"),
    [
        (r"N=J_k\ddot\beta_k", [r"\beta_{k}(t) :"]),
        (r"\dot{\mathbf s}=\begin{bmatrix}v\\w\end{bmatrix}", [r"\dot{\mathbf{s}} 2x1 :"]),
        (r"h(\psi)=b\psi", [r"h(\psi) :"]),
        (r"\dddot{y}(t)=b\psi", [r"y(t) :"]),
        ("W(p,q)=pq", ["W(p,q) :"]),
        ("y=c(p+q)", ["factor c"]),
        (r"\sum N_k=\mu b", [r"\sum N_k :"]),
        (r"C_{\alpha f}=v_{\mathrm{max}r}", [r"C_{\alpha f} :", r"v_{\max r} :"]),
        (r"s_2=s_1+v\,\Delta t", [r"\Delta t :"]),
        (r"\mathcal K=b-c", [r"\mathcal{K} :"]),
        # A size at the end of a display shows the unit of its letter; a bare number does not.
        (
            r"F_{\text{in}}=mb=0.5\cdot40=20\,\mathrm{N}\approx\SI{0.02}{kN}",
            [r"F_{\text{in}} : [N]"],
        ),
        (r"s=\frac v2=0.2\,\mathrm m", ["s : [m]"]),
        (r"\gamma=\arctan b=11.3^\circ", [r"\gamma : [rad]"]),
        (r"\eta=\frac vw=0.81", [r"\eta :"]),
        ("b=h+e", ["# a letter here, Euler's number elsewhere:", "e :"]),
        (r"z=\begin{bmatrix}0&1\end{bmatrix}v", ["z :"]),
        (r"z=\begin{bmatrix}0&1\end{bmatrix}", ["z 1x2 :"]),
        (
            r"Q(\psi)=\begin{pmatrix}\cos\psi&\sin\psi\\-\sin\psi&\cos\psi\end{pmatrix}",
            [r"Q(\psi) | Q 2x2 :"],
        ),
        (r"p=[Q]p+g,\quad p=\begin{bmatrix}h\\k\\l\end{bmatrix}", ["Q 3x3 :", "g 3x1 :"]),
        (r"{}^F_GQ\,{}^Gp={}^Fp,\quad{}^Gp=\begin{bmatrix}h\\k\\l\end{bmatrix}", ["{}^{F}p 3x1 :"]),
        (r"|Q|=\left|\begin{array}{cc}h&k\\l&m\end{array}\right|=hm-kl", ["Q 2x2 :"]),
        (r"c=cos(h)+cos^{-1}(k)", [r"function cos is \cos", r"function \cos^{-1} is \arccos"]),
        (
            r"N=[U]+\sin\psi[k]\end{equation}\begin{equation}k=h\begin{bmatrix}0\\0\\1\end{bmatrix}"
            r"\end{equation}\begin{equation}U=\begin{bmatrix}h&0&0\\0&m&0\\0&0&1\end{bmatrix}",
            ["[k] 3x3 :", "U 3x3 :"],
        ),
    ],
)
def test_letters_are_named_as_they_are_declared(display: str, lines: list[str]) -> None:
    found = draft(rf"\begin{{equation}}{display}\end{{equation}}").splitlines()
    assert not [line for line in found if "missing here" in line]
    assert [line for line in lines if f"%% {line}" not in found] == []


def test_an_e_that_is_raised_is_eulers_number_elsewhere_too() -> None:
    found = draft(r"$$b=h+e$$ $$c=e^{-kt}$$")
    assert "%% e :" not in found
    assert "missing here" in found


@pytest.mark.parametrize(
    ("display", "is_euler"),
    [
        (r"x=Ae^{-kt}", True),
        (r"x=\underbrace{mge^{-kt}}_{c}+e^{kt}", True),
        # An eccentricity and its square, and a command that ends in e.
        (r"x=Ae^2-be", False),
        (r"x=Ae^{-kt}+e", False),
        (r"x\le^{n}k", False),
    ],
)
def test_an_e_that_is_raised_behind_other_letters_is_eulers_number(
    display: str, is_euler: bool
) -> None:
    assert (r"%% let e=\mathrm{e}" in draft(f"$${display}$$").splitlines()) == is_euler


def test_functions_of_values_in_sentences_are_drafted() -> None:
    found = draft(r"$$x=k\sin(\omega t+\phi)$$ where $\phi=\tan^{-1}(\frac bc)$.").splitlines()
    assert {r"%% let \phi=\tan^{-1}(\frac bc)", r"%% function \tan^{-1} is \arctan"} <= {*found}


@pytest.mark.parametrize(
    ("by", "lines"),
    [
        (r"\dot z_{s}", ["Q :", "T_{s} :", "z_{s}(t) :"]),
        ("z_{s}", ["Q :", "T_{s}(z_{s}) :", "z_{s} :"]),
    ],
)
def test_what_is_differentiated_by_a_rate_depends_on_no_letter_for_this(
    by: str, lines: list[str]
) -> None:
    found = draft(rf"$$Q=\frac{{dT_{{s}}}}{{d{by}}}$$").splitlines()
    assert [line.removeprefix("%% ") for line in found if line.endswith(" :")] == lines


@pytest.mark.parametrize(
    ("index", "line"), [("pitch", r"\theta_{pitch} :"), ("bi", r"\theta_{bi}(i) :")]
)
def test_a_word_as_an_index_does_not_run(index: str, line: str) -> None:
    found = draft(rf"$$T=\sum_{{i=1}}^4k_i\theta_{{{index}}}$$").splitlines()
    assert {f"%% {line}", "%% k_{i}(i) :"} <= {*found}


def test_formulas_of_letters_that_only_other_formulas_have_are_drafted() -> None:
    found = draft(r"$$x=kN$$ where $N=b+K_1$ and $K_1=\frac da$; $u=3$ is unused.").splitlines()
    lines = {"K_{1} :", "a :", "d :", "let N=b+K_1", r"let K_{1}=\frac da"}
    assert {f"%% {line}" for line in lines} <= {*found}
    assert "%% u :" not in found


def test_letters_beside_one_that_may_be_a_differential_are_drafted() -> None:
    found = draft(r"$$b=R\theta-\frac d2$$ $$\int_0^1x\,dx=w$$").splitlines()
    assert {"%% R :", r"%% \theta :"} <= {*found}
    assert "%% d :" not in found
    assert any("missing here" in line for line in found)


@pytest.mark.parametrize(
    ("words", "line"),
    [
        ("where $b$ is the width of the belt [mm],", "b : width of the belt [mm]"),
        ("* $b$ width of the belt\n", "b : width of the belt"),
        ("where $b$ is the **mean width** of the *belt*.", "b : mean width of the belt"),
        ("- $b =$ width of the belt (at rest)\n", "b : width of the belt"),
        ("- Width of the belt: $b$\n", "b : Width of the belt"),
        ("| $b$ | width of the belt | mm |\n", "b : width of the belt [mm]"),
        ("\\item $b$: width of the belt\n", "b : width of the belt"),
        (
            "Let $a$ and $b$ be the widths of belt, pulley and rim.",
            "b : widths of belt, pulley and rim",
        ),
        ("With widths $a$, $b$ the length of the belt is\n", "b : widths"),
        # Words directly in front of a letter, without a verb between them.
        ("the centre distance $a$ and the mean width $b$ give\n", "b : mean width"),
        ("a belt of width $b$ and mass $m$\n", "b : width"),
        ("with the angle of rise $b$\n", "b : angle of rise"),
        ("with respect to $b$\n", "b :"),
        ("With $a$ and $b$:\n    - $a=2k$\n", "b :"),
        ("The tight belt couples $b$ and $k$ in time.\n", "b :"),
        ("for small $b$ and by eliminating $b$\n", "b :"),
        ("A belt of width $b$ is fixed at one end.\n", "b : width"),
        ("\\(b\\) ist die Breite des Riemens.\\newline\n", "b : ist die Breite des Riemens"),
        ("$b$ & width of the belt & mm \\\\\n", "b : width of the belt [mm]"),
        ("Let $b$ be the width of the\n  belt.", "b : width of the belt"),
        ("Then $b$ and $a$ are thought to be small.", "b :"),
        ("$b$ and $a$ are the speeds of the belt in rpm.", "b : speeds of the belt [rpm]"),
        (
            "$a,b$ are the widths of belt, pulley and rim, $k$ is the pitch.",
            "b : widths of belt, pulley and rim",
        ),
    ],
)
def test_words_say_what_letters_mean(words: str, line: str) -> None:
    name = "paper.md" if words.startswith(("*", "-", "|")) else "paper.tex"
    found = draft(f"\n{words}\n$$c=2b$$\n", name).splitlines()
    assert line in [one.removeprefix("%% ") for one in found]


SKEW = r"K=\begin{pmatrix}0&-c\\c&0\end{pmatrix}"


@pytest.mark.parametrize(
    ("text", "lines", "missing"),
    [
        (r"$$b=h+e^2$$", ["e :"], []),
        (r"$$i=\frac{n}{m}$$", ["i :"], []),
        (r"$$i=\frac{n}{m}$$ $$i=5.49,\qquad n=2$$", ["i :"], []),
        (r"$$i_0=\frac{n}{m}$$ $$i=2n$$ $$i_0=-4$$", ["i :", "i_{0} :"], ["i_0 :"]),
        (r"$$y=\sum_{i=1}^nb_i$$", [], ["i :"]),
        # Letters that are printed as integers.
        (r"$$y=bk,\qquad k\in\mathbb N$$", ["k :", "natural k"], []),
        (r"$$y=bk_1,\quad k_1\in\mathbb{Z}$$", ["k_{1} :", "integer k_{1}"], []),
        # Letters that the text describes as counts, where reading the print needs that.
        (r"It has $N$ pins. $$y=b\cos N\psi$$", ["natural N"], []),
        (r"the number of teeth $z_1$ $$y=\sin 2z_1\psi$$", ["natural z_{1}"], []),
        (r"$n$ is the number of planets $$y=\sin n\psi$$", ["natural n"], []),
        (r"It has $N$ pins. $$y=bN$$", ["N :"], ["natural N"]),
        (r"It has $n$ turns. $$y=b\cos n\psi$$", ["n :"], ["natural n"]),
        (r"the distance $p$ between pins $$y=b\cos p\psi$$", [], ["natural p"]),
        (r"the force $F$ on bolts $$y=b\cos F\psi$$", [], ["natural F"]),
        (r"the number of revolutions $n$ $$y=b\cos n\psi$$", [], ["natural n"]),
        (r"the virtual number of teeth $z$ $$y=b\cos z\psi$$", [], ["natural z"]),
        (r"the average number of pins $n$ $$y=b\cos n\psi$$", [], ["natural n"]),
        (r"of negative number of teeth $z$ $$y=b\cos z\psi$$", [], ["natural z"]),
        (r"$$C_2=0$$ $$y=C_2b$$", ["# let C_2=0"], ["let C_2=0"]),
        (r"$$y_i=2b_i,\quad i=1,\dots,n$$", [], ["i :"]),
        (r"where $d$ is the width, $$\frac{dy}{dx}=2d+b$$", ["d : width", "y(x) :"], []),
        (r"$$y(x)=bx^2$$ $$y'(x)=2bx,\quad y''=2b$$ $$y(0)=0$$", ["y(x) :"], ["y'(x) :"]),
        (r"$$y(x)=bx$$ $$y(b)=b^2$$ $$c=y(0)(b+1)$$", ["y(x) :"], ["factor y"]),
        (r"with $\lambda=b/c$ $$y=\lambda b^2$$", [r"let \lambda=b/c"], []),
        (r"with $\lambda=b/c$ $$\lambda=y$$", [], [r"let \lambda=b/c"]),
        (r"with $c_p=\cos p$ $$y=c_pc_q+p+q$$", [r"let c_{q}=\cos q"], []),
        (
            r"with $c_p=\cos p$ and the stiffness $c_q$ $$y=c_pc_q+p+q$$",
            [r"let c_{p}=\cos p", "c_{q} : stiffness {c_{q}>0}"],
            [r"let c_{q}=\cos q"],
        ),
        (r"when $b=c$ $$y=2b+c$$", ["# let b=c"], ["let b=c"]),
        (r"when $b=-c$ $$y=2b+c$$", ["# let b=-c"], ["let b=-c"]),
        (r"It ends when $b=k+c$ $$y=2b+c+k$$", ["# let b=k+c"], ["let b=k+c"]),
        (r"It ends with $b=k+c$ $$y=2b+c+k$$", ["let b=k+c"], []),
        (
            r"At $b=\frac{\pi}{2}-c$ it is $q=2b-c$. $$y=2b+c$$ $$y=q$$",
            [r"# let b=\frac{\pi}{2}-c", "let q=2b-c"],
            [r"let b=\frac{\pi}{2}-c"],
        ),
        (r"with $q=2\pi c$ $$y=2c+q$$", [r"let q=2\pi c"], []),
        (r"$$\dot q(t)=2b$$ $$q(t)=2bt$$", ["q(t) :"], ["q(t)(t) :"]),
        (r"$$\dot{\text{rot}}=2b$$", [r"\text{rot}(t) :"], []),
        (r"at $\dot q=w$ $$b=c\dot q+w$$", [r"let \dot q=w"], []),
        (r"For $b=2~\mathrm{mm}$ $$y=2b$$", ["b : [mm]", "sizes b=2 mm"], []),
        (
            r"with $q=b/c$ $$y=qb^2$$ For $q=3$ $$q=\sin\frac{1}{2}$$",
            ["let q=b/c", "sizes q=3"],
            [],
        ),
        # A prime refers to the argument that the text gives to a letter, if there is only one.
        (r"the lift $s(u)$ $$s=bu^2$$ $$s'=2bu$$ $$y'=s'c$$", ["s(u) :", "y(u) :"], ["s' :"]),
        (r"$s(u)$ and $y(v)$ $$s=bu^2+v$$ $$s'=2bu$$ $$y'=s'$$", ["s(u) :", "y(v) :"], ["s' :"]),
        (r"$s(u)$ is $s(v)$ $$s=bu^2+v$$ $$s'=2bu$$ $$y'=s'$$", ["s' :"], ["s(u) :"]),
        (r"the curve $w(u)$ $$w'=bu^2$$ $$w(b)=2u$$", ["w(u) :", "b :"], ["w(b) :"]),
        (r"the factor $k(u)$ $$s=bu^2$$ $$s'=2bu$$", ["s' :"], ["s(u) :"]),
        (
            r"the lift $s(u)$ $$s=bu^2$$ $$s'=2bu$$ $$s'_{\max}=2b,\qquad s_{\min}=0.$$"
            r"$$b_{\max}=1$$",
            [r"# claim \max_{u}s'=2b", r"# claim \min_{u}s=0", r"s_{\max}' :", r"b_{\max} :"],
            [r"# claim \max_{u}b=1", r"s_{\max}(u) :"],
        ),
        # A letter that depends on one that moves in time: both are declared, for the chain rule.
        (r"the lift $s(u)$ $$s=bu^2$$ $$\dot s=2bu\dot u$$", ["s(u) :", "u(t) :"], ["s(t) :"]),
        (r"$$s=bu^2$$ $$\dot s=s'\dot u$$", ["s(u) :", "u(t) :"], ["s' :", "s(t) :"]),
        (r"$$\dot s=\frac{ds}{du}\dot u$$", ["s(u) :", "u(t) :"], ["s(t) :"]),
        (r"$$\dot s=(ds/du)\dot u$$", ["s(u) :", "u(t) :"], ["s(t) :", "d :"]),
        (r"$$\dot s=(bd/du)\dot u$$ $$d=2b$$", ["d :"], ["d(u) :", "b(u) :"]),
        (r"$$s=bu^2$$ $$\dot s=2bu\dot u$$", ["s(t) :", "u(t) :"], []),
        (r"the lift $s(u)$ $$s=bu^2$$ $$\dot y=2s$$", ["s(u) :", "y(t) :"], ["u(t) :"]),
        # Two letters printed as one, with a double index, are declared as two.
        (r"$$y_{1,2}=b\pm c$$ $$y_1+y_2=2b$$", ["y_{1} :", "y_{2} :"], ["y_{1,2} :"]),
        (r"$$y_{1,2}=b\pm c$$ $$y_{1}=2b$$", ["y_{1} :", "y_{1,2} :"], []),
        # Relations that are not solved for a letter, next to definitions.
        (r"the angle $b$ with $\tan b=c$ $$y=b+c$$", [r"claim \tan b=c"], []),
        (r"With $k=b/c$ and $b^2=2c$ $$y=kb+c$$", ["claim b^2=2c", "let k=b/c"], []),
        (r"At $\tan b=c$, with $b=2$ and where $2b=7$ $$y=b+c$$", ["sizes b=2"], ["claim 2b=7"]),
        # A speed is constant if nothing else is said about it.
        (r"with $w=\dot q$ $$b=cw\cos q$$", [r"let \dot q=w", "q(t) :"], ["q :"]),
        (r"with $w=\dot q$ $$b=cw\cos q$$ $$w=2\pi k$$", [r"let \dot q=w", "q(t) :"], ["q :"]),
        (r"with $w=\dot q$ $$b=cw\ddot q$$ $$w=2\pi k$$", ["q(t) :"], [r"let w=\dot q"]),
        (r"with $w=\dot q$ $$b=cq\dot w$$", [r"let w=\dot q", "w(t) :"], []),
        (r"with $w=\dot q$ $$b=cw\ddot q$$", [r"let w=\dot q"], []),
        (r"with $w=\dot q$, $v=\ddot q$ $$b=cwq+v$$", [r"let w=\dot q", r"let v=\ddot q"], []),
        (r"Using $\dot q=w$ $$b=c\sin q$$ $$y=w$$", [r"let \dot q=w", "q(t) :"], ["q :"]),
        (
            r"$$F_{\mathrm{in}}=m_{\mathrm{SC}}z_\text{max}$$",
            [r"F_{\mathrm{in}} :", r"m_{\mathrm{SC}} :", r"z_{\max} :"],
            [],
        ),
        (r"$$c=e^{-kb}$$ $$y=2e^{kb}$$", ["e :", r"let e=\mathrm{e}", "k :"], []),
        (r"$$y=b^2q$$ Derived with respect to the angle $b$: $$y'=2bq$$", ["y(b) :"], ["y' :"]),
        (
            r"$$y=b^2q$$ with respect to $b$ and with respect to $q$ $$y'=2bq$$",
            ["y' :"],
            ["y(b) :"],
        ),
        (r"$$\delta=b\quad y=c+\delta b$$", [r"\delta :"], [r"\delta b :"]),
        (r"Let $b$ be the radius, $c$ the length of a rod $$y=b+c$$", ["b : radius {b>0}"], []),
        (r"Let $b$ be the radius, $c$ the pitch. $$y=b+c$$", ["c : pitch"], ["c : pitch {c>0}"]),
        (
            r"$b$, $c$ and $q$ are the numbers of teeth of the sun, planet and ring: $$y=b+c+q$$",
            [f"{x} : numbers of teeth of the sun, planet and ring" for x in "bcq"],
            [],
        ),
        (
            r"$b$ and $c$ are the radius and the pitch, respectively. $$y=b+c$$",
            ["b : radius {b>0}", "c : pitch"],
            [],
        ),
        (r"$b_{c,q}$ is the pitch. $$y=b_{c,q}+q$$", ["b_{c,q} : pitch", "q :"], []),
        # A rate in the text does not make a matrix, which has a line of its own, depend on t.
        (
            r"$$q=\begin{bmatrix}x\\y\end{bmatrix}$$ With $\dot q=Aq+v$, $\dot x=Ax+w$, we have",
            ["q 2x1 :", "x(t) :"],
            ["q(t) 2x1 :"],
        ),
        # A bracket equated to a vector lists its components, whatever brackets mean elsewhere.
        (r"$$[T]=[R,d+t]$$ $$\mathbf{u}=(b,c)$$", [r"\mathbf{u} 2x1 :"], ["T 2x1 :"]),
        (r"$b$ is defined as follows. $$b=c$$", ["b :"], []),
        (r"Here $b$ is constant. $$y=bc$$", ["b :"], []),
        (
            r"$b$ is the speed of the rear and front wheel. $$y=2b$$",
            ["b : speed of the rear and front wheel"],
            [],
        ),
        (r"$b$ is the pitch and it is small. $$y=2b$$", ["b : pitch"], []),
        (
            r"$$C\frac{d T_\text{wall}}{d t}=y_\text{in}+\frac{d q_{\mathrm{a}}}{dt}$$",
            [r"T_{\text{wall}}(t) :", r"q_{\mathrm{a}}(t) :"],
            [],
        ),
        (r"$$y=e^*+b$$", ["e^* :"], ["e :"]),
        (r"With the speed $b$ the power is $$y=b+c$$", ["b : speed"], []),
        (r"For $b=2$ and then $b=3$ $$y=2b$$", [], ["sizes b=2", "sizes b=3"]),
        (r"at $b=0$ $$y=2b$$", [], ["sizes b=0"]),
        (
            r"For $b=30^\circ$ $$y=2b$$",
            ["b : [rad]", r"sizes b=30^\circ"],
            [],
        ),
        (r"For $b=20$\,mm and $c=3\,$kN, $$y=2bc$$", ["sizes b=20 mm", "sizes c=3 kN"], []),
        (
            r"For $b=2$ N/mm and $c=3$ N/mm$^2$, $$y=2bc$$",
            ["b : [N/mm]", "sizes b=2 N/mm", "sizes c=3 N/mm^2"],
            [],
        ),
        (r"the force $b$ in N, $b=\SI{20}{kN}$, $$y=2b$$", ["sizes b=20 kN"], []),
        (r"For $b=20$ in all $$y=2bc$$", ["sizes b=20"], ["b : [in]"]),
        # Units after letters, and in the heads of tables.
        (
            r"a mass $b$ in kg, force $c$ [N] $$y=b+c$$",
            ["b : mass [kg] {b>0}", "c : force [N]"],
            [],
        ),
        (r"$b$ and $c$ in mm, at a speed $q$ in m/s, $$y=b+cq$$", ["b : [mm]", "c : [mm]"], []),
        (r"at a speed $q$ in m/s, $$y=2q$$", ["q : speed [m/s]"], ["q : speed [m]"]),
        (r"\(b\) (mm) and $c$ (\si{\milli\second}) $$y=b+c$$", ["b : [mm]", "c : [ms]"], []),
        (r"as $b$ [1], $c$ (1), $q$ in A and $k$ (m) $$y=b+cqk$$", ["b :", "c :", "q :"], []),
        (r"the force $b$ in all, $c$ in minima $$y=b+c$$", ["b : force", "c :"], []),
        (
            "$$y=b+c+q+k$$\n\\begin{tabular}{lSSS}\n& {$b$ / \\si{mm}} & {$c$ (\\si{\\kilo"
            "\\newton})} & $q$ [m] & $k$ \\\\\nA & 1 & 2 & 3 & 4\\\\\n\\end{tabular}",
            ["b : [mm]", "c : [kN]", "q : [m]", "k :"],
            [],
        ),
        (
            "$$y=b+c+q$$\n\\begin{tabular}{ccc}\n$b$ & $c$ & $q$\\\\ mm & $^\\circ$ & "
            "\\\\\n1 & 2 & 3\\\\\n\\end{tabular}",
            ["b : [mm]", "c : [°]", "q :"],
            [],
        ),
        (r"\newcommand{\bs}{b_{s}} with $\bs=24$ $$y=2b_s$$", ["sizes b_{s}=24"], []),
        # Equations denied, assumed, derived or true at one moment define nothing; nor do multiples.
        (r"For $b=c^2$ we get $$y=b+c$$", ["# let b=c^2"], ["let b=c^2"]),
        (r"Unless $b=c^2$ it slips. $$y=b+c$$", ["# let b=c^2"], ["let b=c^2"]),
        (r"We do not assume $b=c^2$. $$y=b+c$$", ["# let b=c^2"], ["let b=c^2"]),
        (r"The optimum $b=k/c$ is flat. $$y=bc+k$$", ["# let b=k/c"], ["let b=k/c"]),
        (r"The optimum, with $b=k/c$, is flat. $$y=b^2$$", ["let b=k/c", "k :", "c :"], []),
        (r"Its speed is not constant, with $b=k/c$. $$y=b^2$$", ["let b=k/c"], []),
        (r"which gives $b=k/c$. $$y=bc+k$$", ["# let b=k/c"], ["let b=k/c"]),
        (r"With $b=2c$ we get $$y=b+c$$", ["# let b=2c"], ["let b=2c"]),
        (r"With $b=\frac12c$ we get $$y=b+c$$", [r"# let b=\frac12c"], [r"let b=\frac12c"]),
        (r"Initially $\dot q=w$ $$b=c\dot q+w$$", [r"# let \dot q=w"], [r"let \dot q=w"]),
        (r"At $t=0$ it is $\dot q=w$ $$b=c\dot q+w$$", [r"# let \dot q=w"], [r"let \dot q=w"]),
        (r"For small $b$ it is $\sin b=b$ $$y=\sin b$$", [], [r"claim \sin b=b"]),
        (r"It does not slip with $\tan b=c$ $$y=b+c$$", [r"# claim \tan b=c"], [r"claim \tan b=c"]),
        # A speed that varies is defined as the derivative of the angle.
        (r"The speed $w=\dot q$ varies. $$b=cw\cos q$$", [r"let w=\dot q"], [r"let \dot q=w"]),
        (
            r"The acceleration at constant $\dot q=w$ is $$b=cw\cos q$$",
            [r"let \dot q=w"],
            [r"let w=\dot q"],
        ),
        (r"A variable speed $\dot q=w$. $$b=cw\cos q$$", [r"let w=\dot q"], [r"let \dot q=w"]),
        (
            r"with $w=\dot q$ and $v=\dot w$ $$b=cw\cos q+v$$",
            [r"let w=\dot q", r"let v=\dot w", "w(t) :"],
            [],
        ),
        # The letters in a given value are declared.
        (r"with $b=kw$ $$y=b^2$$", ["let b=kw", "k :", "w :"], []),
        # Primes may refer to other coordinates.
        (
            r"We differentiate with respect to $b$. $$y=b^2q$$ $$y'=y\cos b$$",
            [r"y' :"],
            ["y(b) :"],
        ),
        (r"$$y=b^2q$$ $$y'=2bq$$ The prime is the derivative with respect to $b$.", ["y(b) :"], []),
        # Only the length itself is positive, not a position, difference, ratio or change.
        (r"$b$ is the position of the mass. $$y=b$$", ["b : position of the mass"], []),
        (r"$b$ is the difference of the radii. $$y=b$$", ["b : difference of the radii"], []),
        (r"$b$ is the mass ratio. $$y=b$$", ["b : mass ratio"], []),
        (r"The change of length $b$ is small. $$y=b$$", ["b : change of length"], []),
        (r"the radius of curvature $b$ $$y=b$$", ["b : radius of curvature"], []),
        (
            r"$b$ is the free length of the spring. $$y=b$$",
            ["b : free length of the spring {b>0}"],
            [],
        ),
        (
            r"It is largest in the middle of the rise, $b=c/2$: $$y=2b+c$$",
            ["# let b=c/2"],
            ["let b=c/2"],
        ),
        (
            r"$$y=\begin{Bmatrix}b&\text{if }b>0\\-b&\text{otherwise}\end{Bmatrix}$$",
            ["y :"],
            ["y 2x2 :"],
        ),
        (r"$$y=\begin{pmatrix}b&c_\text{f}\\-b&b\end{pmatrix}$$", ["y 2x2 :"], ["y :"]),
        (r"$$y=b_0^{\text{stat}}+c$$", [r"b_{0}^{\text{stat}} :"], ["b_{0} :"]),
        (r"$$R=\begin{pmatrix}1&b\\0&1\end{pmatrix}$$ $$R^TR=S$$", ["R 2x2 :"], ["T :"]),
        # An exponential has the size of its exponent.
        (
            r"$$A=\begin{pmatrix}0&1\\0&0\end{pmatrix}$$ $$R=e^{-At}=I-At$$ $$S=\exp(At)$$",
            ["R 2x2 :", "S 2x2 :", r"let I=\begin{pmatrix}1&0\\0&1\end{pmatrix}"],
            ["t 2x2 :"],
        ),
        (r"$$h=\begin{pmatrix}b\\c\end{pmatrix}$$ $$R=e^{q}$$", ["R :"], ["R 2x1 :"]),
        (
            r"$$R=\begin{pmatrix}1&b\\0&1\end{pmatrix}$$ $$R^TR=S$$ $$T_x=b$$",
            ["R 2x2 :", "T_{x} :"],
            ["T :"],
        ),
        # A letter in a sum with a running index is a family: its members are not declared.
        (
            r"The weights $q_k$ are $$b=\sum_{k=1}^nq_kh_{bk}$$ $$c_k=2q_k$$"
            r"$$q_1=h_{b1}+q_r+d_k$$",
            ["q_{k}(k) : weights", "h_{bi}(i) :", "c_{i}(i) :", "natural n", "q_{r} :", "d_{k} :"],
            ["q_{1} :", "h_{b1} :", "c_{k} :"],
        ),
        (
            r"The masses: $$m=m_1+\dots+m_n$$ $$y=kx_1+\dots+kx_n$$ $$z=1+2+\dots+q_N$$",
            ["m :", "k :"],
            ["natural m", "natural k", "natural q"],
        ),
        (
            r"where $n$ is the number of links, $c$ is the pitch $$y=\sum_{k=1}^{n-1}kc!+n$$",
            ["natural n", "# natural c"],
            ["natural c"],
        ),
        # A print may be wrapped, but an entry of a block is one line.
        ("$$y=c(b,\nq)$$", ["c(b, q) :"], ["q) :"]),
        # A line that a check would refuse is proposed as a question.
        (
            r"With $b=f(2c)$ the way is $$y=b+q$$ $$f(x)=2x$$",
            ["c :", "# let b=f(2c)"],
            ["let b=f(2c)"],
        ),
        (r"With $b=2q+h$ the way is $$y=b+q$$", ["h :", "let b=2q+h"], []),
        # Unit matrices, and a vector that a sentence gives.
        (
            rf"$${SKEW}$$ $$R=I+K\sin u$$",
            ["I 2x2 :", r"let I=\begin{pmatrix}1&0\\0&1\end{pmatrix}"],
            [],
        ),
        (rf"$${SKEW}$$ $$R=IK+K\sin u$$", [], [r"let I=\begin{pmatrix}1&0\\0&1\end{pmatrix}"]),
        (
            rf"Let $\bm n=(a,b)^T$. $${SKEW}$$ $$K^2=\bm n\bm n^T-I$$",
            [r"\bm{n} 2x1 :", r"let \bm{n}=(a,b)^T"],
            [r"\bm{n} 2x2 :"],
        ),
        # A fraction after an argument may belong to it.
        (
            r"$$y=2\tan b\frac{c+h}{q}$$",
            ["c :", r"# factor \tan b"],
            [r"factor \tan b"],
        ),
        # A chain makes two statements; a number at its end makes none that a row could state.
        (
            r"Writing $q=b/c=\sin h$ we obtain $$y=q\cos h+bc$$",
            ["let q=b/c", r"claim q=\sin h"],
            [],
        ),
        (r"with $q=2b+h=40$ mm we have $$y=qb$$", ["let q=2b+h"], ["claim q=40"]),
        (r"The whole angle is $2q=\pi-b$. $$y=cq+b$$", [r"let q=\frac{\pi-b}{2}"], []),
        (r"We write $2q+1=b$. $$y=cq+b$$", [], ["let q=b"]),
        # The value of a letter at a place.
        (
            r"$$x(q)=b\cos q$$ At the end, $q=\pi$, it is $$x_1=-b$$",
            [r"# claim x=-b\quad\text{for }q=\pi"],
            [],
        ),
        (
            r"$$x(q)=b\cos q$$ The way is largest at $q=0$: $$x_{\max}=b$$",
            [r"# claim x=b\quad\text{for }q=0"],
            [],
        ),
        (r"$$x(q)=b\cos q$$ With $q=0$ known, the spring has $$x_1=-b$$", [], ["# claim x=-b"]),
        # "It" is what the display before defines first.
        (
            r"\begin{alignat}{2}x&=b\cos q\\y&=b\end{alignat} It has its least value $b$ at $q=0$.",
            [r"claim \min_{q}x=b"],
            [r"claim \min_{q}y=b"],
        ),
        # A value in one case does not compete with the definition.
        (
            r"With $b=2q+h$ the way is $$y=b+q$$ It is largest at $b=1/2$.",
            ["let b=2q+h"],
            [],
        ),
    ],
)
def test_drafts_propose_what_prints_and_sentences_show(
    text: str, lines: list[str], missing: list[str]
) -> None:
    found = draft(text).splitlines()
    assert [line for line in lines if f"%% {line}" not in found] == []
    assert [line for line in missing if f"%% {line}" in found] == []


SUBSTITUTED = r"""
\begin{equation}N=kb\label{load}\end{equation}
\begin{equation}b=2c\label{width}\end{equation}
Putting \eqref{width} into \eqref{load} we have
\begin{equation}N=2kc\label{sum}\end{equation}
and, as \eqref{load} and \eqref{later} tell,
\begin{equation}k=N/b\label{later}\end{equation}
"""


def test_words_ask_what_follows() -> None:
    found = draft(SUBSTITUTED)
    assert "%% # line 4 refers to (2), (1). Does (3) follow from them?" in found
    assert "%% # follows (3): (2), (1)\n" in found
    assert found.count("follows") == 2


def test_a_number_beside_its_own_equation_refers_to_no_other() -> None:
    numbered = r"$$N=kb\qquad-(1)$$ $$b=2c\qquad(2)$$ {} $$N=2kc\qquad(3)$$"
    assert "follows" not in draft(numbered.format("The sum is"))
    assert "# follows (3): (1), (2)\n" in draft(numbered.format("With (1) and (2) we have"))


def test_what_refers_to_a_display_asks_for_all_its_parts() -> None:
    found = draft(
        r"\begin{equation}N=kb,\quad b=2c\label{both}\end{equation} From \eqref{both} we have"
        r"\begin{equation}N=2kc\end{equation}"
    )
    assert "%% # follows (2): (1), part 1, (1), part 2\n" in found
