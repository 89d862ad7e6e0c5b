"""Numbers equated to letters: compared at the sizes, in the units of their letters."""

from __future__ import annotations

import pytest
from small_papers import outcomes, run

from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")


def test_numbers_are_compared_at_the_sizes() -> None:
    sizes = "%% sizes r=20 mm, l=60\\,mm\n"
    found = outcomes(r"\lambda=\frac rl=0.333", r"\lambda=\frac rl=0.34", block=sizes)
    assert found == ["DEFINITION", "PROVED", "DEFINITION", "REFUTED"]
    assert outcomes(r"\lambda=\frac rl", r"\lambda=0.34", block=sizes)[1] == "not judged"
    assert outcomes(r"\lambda=\frac rl", r"\lambda=0", block=sizes)[1] == "not judged"


def test_a_size_may_have_another_unit_than_its_letter() -> None:
    block = "%% D : diameter [mm]\n%% sizes D=2.5 cm\n"
    for number, outcome in (("50", "PROVED"), ("5.0", "REFUTED")):
        assert outcomes(f"x=2D={number}", block=block)[1] == outcome


def test_numbers_are_compared_in_the_units_of_their_letters() -> None:
    block = "%% w : speed [m/s]\n%% \\omega : speed [rpm]\n%% \\delta : angle [deg]\n"
    sizes = "%% sizes r=20 mm, \\omega=30\\,rpm, \\delta=30\n"
    right = outcomes(r"w=r\omega=0.0628", r"x=r\sin\delta=10.0", block=block + sizes)
    assert right == ["DEFINITION", "PROVED", "DEFINITION", "PROVED"]
    wrong = outcomes(r"w=r\omega=0.0728", r"x=r\sin\delta=11.0", block=block + sizes)
    assert wrong == ["DEFINITION", "REFUTED", "DEFINITION", "REFUTED"]
    numbers = outcomes(r"\omega=\frac{30k}{\pi}=95.5", block=block + "%% sizes k=10\n")
    assert numbers == ["DEFINITION", "PROVED"]
    turns = "%% n_0 : turns [min^-1]\n%% sizes n_0=300\n"
    for number, outcome in (("31.42", "PROVED"), ("3.142", "REFUTED"), ("30.42", "REFUTED")):
        printed = rf"w=\frac{{2\pi n_0}}{{60}}={number}\,\mathrm{{s}}^{{-1}}"
        assert outcomes(printed, block="%% w : speed\n" + turns)[1] == outcome


