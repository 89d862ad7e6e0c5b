"""Papers of a few lines: the role and the outcome of each equation, with wrong neighbours."""

from __future__ import annotations

import pytest
from small_papers import ROD, outcomes, paper, run

from mechproof.document.checked_rows import show_left
from mechproof.document.checking import check
from mechproof.document.tasks import Role
from mechproof.proof.verdict import Left, State
from mechproof.sources.located_text import Place

pytestmark = pytest.mark.usefixtures("judged_here")

CASES = {
    "first prints define, later ones are compared": (
        [
            r"\lambda=\frac rl",
            r"\lambda=\frac{r\sin^2\alpha+r\cos^2\alpha}{l}",
            r"\lambda=\frac lr",
        ],
        ["DEFINITION", "PROVED", "REFUTED"],
    ),
    "definitions are put in": (
        [r"\lambda=\frac rl", r"\lambda l\sin\alpha=r\sin\alpha"],
        ["DEFINITION", "PROVED"],
    ),
    "steps of chains are compared": (
        [r"k=\cos 2\alpha=1-2\sin^2\alpha=2\cos^2\alpha+1"],
        ["DEFINITION", "PROVED", "REFUTED"],
    ),
    "what depends on a place, times constants": (
        [
            r"kms''=-a\cos\psi",
            r"kms=a\cos\psi",
            r"s'=-\frac{a\sin\psi}{km}",
            r"s(0)=\frac{a}{km}",
            r"s(0)=\frac{2a}{km}",
        ],
        ["PROVED", "DEFINITION", "PROVED", "PROVED", "REFUTED"],
    ),
    "nothing of what moves with time, or as a constant does": (
        [r"kmx=a\cos\varphi", r"kms\psi=a"],
        ["DEFINITION"] * 2,
    ),
    "a root may be the opposite of what is printed": (
        [
            r"x=r\cos\varphi",
            r"\sqrt{x^2}=r\cos\varphi",
            r"\sqrt{x^2}=r\sin\varphi",
            r"\sqrt{r^2}=-r",
            r"\sqrt{r^2}=r",
        ],
        ["DEFINITION", "not judged", "REFUTED", "REFUTED", "PROVED"],
    ),
    "a star is part of a name": (
        [
            r"F=\frac{E^*m^2}{R^\ast}",
            r"\frac{\partial F}{\partial m}=\frac{2E^{*}m}{R^{\ast}}",
            r"F=\frac{E^*m^3}{R^*}",
            r"\frac{\partial F}{\partial m}=2E^{*2}mE^{\star-1}/R^*",
            r"F=E^{*2}m^2R^{\ast-1}",
        ],
        ["DEFINITION", "PROVED", "REFUTED", "PROVED", "REFUTED"],
    ),
    "a bracket that rounds": (
        [
            r"n=\left\lfloor\frac{\varphi}{2\pi}\right\rfloor",
            r"n+1=\lfloor\frac{\varphi}{2\pi}+1\rfloor",
            r"n=\lceil\frac{\varphi}{2\pi}\rceil",
            r"m=\lfloor\frac{\varphi+\alpha}{2\pi}\rfloor",
            r"m=\lfloor\frac{\varphi}{2\pi}+\frac{\alpha}{\pi}\rfloor",
        ],
        ["DEFINITION", "PROVED", "REFUTED", "DEFINITION", "REFUTED"],
    ),
    "a letter that counts may be printed as another number": (
        [
            r"n=\lfloor\frac{\varphi}{2\pi}\rfloor",
            r"\cos(\alpha+2\pi n)=\cos\alpha",
            r"\cos(\alpha+\pi n)=\cos\alpha",
        ],
        ["DEFINITION", "PROVED", "REFUTED"],
    ),
    # Some of the values tried for the letters make k + n zero.
    "a form that has no value where letters are the opposite of others": (
        [r"h=\frac{kn}{k+n}-\frac{an}{k+n}=\frac{(k-a)n}{k+n}"],
        ["DEFINITION", "PROVED"],
    ),
    "dots are derivatives": (
        [ROD, r"\dot x=-r\dot\varphi\sin\varphi", r"\dot x=r\dot\varphi\sin\varphi"],
        ["DEFINITION", "PROVED", "REFUTED"],
    ),
    "a derivative through letters that are given by others": (
        [
            r"\gamma=\varphi+\alpha",
            r"x=r\sin\gamma",
            r"\dot x=r\dot\varphi\cos(\varphi+\alpha)",
            r"\dot x=0",
            r"\dot x=r\dot\varphi\sin\gamma",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "not judged", "REFUTED"],
    ),
    "two dots": (
        [ROD, r"\ddot x=-r\ddot\varphi\sin\varphi-r\dot\varphi^2\cos\varphi"],
        ["DEFINITION", "PROVED"],
    ),
    "d by dt": (
        [ROD, r"\frac{dx}{dt}=-r\frac{d\varphi}{dt}\sin\varphi"],
        ["DEFINITION", "PROVED"],
    ),
    "d by dt with a slash": (
        [
            ROD,
            r"dx/dt=-r(d\varphi/dt)\sin\varphi",
            r"\mathrm dx/\mathrm dt=-r\dot\varphi\cos\varphi",
            r"d^2x/dt^2=-r\ddot\varphi\sin\varphi-r\dot\varphi^2\cos\varphi",
            r"d(x^2)/dt=2x\,dx/dt",
            r"dx^2/dt=2x\dot x",
            r"\frac{1}{dx/dt}=1/dx/dt",
        ],
        ["DEFINITION", "PROVED", "REFUTED", "PROVED", "PROVED", "not read", "not read"],
    ),
    "partial derivatives with a slash": (
        [
            r"k=\frac12m\dot\varphi^2",
            r"\partial k/\partial\dot\varphi=m\dot\varphi",
            r"\partial k/\partial\dot\varphi=2m\dot\varphi",
            r"\partial^2k/\partial m\,\partial\dot\varphi=\dot\varphi",
            r"\partial^2k/\partial\dot\varphi^2=\dot\varphi",
            r"d/dt(\partial k/\partial\dot\varphi)=m\ddot\varphi",
        ],
        ["DEFINITION", "PROVED", "REFUTED", "PROVED", "REFUTED", "PROVED"],
    ),
    "primes": (
        [r"s=a\cos\psi+b\psi", r"s'=b-a\sin\psi", r"s''=a\cos\psi"],
        ["DEFINITION", "PROVED", "REFUTED"],
    ),
    "a derivative by the angle with a slash": (
        [r"s=a\cos\psi+b\psi", r"ds/d\psi=b-a\sin\psi", r"d^2s/d\psi^2=a\cos\psi"],
        ["DEFINITION", "PROVED", "REFUTED"],
    ),
    "a rate that is said to be itself": ([ROD, r"\dot x=\frac{dx}{dt}"], ["DEFINITION", "PROVED"]),
    "a derivative by the time of what is printed of a letter": (
        [
            r"k=\frac12r^2\dot\varphi^2-rl\cos\varphi",
            r"\frac{d}{dt}\frac{\partial k}{\partial\dot\varphi}=r^2\ddot\varphi",
            r"\frac{d}{dt}\frac{\partial k}{\partial\dot\varphi}=2r^2\ddot\varphi",
            r"\frac{\partial k}{\partial\varphi}=rl\sin\varphi",
            r"\frac{\partial k}{\partial\varphi}=-rl\sin\varphi",
        ],
        ["DEFINITION", "PROVED", "REFUTED", "PROVED", "REFUTED"],
    ),
    "a third derivative": (
        [r"k=\ddot\varphi", r"\frac{dk}{dt}=\dddot\varphi", r"\frac{dk}{dt}=2\dddot\varphi"],
        ["DEFINITION", "PROVED", "REFUTED"],
    ),
    "the fourth derivative has no symbol": (
        [r"k=\dddot\varphi", r"\frac{dk}{dt}=m"],
        ["DEFINITION", "not read"],
    ),
    "a derivative defines what is bare": (
        [r"k=m^2n", r"u=\frac{\partial k}{\partial m}", r"u=2mn", r"u=mn"],
        ["DEFINITION", "DEFINITION", "PROVED", "REFUTED"],
    ),
    "a matrix": (
        [
            r"R=\begin{pmatrix}\cos\alpha&-\sin\alpha\\\sin\alpha&\cos\alpha\end{pmatrix}",
            r"RR^T=\begin{pmatrix}1&0\\0&1\end{pmatrix}",
        ],
        ["DEFINITION", "PROVED"],
    ),
    "letters of which only some have units": (
        [r"x=rk", r"rk\cos\alpha=x\cos\alpha", r"m=\frac{x}{l}", r"\frac{x}{n}=\frac{rk}{n}"],
        ["DEFINITION", "PROVED", "DEFINITION", "PROVED"],
    ),
    "nothing excuses another extremum": (
        [r"\min_\psi(a\cos\psi+c)=a+c", r"kn=m^2"],
        ["REFUTED", "DEFINITION"],
    ),
    "special positions define nothing": (
        [r"k=m\cos\alpha+n\cos\beta", r"k=n\cos\alpha+m\cos\beta", r"m=n"],
        ["DEFINITION", "not judged", "DEFINITION"],
    ),
    "of two special positions neither defines a letter": (
        [r"m\sin\alpha=n\sin\beta", r"\alpha=-\beta", r"\alpha+\beta=\pi"],
        ["DEFINITION", "DEFINITION", "DEFINITION"],
    ),
    "units tell what a bracket multiplies": (
        [
            r"x=r(1-\cos\alpha)",
            r"x=r-r\cos\alpha",
            r"x=r(1+\cos\alpha)",
            r"x=\lambda(l+b)",
            r"x=r(\alpha+\beta)",
            r"x=r(\alpha)",
            r"x=k(l+b)",
            r"s=x(1+\cos\psi)",
            r"x=r(1-u)",
        ],
        [
            *["DEFINITION", "PROVED", "REFUTED", "not judged"],
            *["not read", "not read", "not read", "not read", "not read"],
        ],
    ),
    "what depends on time is multiplied by what is no time": (
        [
            r"\eta=2r\sin\xi",
            r"\dot\eta=r\dot\xi\left(\cos\xi+\cos\xi\right)",
            r"\ddot\eta=\ddot\xi(2r\cos\xi+0)-2r\dot\xi^2(1-1+\sin\xi)",
            r"\ddot\eta=\dot\xi(\tau_1-\tau_2)",
            r"\ddot\eta=\dot\xi(\tau_1+\tau_2+t)",
            r"\eta=r(\lambda-\sqrt{1-\lambda^2})",
        ],
        ["DEFINITION", "PROVED", "PROVED", "not read", "not read", "not judged"],
    ),
    "later prints are compared with each member of a chain": (
        [r"k=mu=n\cos\alpha", r"k=n\frac{\cos^2\alpha}{\cos\alpha}", r"k=n\sin\alpha", r"k=2mu"],
        ["DEFINITION", "not judged", "PROVED", "not judged", "REFUTED"],
    ),
    # The first member of the chain depends on time only if k or l does, which is asked for.
    "derivatives of a chain with a member whose letters may move are left open": (
        [
            r"x=lk=r\cos\varphi",
            r"\dot x=-r\dot\varphi\sin\varphi",
            r"\dot x=r\dot\varphi\sin\varphi",
        ],
        ["DEFINITION", "not judged", "not judged", "not judged"],
    ),
    "a member that differs from the others does not stand": (
        [r"k=\cos2\alpha=1-2\sin^2\alpha=2\cos^2\alpha+1", r"k=2\cos^2\alpha+1"],
        ["DEFINITION", "PROVED", "REFUTED", "REFUTED"],
    ),
    "of two members that differ either may be right": (
        [
            r"x=r\cos\varphi=r\sin\varphi",
            r"\dot x=-r\dot\varphi\sin\varphi",
            r"\ddot x=r\ddot\varphi\cos\varphi-r\dot\varphi^2\sin\varphi",
            r"x=r\tan\varphi",
        ],
        ["DEFINITION", "REFUTED", "PROVED", "PROVED", "not judged"],
    ),
    "two letters that are zero define nothing": (
        [r"\dot x=\dot\varphi=0", ROD, r"\dot x=-r\dot\varphi\sin\varphi"],
        ["DEFINITION", "DEFINITION", "DEFINITION", "PROVED"],
    ),
    "constant speed has no acceleration": (
        [r"\dot\varphi=k", ROD, r"\ddot x=-rk^2\cos\varphi", r"\ddot x=-2rk^2\cos\varphi"],
        ["DEFINITION", "DEFINITION", "PROVED", "REFUTED"],
    ),
    "a number within a chain": (
        [r"k=12=3\cdot4", r"m=25=3\cdot4", r"n=2.5=3.5"],
        ["DEFINITION", "PROVED", "DEFINITION", "REFUTED", "DEFINITION", "REFUTED"],
    ),
    "rounded coefficients accuse nobody": (
        [r"k=\frac{\pi n}{30}=0.105n", r"\sqrt2m=1.414m", r"\sqrt2m=1.42m"],
        ["DEFINITION", "PROVED", "PROVED", "not judged"],
    ),
    "nowhere true": ([r"m^2+1=0"], ["REFUTED"]),
    "somewhere true": ([r"m^2-1=0"], ["DEFINITION"]),
    "other letters make no accusation": (
        [r"k=mn=\frac{2mu}{3}", r"k=mu"],
        ["DEFINITION", "not judged", "not judged"],
    ),
    "an identity may be claimed": (
        [r"\sin\alpha\cos\alpha=\sin2\alpha"],
        ["REFUTED"],
    ),
    "a circle of definitions is compared": (
        [ROD, r"r=\frac{x}{\cos\varphi}"],
        ["DEFINITION", "PROVED"],
    ),
    "an inverse with a branch is not accused": (
        [r"k=\cos\alpha", r"\alpha=\arccos k"],
        ["DEFINITION", "DEFINITION"],
    ),
    "conditions": ([r"l>r", r"k^2\ge0", r"k^2<0"], ["DEFINITION", "PROVED", "REFUTED"]),
    "a double sign on one side is the branch": (
        [r"m=k\pm\sqrt{k^2+n^2}", r"m^2-2mk=n^2", r"m^2-2mk=2n^2"],
        ["DEFINITION", "PROVED", "DEFINITION"],
    ),
    "a bracket behind a matrix is its name": (
        [r"Q(\alpha)=\begin{pmatrix}1&\alpha\\0&1\end{pmatrix}", r"\det Q(\alpha)=1"],
        ["DEFINITION", "PROVED"],
    ),
    "a branch": ([r"\sigma^2=1", r"\sigma=1"], ["PROVED", "DEFINITION"]),
    "what a letter raises has no known dimension": (
        [r"rr^k=lr^k", r"r^kl=r^{k-1}rl", r"r^kl=r^{k-1}l"],
        ["DEFINITION", "PROVED", "REFUTED"],
    ),
    "a definition of another dimension": (
        [r"h=\frac{a^2b}{a+b}", r"c=\frac ch c", r"\frac ah=\frac{a+b}b"],
        ["ILL_FORMED", "DEFINITION", "not judged"],
    ),
    "dimensions": ([r"x=r+\lambda", r"k=\frac{r}{l}+m"], ["ILL_FORMED", "DEFINITION"]),
    "sizes are no definitions": ([r"r=66", r"\lambda=\frac rl"], ["DEFINITION", "DEFINITION"]),
    "rounded numbers need sizes": (
        [r"\lambda=\frac rl=0.33"],
        ["DEFINITION", "not judged"],
    ),
    "an undeclared letter": ([r"q=2r"], ["not read"]),
    "a derivative that is not declared": ([r"\frac{dk}{dm}=0"], ["not read"]),
    "an expression": ([r"a+b"], ["not judged"]),
}
# Additional lines of the block of a case.
SAID = {
    "a letter that counts may be printed as another number": "%% natural n\n%% identity (2), (3)\n",
    "what depends on time is multiplied by what is no time": (
        "%% \\eta(t) : a path [m]\n%% \\xi(t) : an angle [rad]\n%% \\tau_1 ; \\tau_2 : times [s]\n"
    ),
    "a star is part of a name": "%% F ; E^* ; R^\\star : sizes\n",
    "an identity may be claimed": "%% identity (1)\n",
    "d by dt with a slash": "%% factor r\n",
}


