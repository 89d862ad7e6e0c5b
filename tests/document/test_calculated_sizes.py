"""Worked examples: sizes put into formulas, and calculations with units."""

from __future__ import annotations

import pytest

from mechproof.document.checking import CheckedPaper, check
from mechproof.record.unit_notation import name_in_si, read_unit

pytestmark = pytest.mark.usefixtures("judged_here")

LETTERS = r"""%% mechproof
%% z_1 ; z_2 : numbers of teeth
%% i : ratio [1]
%% F : force [N]
%% T : torque [N mm]
%% d ; l : lengths [mm]
%% A : area [mm^2]
%% p : pressure [MPa]
%% v : speed [m/s]
%% n ; n_2 : speeds of rotation [1/min]
%% \omega : angular speed [rad/s]
%% P : power [kW]
%% \varphi : angle [rad]
%% \eta : efficiency
%% end
\begin{equation}i=\frac{z_2}{z_1}\end{equation}
\begin{equation}F=\frac{2T}{d}\end{equation}
\begin{equation}p=\frac FA\end{equation}
\begin{equation}v=\pi dn\end{equation}
"""
SAID = (
    r"For $z_1=24$, $z_2=84$, $T=150\,\mathrm{N\,m}$, $d=60\,\mathrm{mm}$ and "
    r"$A=200\,\mathrm{mm^2}$ we get"
)
UNJUDGED = "not judged"


def judge(*equations: str, said: str = "") -> CheckedPaper:
    lines = "".join(f"\\begin{{equation}}{latex}\\end{{equation}}\n" for latex in equations)
    return check("paper.tex", f"{LETTERS}{said}\n{lines}")


def outcomes(*equations: str, said: str = "") -> list[str]:
    return [row.outcome for row in judge(*equations, said=said).rows[4:]]


# Sizes in several units, and letters declared in others.
UNITS = r"""%% mechproof
%% F ; G : forces [N]
%% A : area [mm^2]
%% p : pressure [MPa]
%% T : torque [N m]
%% \omega : angular speed [rad/s]
%% P : power [kW]
%% v : speed [m/s]
%% d : diameter [m]
%% n ; n_s : speeds [1/min]
%% s : slip [%]
%% end
For $F=12\,\mathrm{kN}$, $A=50\,\mathrm{mm^2}$, $T=49\,\mathrm{N\,m}$, $\omega=150\,\mathrm{rad/s}$,
$d=50\,\mathrm{mm}$, $n=1450\,\mathrm{min}^{-1}$ and $n_s=1500\,\mathrm{min}^{-1}$
"""
IN_UNITS = {
    # The numbers are in N/mm^2 throughout, or in no unit that fits.
    r"p=\frac FA=\frac{12000}{50}=240\,\mathrm{MPa}": ["PROVED", "PROVED"],
    r"p=\frac FA=\frac{12000}{50}=240\,\mathrm{Pa}": ["PROVED", "REFUTED"],
    r"p=\frac FA=\frac{12000}{50}=0.00024\,\mathrm{MPa}": ["PROVED", "REFUTED"],
    r"p=\frac FA=\frac{12000}{50}=240\,\mathrm{kg}": ["PROVED", UNJUDGED],
    r"P=T\omega=49\cdot150=7350\,\mathrm{W}": ["PROVED", "PROVED"],
    r"P=T\omega=49\cdot150=7.35\,\mathrm{kW}": ["PROVED", "PROVED"],
    r"P=T\omega=49\cdot150=7350\,\mathrm{kW}": ["PROVED", "REFUTED"],
    r"P=T\omega=\frac{49\cdot150}{1000}=7.35\,\mathrm{W}": ["PROVED", "REFUTED"],
    r"v=\pi dn=\pi\cdot0.05\cdot1450=227.8\,\mathrm{m/min}": [UNJUDGED, UNJUDGED],
    r"v=\pi dn=\pi\cdot0.05\cdot1450=227.8\,\mathrm{m/s}": [UNJUDGED, UNJUDGED],
    r"s=\frac{n_s-n}{n_s}=\frac{50}{1500}=3.33\,\%": ["PROVED", "PROVED"],
    r"s=\frac{n_s-n}{n_s}=\frac{50}{1500}=0.0333\,\%": ["PROVED", UNJUDGED],
    # Rounded intermediate numbers.
    r"G=\frac{2T}d=\frac{98}{0.05}=1960\,\mathrm{N}": ["PROVED", "PROVED"],
    r"p=\frac FA=\frac{12000}{50.3}=240\,\mathrm{MPa}": [UNJUDGED, UNJUDGED],
}


