"""Judging for a command: with progress, and failures as an exit status."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from mechproof.cli.console import fail, show_progress
from mechproof.derivation import DerivationError
from mechproof.ledger.judged import JudgedPaper, Ledger
from mechproof.pipeline.verification import (
    VerificationError,
    find_ledgers,
    judge_derivations,
    list_failures,
    name_judging,
    restore_papers,
)


def judge_papers(
    locations: Sequence[Path], *, use_cache: bool, limit: float, only_kernels: bool = False
) -> list[JudgedPaper]:
    """Judge the papers; a derivation that fails ends the command with status 1."""
    with _judging(name_judging(locations, only_kernels=only_kernels)) as report:
        return judge_derivations(
            locations,
            use_cache=use_cache,
            only_kernels=only_kernels,
            limit=limit,
            report=report,
        )


def load_papers(
    ledgers: Sequence[Ledger], locations: Sequence[Path], *, limit: float
) -> list[JudgedPaper]:
    """Load the papers whose ledgers were taken as they are kept."""
    with _judging("loading what was judged before") as report:
        return restore_papers(ledgers, locations, limit=limit, report=report)


def read_ledgers(locations: Sequence[Path], *, use_cache: bool, limit: float) -> list[Ledger]:
    """Judge the papers that have changed, and take the ledgers of the others as they are kept."""
    with _judging(name_judging(locations)) as report:
        return find_ledgers(locations, use_cache=use_cache, limit=limit, report=report)


@contextmanager
def _judging(title: str) -> Iterator[Callable[[str], None]]:
    try:
        with show_progress(title) as report:
            yield report
    except (DerivationError, VerificationError) as error:
        fail(str(error))


def refuse_failures(ledgers: Sequence[Ledger], others: Sequence[str] = ()) -> None:
    """Name rows that could not be judged, kernels not proved, what else failed; end with 1."""
    if failures := [*list_failures(ledgers), *others]:
        fail("\n".join(failures))
