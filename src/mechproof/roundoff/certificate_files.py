"""Files of certificates: reads them, proves anew whatever has changed, and writes them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import suppress
from functools import cache
from importlib.resources.abc import Traversable
from pathlib import Path

from mechproof.programs.kernel import Kernel
from mechproof.record import Paper
from mechproof.roundoff.certificate import (
    Certificate,
    RoundingClaim,
    certify,
    list_stages,
    read_certificate,
    write_certificate,
)
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.tools.cache import Store, make_key

FOLDER = "certificates"
CERTIFIED = Store("certified.json")
# Files of the package that proofs rest on: the proofs themselves, the fits and enclosures of
# functions, the error-free transformations, and the meaning of programs, operations and balls.
SOURCES = (
    *("roundoff/*.py", "programs/elementary/*.py", "kernel_support/*.py"),
    *("programs/program.py", "programs/operations.py", "programs/trace.py", "arithmetic/*.py"),
)
PACKAGES = ("sympy", "numpy", "python-flint")


def find_certificate(generated: Traversable, system: str) -> Certificate | None:
    """Read the certificate of a system, stored next to its kernels; None if there is none.

    Raises ValueError, naming the file, for one that cannot be read.
    """
    file = generated.joinpath(_name(system))
    if not file.is_file():
        return None
    return read_certificate(file.read_text(encoding="utf-8"), str(file))


def write_certificates(certificates: Iterable[Certificate]) -> dict[str, str]:
    """Return the text of every certificate by its file name in the generated package."""
    return {_name(c.system): write_certificate(c) for c in certificates}


def _name(system: str) -> str:
    return f"{FOLDER}/{system}.json"


def read_claims(directory: Path, system: str) -> tuple[RoundingClaim, ...]:
    """Return the stored claims of a system; none if the file is missing or cannot be read.

    Such a file is written anew, and so shows up as a difference.
    """
    with suppress(ValueError):
        if known := find_certificate(directory, system):
            return known.claims
    return ()


def certify_kernel(
    kernel: Kernel, paper: Paper, known: tuple[RoundingClaim, ...], *, use_cache: bool
) -> tuple[tuple[RoundingClaim, ...], str]:
    """Prove the bounds of a kernel; return its claims and the key of all that they rest on.

    With the cache, known claims that were proved before are not proved again. Raises ValueError for
    a chart that cannot be used.
    """
    stages = list_stages(kernel, paper)
    if use_cache and (key := _key(stages, known)) in CERTIFIED.read():
        return known, key
    claims = certify(stages, known)
    return claims, _key(stages, claims)


def _key(stages: Sequence[ComputedStage], claims: tuple[RoundingClaim, ...]) -> str:
    digests = [stage.digest for stage in stages]
    return make_key((), (), _digest_proofs(), *digests, *map(str, claims))


@cache
def _digest_proofs() -> str:
    package = Path(__file__).parents[1]
    sources = [path for pattern in SOURCES for path in sorted(package.glob(pattern))]
    return make_key(sources, PACKAGES)