UNITS = {
    r"\lambda=\frac rl\approx0.333": ["DEFINITION", "PROVED"],
    r"\lambda=\frac rl\approx0.343": ["DEFINITION", "REFUTED"],
    r"x=r\cos\alpha=17.6\,\mathrm{mm}": ["DEFINITION", "PROVED"],
    r"x=r\cos\alpha=\SI{1.76}{\centi\metre}": ["DEFINITION", "PROVED"],
    r"x=r\cos\alpha=\qty{1.76}{mm}": ["DEFINITION", "REFUTED"],
    r"\beta=\arcsin\frac rl=19.5^\circ": ["DEFINITION", "PROVED"],
    r"\beta=\arcsin\frac rl=-19.5^\circ": ["DEFINITION", "REFUTED"],
    r"r=20\,\text{mm},\quad l=\num{60}~\mathrm{mm}": ["DEFINITION", "DEFINITION"],
    r"r>10\,\mathrm{mm}": ["DEFINITION"],
    r"x=3\,\mathrm{mm}\cos\alpha": ["DEFINITION"],
    r"x=r\cos\alpha=17.6\,\mathrm{apples}": ["not read"],
    r"-x=-r\cos\alpha=\SI{-17.6}{mm}": ["DEFINITION", "PROVED"],
    r"-x=-r\cos\alpha=\SI{+17.6}{mm}": ["DEFINITION", "REFUTED"],
    r"x=r\cos\alpha=\SI{17,6}{mm}": ["DEFINITION", "PROVED"],
    r"\sin\ang{30}=\num{0.5}": ["PROVED"],
    r"\sin\ang{60}=\num{0,5}": ["REFUTED"],
    r"x=r\cos\alpha=17.6\,{\rm mm}": ["DEFINITION", "PROVED"],
    r"x=r\cos\alpha=19.6\,{\rm mm}": ["DEFINITION", "REFUTED"],
    r"2\,\mathrm{k}\Omega=2000\,\Omega": ["PROVED"],
    r"24\,\mathrm{V}/(2\,\Omega)=6\,\mathrm{A}": ["REFUTED"],
    r"x=r\cos\alpha=1.76\cdot10^1\,\mathrm{mm}": ["DEFINITION", "PROVED"],
    r"x=r\cos\alpha=1.76\times10^{-2}\,\mathrm{m}": ["DEFINITION", "PROVED"],
    r"x=r\cos\alpha=1.86\cdot10^{-2}\,\mathrm{m}": ["DEFINITION", "REFUTED"],
    r"x=r\cos\alpha=\SI{1.76e-2}{m}": ["DEFINITION", "PROVED"],
    r"x=r\cos\alpha=\SI{1.76e2}{m}": ["DEFINITION", "REFUTED"],
    r"\num{1.5e3}=1500": ["PROVED"],
    r"x=1.76e2": ["not read"],
    r"10^5\,\mathrm{Pa}=1\,\mathrm{bar}": ["PROVED"],
    r"10^5\,\mathrm{Pa}=3\,\mathrm{bar}": ["REFUTED"],
    r"10^{-3}\,\mathrm{m^3/s}=60\,\mathrm{l/min}": ["PROVED"],
    r"\SI{6}{kN.m}=6000\,\mathrm{N\,m}": ["PROVED"],
    r"1\,\mathrm{kWh}=3.6\cdot10^6\,\mathrm J": ["PROVED"],
    r"\cos30^\circ\approx0.866": ["PROVED"],
    r"x\approx r": ["not judged"],
    r"k\approx3.52": ["DEFINITION"],
    r"l\approx0.06\,\mathrm m": ["DEFINITION"],
}


@pytest.mark.parametrize("latex", UNITS)
def test_numbers_may_have_units(latex: str) -> None:
    block = "%% sizes r=20 mm, l=60 mm, \\alpha=0.5\n"
    assert outcomes(latex, block=block) == UNITS[latex]


@pytest.mark.parametrize("words", ["", "For this crank the ratio is", "If the rod is short,"])
@pytest.mark.parametrize(("number", "outcome"), [("0.333", "PROVED"), ("0.343", "REFUTED")])
def test_words_excuse_no_number_at_the_sizes(words: str, number: str, outcome: str) -> None:
    block = "%% mechproof\n%% r ; l : lengths [mm]\n%% \\lambda : ratio\n%% sizes r=20 mm, l=60 mm"
    display = rf"\begin{{equation}}\lambda=\frac rl={number}\end{{equation}}"
    text = f"{block}\n%% end\n{words} {display}"
    assert [row.outcome for row in check("paper.tex", text).rows] == ["DEFINITION", outcome]


SHAFT = r"""%% mechproof
%% d : diameter [mm]
%% \tau : stress [MPa]
%% T : torque [N*m]
%% P : power [kW]
%% n : speed [rpm]
%% \omega : angular velocity [rad/s]
%% sizes P=15 kW, n=1450 rpm, d=38 mm
%% end
\begin{equation}\omega=\frac{2\pi n}{60}=151.8\,\mathrm{rad/s}\end{equation}
"""


@pytest.mark.parametrize(
    ("latex", "outcome"),
    [
        (r"T=\frac P\omega=98.8\,\mathrm{N\,m}", "PROVED"),
        (r"T=\frac P\omega=89.8\,\mathrm{N\,m}", "REFUTED"),
        (r"T=\frac P\omega,\qquad\tau=\frac{16T}{\pi d^3}=9.17\,\mathrm{MPa}", "PROVED"),
        (r"T=\frac P\omega,\qquad\tau=\frac{16T}{\pi d^3}=9.71\,\mathrm{MPa}", "REFUTED"),
    ],
)
def test_a_formula_may_turn_revolutions_itself_and_others_rest_on_it(
    latex: str, outcome: str
) -> None:
    text = rf"{SHAFT}\begin{{equation}}{latex}\end{{equation}}"
    assert check("paper.tex", text).rows[-1].outcome == outcome


