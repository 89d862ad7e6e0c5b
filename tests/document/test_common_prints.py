"""Prints common in papers: separated thousands, degrees in brackets, partial derivatives."""

from __future__ import annotations

import pytest
from small_papers import judge_parts, outcomes

from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

TURN = r"s=r\sin\psi"
KINETIC = r"k=\frac12mr^2\dot\varphi^2"
BY_ANGLE = r"\frac{\partial k}{\partial\varphi}"
MOTION = (
    rf"\frac{{d}}{{dt}}\frac{{\partial k}}{{\partial\dot\varphi}}-{BY_ANGLE}"
    r"=-\frac{\partial u}{\partial\varphi}"
)
CASES = {
    "parts with braces and names, and signs with marks": (
        [
            r"x=\underbrace{2r}_{\text{crank}}+\overbrace{l}^{=1}=2r+l",
            r"x=\underbrace{2r}_{\text{crank}}+\underbrace{2l}_{\text{rod}}",
            r"x\overset{!}{=}2r+l",
            r"x\stackrel{(1)}{=}2r-l",
            r"\color{blue}x=\textcolor{red}{2r}+l",
            r"x\overset{?}{=}2r+l",
            r"\overset{!}{x}=2r+l",
            r"x=2\underbrace{r+l}_{a}",
        ],
        ["DEFINITION", "PROVED", "REFUTED", "PROVED", "REFUTED", "PROVED", *["not read"] * 3],
    ),
    "thousands are parted by thin spaces": (
        [
            r"60\,000=6\cdot10^4",
            r"60\,000=6\cdot10^5",
            r"1\,234\,567=1234567",
            r"n=1\,23",
            r"n=1\,2345",
            "n=60 000",
        ],
        ["PROVED", "REFUTED", "PROVED", "not read", "not read", "not read"],
    ),
    "thousands are parted by points beside decimal commas": (
        [r"12.500=1{,}25\cdot10^4", r"12.500=12{,}5"],
        ["PROVED", "REFUTED"],
    ),
    "points are decimal beside commas": (
        [r"12.500=1{,}25\cdot10", r"1.5=1{,}5"],
        ["PROVED", "PROVED"],
    ),
    "a value is printed at an angle in degrees": (
        [TURN, r"s(90^\circ)=r", r"s(30^\circ)=\frac r2", r"s(90^\circ)=2r", r"r(90^\circ)=2r"],
        ["DEFINITION", "PROVED", "PROVED", "REFUTED", "not read"],
    ),
    "approximations with zeros at their end": (
        [r"17\cdot37\approx630", r"12^3\approx1730", r"17\cdot37\approx640", r"17\cdot37=630"],
        ["not judged", "not judged", "REFUTED", "REFUTED"],
    ),
    "what does not change is equal to nothing": (
        [r"m=\text{const.}", r"n=\mathrm{const}", r"k = {\rm konst}", r"u=const.", r"m=n"],
        ["not judged", "not judged", "not judged", "not judged", "DEFINITION"],
    ),
    "frames at the right are no powers": (
        [r"k^0=2m", r"k^0_1=3m", r"n=k\cdot m^0"],
        ["not read", "not read", "not read"],
    ),
    "operators in script letters": (
        [r"\mathcal{L}\{k\}=2m", r"\mathcal{L}\{k^2\}=2km", r"\mathcal{L}[k]=2"],
        ["not read", "not read", "not read"],
    ),
    "what stands behind an angle and makes none of it": (
        [
            r"x=r\cos\alpha\,",
            r"s=\cos\alpha r+\cos\beta\,l",
            r"s=l\cos\beta-r\cos\alpha",
            r"s=\cos\alpha(r+l)",
            r"s=\cos\alpha(1+k)",
            r"s=\cos\alpha\beta",
        ],
        ["DEFINITION", "DEFINITION", "REFUTED", "not judged", "not read", "not read"],
    ),
    "a quantity that is given by itself": ([r"r=a+l r", r"r=a+k r"], ["ILL_FORMED", "DEFINITION"]),
    "an assignment is no constraint, from which anything would follow": (
        [r"x=x+r\varphi", r"l\varphi=2l\varphi", r"\beta=\beta+\varphi-\psi", r"x=2x-l", r"r=l-r"],
        ["not judged", "not judged", "not judged", "DEFINITION", "DEFINITION"],
    ),
    "an integral over a body has no derivative by what is printed of it": (
        [
            r"\int r^2\,dm=\frac13ml^2",
            r"\int r\,dn=nl",
            r"\int x^2\,dx=\frac{l^3}3",
            r"\int k\,dn=kn",
            r"\int r\,dr=\frac{r^2}2+b",
            r"\int r\,dr=r^2+b",
        ],
        ["not read", "not read", "not read", "PROVED", "PROVED", "REFUTED"],
    ),
    "powers of powers end": (
        [r"h=\frac{b}{c}\left(\left(\frac ab\right)^{\frac{9.80665m}{n\cdot c}}-1\right)+u"],
        ["DEFINITION"],
    ),
    "numbers in two units need no letter": (
        [
            r"85\,\%=0.85",
            r"85\,\%=8.5",
            r"1\,\mathrm{kN}=1000\,\mathrm N",
            r"1\,\mathrm{kN}=100\,\mathrm N",
            r"3\,\mathrm{mm}=3",
            r"3\,\mathrm{mm}>3",
        ],
        ["PROVED", "REFUTED", "PROVED", "REFUTED", "not judged", "not judged"],
    ),
    "an energy by an angle of which it has the rate only": (
        [KINETIC, rf"{BY_ANGLE}=0", rf"{BY_ANGLE}=1"],
        ["DEFINITION", "PROVED", "REFUTED"],
    ),
    "what else moves may depend on the angle": (
        [
            r"k=mx",
            rf"{BY_ANGLE}=0",
            r"u=\frac12mx\dot\varphi^2",
            r"\frac{\partial u}{\partial\varphi}=0",
        ],
        ["DEFINITION", "not read", "DEFINITION", "not read"],
    ),
    "an equation of motion and what follows from it": (
        [
            KINETIC,
            r"u=mn\cos\varphi",
            MOTION,
            r"r^2\ddot\varphi=n\sin\varphi",
            r"\ddot\varphi=\frac{n}{r^2}\cos\varphi",
        ],
        ["DEFINITION", "DEFINITION", "DEFINITION", "PROVED", "REFUTED"],
    ),
}