@pytest.mark.slow
@pytest.mark.parametrize("latex", IN_UNITS)
def test_numbers_without_units_have_those_of_the_result(latex: str) -> None:
    rows = check("paper.tex", f"{UNITS}\n\\begin{{equation}}{latex}\\end{{equation}}\n").rows
    assert [row.outcome for row in rows[1:]] == IN_UNITS[latex]


@pytest.mark.parametrize("number", ["200", "1257"])
def test_nothing_is_said_of_turns_that_no_letter_counts(number: str) -> None:
    calculation = r"\frac{10\,\mathrm{m/s}}{0.05\,\mathrm m}"
    assert outcomes(rf"{calculation}={number}\,\mathrm{{rad/s}}") == [UNJUDGED]
    found = {"200": "PROVED", "1257": "REFUTED"}[number]
    assert outcomes(rf"\omega={calculation}={number}\,\mathrm{{rad/s}}")[1:] == [found]


ROUNDED = {
    r"\frac{3.14\cdot7^2}4=38.48": [UNJUDGED],
    r"\frac{3.14\cdot7^2}4=39.5": ["REFUTED"],
    r"\frac{1000\,\mathrm N}{38.5\,\mathrm{mm^2}}=25.98\,\mathrm{MPa}": [UNJUDGED],
    r"\frac{1000\,\mathrm N}{38.5\,\mathrm{mm^2}}=26.98\,\mathrm{MPa}": ["REFUTED"],
    r"\omega=2\pi\cdot24.17=151.8": ["DEFINITION", UNJUDGED],
    r"\omega=2\pi\cdot24=151.8": ["DEFINITION", "REFUTED"],
}


@pytest.mark.slow
@pytest.mark.parametrize("latex", ROUNDED)
def test_decimals_that_are_put_in_may_be_rounded(latex: str) -> None:
    assert outcomes(latex) == ROUNDED[latex]


PUT_IN = {
    r"i=\frac{84}{24}": ["PROVED"],
    r"i=\frac{84}{23}": [UNJUDGED],
    r"i=\frac{z_2}{z_1}=\frac{84}{24}=3.5": ["DEFINITION", "PROVED", "PROVED"],
    r"i=\frac{84}{24}=3.6": ["PROVED", "REFUTED"],
    r"F=\frac{2\cdot150\cdot10^3}{60}=5000\,\mathrm{N}": ["PROVED", "PROVED"],
    r"F=\frac{2\cdot150}{0.06}=\SI{5}{kN}": ["PROVED", "PROVED"],
    r"F=\frac{2\cdot150}{0.06}=\SI{5.5}{kN}": ["PROVED", "REFUTED"],
    r"F=\frac{2\cdot150\,\mathrm{N\,m}}{60\,\mathrm{mm}}=5\,\mathrm{kN}": ["PROVED", "PROVED"],
    r"F=\frac{2\cdot150\,\mathrm{N\,m}}{50\,\mathrm{mm}}=6\,\mathrm{kN}": [UNJUDGED, "PROVED"],
    r"p=\frac{5000\,\mathrm{N}}{200\,\mathrm{mm^2}}=25\,\mathrm{MPa}": ["PROVED", "PROVED"],
    r"p=\frac{\SI{5}{kN}}{\SI{2}{cm^2}}=\SI{25}{MPa}": ["PROVED", "PROVED"],
    r"p=\frac{\SI{5}{kN}}{\SI{2}{cm^2}}=\SI{2.5}{MPa}": ["PROVED", "REFUTED"],
    r"p=5\,\mathrm{kN}\cdot 2\,\mathrm{cm^2}": [UNJUDGED],
}


@pytest.mark.slow
@pytest.mark.parametrize("latex", PUT_IN)
def test_numbers_that_are_put_in_are_those_of_the_sentence_before(latex: str) -> None:
    assert outcomes(latex, said=SAID) == PUT_IN[latex]