# Equations about w(\varphi) when \varphi(t) is declared, and the outcome of the last one.
CHAINED = [
    ([r"w=h\sin\varphi", r"\dot w=h\dot\varphi\cos\varphi"], "PROVED"),
    ([r"w=h\sin\varphi", r"\dot w=-h\dot\varphi\cos\varphi"], "REFUTED"),
    ([r"w=h\sin\varphi", r"\frac{dw}{dt}=h\dot\varphi\sin\varphi"], "REFUTED"),
    ([r"\ddot w=w''\dot\varphi^2+w'\ddot\varphi"], "DEFINITION"),
    ([r"\ddot w=w''\dot\varphi^2-w'\ddot\varphi"], "REFUTED"),
    ([r"w'=h\cos\varphi", r"\ddot w=h\ddot\varphi\cos\varphi-h\dot\varphi^2\sin\varphi"], "PROVED"),
    ([r"k\dot w=kw'\dot\varphi"], "PROVED"),
    ([r"\frac{d}{dt}\left(kw^2\right)=2kww'\dot\varphi"], "PROVED"),
    ([r"\frac{d}{dt}\left(kw^2\right)=2kw\dot\varphi^2w'"], "REFUTED"),
    ([r"\frac{d}{dt}(kw\cos\varphi)=k\dot w\cos\varphi-kw\dot\varphi\sin\varphi"], "PROVED"),
    ([r"\frac{d}{d\varphi}\left(kw^2\right)=2kww'"], "PROVED"),
]