@pytest.mark.parametrize(
    ("package", "found"),
    [
        (r"\usepackage{amsmath, icomma}", ["DEFINITION", "PROVED", "REFUTED"]),
        (r"\usepackage{amsmath}", ["not read", "DEFINITION"]),
    ],
)
def test_commas_are_decimal_where_the_text_loads_what_makes_them_so(
    package: str, found: list[str]
) -> None:
    block = f"{package}\n%% mechproof\n%% a_{{1,2}} ; b : numbers\n%% end\n"
    parts = (r"a_{1,2}=3,5\cdot b=\frac72b", r"a_{1,2}=\frac92b")
    assert judge_parts(block, *parts) == found


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_what_is_printed_so(name: str) -> None:
    equations, expected = CASES[name]
    assert outcomes(*equations, block="%% where m>0\n") == expected


@pytest.mark.parametrize(("block", "outcome"), [("%% where m>0\n", "PROVED"), ("", "DEFINITION")])
def test_a_mass_that_all_terms_have_is_left_out(block: str, outcome: str) -> None:
    motion = r"mr^2\ddot\varphi-mnu\sin\varphi=0"
    without = r"\ddot\varphi=\frac{nu}{r^2}\sin\varphi"
    assert outcomes(motion, without, block=block) == ["DEFINITION", outcome]


@pytest.mark.parametrize(
    ("number", "outcome"),
    [("254", "not judged"), ("3{,}6", "not judged"), ("0.28", "not judged"), ("192", "ILL_FORMED")],
)
def test_a_number_that_may_have_a_unit_accuses_no_dimensions(number: str, outcome: str) -> None:
    block = "%% mechproof\n%% s : distance [m]\n%% v : speed [km/h]\n%% f : friction [1]\n%% end\n"
    assert judge_parts(block, rf"s=\frac{{v^2}}{{{number}f}}") == [outcome]


MASS = (
    "%% mechproof\n%% r ; l : [mm]\n%% v : [m/s]\n%% m : mass [kg]\n%% s : [mm]\n%% g : [m/s^2]\n"
)
UNITS = {
    "r=66 mm": "not read",
    r"l=1000\ mm=1\ m": "not read",
    "v=36~m/s": "not read",
    "r=5 m": "not read",
    r"\frac lr=2\pi rad": "not read",
    r"l=(r+2s)~mm": "not read",
    # Products of letters, right and wrong ones.
    r"l=2\,s=\frac{4s}{2}": "DEFINITION",
    "ml=2 ms": "DEFINITION",
    "v^2=2 gs": "DEFINITION",
    "l=3 mg": "ILL_FORMED",
    "l=2(3)=6": "DEFINITION",
}