def test_a_proof_says_which_sizes_are_put_in() -> None:
    row = judge(r"i=\frac{84}{24}", said=SAID).rows[-1]
    assert "z_1 = 24 in line 20, z_2 = 84 in line 20" in row.reason
    row = judge(r"i=\frac{84}{23}", said=SAID).rows[-1]
    assert "the numbers put in give 3.65217, the sizes 3.5" in row.reason


STEP_BY_STEP = r"""%% mechproof
%% P : power [kW]
%% n : speed [1/min]
%% T : torque [N m]
%% d : diameter [mm]
%% F ; F_r : forces [N]
%% \alpha : angle [deg]
%% end
For $P=5.5\,\mathrm{kW}$, $n=1450\,\mathrm{min}^{-1}$, $d=50\,\mathrm{mm}$ and $\alpha=20^\circ$
\begin{align}
T&=9550\,\frac Pn=9550\cdot\frac{5.5}{1450}=36.2\,\mathrm{N\,m}\\
F&=\frac{2T}d=\frac{2\cdot36.2\cdot10^3\,\mathrm{N\,mm}}{50\,\mathrm{mm}}=1448\,\mathrm{N}\\
F_r&=F\tan\alpha=1448\,\mathrm{N}\cdot\tan20^\circ=527\,\mathrm{N}\\
F_r&=F\tan\alpha=1450\,\mathrm{N}\cdot\tan20^\circ=528\,\mathrm{N}\\
F_r&=F\tan\alpha=1484\,\mathrm{N}\cdot\tan20^\circ=540\,\mathrm{N}
\end{align}
"""


def test_numbers_that_are_put_in_may_be_those_of_equations_before() -> None:
    rows = check("paper.tex", STEP_BY_STEP).rows
    found = [row for row in rows if "second" in row.name]
    assert [row.outcome for row in found] == ["PROVED"] * 3 + [UNJUDGED] * 2
    assert "The text says P = 5.5 in line 9, n = 1450 in line 9." in found[0].reason
    assert "At T = 36.2 of (1). The text says d = 50 in line 9." in found[1].reason
    assert "At F = 1448 of (2). The text says \\alpha = 20 in line 9." in found[2].reason
    assert "which rounding may explain" in found[3].reason
    assert "are other sizes meant?" in found[4].reason
    assert all(row.outcome == "PROVED" for row in rows if "third" in row.name)


def test_numbers_may_be_those_at_the_sizes_of_a_sentence() -> None:
    numbers = (r"F=\frac{2T}d=5.00\,\mathrm{kN}", r"F=5.01\,\mathrm{kN}", r"p=25.0\,\mathrm{MPa}")
    rows = judge(*numbers, said=SAID).rows[4:]
    assert [row.outcome for row in rows] == ["DEFINITION", "PROVED", UNJUDGED, "PROVED"]
    assert "The text says T = 150000 in line 20, d = 60 in line 20." in rows[1].reason
    assert "sizes that are not declared: T, d" in rows[2].reason
    assert outcomes(*numbers)[1:] == [UNJUDGED] * 3


def test_without_sizes_nothing_is_said_of_what_is_put_in() -> None:
    found = outcomes(r"i=\frac{84}{24}=3.5", r"p=\frac{5\,\mathrm{kN}}{2\,\mathrm{cm}^2}")
    assert found == [UNJUDGED, "PROVED", UNJUDGED]