@pytest.mark.parametrize(("latex", "outcome"), CHAINED)
@pytest.mark.parametrize("rate", ["", "%% \\dot w : speed [mm/s]\n"])
def test_the_rates_of_what_moves_with_a_letter_are_by_the_chain_rule(
    latex: list[str], outcome: str, rate: str
) -> None:
    block = f"%% w(\\varphi) : lift [mm]\n{rate}"
    assert outcomes(*latex, block=block)[-1] == outcome


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_every_row_has_its_outcome(case: str) -> None:
    equations, expected = CASES[case]
    assert outcomes(*equations, block=SAID.get(case, "")) == expected


def test_without_a_block_a_vector_has_the_size_that_it_is_used_with() -> None:
    table = r"\begin{pmatrix}\cos\theta\\ \sin\theta\end{pmatrix}"
    wrong = r"\mathbf r=\begin{pmatrix}l\cos\theta\\ -l\sin\theta\end{pmatrix}"
    prints = (r"\mathbf r=l\mathbf s", rf"\mathbf s={table}", wrong.replace("-l", "l"), wrong)
    found = check("paper.tex", " ".join(f"$${one}$$" for one in prints))
    assert [row.outcome for row in found.rows] == ["DEFINITION", "DEFINITION", "PROVED", "REFUTED"]