@pytest.mark.parametrize(("printed", "outcome"), UNITS.items())
def test_units_in_italics_are_asked_for_and_products_are_not(printed: str, outcome: str) -> None:
    found = judge_parts(f"{MASS}%% end\n", printed, "l+r=3r", "l-r=r")
    assert found[0] == outcome


BELT = (
    "%% mechproof\n%% D ; d : diameters [mm]\n%% T ; N ; p ; q : forces [N]\n"
    "%% \\mu : number\n%% end\n"
)
FRICTION = r"\ln\frac qp=\int_p^q\frac{dT}T"


@pytest.mark.parametrize(
    ("printed", "outcome"),
    [("dT=\\mu N", "not read"), (r"d\cdot T=D N", "DEFINITION"), ("dN=D T", "DEFINITION")],
)
def test_a_differential_is_no_product_with_a_diameter(printed: str, outcome: str) -> None:
    assert judge_parts(BELT, printed)[0] != "not read"
    assert judge_parts(BELT, FRICTION, printed)[1] == outcome


INDEX_WORDS = r"""%% mechproof
%% F_{max} ; F_\mathrm{min} : forces [N]
%% s_\text{rel}(t) : way
%% end
"""


def test_words_in_italics_and_upright_are_one_index() -> None:
    prints = (
        r"F_{\mathrm{max}}=2F_\mathrm{min}",
        r"F_{\max}=F_{min}+F_{\text{min}}",
        r"\ddot{s}_{\rm rel}=\frac{d\dot s_{rel}}{dt}",
        r"F_{{\rm max}}=F_\min",
        r"F_{\mathrm{maxi}}=F_\min",
    )
    found = judge_parts(INDEX_WORDS, *prints)
    assert found == ["DEFINITION", "DEFINITION", "PROVED", "REFUTED", "not read"]


def test_letters_that_both_are_declared_stay_two() -> None:
    block = INDEX_WORDS.replace("F_{max} ;", r"F_{max} ; F_\mathrm{max} ;")
    prints = (r"F_{max}=2F_{min}", r"F_\mathrm{max}=3F_{max}", r"F_\mathrm{max}=2F_\mathrm{min}")
    assert judge_parts(block, *prints) == ["DEFINITION", "DEFINITION", "REFUTED"]


@pytest.mark.parametrize(
    ("printed", "outcome"),
    [
        (r"\dot y=-b\Omega\sin\Omega t", "PROVED"),
        (r"\dot y=-b\sin\Omega t", "REFUTED"),
        (r"\dot y=-b\Omega\sin b t", "not read"),
    ],
)
def test_a_phase_of_letters_without_units_is_one_argument(printed: str, outcome: str) -> None:
    block = "%% mechproof\n%% y(t) : way\n%% b ; \\Omega ; t :\n%% end\n"
    rows = check("paper.tex", rf"{block}$$y=b\cos\Omega t$$ $${printed}$$").rows
    assert rows[1].outcome == outcome, rows[1].reason


@pytest.mark.parametrize(
    ("said", "outcomes"),
    [
        (r"function \arccot is (0,\pi)", ["PROVED", "REFUTED"]),
        (r"function \arccot is (-\pi/2, \pi/2)", ["REFUTED", "PROVED"]),
        ("factor k", ["not read", "not read"]),
    ],
)
def test_the_range_of_an_arccotangent_is_said(said: str, outcomes: list[str]) -> None:
    block = f"%% mechproof\n%% k : number {{k>0}}\n%% {said}\n%% end\n"
    prints = (
        rf"\operatorname{{arccot}}(-k)={sign}\operatorname{{arccot}}k" for sign in (r"\pi-", "-")
    )
    assert judge_parts(block, *prints) == outcomes


@pytest.mark.parametrize(
    ("printed", "outcome"),
    [
        (r"tan(2x)=\frac{2\,tan(x)}{1-tan^2(x)}", "PROVED"),
        (r"tan(2x)=\frac{2\,tan(x)}{1+tan^2(x)}", "REFUTED"),
        # A declared name that is longer is no function.
        (r"tan_1=2tan_1-tan_1", "PROVED"),
    ],
)
def test_a_function_in_italics_is_declared_beside_its_letters(printed: str, outcome: str) -> None:
    block = "%% mechproof\n%% t ; a ; n ; x ; tan_1 : numbers\n%% function tan is \\tan\n%% end\n"
    (row,) = check("paper.tex", rf"{block}\[{printed}\]").rows
    assert str(row.outcome) == outcome, row.reason
