"""Files of certificates: read, proved anew where something has changed, and written."""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from importlib.resources.abc import Traversable
from pathlib import Path

from mechproof.record import Paper
from mechproof.roundoff.certificate import (
    Certificate,
    certify,
    list_digests,
    read_certificate,
    write_certificate,
)
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
    """Read the certificate of a system that is beside its kernels; None where there is none.

    Raises ValueError, naming the file, for one that cannot be read.
    """
    file = generated.joinpath(_name(system))
    if not file.is_file():
        return None
    return read_certificate(file.read_text(encoding="utf-8"), str(file))


def write_certificates(certificates: Iterable[Certificate]) -> dict[str, str]:
    """Return the text of every certificate by its name relative to the generated package."""
    return {_name(c.system): write_certificate(c) for c in certificates}


def _name(system: str) -> str:
    return f"{FOLDER}/{system}.json"


def certify_paper(paper: Paper, directory: Path, *, use_cache: bool) -> Certificate | None:
    """Prove the bounds of a paper; with the cache what was proved before is not done again.

    Raises ValueError for a chart that cannot be used.
    """
    path = directory / _name(paper.system)
    text = path.read_text(encoding="utf-8") if path.is_file() else ""
    known = None
    # A file that cannot be read is written anew, and shows up as a difference.
    with suppress(ValueError):
        known = read_certificate(text, str(path))
    if known and use_cache and _key(paper, text) in CERTIFIED.read():
        return known
    certificate = certify(paper, known)
    if certificate and use_cache:
        CERTIFIED.add([_key(paper, write_certificate(certificate))])
    return certificate


def _key(paper: Paper, text: str) -> str:
    """Return a key of all that a certificate rests on."""
    package = Path(__file__).parents[1]
    sources = [path for pattern in SOURCES for path in sorted(package.glob(pattern))]
    return make_key(sources, PACKAGES, *list_digests(paper), text)
