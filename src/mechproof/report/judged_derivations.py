"""Sources: a derivation with everything that a report shows: verdicts, bounds, measurements."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from importlib.resources import files
from importlib.resources.abc import Traversable
from pathlib import Path

from mechproof.coq.folder import read_checks
from mechproof.derivation import packaged_directory
from mechproof.ledger.judged import JudgedPaper
from mechproof.measured import KERNELS, Record, find_all_files, read_record
from mechproof.record import Paper
from mechproof.roundoff.certificate import describe_proofs
from mechproof.roundoff.certificate_files import find_certificate


@dataclass(frozen=True)
class JudgedDerivation:
    """A derivation and its ledger; `home` is the package of its kernels, "" without kernels.

    `told` is the paper whose forms state the proved bounds of their rounding errors; `checks` tell
    by the ids of rows whether Coq has checked them.
    """

    location: Path
    ledger: JudgedPaper
    told: Paper
    records: tuple[Record, ...] = ()
    home: str = ""
    checks: Mapping[str, str] = field(default_factory=dict)

    @property
    def system(self) -> str:
        """Return the name of the paper."""
        return self.ledger.system


def find_source(location: Path, ledger: JudgedPaper) -> JudgedDerivation:
    """Return a derivation with the files generated from it and its measurements.

    Raises ValueError, naming the file, for a record or a certificate that cannot be read.
    """
    folder = find_generated(location)
    paper = ledger.paper
    kernels = folder.joinpath(f"{paper.system}.py")
    home = KERNELS if _is_packaged(location) else folder.name
    return JudgedDerivation(
        location,
        ledger,
        describe_proofs(paper, find_certificate(folder, paper.system)),
        tuple(read_records(folder, [f"{paper.system}.{q.name}" for q in paper.quantities])),
        home if kernels.is_file() else "",
        read_checks(folder),
    )


def _is_packaged(location: Path) -> bool:
    return location.resolve().parent == packaged_directory().resolve()


def find_generated(location: Path) -> Traversable:
    """Return the folder of the files generated from a derivation and of its measurements."""
    if _is_packaged(location):
        return files(KERNELS)
    return location.resolve().parent.parent / "generated"


def read_records(folder: Traversable, names: Iterable[str]) -> Sequence[Record]:
    """Return the records of quantities by their full names, quick ones if there are no others."""
    found = find_all_files(folder)
    return [read_record(found[name]) for name in names if name in found]
