"""Validation of emitted kernels on all processors, before they are written."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory

from mechproof.codegen.source_reading import TranslationError
from mechproof.derivation import load_paper
from mechproof.lab.subject import Subject, make_subjects
from mechproof.lab.validation import check_meaning, validate
from mechproof.programs.kernel import build_functions
from mechproof.record import Paper
from mechproof.tools.cache import Store, make_key
from mechproof.tools.processes import WorkerError, run_tasks

# What a validation rests on besides the emitted source and the derivation.
LAYERS = (
    *("arguments", "kernel_support", "compiled_support", "record", "latex", "programs"),
    *("arithmetic", "sources", "statement_domains", "codegen", "proof", "roundoff", "lab"),
)
PACKAGES = ("sympy", "numpy", "python-flint")
PASSED = Store("validated.json")


def list_unmeant(paper: Paper, place: Path) -> list[str]:
    """Name kernels whose rows say less than their definition, and that compute something else."""
    refused, found = build_functions(paper).refused, []
    for subject in make_subjects(paper, place, None):
        quantity = subject.quantity
        says_less = any(form.on or form.states for form in quantity.shipped)
        if quantity.name in refused or not says_less:
            continue
        try:
            check_meaning(subject)
        except TranslationError as error:
            found.append(f"{paper.system}: {error}")
    return found


class ValidationError(RuntimeError):
    """A kernel does not compute what was emitted, or not within its accuracy bound."""


# The papers of this process by their places; one that was forked finds here what its parent had.
_papers: dict[Path, Paper] = {}
# Subjects that a process has made, by the place of the derivation and the emitted files.
_made: dict[tuple[Path, Path], tuple[Subject, ...]] = {}


def validate_derivations(
    papers: Mapping[Path, Paper],
    files: Mapping[str, str],
    *,
    use_cache: bool = True,
    limit: float = 600.0,
    report: Callable[[str], None] = lambda text: None,
) -> None:
    """Run the emitted kernels of all papers, given by their places.

    Raises `ValidationError` with the kernel, the point and both values.
    """
    kept = PASSED.read() if use_cache else {}
    keys = {place: _key(place, paper, files) for place, paper in papers.items()}
    wanted = [(place, paper) for place, paper in papers.items() if keys[place] not in kept]
    with TemporaryDirectory() as folder:
        for name, text in files.items():
            target = Path(folder, name)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8")
        names = [(place, q.name) for place, paper in wanted for q in paper.quantities if q.forms]
        tasks = [(place, Path(folder), name) for place, name in names]
        _papers.update(wanted)
        try:
            results = run_tasks(_validate, tasks, limit=limit)
            for done, (number, result) in enumerate(results, start=1):
                if isinstance(result, WorkerError):
                    place, name = names[number]
                    raise ValidationError(f"{place}: {name}: {result}") from result
                report(f"{done} of {len(tasks)} kernels run")
        finally:
            _papers.clear()
    if use_cache and wanted:
        PASSED.add(keys[place] for place, _ in wanted)


def _validate(task: tuple[Path, Path, str]) -> None:
    place, folder, name = task
    if (place, folder) not in _made:
        paper = _papers.get(place) or load_paper(place)
        _made[place, folder] = tuple(make_subjects(paper, place, folder))
    validate(s for s in _made[place, folder] if s.quantity.name == name)


def _key(place: Path, paper: Paper, files: Mapping[str, str]) -> str:
    """Return a key of all that the values depend on: sources of the package and of the paper."""
    package = Path(__file__).parents[1]
    sources = [p for layer in LAYERS for p in sorted((package / layer).rglob("*.py"))]
    sources += sorted(place.rglob("*.py")) if place.is_dir() else [place]
    sources += sorted(place.parent.glob("_*.py"))
    emitted = [text for name, text in sorted(files.items()) if Path(name).stem == paper.system]
    compiler = version("numba") if find_spec("numba") else ""
    return make_key(sources, PACKAGES, compiler, *emitted)