# Prints and their outcomes: an angle and its tangent, a size printed before its formula.
TANGENTS = [
    ([r"\tan\beta=\frac rl", r"\beta=18.4^\circ"], ["DEFINITION", "PROVED"]),
    ([r"\tan\beta=\frac rl", r"\beta=14.8^\circ"], ["DEFINITION", "REFUTED"]),
    ([r"\tan\beta=\frac rl", r"\beta=33.0^\circ"], ["DEFINITION", "not judged"]),
    ([r"\beta=18.4^\circ", r"\tan\beta=\frac rl"], ["PROVED", "DEFINITION"]),
    ([r"\beta=14.8^\circ", r"\tan\beta=\frac rl"], ["REFUTED", "DEFINITION"]),
    (
        [r"\tan\beta=\frac hl", r"\tan\beta=\frac rl", r"\beta=18.4^\circ"],
        ["DEFINITION", "DEFINITION", "PROVED"],
    ),
    ([r"\tan\beta=\frac hl", r"\beta=18.4^\circ"], ["DEFINITION", "DEFINITION"]),
    ([r"\sin\beta=\frac rl", r"\beta=19.5^\circ"], ["DEFINITION", "PROVED"]),
    ([r"\sin\beta=\frac rl", r"\beta=15.9^\circ"], ["DEFINITION", "REFUTED"]),
    (
        [r"\lambda=\frac rl", r"\cos\beta=\lambda", r"\beta=70.5^\circ"],
        ["DEFINITION", "not judged", "PROVED"],
    ),
    ([r"\cos\beta=\frac rl", r"\beta=-70.5^\circ"], ["DEFINITION", "not judged"]),
    ([r"\sin\beta=\frac rl", r"\beta=160.5^\circ"], ["DEFINITION", "not judged"]),
    # The number of the tangent is rounded.
    ([r"\tan\beta=0.33", r"\beta=18.4^\circ"], ["PROVED", "DEFINITION"]),
    ([r"\lambda=0.333", r"\lambda=\frac rl"], ["PROVED", "DEFINITION"]),
    ([r"\lambda=0.383", r"\lambda=\frac rl"], ["REFUTED", "DEFINITION"]),
]


@pytest.mark.slow
@pytest.mark.parametrize(("equations", "expected"), TANGENTS)
def test_a_size_is_compared_with_what_else_is_printed(
    equations: list[str], expected: list[str]
) -> None:
    assert outcomes(*equations, block="%% sizes r=20 mm, l=60 mm\n") == expected


def test_a_letter_with_a_size_and_no_sizes_of_its_formula_is_taken_at_its_size() -> None:
    block = "%% sizes m=2, n=5\n"
    equations = [r"n=\frac ku", r"h=\frac mn=0.40", r"h=\frac mn=0.45"]
    found = outcomes(*equations, block=block)
    assert found == ["DEFINITION", "DEFINITION", "PROVED", "DEFINITION", "REFUTED"]
    assert outcomes(equations[0], "n=4.55", block=block)[1] == "not judged"


def test_a_letter_with_a_size_and_a_formula_may_be_either() -> None:
    block = "%% sizes r=20 mm, l=60 mm, \\beta=0.5\n"
    numbers = [r"h=r\cos\beta=17.55", r"h=r\cos\beta=18.86", r"h=r\cos\beta=18.0"]
    found = outcomes(r"\beta=\arcsin\frac rl", *numbers, block=block)
    assert found[2::2] == ["PROVED", "PROVED", "REFUTED"]