def test_a_double_sign_without_a_branch_defines_nothing() -> None:
    block = "%% mechproof\n%% k ; m ; n : numbers\n%% end\n"
    found = check("paper.tex", block + r"$$k=m\pm n$$ $$k=m-n$$")
    assert [row.outcome for row in found.rows] == ["not judged", "DEFINITION"]


def test_values_may_be_said_that_the_paper_says_in_words() -> None:
    block = "%% let m=\\cos\\alpha, n=\\sin\\alpha\n"
    assert outcomes("m^2+n^2=1", "m^2-n^2=1", block=block) == ["PROVED", "DEFINITION"]
    assert outcomes(r"m=\cos\alpha", r"m=\sin\alpha", block=block) == ["DEFINITION", "REFUTED"]


def test_angles_may_be_said_modulo_turns() -> None:
    equal = r"\alpha=\alpha+2\pi"
    wrong = r"\alpha=\alpha+\pi"
    said = "%% modulo 2\\pi (1), (2)\n"
    assert outcomes(equal, wrong, block=said) == ["PROVED", "REFUTED"]
    assert outcomes(equal) == ["REFUTED"]


def test_equations_are_skipped_or_constrained_by_name_or_label() -> None:
    block = "%% skip (1): a print of the scan\n%% constraint eq:b\n"
    rows = run(r"k=m", r"\label{eq:b}k=m=\cos k", block=block).rows
    assert [row.outcome for row in rows] == ["skipped", "DEFINITION", "DEFINITION"]
    assert rows[0].reason == "a print of the scan"


