"""Judging as the first stage of work on papers: their ledgers, or a `PipelineError`."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path

from mechproof.derivation import DerivationError
from mechproof.ledger.judged import JudgedPaper, Ledger
from mechproof.pipeline import verification

# Called with the title of a stage; returns the stage's context manager, which yields a function
# that reports progress.
Progress = Callable[[str], AbstractContextManager[Callable[[str], None]]]


class PipelineError(RuntimeError):
    """A stage found a fault; the message says what and where."""


@contextmanager
def report_nothing(title: str) -> Iterator[Callable[[str], None]]:
    """Run a stage without reporting."""
    yield lambda text: None


@contextmanager
def name_faults(*errors: type[Exception], where: str = "") -> Iterator[None]:
    """Turn these errors into a `PipelineError`."""
    try:
        yield
    except errors as error:
        raise PipelineError(f"{where}{error}") from error


def judge_papers(
    locations: Sequence[Path],
    *,
    use_cache: bool = True,
    limit: float = verification.LIMIT,
    only_kernels: bool = False,
    progress: Progress = report_nothing,
) -> list[JudgedPaper]:
    """Judge the papers, or with `only_kernels` just the rows on which shipped code rests."""
    title = name_judging(locations, "the kernels of " if only_kernels else "")
    with name_faults(DerivationError, verification.VerificationError), progress(title) as report:
        return verification.judge_derivations(
            locations, use_cache=use_cache, only_kernels=only_kernels, limit=limit, report=report
        )


def read_ledgers(
    locations: Sequence[Path],
    *,
    use_cache: bool = True,
    limit: float = verification.LIMIT,
    progress: Progress = report_nothing,
) -> list[Ledger]:
    """Judge the papers that have changed, and read the cached ledgers of the others."""
    title = name_judging(locations)
    with name_faults(DerivationError, verification.VerificationError), progress(title) as report:
        return verification.find_ledgers(locations, use_cache=use_cache, limit=limit, report=report)


def name_judging(locations: Sequence[Path], what: str = "") -> str:
    """Return the title of the stage that judges these derivations."""
    return f"judging {what}{', '.join(location.stem for location in locations)}"


def refuse_failures(ledgers: Sequence[Ledger], others: Sequence[str] = ()) -> None:
    """Raise `PipelineError` for rows not judged, kernels not proved, and other failures."""
    if failures := [*verification.list_failures(ledgers), *others]:
        raise PipelineError("\n".join(failures))