CALCULATED = {
    # The earth's motion around the sun per day: as it is, and with two digits exchanged.
    r"\frac{360^\circ}{365.26\text{ days}}\cdot1\text{ day}=0.9856^\circ": ["PROVED"],
    r"\frac{360^\circ}{356.26\text{ days}}\cdot1\text{ day}=0.9856^\circ": ["REFUTED"],
    r"\frac{5\,\mathrm{kN}}{20\,\mathrm{mm^2}}=250\,\mathrm{MPa}": ["PROVED"],
    r"\frac{5\,\mathrm{kN}}{20\,\mathrm{mm^2}}=25\,\mathrm{MPa}": ["REFUTED"],
    r"l=2\,\mathrm{m}-30\,\mathrm{cm}=1.7\,\mathrm{m}": ["DEFINITION", "PROVED"],
    r"l=2(3+4)\,\mathrm{mm}=14\,\mathrm{mm}": ["DEFINITION", "PROVED"],
    r"l=\sqrt{(3\,\mathrm{m})^2+(4\,\mathrm{m})^2}=5\,\mathrm{m}": ["DEFINITION", "PROVED"],
    r"T=100\,\mathrm N\cdot\cos 60^\circ\cdot 0.5\,\mathrm m=25\,\mathrm{Nm}": [
        "DEFINITION",
        "PROVED",
    ],
    r"\varphi=\arctan\frac{3\,\mathrm{mm}}{4\,\mathrm{mm}}=36.9^\circ": ["DEFINITION", "PROVED"],
    r"\eta=\frac{8\,\mathrm{kW}}{10\,\mathrm{kW}}=80\,\%": ["DEFINITION", "PROVED"],
    r"\pi\cdot0.1\,\mathrm m\cdot3000\,\mathrm{min^{-1}}=15.7\,\mathrm{m/s}": ["PROVED"],
    r"\pi\cdot0.1\,\mathrm m\cdot3000\,\mathrm{min^{-1}}=98.7\,\mathrm{m/s}": ["REFUTED"],
    r"n_2=\frac{1500\,\mathrm{min^{-1}}}{3}=500\,\mathrm{min^{-1}}": ["DEFINITION", "PROVED"],
    r"n_2=1500\,\mathrm{min^{-1}}-300\,\mathrm{rpm}=1200\,\mathrm{rpm}": ["DEFINITION", "PROVED"],
    r"0.2\,\mathrm{mm}\cdot1450\,\mathrm{min^{-1}}=290\,\mathrm{mm/min}": ["PROVED"],
    r"\frac{\pi\cdot1450\,\mathrm{min}^{-1}}{30}=151.8\,\mathrm{s^{-1}}": ["not read"],
    r"\frac{1500\,\mathrm{min}^{-1}-1450\,\mathrm{rpm}}{1500\,\mathrm{rpm}}=0.0333": ["PROVED"],
    r"\omega=2\pi\cdot\frac{1500}{60}\,\mathrm{s^{-1}}=157\,\mathrm{rad/s}": [
        "DEFINITION",
        "PROVED",
    ],
    r"7850\,\frac{\mathrm{kg}}{\mathrm{m}^3}\cdot 1\,\text{dm}^3=7.85\,\text{kg}": ["PROVED"],
    r"9.81\,\mathrm{\frac{m}{s^2}}\cdot 10\,\mathrm{kg}=98.1\,\mathrm{N}": ["PROVED"],
    r"\frac{10}2\,\text{kN}=5\,\text{kN}": ["PROVED"],
    r"\sqrt{3^2+4^2}\,\frac{\mathrm m}{\mathrm s}=5\,\mathrm{m/s}": ["PROVED"],
    r"160\cdot10^5\,\frac{\mathrm{N}}{\mathrm{m}^2}=16\,\mathrm{MPa}": ["PROVED"],
    r"25\,\mathrm{cm^3}\cdot1000\,\frac{1}{\mathrm{min}}=25\,\mathrm{l/min}": ["PROVED"],
    r"4.19\,\mathrm{kJ/(kg\,K)}\cdot2\,\mathrm{kg}=8.38\,\mathrm{kJ/K}": ["PROVED"],
    r"v=\sqrt{2\,\mathrm{m/s}\cdot2\,\mathrm m}": ["not read"],
    r"F=2\min(T,d)": ["ILL_FORMED"],
    r"1.2\cdot10^3\,\mathrm N\cdot2=2.4\,\mathrm{kN}": ["PROVED"],
    r"l=2\,\mathrm{m}+30\,\mathrm{s}": ["not read"],
    r"F=d\cdot3\,\mathrm{N/mm}": ["not judged"],
    r"F=\sqrt{-4\,\mathrm{N^2}}": ["not read"],
}


@pytest.mark.slow
@pytest.mark.parametrize("latex", CALCULATED)
def test_calculations_with_units_give_sizes(latex: str) -> None:
    assert outcomes(latex) == CALCULATED[latex]


@pytest.mark.parametrize("latex", [r"l=3\,\mathrm{s}", r"l=\frac12\,\mathrm{s}"])
def test_a_size_has_the_dimension_of_its_letter(latex: str) -> None:
    (row,) = judge(latex).rows[4:]
    assert row.outcome == UNJUDGED
    assert "l has dimension L but the unit s has T" in row.reason


def test_units_that_do_not_fit_are_told() -> None:
    (row,) = judge(r"l=2\,\mathrm{m}+30\,\mathrm{s}").rows[4:]
    assert "2 m has dimension L but 30 s has T" in row.reason


