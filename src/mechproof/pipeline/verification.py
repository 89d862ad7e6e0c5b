"""Verification: the places of papers -> their judgements, on all processors.

A paper is a derivation, or its own source as LaTeX or Markdown.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TypeVar

from mechproof.codegen.docstrings import capitalise
from mechproof.derivation import DerivationError, check_names, load_paper, stop_after
from mechproof.document import checking, judging_workers
from mechproof.ledger.judged import JudgedPaper, Ledger, Origin
from mechproof.ledger.ledger_findings import list_findings
from mechproof.ledger.verdict_cache import VerdictCache, make_keys
from mechproof.pipeline.ledger_cache import LedgerCache
from mechproof.pipeline.opening import Opened, open_derivation
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Paper, Row
from mechproof.sources.paper_files import BESIDE, SUFFIXES
from mechproof.tools.cache import digest_files, note_reads
from mechproof.tools.processes import START, WorkerError, run_batches

R = TypeVar("R", Judgement, Row)
# Time limit for a row, in seconds: beyond it something hangs.
LIMIT = 600.0


class VerificationError(RuntimeError):
    """The judgements are inconsistent, as a derivation changed in the meantime."""


# Derivations that this process has opened; forked processes find those of their parent here.
_opened: dict[Path, Opened] = {}


def find_ledgers(
    locations: Sequence[Path],
    *,
    use_cache: bool = True,
    limit: float = LIMIT,
    report: Callable[[str], None] = lambda text: None,
) -> list[Ledger]:
    """Return the ledgers of the papers; a paper whose files have not changed is not judged again.

    Otherwise like `judge_derivations`.
    """
    caches = {place: LedgerCache(place) for place in locations} if use_cache else {}
    found = {place: kept for place, cache in caches.items() if (kept := cache.load())}
    changed = [place for place in locations if place not in found]
    judged = judge_derivations(changed, use_cache=use_cache, limit=limit, report=report)
    found.update(zip(changed, judged, strict=True))
    places: dict[str, Path] = {}
    for place in locations:
        check_names(places, found[place].system, place)
    return [found[place] for place in locations]


def restore_papers(
    ledgers: Sequence[Ledger],
    locations: Sequence[Path],
    *,
    limit: float = LIMIT,
    report: Callable[[str], None] = lambda text: None,
) -> list[JudgedPaper]:
    """Return the ledgers of `find_ledgers` with their papers, loading those not yet loaded."""
    return [
        ledger if isinstance(ledger, JudgedPaper) else _restore(ledger, location, limit, report)
        for ledger, location in zip(ledgers, locations, strict=True)
    ]


def judge_derivations(
    locations: Sequence[Path],
    *,
    use_cache: bool = True,
    only_kernels: bool = False,
    limit: float = LIMIT,
    processes: int | None = None,
    start: str = START,
    report: Callable[[str], None] = lambda text: None,
) -> list[JudgedPaper]:
    """Judge every row of the papers, with the rows that follow from findings and those of forms.

    Sources of papers, which have no findings or forms, are judged as `mechproof.check` does.

    With `only_kernels`, only rows on which shipped kernels rest are judged, and no findings.
    `report` is called with the progress. A row that takes longer than `limit` seconds, that is
    wrongly stated or at which the prover fails has no judgement but a failure that names it; the
    other rows are judged nevertheless. Raises `DerivationError`, also for a derivation that takes
    longer to load.
    """
    progress: dict[Path, _Progress] = {}
    places: dict[str, Path] = {}

    def load(location: Path) -> _Progress:
        report(f"loading {location}")
        whole = LedgerCache(location) if use_cache else None
        with note_reads() as read, stop_after(limit, location):
            _opened[location] = opened = open_derivation(location)
        check_names(places, opened.paper.system, location)
        progress[location] = paper = _Progress(opened, whole, only_kernels, read)
        if opened.paper.print and not only_kernels:
            # Done here, while other processes judge.
            paper.rest = _check_rest(opened.paper, limit, report)
        return paper

    derivations = [location for location in locations if location.suffix not in SUFFIXES]
    # The shortest first, so that the other processes soon have something to judge.
    loaders = [partial(load, one) for one in sorted(derivations, key=_count_bytes)]
    try:
        _fill(loaders, limit, processes, start, report)
    finally:
        _opened.clear()
        for paper in progress.values() if use_cache else ():
            paper.save()
    found = {location: paper.finish() for location, paper in progress.items()}
    for location in locations:
        if location not in found:
            found[location] = _check_source(location, limit, report, use_cache=use_cache)
            check_names(places, found[location].system, location)
    return [found[location] for location in locations]


def _count_bytes(location: Path) -> int:
    """Return the size of a derivation's sources in bytes; 0 if there are none."""
    sources = location.rglob("*.py") if location.is_dir() else [location]
    return sum(source.stat().st_size for source in sources if source.is_file())


