"""Equations with an integral over a narrow peak are judged by its value; an estimate misses it."""

from __future__ import annotations

import pytest
from small_papers import judge_parts

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = "%% mechproof\n%% x : number\n%% end\n"
PEAK = r"\int_0^\infty1000\mathrm{e}^{-10^6(x-300)^2}dx"


@pytest.mark.parametrize(
    ("print_", "outcome"),
    [
        (rf"\sqrt{{({PEAK}-1)^2}}=1-{PEAK}", "REFUTED"),
        (rf"\sqrt{{({PEAK}-1)^2}}={PEAK}-1", "PROVED"),
        (f"{PEAK}<1", "REFUTED"),
        (f"{PEAK}<2", "PROVED"),
        (f"{PEAK}=0", "REFUTED"),
    ],
)
def test_a_peak_is_not_missed(print_: str, outcome: str) -> None:
    assert judge_parts(BLOCK, print_) == [outcome]
