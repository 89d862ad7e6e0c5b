"""Equations between numerical values, which hold for numbers in the units of their letters."""

from __future__ import annotations

import pytest
from small_papers import judge_parts

pytestmark = pytest.mark.usefixtures("judged_here")

LETTERS = r"""%% P : power [kW]
%% n : speed [1/min]
%% \omega : angular velocity [rad/s]
%% v : speed [m/s]
%% d : diameter [mm]
%% Q : flow [l/min]
%% p : pressure [bar]
%% V : displacement [cm^3]
"""
WITHOUT = "%% P ; n ; \\omega ; v ; d ; Q ; p ; V : letters\n"
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


def test_a_letter_printed_again_may_be_a_number() -> None:
    block = f"%% mechproof\n{LETTERS}%% end\n"
    for factor, outcome in ((r"60\,000", "PROVED"), (r"70\,000", "REFUTED")):
        again = rf"v=\frac{{\pi dn}}{{{factor}}}"
        assert judge_parts(block, r"v=\pi dn", "#and hence", again)[-1] == outcome
