"""Equations between numerical values: they hold for numbers in the units of their letters."""

from __future__ import annotations

import pytest
from small_papers import judge_parts

pytestmark = pytest.mark.usefixtures("judged_here")

LETTERS = r"""%% P : power [kW]
%% n : speed [1/min]
%% \omega : angular velocity [rad/s]
%% \Omega : angular velocity [rpm]
%% v : speed [m/s]
%% d : diameter [mm]
%% Q : flow [l/min]
%% p : pressure [bar]
%% V : displacement [cm^3]
%% F : force [N]
%% A : area [cm^2]
%% M : torque [N m]
%% \tau : stress [N/mm^2]
"""
WITHOUT = "%% P ; M ; n ; \\omega ; \\Omega ; v ; d ; Q ; p ; V ; A : letters\n"
CASES = {
    r"v=\pi dn=\frac{\pi dn}{60\,000}": ("PROVED", "not judged"),
    r"v=\frac{\pi dn}{60\,000}=\pi dn": ("PROVED", "not judged"),
    r"v=\pi dn=\frac{\pi dn}{60\cdot1000}": ("PROVED", "not judged"),
    r"v=\pi dn=\frac{\pi dn}{6000}": ("not judged", "not judged"),
    r"v=\pi dn=\frac{\pi dn}{70\,000}": ("REFUTED", "REFUTED"),
    r"v=\pi dn=\frac{dn}{19\,100}": ("not judged", "REFUTED"),
    r"v=\pi dn=\frac{dn}{18\,100}": ("REFUTED", "REFUTED"),
    r"Q=Vn=\frac{Vn}{1000}": ("PROVED", "not judged"),
    r"P=pQ=\frac{pQ}{600}": ("PROVED", "not judged"),
    r"v=\frac QA=\frac Q{6A}": ("PROVED", "REFUTED"),
    r"v=\frac QA=\frac{6Q}A": ("REFUTED", "REFUTED"),
    r"v=\frac QA=\frac Q{7A}": ("REFUTED", "REFUTED"),
    # Turns are either counted or in radians, and alike on both sides.
    r"P=M\Omega=2\pi M\Omega": ("REFUTED", "REFUTED"),
    r"P=2\pi Mn=Mn": ("REFUTED", "REFUTED"),
    r"v=\pi dn=2\pi^2dn": ("REFUTED", "REFUTED"),
    r"v=\pi d\Omega=\frac{d\Omega}2": ("REFUTED", "REFUTED"),
    r"P=M\Omega=\frac{\pi M\Omega}{30\,000}": ("PROVED", "not judged"),
    r"P=M\Omega=\frac{M\Omega}{60\,000}": ("not judged", "not judged"),
    r"P=pQ=600pQ": ("not judged", "not judged"),
    r"P=pQ=\frac{pQ}{12}": ("REFUTED", "REFUTED"),
    r"\omega=2\pi n+\frac vd=\frac{\pi n}{30}+\frac vd": ("REFUTED", "REFUTED"),
    r"P=pQ=2pQ": ("REFUTED", "REFUTED"),
    r"\omega=2\pi n=\frac{\pi n}{30}": ("PROVED", "not judged"),
    r"\omega=2\pi n=\frac{\pi n}{15}": ("not judged", "not judged"),
}


@pytest.mark.parametrize("latex", CASES)
def test_a_factor_may_turn_units(latex: str) -> None:
    for letters, outcome in zip((LETTERS, WITHOUT), CASES[latex], strict=True):
        assert judge_parts(f"%% mechproof\n{letters}%% end\n", latex)[-1] == outcome


# Definitions, and consequences for numbers in the letters' units, right and wrong.
FLOW = (r"P=pQ=\frac{pQ}{600}", r"Q=Vn=\frac{Vn}{1000}")
POWER = (r"v=\omega\frac d2", r"M=\frac{Fd}2", r"P=M\omega")
RIM = (r"v=\frac{\pi dn}{60\,000}", r"\omega=\frac{2\pi n}{60}")
HANDBOOK = (r"P=M\omega", r"\omega=2\pi n")
SHAFT = (r"\tau=\frac{16M}{\pi d^3}",)
CHAINS = [
    (FLOW, r"P=\frac{pVn}{600\,000}", r"P=\frac{pVn}{610\,000}"),
    (POWER, r"P=\frac{Fv}{1000}", r"P=\frac{Fv}{1100}"),
    (RIM, r"v=\frac{\omega d}2", r"v=\frac{\omega d}{14}"),
    (
        SHAFT,
        r"d=\sqrt[3]{\frac{16\cdot10^3M}{\pi\tau}}",
        r"d=\sqrt[3]{\frac{16\cdot20^3M}{\pi\tau}}",
    ),
]


# A rounded factor is left open, and proves no other factor.
@pytest.mark.parametrize("factors", [("9549", "9594"), ("9550", "9950")])
def test_a_rounded_factor_proves_no_other(factors: tuple[str, str]) -> None:
    block = f"%% mechproof\n{LETTERS}%% end\n"
    prints = [rf"M={factor}\frac Pn" for factor in factors]
    found = judge_parts(block, *HANDBOOK, *prints)
    assert found[2] == "not judged"
    assert found[3] != "PROVED"


def test_a_derivative_may_have_a_unit_of_its_own() -> None:
    block = "%% mechproof\n%% x(t) : position [mm]\n%% A : amplitude [mm]\n"
    block += "%% \\dot x : speed [m/s]\n%% \\omega : frequency [rad/s]\n%% end\n"
    motion = r"x=A\sin\omega t"
    for factor, outcome in ((r"\frac{A\omega}{1000}", "PROVED"), (r"\frac{A\omega}{7}", "REFUTED")):
        speed = rf"\dot x={factor}\cos\omega t"
        assert judge_parts(block, motion, "#Hence", speed)[-1] == outcome


@pytest.mark.parametrize(("given", "right", "wrong"), CHAINS)
def test_numbers_follow_from_definitions(given: tuple[str, ...], right: str, wrong: str) -> None:
    block = f"%% mechproof\n{LETTERS}%% end\n"
    assert judge_parts(block, *given, "#Hence", right)[-1] == "PROVED"
    assert judge_parts(block, *given, "#Hence", wrong)[-1] == "REFUTED"


def test_a_letter_printed_again_may_be_a_number() -> None:
    block = f"%% mechproof\n{LETTERS}%% end\n"
    for factor, outcome in ((r"60\,000", "PROVED"), (r"70\,000", "REFUTED")):
        again = rf"v=\frac{{\pi dn}}{{{factor}}}"
        assert judge_parts(block, r"v=\pi dn", "#and hence", again)[-1] == outcome
