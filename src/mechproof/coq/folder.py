"""Papers with their verdicts -> the files of a folder that `make` has Coq check, and what is left.

A row has a file, or a reason why it has none.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from hashlib import sha256
from importlib.resources import files
from pathlib import Path

from mechproof.coq.comparison import compare_script
from mechproof.coq.scripts import write_script
from mechproof.coq.terms import UnwritableError
from mechproof.coq.theorems import build_theorems
from mechproof.made import ForeignFileError, Made
from mechproof.proof.domain import Domain
from mechproof.proof.ledger import JudgedPaper, classify
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Row

PRELUDE = "Mechproof.v"
LIST = "mechproof-coq.sha256"
# What of a ledger says that something is proved, of all values or at a point.
CERTIFIABLE = (Verdict.PROVED, Verdict.REFUTED)
_MAKEFILE = """# Has Coq check every file: make -j2
SCRIPTS := $(filter-out Mechproof.v, $(wildcard *.v))

all: $(SCRIPTS:.v=.vo)

%.vo: %.v
\tcoqc -q $<

$(SCRIPTS:.v=.vo): Mechproof.vo

clean:
\trm -f *.vo *.vok *.vos *.glob .*.aux

.PHONY: all clean
"""


@dataclass(frozen=True)
class RowScript:
    """What there is of a row: its file with the text, or the reason why there is none."""

    id: str
    verdict: str
    rung: str
    counted_as: str
    file: str = ""
    text: str = ""
    reason: str = ""

    @property
    def digest(self) -> str:
        """Return the SHA-256 of the text, or nothing where there is none."""
        return sha256(self.text.encode()).hexdigest() if self.text else ""


def read_prelude() -> str:
    """Return the file that all others require."""
    return files(__package__).joinpath(PRELUDE).read_text(encoding="utf-8")


def digest_prelude() -> str:
    """Return the SHA-256 of the file that all others require."""
    return sha256(read_prelude().encode()).hexdigest()


def write_certificates(
    ledger: JudgedPaper,
    rows: Mapping[str, Row],
    tell: Callable[[str], None] = lambda text: None,
) -> Iterator[RowScript]:
    """Yield a certificate for every row of a paper that is proved or refuted, in their order."""
    for judgement in ledger.judgements:
        if judgement.verdict in CERTIFIABLE:
            tell(judgement.id)
            yield _certify(judgement, rows[judgement.number], ledger)


def _certify(judgement: Judgement, row: Row, ledger: JudgedPaper) -> RowScript:
    about = (judgement.id, judgement.verdict.value, judgement.rung, classify(judgement))
    name = f"{re.sub(r'[^a-z0-9]+', '_', judgement.id.lower())}.v"
    try:
        theorems = build_theorems(row, judgement.verdict, Domain.of(ledger.paper, row.on))
        text = write_script(judgement.id, theorems)
    except UnwritableError as error:
        return RowScript(*about, reason=str(error))
    compare_script(text, theorems)
    return RowScript(*about, file=name, text=text)


def list_files(certificates: Sequence[RowScript]) -> dict[str, str]:
    """Return the text of every file of the folder by its name."""
    found = {PRELUDE: read_prelude(), "Makefile": _MAKEFILE}
    for certificate in certificates:
        if certificate.text:
            found[certificate.file] = certificate.text
    return found


def write_folder(folder: Path, certificates: Sequence[RowScript]) -> None:
    """Write the files into a folder that is new, empty or was written so.

    Raises `ForeignFileError` for any other, and `OSError`.
    """
    if folder.is_dir() and not (folder / LIST).exists() and any(folder.iterdir()):
        raise ForeignFileError(f"{folder}: holds files that are no scripts of `mechproof certify`")
    Made(folder, LIST).update(list_files(certificates))