def test_rows_say_what_they_do_and_where_they_stand() -> None:
    rows = run(ROD, r"\dot x=-r\dot\varphi\sin\varphi").rows
    assert [row.role for row in rows] == [Role.DEFINITION, Role.DERIVATIVE]
    assert [row.place.line for row in rows] == [17, 18]


# An equation, the text after it, and whether the row reports that nothing else uses its letter.
LONELY = {
    (r"u=m\cos\alpha", ""): True,
    (r"u=m\cos\alpha", "$$k=2u$$"): False,
    (r"\dot x=r\dot\varphi", "$$x=r$$"): False,
    # The display cannot be read, so it may use the letter.
    (r"u=m\cos\alpha", "$$k=2q_u$$"): False,
    (r"u=m\cos\alpha", "$$k=\\mu$$"): True,
    (r"u=m\cos\alpha", r"\begin{tabular}{ll}$m$ & $u$\\1 & 2\end{tabular}"): False,
    (r"u=3", ""): True,
}


@pytest.mark.parametrize(("latex", "more"), LONELY)
def test_a_letter_that_nothing_else_uses_is_told(latex: str, more: str) -> None:
    row = check("paper.tex", paper(latex) + more).rows[0]
    assert row.outcome == "DEFINITION"
    assert row.reason.endswith(" uses u.") == LONELY[latex, more]