def _restore(
    kept: Ledger, location: Path, limit: float, report: Callable[[str], None]
) -> JudgedPaper:
    """Reunite a cached ledger with its paper; the rows of forms are not stated again."""
    if location.suffix in SUFFIXES:
        return _check_source(location, limit, report, use_cache=True)
    report(f"loading {location}")
    with stop_after(limit, location):
        paper = load_paper(location)
    if paper.print:
        paper = _add_rows(paper, _check_rest(paper, limit, report))
    return JudgedPaper(**vars(kept), paper=paper)


def _add_rest(ledger: JudgedPaper, checked: checking.CheckedPaper) -> JudgedPaper:
    """Add the judgements of a paper's other equations, in printed order; they need no mechanics."""
    rest = checked.to_ledger(ledger.system)
    return replace(
        ledger,
        judgements=_insert(ledger.judgements, rest.judgements, checked.names),
        findings=ledger.findings + rest.findings,
        left=rest.left,
        paper=_add_rows(ledger.paper, checked),
    )


def _check_rest(paper: Paper, limit: float, report: Callable[[str], None]) -> checking.CheckedPaper:
    assert paper.print
    try:
        return checking.check_rest(
            paper.print, paper.rows, min(limit, judging_workers.LIMIT), report
        )
    except ValueError as error:
        raise DerivationError(str(error)) from error


def _add_rows(paper: Paper, checked: checking.CheckedPaper) -> Paper:
    rest = checked.to_ledger(paper.system).paper.rows
    return replace(paper, rows=_insert(paper.rows, rest, checked.names))


def _insert(rows: Sequence[R], others: Sequence[R], names: Sequence[str]) -> tuple[R, ...]:
    """Insert other rows after those whose equations come before theirs, or at the beginning."""
    places = {name: place for place, name in enumerate(names)}
    found = [(places.get(judging_workers.name_equation(row.number)), row) for row in rows]
    for other in others:
        place = places.get(judging_workers.name_equation(other.number), len(names))
        known = [(n, own) for n, (own, _) in enumerate(found) if own is not None]
        before = [n + 1 for n, own in known if own <= place]
        first = known[0][0] if known else len(found)
        found.insert(before[-1] if before else first, (place, other))
    return tuple(row for _, row in found)


def _check_source(
    location: Path, limit: float, report: Callable[[str], None], *, use_cache: bool
) -> JudgedPaper:
    """Judge a paper's own source, and cache its ledger if all files it names were found."""
    whole = LedgerCache(location)
    report(f"reading {location}")
    try:
        with note_reads() as read:
            paper = checking.check(location, limit=min(limit, judging_workers.LIMIT), report=report)
    except ValueError as error:
        raise DerivationError(str(error)) from error
    ledger = paper.to_ledger()
    if use_cache and read and not paper.missing:
        whole.save(ledger, {**read, **digest_files([location.resolve().with_suffix(BESIDE)])})
    return ledger


