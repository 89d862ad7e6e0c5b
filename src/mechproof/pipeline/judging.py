"""Judging as the first stage of what is made of papers: their ledgers, or a `PipelineError`."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path

from mechproof.derivation import DerivationError
from mechproof.ledger.judged import JudgedPaper, Ledger
from mechproof.pipeline import verification

# Called with the title of a stage; returns the stage's context, which yields a function to tell its
# progress.
Progress = Callable[[str], AbstractContextManager[Callable[[str], None]]]


class PipelineError(RuntimeError):
    """A stage found a fault; the text names what and where."""


@contextmanager
def tell_nobody(title: str) -> Iterator[Callable[[str], None]]:
    """Run a stage without a word."""
    yield lambda text: None


@contextmanager
def name_faults(*errors: type[Exception], where: str = "") -> Iterator[None]:
    """Make these errors a `PipelineError`."""
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
    progress: Progress = tell_nobody,
) -> list[JudgedPaper]:
    """Judge the papers, or `only_kernels`, on which what is shipped rests."""
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
    progress: Progress = tell_nobody,
) -> list[Ledger]:
    """Judge the papers that have changed, and take the ledgers of the others as they are kept."""
    title = name_judging(locations)
    with name_faults(DerivationError, verification.VerificationError), progress(title) as report:
        return verification.find_ledgers(locations, use_cache=use_cache, limit=limit, report=report)


def name_judging(locations: Sequence[Path], what: str = "") -> str:
    """Say what is judged."""
    return f"judging {what}{', '.join(location.stem for location in locations)}"


def refuse_failures(ledgers: Sequence[Ledger], others: Sequence[str] = ()) -> None:
    """Name rows that could not be judged, kernels not proved, and what else failed."""
    if failures := [*verification.list_failures(ledgers), *others]:
        raise PipelineError("\n".join(failures))
