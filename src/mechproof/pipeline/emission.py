"""Emission: from the places of derivations to the files of a language, in two stages.

1. Judge: what is shipped of each paper must be PROVED, and compute what its rows say.
2. Render: every kernel becomes a function of the language, which is read back.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from mechproof.codegen.backends.c99 import render_c, render_c_derivatives, render_makefile
from mechproof.codegen.backends.standalone_functions import render_scripts
from mechproof.lab.single_precision_errors import state_errors
from mechproof.pipeline.judging import Progress, judge_papers, refuse_failures, report_nothing
from mechproof.pipeline.stages import list_unmeant
from mechproof.record import Paper


@dataclass(frozen=True)
class Emitted:
    """The text of each file of a system by its name, and the reasons for what is left out."""

    files: Mapping[str, str]
    left_out: Sequence[str] = ()


def emit_c(
    locations: Sequence[Path],
    *,
    float32: bool = False,
    derivatives: bool = False,
    progress: Progress = report_nothing,
) -> Iterator[Emitted]:
    """Write the kernels of each paper in C, or their derivatives, and finally a Makefile.

    A paper without kernels for C has no files, but a reason. Raises `PipelineError`.
    """
    for place, paper in _judge(locations, progress):
        try:
            yield Emitted(
                render_c_derivatives(paper)
                if derivatives
                else render_c(paper, errors=_find_errors(paper, place, progress, float32))
            )
        except (ValueError, NotImplementedError) as error:
            yield Emitted({}, (str(error),))
    yield Emitted({"Makefile": render_makefile()})


def emit_scripts(
    language: str, locations: Sequence[Path], *, progress: Progress = report_nothing
) -> Iterator[Emitted]:
    """Write the kernels of each paper in a scripting language. Raises `PipelineError`."""
    for _, paper in _judge(locations, progress):
        yield Emitted(*render_scripts(paper, language))


def _judge(locations: Sequence[Path], progress: Progress) -> Iterator[tuple[Path, Paper]]:
    """Yield each place with its paper, once its kernels are proved, now or in an earlier run."""
    ledgers = judge_papers(locations, only_kernels=True, progress=progress)
    judged = [(place, one.paper) for place, one in zip(locations, ledgers, strict=True)]
    refuse_failures(
        ledgers, [text for place, paper in judged for text in list_unmeant(paper, place)]
    )
    yield from judged


def _find_errors(
    paper: Paper, place: Path, progress: Progress, float32: bool
) -> Mapping[str, str] | None:
    """Return the largest errors found for kernels in float, or None without float32."""
    if not float32:
        return None
    with progress(f"{paper.system}: searching for the largest errors in float"):
        return state_errors(paper, place)