@pytest.mark.parametrize(
    ("unit", "name"),
    [("N/mm^2", "Pa"), ("kN m", "Nm"), ("km/h", "m s^-1"), ("1", "1"), ("l", "m^3"), ("V/A", "Ω")],
)
def test_dimensions_have_units_of_si(unit: str, name: str) -> None:
    dimension = read_unit(unit).dimension
    assert name_in_si(dimension) == name
    assert read_unit(name).dimension == dimension
    assert read_unit(name).scale == 1


# Calculations in chains, and how far rounding explains their results.
WORKED_OUT = r"""%% mechproof
%% h ; a ; b ; r : lengths [mm]
%% l : length [cm]
%% \omega : angular speed [rad/s]
%% A : acceleration [m/s^2]
%% v : speed [m/s]
%% n : speed of rotation [rpm]
%% q ; u : numbers [1]
%% \psi : angle [rad]
%% sizes h=20 mm, a=20 mm, b=30 mm, r=40 mm, \omega=30 rad/s, n=3000 rpm, u=0.5
%% end
"""
RESULTS = {
    r"A=h\omega^2=0.020\cdot30^2=18.0\,\mathrm{m/s^2}": ["PROVED", "PROVED"],
    r"A=h\omega^2=0.200\cdot30^2=18.0\,\mathrm{m/s^2}": [UNJUDGED, "REFUTED"],
    # Numbers that may be rounded, or in other units.
    r"A=h\omega^2=0.021\cdot30^2=18.0\,\mathrm{m/s^2}": [UNJUDGED, UNJUDGED],
    r"A=h\omega^2=20\cdot30^2=18.0\,\mathrm{m/s^2}": [UNJUDGED, UNJUDGED],
    r"l=a+b=20+30=5\,\mathrm{cm}": [UNJUDGED, UNJUDGED],
    # Revolutions per minute, put in without conversion.
    r"v=\frac{4rn}{60}=\frac{4\cdot0.04\cdot3000}{60}=8\,\mathrm{m/s}": ["PROVED", "PROVED"],
    r"v=\frac{4rn}{60}=\frac{4\cdot0.04\cdot3000}{60}=9\,\mathrm{m/s}": ["PROVED", "REFUTED"],
    r"v=\frac{4rn}{60}=\frac{2\cdot0.04\cdot3000}{60}=4\,\mathrm{m/s}": [UNJUDGED, UNJUDGED],
    # Exact numbers: declared ones, and members that repeat the one before.
    r"q=\frac{u^2}{1.5}=\frac{0.5^2}{3\cdot0.5}=\frac{0.25}{1.5}=0.1667": ["PROVED"] * 3,
    r"q=\frac{u^2}{1.5}=\frac{0.5^2}{3\cdot0.5}=\frac{0.25}{1.5}=0.1767": [
        "PROVED",
        "PROVED",
        "REFUTED",
    ],
    r"q=\frac{u^2}{1.5}=\frac{0.5^2}{3\cdot0.5}=\frac{0.52}{1.5}=0.347": [
        "PROVED",
        "REFUTED",
        "PROVED",
    ],
    r"q=\frac{0.4^2}{1.4}=\frac{0.16}{1.4}=0.12": ["PROVED", UNJUDGED],
    r"q=\frac{1.4^2}{1.5}=\frac{1.97}{1.5}=1.3": [UNJUDGED, "PROVED"],
    r"q=\frac{0.04}{0.24}=0.1767": [UNJUDGED],
    r"q=\frac{84}{24}=\frac{84}{2.4}=35": ["REFUTED", "PROVED"],
    r"q=\frac{84}{24}=\frac{84}{0.024}=3500": [UNJUDGED, "PROVED"],
}


@pytest.mark.parametrize("printed", RESULTS)
def test_calculations_give_what_stands_behind_them(printed: str) -> None:
    rows = check("p.tex", f"{WORKED_OUT}\\begin{{equation}}{printed}\\end{{equation}}").rows
    assert [row.outcome for row in rows][1:] == RESULTS[printed]