class _Progress:
    """The judgements of a paper while they come in."""

    def __init__(
        self, opened: Opened, whole: LedgerCache | None, only_kernels: bool, read: Mapping[str, str]
    ) -> None:
        """Take over cached judgements, if ledgers are cached (`whole`)."""
        self.opened = opened
        self.whole = whole
        self.only_kernels = only_kernels
        self.read = read
        self.tasks = opened.tasks
        numbers = range(len(self.tasks))
        self.wanted = [n for n in numbers if not only_kernels or opened.is_kernel(n)]
        self.cache = VerdictCache(opened.location)
        sources = opened.list_sources()
        self.keys = make_keys(opened.domain, sources) if whole else [""] * len(sources)
        self.kept = self.cache.load() if whole else {}
        self.found = {n: self.kept[k] for n, k in enumerate(self.keys) if k in self.kept}
        self.failed: dict[int, str] = {}
        self.rest: checking.CheckedPaper | None = None

    def missing(self) -> Iterator[int]:
        """Yield the numbers of tasks left, in reverse: derivatives come last and take longest."""
        done = self.found.keys() | self.failed.keys()
        return (n for n in reversed(self.wanted) if n not in done)

    def add(self, number: int, result: tuple[Judgement, ...] | WorkerError) -> None:
        """Add the result of a task; a process that rereads the file may have another version."""
        name = self.tasks[number]
        if isinstance(result, WorkerError):
            self.failed[number] = f"{self.opened.location}: row {name}: {result}"
        elif result[0].number != name:
            raise VerificationError(f"{self.opened.location}: changed while it was judged")
        else:
            self.found[number] = result

    def save(self) -> None:
        """Store new judgements in the cache."""
        judged = {self.keys[number]: found for number, found in self.found.items()}
        if judged != self.kept:
            self.cache.save(judged)

    def finish(self) -> JudgedPaper:
        """Return the ledger with rows in order; raises `DerivationError` for a wrong finding."""
        paper = self.opened.paper
        found = [(n, judgement) for n in sorted(self.found) for judgement in self.found[n]]
        ledger = JudgedPaper(
            paper.system,
            paper.reference,
            tuple(judgement for _, judgement in found),
            shipped=frozenset(j.number for n, j in found if self.opened.is_kernel(n)),
            failures=tuple(self.failed[number] for number in sorted(self.failed)),
            origin=Origin.of(paper),
            paper=paper,
        )
        if ledger.failures or self.only_kernels:
            return ledger
        try:
            ledger = replace(ledger, findings=list_findings(paper, ledger.judgements))
        except ValueError as error:
            raise DerivationError(f"{self.opened.location}: {error}") from error
        if self.rest:
            ledger = _add_rest(ledger, self.rest)
        if self.whole and self.read and all(self.keys):
            self.whole.save(ledger, self.read)
        return ledger


def _fill(
    loaders: Sequence[Callable[[], _Progress]],
    limit: float,
    processes: int | None,
    start: str,
    report: Callable[[str], None],
) -> None:
    """Judge the missing rows of each paper while the next ones are still being loaded."""
    tasks: list[tuple[_Progress, int]] = []

    def make(load: Callable[[], _Progress]) -> list[tuple[Path, int]]:
        paper = load()
        missing = list(paper.missing())
        tasks.extend((paper, number) for number in missing)
        return [(paper.opened.location, number) for number in missing]

    makers = [partial(make, load) for load in loaders]
    results = run_batches(_judge, makers, limit=limit, processes=processes, start=start)
    for task, result in results:
        paper, number = tasks[task]
        paper.add(number, result)
        report(_count({id(paper): paper for paper, _ in tasks}.values()))


def _count(papers: Iterable[_Progress]) -> str:
    """Return the progress of each paper that has rows left: judged rows of all rows."""
    counts = [(p.opened.paper.system, len(list(p.missing())), len(p.wanted)) for p in papers]
    at_work = [f"{name} {rows - left} of {rows}" for name, left, rows in counts if left]
    return ", ".join(at_work) or "all rows judged"


def list_failures(ledgers: Sequence[Ledger]) -> list[str]:
    """Return rows that could not be judged, and kernels not proved, with where they differ.

    A kernel is proved exactly or within its bound.
    """
    failures = [failure for ledger in ledgers for failure in ledger.failures]
    return failures + [
        f"{ledger.system}: {_describe_refusal(row)}"
        for ledger in ledgers
        for row in ledger.judgements
        if row.number in ledger.shipped and row.verdict is not Verdict.PROVED
    ]


def _describe_refusal(row: Judgement) -> str:
    where = next((item for item in row.evidence if item.at), None)
    text = f"{row.number} is {row.verdict}, but only proved rows are shipped: {row.reason}"
    if where is None:
        return text
    at, *values = where.list_values(("its source gives", "the definition"))
    return f"{text} {capitalise(at)}: {', '.join(values) or where.what}."


def _judge(task: tuple[Path, int]) -> tuple[Judgement, ...]:
    location, number = task
    if location not in _opened:
        _opened[location] = open_derivation(location)
    opened = _opened[location]
    return tuple(judge(row, opened.domain) for row in opened.state(number))
