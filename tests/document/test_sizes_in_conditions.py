r"""Sizes with a unit in the condition of an equation: `\text{at }F=\SI{1}{kN}`."""

from __future__ import annotations

import pytest

from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

LETTERS = r"""%% mechproof
%% F : force [kN]
%% w(x) : deflection [mm]
%% x : place [cm]
%% c : stiffness [N/mm]
%% s : path [mm]
%% k : factor [1/mm]
%% y : letter
%% sizes k=0.5 1/mm, c=500 N/mm
%% end
$$s=\frac{F}{c}$$
$$w=kx^2$$
"""
AT_FORCE = r"\quad\text{for }F=1\,\mathrm{kN}"
# Equations under a condition, and their outcomes.
ROWS = [
    (rf"s=\frac{{1}}{{c}}{AT_FORCE}", "PROVED"),
    (rf"s=\frac{{2}}{{c}}{AT_FORCE}", "REFUTED"),
    (r"s=\frac{1}{c}\text{ at }F=\SI{1000}{N}", "PROVED"),
    (r"s=\frac{1}{c}\text{ at }F=\SI{1500}{N}", "REFUTED"),
    # Whether kN are meant is not said.
    (rf"s=\frac{{1000}}{{c}}{AT_FORCE}", "not judged"),
    (rf"s=\frac{{\SI{{1}}{{kN}}}}{{c}}{AT_FORCE}", "PROVED"),
    (rf"s=\frac{{\SI{{2}}{{kN}}}}{{c}}{AT_FORCE}", "REFUTED"),
    (rf"s=2.00\,\mathrm{{mm}}{AT_FORCE}", "PROVED"),
    (rf"s=20.0\,\mathrm{{mm}}{AT_FORCE}", "REFUTED"),
    (r"w=50.0\,\mathrm{mm}\text{ for }x=10\,\mathrm{mm}", "PROVED"),
    (r"w=50.0\,\mathrm{mm}\text{ for }x=1\,\mathrm{cm}", "PROVED"),
    (r"w=50.0\,\mathrm{mm}\text{ for }x=1\,\mathrm{mm}", "REFUTED"),
    (r"|x|=x\quad\text{for }0\le x\le10\,\mathrm{mm}", "PROVED"),
    (r"|x|=x\quad\text{for }-5\,\mathrm{mm}\le x\le10\,\mathrm{mm}", "not judged"),
    # A unit that is not that of the letter, is unknown for it, or stands beside a number alone.
    (r"s=\frac{1}{c}\text{ for }F=1\,\mathrm{mm}", "not read"),
    (r"s=\frac{1}{c}\text{ for }y=1\,\mathrm{mm}", "not read"),
    (r"w=k\text{ for }5<x\le30\,\mathrm{mm}", "not read"),
]


@pytest.mark.parametrize(("latex", "outcome"), ROWS)
def test_a_size_in_a_condition_has_the_unit_that_is_printed(latex: str, outcome: str) -> None:
    (*_, row) = check("paper.tex", f"{LETTERS}$${latex}$$").rows
    assert row.outcome == outcome, row.reason