DRIVE = r"""%% mechproof
%% v : speed [m/s]
%% D : diameter [mm]
%% P : power [kW]
%% M : torque [N m]
%% n ; n_1 : revolutions [min^{-1}]
%% N ; f : revolutions, frequency of the mains [1/s]
%% \omega : angular velocity [rad/s]
%% z_1 ; z_2 : teeth
%% s ; p : slip, pairs of poles [1]
%% sizes v=0.25 m/s, D=400 mm, P=5.68 kW, n_1=1450 min^{-1}, z_1=20, z_2=50, p=2, f=50 1/s
%% end
"""
REVOLVING = [
    (r"n=\frac{v}{\pi D}=11.9\,\mathrm{min}^{-1}", "PROVED"),
    (r"n=\frac{v}{\pi D}=11.9\,\mathrm{min^{-1}}", "PROVED"),
    (r"n=\frac{v}{\pi D}=11.9\,\min^{-1}", "PROVED"),
    (r"n=\frac{v}{\pi D}=11.9\,\mathrm{rev/min}", "PROVED"),
    (r"n=\frac{v}{\pi D}=19.1\,\mathrm{min}^{-1}", "REFUTED"),
    (r"n=\frac{v}{\pi D}=0.199\,\mathrm{s}^{-1}", "PROVED"),
    (r"n=\frac{v}{\pi D}=0.199\,\mathrm{min}^{-1}", "REFUTED"),
    (r"n=\frac{60v}{\pi D}=11.9\,\mathrm{min}^{-1}", "PROVED"),
    (r"n=\frac{60v}{\pi D}=19.1\,\mathrm{min}^{-1}", "REFUTED"),
    (r"N=\frac{v}{\pi D}=11.9\,\mathrm{rpm}", "PROVED"),
    (r"N=\frac{v}{\pi D}=19.1\,\mathrm{rpm}", "REFUTED"),
    (r"\frac{v}{\pi D}=11.9\,\mathrm{rpm}", "PROVED"),
    (r"\frac{v}{\pi D}=19.1\,\mathrm{rpm}", "REFUTED"),
    (r"\pi Dn_1=30.4\,\mathrm{m/s}", "PROVED"),
    (r"\frac{\pi Dn_1}{60\cdot1000}=30.4\,\mathrm{m/s}", "PROVED"),
    (r"\pi Dn_1=1822124\,\mathrm{m/s}", "not judged"),
    (r"Pn_1=862\,\mathrm{kW/s}", "REFUTED"),
    (r"\frac{1}{n_1}=0.0414\,\mathrm{s}", "PROVED"),
    (r"\frac{n_1D}2=4.83\,\mathrm{m/s}", "PROVED"),
    (r"\frac{n_1D}2=30.4\,\mathrm{m/s}", "REFUTED"),
    (r"M=\frac{P}{n_1}=235\,\mathrm{N}", "not judged"),
    (r"1450\,\mathrm{min^{-1}}=24.17\,\mathrm{s^{-1}}", "PROVED"),
    (r"1450\,\mathrm{min^{-1}}=27.14\,\mathrm{s^{-1}}", "REFUTED"),
    (r"\omega=2\pi n_1=151.8\,\mathrm{s^{-1}}", "PROVED"),
    (r"\omega=2\pi n_1=158.1\,\mathrm{s^{-1}}", "REFUTED"),
    (r"M=\frac{P}{2\pi n_1}=37.4\,\mathrm{N\,m}", "PROVED"),
    (r"M=\frac{P}{2\pi n_1}=34.7\,\mathrm{N\,m}", "REFUTED"),
    (r"n=\frac{z_1}{z_2}n_1,\quad v=\pi Dn=12.1\,\mathrm{m/s}", "PROVED"),
    (r"n=\frac{z_1}{z_2}n_1,\quad v=\pi Dn=1.21\,\mathrm{m/s}", "REFUTED"),
    (r"N=\frac{z_1}{z_2}n_1=9.67\,\mathrm{s}^{-1}", "PROVED"),
    (r"N=\frac{z_1}{z_2}n_1=6.97\,\mathrm{s}^{-1}", "REFUTED"),
    (r"s=1-\frac{n_1p}{f}=0.033", "PROVED"),
    (r"s=1-\frac{n_1p}{f}=0.043", "REFUTED"),
]


@pytest.mark.parametrize(("latex", "outcome"), REVOLVING)
def test_revolutions_are_radians_or_counted(latex: str, outcome: str) -> None:
    text = rf"{DRIVE}\begin{{equation}}{latex}\end{{equation}}"
    assert check("paper.tex", text).rows[-1].outcome == outcome


