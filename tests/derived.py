"""The papers of the package, loaded once in each test process."""

from __future__ import annotations

import sys
from functools import cache
from pathlib import Path

import pytest

from mechproof import derivation
from mechproof.derivation import find_systems, packaged_directory
from mechproof.lab.subject import find_subjects
from mechproof.pipeline import verification
from mechproof.pipeline.opening import Opened, open_paper
from mechproof.pipeline.verification import find_ledgers
from mechproof.proof.verdict import Judgement
from mechproof.record import Paper

SYSTEMS = find_systems(packaged_directory())


@cache
def paper_of(system: str) -> Paper:
    """Return the paper of a system with its prints read."""
    return find_subjects((system,))[0].paper


@cache
def declared_paper_of(system: str) -> Paper:
    """Return the paper of a system as its module binds it."""
    paper_of(system)
    paper: Paper = sys.modules[derivation._modules[SYSTEMS[system].resolve()]].PAPER
    return paper


@cache
def judge_all(system: str) -> dict[str, Judgement]:
    """Return the judgements of all rows of a paper, keyed by row number."""

    def open_known(place: Path) -> Opened:
        # Load the paper's files, so that the cache notes them.
        derivation.load_paper(place)
        return opened(system)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(verification, "open_derivation", open_known)
        (ledger,) = find_ledgers([SYSTEMS[system]])
    assert ledger.failures == ()
    return {judgement.number: judgement for judgement in ledger.judgements}


@cache
def opened(system: str) -> Opened:
    """Return the paper of a system together with the rows of its forms."""
    return open_paper(SYSTEMS[system], paper_of(system))
