"""The package's certificates, and the computed stages whose errors they bound."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path

from derived import paper_of

import mechproof.kernels
from mechproof.programs.kernel import list_functions
from mechproof.roundoff.certificate import Certificate, RoundingClaim
from mechproof.roundoff.certificate_files import FOLDER, find_certificate
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.kernel_stages import list_computed_stages

GENERATED = Path(next(iter(mechproof.kernels.__path__)))
# For tests that need all subjects: one worker lowers them once.
GROUP = "certificates"
SYSTEMS = sorted(path.stem for path in (GENERATED / FOLDER).glob("*.json"))


@cache
def certificate(system: str) -> Certificate:
    found = find_certificate(GENERATED, system)
    assert found is not None
    return found


@cache
def subjects() -> Mapping[tuple[str, str, str], ComputedStage]:
    papers = (paper_of(system) for system in SYSTEMS)
    kernels = ((kernel, paper) for paper in papers for kernel in list_functions(paper))
    found = (s for kernel, paper in kernels for s in list_computed_stages(kernel, paper))
    return {(s.kernel.name, s.form.name, s.way): s for s in found}


def claims() -> list[RoundingClaim]:
    return [claim for system in sorted(SYSTEMS) for claim in certificate(system).claims]


def subject_of(claim: RoundingClaim) -> ComputedStage:
    return subjects()[claim.quantity, claim.form, claim.way]


def name_claim(claim: RoundingClaim) -> str:
    return f"{claim.quantity}: {claim.form}, {claim.way}"