# Angles from numbers alone: in degrees, and where nothing says so.
DEGREES = {
    r"\psi=\arctan\frac{6}{\pi\cdot36}=3.04^\circ": "PROVED",
    r"\psi=\arctan\frac{6}{\pi\cdot36}=3.40^\circ": "REFUTED",
    r"\psi=90^\circ-\arctan0.5=63.4^\circ": "PROVED",
    r"\psi=90-\arctan0.5=63.4^\circ": UNJUDGED,
    r"\psi=90-\arctan0.5=64.3^\circ": "REFUTED",
    r"q=10\sin30=5": UNJUDGED,
    r"q=10\sin30=-9.88": "PROVED",
    r"q=10\sin30=6": "REFUTED",
}


@pytest.mark.parametrize("printed", DEGREES)
def test_angles_without_a_sign_of_degrees_accuse_nobody(printed: str) -> None:
    rows = check("p.tex", f"{WORKED_OUT}\\begin{{equation}}{printed}\\end{{equation}}").rows
    assert rows[-1].outcome == DEGREES[printed]


# The first member of the chain needs letters without sizes, or has no value as one of them is zero.
MEMBERS = {
    r"q=\frac{6-2}{2\cdot6}": "PROVED",
    r"q=\frac{6+2}{2\cdot6}": UNJUDGED,
}


@pytest.mark.parametrize("printed", MEMBERS)
@pytest.mark.parametrize("said", ["", "If it is at rest, $u=0$ and $v=0$. In general $n=6$ and"])
def test_numbers_may_be_put_into_a_further_member(printed: str, said: str) -> None:
    block = "%% mechproof\n%% q ; n ; u ; v : numbers\n%% sizes n=6\n%% end\n"
    chain = r"\begin{equation}q=\frac uv=\frac12-\frac1n\end{equation}"
    rows = check("p.tex", f"{block}{chain}{said}\\begin{{equation}}{printed}\\end{{equation}}").rows
    assert rows[-1].outcome == MEMBERS[printed]


# An angle printed after its cosine or sine.
ANGLES = {
    r"\cos\psi=\frac{0.5^2}{3\cdot0.5},\quad\psi=80.4^\circ": "PROVED",
    r"\cos\psi=\frac{0.5^2}{3\cdot0.5}=0.1667,\quad\psi=84.0^\circ": "REFUTED",
    r"\cos\psi=\frac{0.5^2}{3\cdot0.5},\quad\psi=-80.4^\circ": UNJUDGED,
    r"\cos\psi=\frac{0.5^2}{3\cdot0.5},\quad\psi=\pm80.4^\circ": "PROVED",
    r"\cos\psi=\frac{0.5^2}{3\cdot0.5},\quad\psi=\pm84.0^\circ": "REFUTED",
    r"\cos\psi=\frac{0.5^2}{3\cdot0.5},\quad\psi=81.0^\circ": UNJUDGED,
    r"\sin\psi=\frac{0.5^2}{3\cdot0.5},\quad\psi=170.4^\circ": UNJUDGED,
    r"\sin\psi=\frac{0.5^2}{3\cdot0.5},\quad\psi=\pm9.59^\circ": "DEFINITION",
    # Rounded.
    r"\cos\psi=0.17,\quad\psi=80.4^\circ": "DEFINITION",
    r"\cos\psi=\frac{0.26}{1.5},\quad\psi=80.4^\circ": "DEFINITION",
}


@pytest.mark.parametrize("printed", ANGLES)
def test_angles_are_those_of_their_cosines(printed: str) -> None:
    rows = check("p.tex", f"{WORKED_OUT}\\begin{{equation}}{printed}\\end{{equation}}").rows
    assert rows[-1].outcome == ANGLES[printed]


@pytest.mark.parametrize(("number", "outcome"), [("2467", "PROVED"), ("2764", "REFUTED")])
def test_a_unit_behind_a_number_is_that_of_a_letter_without(number: str, outcome: str) -> None:
    block = (
        "%% mechproof\n%% F :\n%% r : [mm]\n%% w : [1/s]\n%% m : [kg]\n%% a : [m/s^2]\n"
        "%% sizes r=40 mm, w=351.2 1/s, m=0.5 kg\n%% end\n"
    )
    chain = rf"$$a=rw^2=4934\,\mathrm{{m/s^2}}$$ $$F=ma=0.5\cdot4934={number}\,\mathrm{{N}}$$"
    row = check("paper.tex", block + chain).rows[-1]
    assert row.outcome == outcome, row.reason
