"""Naive formulas get their digits back by forms that are offered, stored, emitted and proved."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from contextlib import chdir
from dataclasses import replace
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from command import run

from mechproof import improvement as searching
from mechproof.derivation import DerivationError, find_file, load_paper, rewrite_definition
from mechproof.improvement import Candidate, draw, find_offer, measure_loss, prove, search
from mechproof.lab.sampling.named_sets import TUNE
from mechproof.lab.subject import Subject, find_subjects
from mechproof.programs import rewrites
from mechproof.programs.evaluation import Evaluation

GEAR = Path(__file__).parent / "gear.py"
# The whole digits that the typed form loses, and the rewrite with which it loses none.
FIRST_TRIES = {
    "involute": (16, "taylor"),
    "segment": (16, "taylor"),
    "versine": (16, "cosine_minus_one"),
    "curvature": (16, "cosine_minus_one"),
    "step": (3, "difference_of_roots"),
    "turn": (6, "difference_of_functions"),
    "growth": (2, "expm1_log1p"),
    "doubling": (2, "expm1_log1p"),
    "root": (8, "difference_of_roots"),
    "tangent": (0, ""),
}


# The quantities that the commands search; offers for all are found without commands.
WRITTEN = ("involute", "step", "tangent")


@pytest.fixture(scope="module")
def workshop(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with a derivation of only the quantities in `WRITTEN`."""
    folder = tmp_path_factory.mktemp("gears")
    (folder / "derivations").mkdir()
    lines = GEAR.read_text(encoding="utf-8").splitlines(keepends=True)
    others = [f'        ship("{name}",' for name in FIRST_TRIES if name not in WRITTEN]
    kept = [line for line in lines if not line.startswith(tuple(others))]
    assert len(lines) - len(kept) == len(others)
    (folder / "derivations" / GEAR.name).write_text("".join(kept), encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def subjects(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Subject]:
    folder = tmp_path_factory.mktemp("offers")
    shutil.copy(GEAR, folder)
    return {subject.quantity.name: subject for subject in find_subjects((), folder)}


def run_in(folder: Path, *arguments: str) -> str:
    with chdir(folder):
        done = run(*arguments)
    assert done.exit_code == 0, done.output
    return done.output


@pytest.mark.slow
@pytest.mark.parametrize("name", FIRST_TRIES)
def test_what_is_typed_first_gets_its_digits_back(name: str, subjects: dict[str, Subject]) -> None:
    lost, rewrite = FIRST_TRIES[name]
    offer = find_offer(subjects[name])
    assert round(offer.shipped.digits) >= lost - 1
    if not rewrite:
        assert offer.found is None
        assert "nothing to gain" in offer.describe()
        return
    assert rewrite in offer.rewrites
    assert offer.found is not None
    assert offer.found.digits < 1
    assert offer.rungs


def wrong_cosine(evaluation: Evaluation) -> Evaluation:
    """Replace cosines by a Taylor polynomial, which near 0 does not show to be wrong."""
    return evaluation.transform(
        lambda e: e.replace(sp.cos, lambda x: 1 - x**2 / 2 + x**4 / 24 - x**6 / 720)
    )


def test_a_wrong_rewrite_is_not_offered(
    subjects: dict[str, Subject], monkeypatch: pytest.MonkeyPatch
) -> None:
    wrong = {"wrong_cosine": wrong_cosine}
    monkeypatch.setattr(rewrites, "REWRITES", wrong)
    monkeypatch.setattr(searching, "REWRITES", wrong)
    subject = subjects["versine"]
    points = draw(subject, TUNE)
    near = np.abs(points.arguments[0]) < 1e-2
    counts = points.counts & near
    ((loss, best), *_) = search(subject, replace(points, counts=counts))
    assert best.form.rewrites == ("wrong_cosine",)
    assert loss.digits < 1
    assert prove(best) == ()
    assert find_offer(subject).found is None


def test_a_form_that_is_not_legal_everywhere_is_not_proved(subjects: dict[str, Subject]) -> None:
    subject = subjects["turn"]
    quantity, (p,) = subject.quantity, subject.quantity.arguments[0].symbols
    for value, legal in ((sp.atan(p + 1) - sp.atan(p), True), (sp.atan(p) - sp.atan(p - 5), False)):
        stated = replace(subject, quantity=replace(quantity, definition=value))
        form = rewrite_definition(stated.quantity, ("difference_of_functions",))
        assert bool(prove(Candidate(stated, form))) is legal


def test_a_candidate_computes_what_its_kernel_computes(subjects: dict[str, Subject]) -> None:
    subject = subjects["involute"]
    points = draw(subject, TUNE)
    candidate = Candidate(subject, rewrite_definition(subject.quantity, ("taylor",)))
    found, truth = candidate.compute(*points.arguments), points.truth.high
    assert np.allclose(found[points.counts], truth[points.counts], rtol=1e-14, atol=0)
    assert measure_loss(candidate.compute, points).digits < 1


@pytest.mark.thorough
def test_what_is_found_is_kept_and_shipped(workshop: Path) -> None:
    derivation = workshop / "derivations" / "gear.py"
    run_in(workshop, "verify")
    told = run_in(workshop, "improve", "gear.involute", "gear.tangent", "--write")
    assert "gear.involute: the shipped form loses" in told
    assert "with taylor, proved equal" in told
    kept = json.loads(find_file(derivation).read_text())
    assert kept == {"involute": ["taylor"]}
    # The cached ledger does not contain the new form yet.
    run_in(workshop, "verify", "--json", "rows.json")
    rows = {r["number"]: r for r in json.loads((workshop / "rows.json").read_text())["rows"]}
    assert rows["kernel involute, near 0"]["verdict"] == "PROVED"
    assert rows["kernel involute_as_stated"]["verdict"] == "PROVED"
    # In a new process, since one that has loaded the derivation keeps using it.
    command = [sys.executable, "-m", "mechproof", "regenerate", "--improve"]
    done = subprocess.run(command, cwd=workshop, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "gear.involute: the shipped form loses 0.6 digits; no rewrite is better" in done.stdout
    assert json.loads(find_file(derivation).read_text()).keys() == {"involute", "step"}
    run_in(workshop, "regenerate", "--check")
    file = workshop / "generated" / "gear.py"
    spec = spec_from_file_location("gear_of_workshop", file)
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    with mp.workdps(60):
        for x in (1e-6, -1e-9, 0.3, 0.5, 0.50001, 1.5, 0.0):
            right = mp.tan(mp.mpf(x)) - mp.mpf(x)
            assert abs(mp.mpf(float(module.involute(x))) - right) <= 16 * 2.0**-52 * abs(right)


@pytest.mark.parametrize(
    "text", ["[1]", "{", '{"involute": ["magic"]}', '{"nothing": ["taylor"]}', '{"involute": 1}']
)
def test_a_choice_that_is_none_is_refused_with_its_file(text: str, tmp_path: Path) -> None:
    derivation = Path(shutil.copy(GEAR, tmp_path))
    find_file(derivation).write_text(text)
    with pytest.raises(DerivationError, match=r"gear\.forms\.json"):
        load_paper(derivation)


def test_regenerate_does_not_search_and_check_at_once(workshop: Path) -> None:
    with chdir(workshop):
        done = run("regenerate", "--improve", "--check")
    assert done.exit_code == 2
    assert "--improve" in done.output
