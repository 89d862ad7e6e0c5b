"""The certificates of the package, and what they are about."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path

from derived import paper_of

import mechproof.kernels
from mechproof.programs.kernel import list_functions
from mechproof.roundoff.certificate import Certificate, Claim
from mechproof.roundoff.files import FOLDER, find_certificate
from mechproof.roundoff.subject import Subject, list_subjects

GENERATED = Path(next(iter(mechproof.kernels.__path__)))
# Of the tests that need all subjects: one worker lowers them once.
GROUP = "certificates"
SYSTEMS = sorted(path.stem for path in (GENERATED / FOLDER).glob("*.json"))


@cache
def certificate(system: str) -> Certificate:
    found = find_certificate(GENERATED, system)
    assert found is not None
    return found


@cache
def subjects() -> Mapping[tuple[str, str, str], Subject]:
    papers = (paper_of(system) for system in SYSTEMS)
    kernels = ((kernel, paper) for paper in papers for kernel in list_functions(paper))
    found = (s for kernel, paper in kernels for s in list_subjects(kernel, paper))
    return {(s.kernel.name, s.form.name, s.way): s for s in found}


def claims() -> list[Claim]:
    return [claim for system in sorted(SYSTEMS) for claim in certificate(system).claims]


def subject_of(claim: Claim) -> Subject:
    return subjects()[claim.quantity, claim.form, claim.way]


def name_claim(claim: Claim) -> str:
    return f"{claim.quantity}: {claim.form}, {claim.way}"
