"""Certification of rounding errors on all processors: papers in, their certificates out."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from mechproof.derivation import load_paper
from mechproof.record import Paper
from mechproof.roundoff.certificate import Certificate
from mechproof.roundoff.certificate_files import certify_paper
from mechproof.tools.processes import WorkerError, run_tasks

# Seconds for a paper: a search for bounds that nobody knows yet may take an hour.
LIMIT = 6 * 3600.0
# The papers of this process by their places; one that was forked finds here what its parent had.
_papers: dict[Path, Paper] = {}


def certify_derivations(
    papers: Mapping[Path, Paper], directory: Path, *, use_cache: bool = True
) -> list[Certificate | None]:
    """Prove the bounds of papers, given by their places; None for one without charts.

    Raises ValueError for a chart that cannot be used.
    """
    places = list(papers)
    found: dict[int, Certificate | None] = {}
    _papers.update(papers)
    try:
        tasks = [(place, directory, use_cache) for place in places]
        for number, result in run_tasks(_certify, tasks, limit=LIMIT):
            if isinstance(result, WorkerError):
                raise ValueError(f"{places[number]}: {result}") from result
            found[number] = result
    finally:
        _papers.clear()
    return [found[number] for number in range(len(places))]


def _certify(task: tuple[Path, Path, bool]) -> Certificate | None:
    place, directory, use_cache = task
    paper = _papers.get(place) or load_paper(place)
    return certify_paper(paper, directory, use_cache=use_cache)
