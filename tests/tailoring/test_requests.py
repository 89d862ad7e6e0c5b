"""Requests for tailored kernels: periodicity is proved, and a domain need not be stated."""

from __future__ import annotations

from dataclasses import replace
from types import ModuleType

import pytest
import sympy as sp
from derived import paper_of

from mechproof.proof.verdict import Verdict
from mechproof.record import Periodicity, Quantity
from mechproof.tailoring import request
from mechproof.tailoring.request import prove_periodicity, read_request

NAME = "elliptic_planetary.position"
SIZES = {"R1": 66, "R2": 16, "e": 0.475}
MOTION = ("ratio", "position", "acceleration", "jerk")
# Listed by name, since every worker collects all tests but loads a paper only where needed.
PERIODIC = [
    *(("elliptic_planetary", name) for name in MOTION),
    *(("oval_planetary", f"{name}{gears}") for name in MOTION for gears in ("", "_cylindrical")),
]


def quantity_of(system: str, name: str) -> Quantity:
    return next(one for one in paper_of(system).quantities if one.name == name)


def test_what_comes_again_is_listed() -> None:
    systems = sorted({system for system, _ in PERIODIC})
    found = [(s, q.name) for s in systems for q in paper_of(s).quantities if q.periodicity]
    assert sorted(found) == sorted(PERIODIC)


@pytest.mark.slow
@pytest.mark.parametrize(("system", "name"), PERIODIC)
def test_what_comes_again_is_proved_and_nothing_else(system: str, name: str) -> None:
    paper, quantity = paper_of(system), quantity_of(system, name)
    repeats = quantity.periodicity
    assert repeats is not None
    assert prove_periodicity(paper, quantity, repeats).verdict is Verdict.PROVED
    for wrong in (
        Periodicity(repeats.period * sp.Rational(2, 3), repeats.gain),
        Periodicity(repeats.period, repeats.gain + sp.Rational(1, 10**9)),
    ):
        assert prove_periodicity(paper, quantity, wrong).verdict is Verdict.REFUTED


def test_what_does_not_come_again_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    system, _, name = NAME.partition(".")
    wrong = replace(quantity_of(system, name), periodicity=Periodicity(sp.pi))
    monkeypatch.setattr(request, "_find_quantity", lambda *_: (paper_of(system), wrong))
    with pytest.raises(ValueError, match=rf"name = '{NAME}': its period .* is REFUTED"):
        read_request(NAME, 1e-6, SIZES)


def test_kernels_may_be_defined_everywhere(monkeypatch: pytest.MonkeyPatch) -> None:
    module = ModuleType("kernels")
    monkeypatch.setattr(request, "load_kernels", lambda *_: module)
    assert read_request(NAME, 1e-6, SIZES).module is module