def test_the_recomputed_number_is_that_of_the_nearest_reading() -> None:
    text = rf"{DRIVE}\begin{{equation}}\omega=2\pi n_1=158.1\,\mathrm{{s}}^{{-1}}\end{{equation}}"
    assert "recomputed 151.844" in check("paper.tex", text).rows[-1].reason


SPRING = r"""%% mechproof
%% d ; D ; s : diameters of wire and coil, deflection [mm]
%% i : number of coils [1]
%% G : shear modulus [N/mm^2]
%% R : rate [N/mm]
%% F : force [N]
%% W : energy [N mm]
%% w : ratio of diameters [1]
%% sizes d=4 mm, D=30 mm, i=8, G=81500 N/mm^2, F=300 N
%% end
"""
RATE = r"R=\frac{Gd^4}{8D^3i}=12.07\,\mathrm{N/mm}"
RATIO = r"w=\frac Dd=7.5"
ENERGY = r"W=\frac{F^2}{2R}="
AGREES = "it agrees with the printed rounded numbers, R of (1); unrounded ones give 3"
# Prints, and the reason given for the last number.
ROUNDED = [
    ([RATE, ENERGY + r"3727\,\mathrm{N\,mm}"], "recomputed 3726.99"),
    ([RATE, ENERGY + r"3728\,\mathrm{N\,mm}"], AGREES),
    ([RATE, ENERGY + r"3.728\,\mathrm{N\,m}"], AGREES),
    ([RATE, ENERGY + r"3782\,\mathrm{N\,mm}"], "recomputed 3726.99, printed 3782"),
    ([ENERGY + r"3728\,\mathrm{N\,mm}", RATE], "recomputed 12.0741"),
    ([RATE.partition("=12")[0], ENERGY + "3728"], "recomputed 3726.99, printed 3728"),
    # An exact number was not rounded.
    ([RATIO, r"s=dw=30.2\,\mathrm{mm}"], "recomputed 30, printed 30.2"),
    ([RATIO.replace("7.5", "7.6"), r"s=dw=30.4\,\mathrm{mm}"], "it agrees with the printed"),
]


@pytest.mark.parametrize(("equations", "reason"), ROUNDED)
def test_a_number_may_rest_on_rounded_ones(equations: list[str], reason: str) -> None:
    shown = (rf"\begin{{equation}}{latex}\end{{equation}}" for latex in equations)
    row = check("paper.tex", SPRING + "\n".join(shown)).rows[-1]
    assert row.reason.startswith(reason)
    outcome = "REFUTED" if "printed" in reason else "PROVED"
    assert row.outcome == ("not judged" if reason.startswith("it agrees") else outcome)


# Prints, and the outcome of the last one: where decimals have points, commas separate thousands.
COMMAS = [
    ([r"\frac12=0.5", r"10^3=1{,}000"], "PROVED"),
    ([r"\frac12=0.5", r"10^3=1{,}001"], "REFUTED"),
    ([r"1000^2=1{,}000{,}000", r"\frac{12345}{10}=1{,}234.5"], "PROVED"),
    ([r"\frac12=0.5", r"\frac54=1{,}25"], "PROVED"),
    ([r"\frac12=0.5", r"\frac54=1{,}250"], "REFUTED"),
    ([r"\frac12=0{,}5", r"\frac54=1{,}250"], "PROVED"),
    ([r"\frac12=0{,}5", r"10^3=1{,}000"], "REFUTED"),
    ([r"2=2\quad\text{by (2.1)}", r"\frac54=1{,}250"], "PROVED"),
]


@pytest.mark.parametrize(("equations", "outcome"), COMMAS)
def test_a_comma_is_decimal_or_parts_thousands(equations: list[str], outcome: str) -> None:
    assert outcomes(*equations)[-1] == outcome