def test_an_accusation_names_what_it_is_compared_with() -> None:
    rows = run(r"\lambda=\frac rl", r"\lambda=\frac lr").rows
    assert rows[1].reason.endswith("compared with (1)")


def test_without_a_block_letters_are_real_numbers_and_told() -> None:
    found = check("paper.tex", r"$$k=\frac{a}{b}$$ $$k^2=\frac{a^2}{b^2}$$ $$f(x+1)=x$$")
    assert found.taken == ("k", "a", "b", "f", "x")
    assert [row.outcome for row in found.rows] == ["DEFINITION", "PROVED", "not read"]


@pytest.mark.parametrize(
    ("latex", "outcome"),
    [
        # A letter where it can be nothing else.
        (r"k=\frac{Gd^4}{8D^3n}", "DEFINITION"),
        (r"b=\frac{ce}{c+f}", "DEFINITION"),
        (r"i_{\max}=2i", "DEFINITION"),
        (r"k=\int_0^1 x\,dx+d", "not read"),
        (r"k=e^{-t}+e", "not read"),
    ],
)
def test_without_a_block_a_letter_that_may_be_a_sign_is_taken_or_named(
    latex: str, outcome: str
) -> None:
    (row,) = check("paper.tex", f"$${latex}$$").rows
    assert row.outcome == outcome
    # The reason names that letter, not the first one of the print.
    assert outcome == "DEFINITION" or row.reason[0] in "de"


def test_what_is_nested_too_deeply_ends_nothing() -> None:
    deep = r"\sqrt{" * 1500 + "x" + "}" * 1500
    deep_row, row = check("paper.tex", f"$${deep}=1$$ $$a+b=b+a$$").rows
    assert (deep_row.outcome, row.outcome) == ("not read", "PROVED")
    assert deep_row.reason == "it is nested too deeply to be read"


def test_a_wrong_line_of_many_ends_nothing() -> None:
    found = outcomes(r"k=\frac{m}{", r"m=\begin{foo}", r"\lambda=\frac rl", r"u=\unknown{2}")
    assert found == ["not read", "not read", "DEFINITION", "not read"]


@pytest.mark.parametrize(
    "between",
    [
        r"\quad\Rightarrow\quad ",
        r"\Rightarrow ",
        r"\quad\Longrightarrow\quad ",
        r",\quad\text{hence}\quad ",
        r",\quad\text{so that }",
        r"\qquad\text{und}\qquad ",
    ],
)
def test_words_and_arrows_part_equations(between: str) -> None:
    assert outcomes(rf"k=mn{between}m=\frac kn") == ["DEFINITION", "PROVED"]


def test_a_word_may_lead_to_an_equation() -> None:
    assert outcomes("k=mn", r"\text{hence}\quad m=\frac kn") == ["DEFINITION", "PROVED"]


@pytest.mark.parametrize(
    ("reason", "written"),
    [
        ("nothing is known about d_i[1], a member", "nothing is known about d_1, a member"),
        ("d_{bi}[2] and R_{ij}[1, 2]", "d_{b2} and R_{12}"),
        ("T_i[12] and T_i[i]", "T_{12} and T_i"),
        ("R_{ij}[1, n + 1]**2", "R_{1,n + 1}^2"),
        # Entries of matrices.
        ("R_a[1, 2] and R_i[1, 2] and v[1]", "R_a[1, 2] and R_i[1, 2] and v[1]"),
    ],
)
def test_members_of_families_are_named_as_they_are_printed(reason: str, written: str) -> None:
    left = Left("(1)", Place("p.tex", 1, 1), "d_1=a", State.NOT_JUDGED, reason)
    assert show_left(left).reason == written


def test_a_step_of_other_letters_says_what_would_decide() -> None:
    row = run(r"k=\frac{a-b}{c-b}=-\frac mn").rows[1]
    assert row.outcome == "not judged"
    assert row.reason.endswith("if it is meant for all their values, identity (1)")
    row = run(r"k=\frac{a-b}{c-b}=-\frac mn", block="%% constraint (1)\n").rows[1]
    assert row.outcome == "DEFINITION"