ROD = r"""%% mechproof
%% F : force [N]
%% d : diameter [mm]
%% A : area [mm^2]
%% \sigma : stress [MPa]
%% sizes F=20000 N, d=16 mm
%% end
A rod of $d=16$ mm carries $F=20$ kN.
\begin{equation}A=\frac{\pi d^2}4=201\,\mathrm{mm^2}\end{equation}
"""
AREA, STRESS = r"A=\frac{\pi d^2}4={}\,\mathrm{mm^2}", r"\sigma=\frac FA={}\,\mathrm{MPa}"
# Words, the print after them, its number, and its outcome.
RESTATED = [
    ("With $d=20$ mm we have", AREA, "314", "PROVED"),
    ("With $d=2$ cm we have", AREA, "314", "PROVED"),
    (r"For $d=20\,\mathrm{mm}$", STRESS, "63.7", "PROVED"),
    ("For $d=20$ mm", AREA, "341", "not judged"),
    ("For $d=20$ mm", "A={}", "314", "PROVED"),
    ("With $d=20$ in place of it", AREA, "314", "PROVED"),
    ("With $d=20$ mm, but again $d=16$ mm for the old one,", AREA, "314", "REFUTED"),
    ("With $d=16$ mm", AREA, "314", "REFUTED"),
    ("With $D=20$ mm", AREA, "314", "REFUTED"),
    ("With $F=40$ kN", AREA, "314", "REFUTED"),
    ("With $F=40$ kN", STRESS, "198.9", "PROVED"),
    (r"We choose M20 with $A=245\,\mathrm{mm^2}$ and have", STRESS, "81.6", "not judged"),
    ("A bar of 314 mm$^2$ has", STRESS, "63.7", "not judged"),
    (r"A bar of $3.14\,\mathrm{cm^2}$ in its place has", STRESS, "63.7", "not judged"),
    ("A bar of 314 mm has", STRESS, "63.7", "REFUTED"),
    ("A bar of 324 mm$^2$ has", STRESS, "63.7", "REFUTED"),
    (r"Its area $A=201\,\mathrm{mm^2}$ gives", STRESS, "99.5", "PROVED"),
]


@pytest.mark.parametrize(("words", "latex", "number", "outcome"), RESTATED)
def test_words_may_state_a_size_anew(words: str, latex: str, number: str, outcome: str) -> None:
    display = rf"\begin{{equation}}{latex.replace('{}', number)}\end{{equation}}"
    assert check("paper.tex", f"{ROD}{words} {display}").rows[-1].outcome == outcome


FEW = "the value at the sizes is 2; a number of so few digits may be rounded, or for other sizes"
# Numbers of one digit or two, their outcome, and the reason given.
DIGITS = [
    ("k=2", "PROVED", "recomputed 2"),
    ("k=3", "not judged", FEW),
    ("k=3.0", "not judged", "not the value at the declared sizes: recomputed 2, printed 3.0"),
    (r"k=\frac{\pi-\beta}\beta=3", "not judged", FEW),
    (r"k=\frac{\pi-\beta}\beta=3.0", "REFUTED", "recomputed 2, printed 3.0"),
]


@pytest.mark.parametrize(("latex", "outcome", "reason"), DIGITS)
def test_numbers_of_one_digit_are_told_the_value_at_the_sizes(
    latex: str, outcome: str, reason: str
) -> None:
    equations = [r"\beta=\arccos\frac rl", r"k=\frac{\pi-\beta}\beta", latex]
    row = run(*equations, block="%% sizes r=30 mm, l=60 mm\n").rows[-1]
    assert (row.outcome, row.reason) == (outcome, reason)


CHOSEN = r"""%% mechproof
%% F : force [N]
%% d : diameter [mm]
%% A : area [mm^2]
%% \sigma : stress [MPa]
%% z : number of bolts [1]
%% sizes F=20000 N, \sigma=140 MPa
%% end
\[d=\sqrt{\frac{4F}{\pi\sigma}}=13.49\,\mathrm{mm}\]
The next standard one is \[d=14\,\mathrm{mm}\]
with \[A=\frac{\pi d^2}4=153.9\,\mathrm{mm^2}\]
and \[z=\frac{7F}{\sigma A}=@.\]
"""


@pytest.mark.parametrize(("number", "outcome"), [("6.5", "not judged"), ("7.5", "REFUTED")])
def test_a_number_may_be_that_of_a_chosen_one(number: str, outcome: str) -> None:
    assert check("paper.tex", CHOSEN.replace("@", number)).rows[-1].outcome == outcome
