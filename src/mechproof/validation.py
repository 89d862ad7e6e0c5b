"""Validation of emitted kernels on all processors, before they are written."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from hashlib import sha256
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory

from mechproof.derivation import load_paper
from mechproof.files import write_whole
from mechproof.lab.subject import Subject, make_subjects
from mechproof.lab.validation import validate
from mechproof.processes import START, WorkerError, run_tasks
from mechproof.proof.cache import cache_folder
from mechproof.record import Paper

# What a validation rests on besides the emitted source and the derivation.
LAYERS = ("kernel_support", "compiled_support", "codegen", "lab", "proof")
VERSIONS = ("sympy", "numpy", "python-flint")
# What has passed is kept; more than so many entries are of old sources.
MOST_KEPT = 1000


class ValidationError(RuntimeError):
    """A kernel does not compute what was emitted, or not within its accuracy bound."""


# Subjects that a process has made, by the place of the derivation and the emitted files.
_made: dict[tuple[Path, Path], tuple[Subject, ...]] = {}


def validate_derivations(
    papers: Sequence[tuple[Path, Paper]],
    files: Mapping[str, str],
    *,
    use_cache: bool = True,
    limit: float = 600.0,
    report: Callable[[str], None] = lambda text: None,
) -> None:
    """Run the emitted kernels of all papers, given by their places.

    Raises `ValidationError` with the kernel, the point and both values.
    """
    kept = _load() if use_cache else []
    keys = {place: _key(place, paper, files) for place, paper in papers}
    wanted = [(place, paper) for place, paper in papers if keys[place] not in kept]
    with TemporaryDirectory() as folder:
        for name, text in files.items():
            target = Path(folder, name)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8")
        names = [(place, q.name) for place, paper in wanted for q in paper.quantities if q.forms]
        tasks = [(place, Path(folder), name) for place, name in names]
        results = run_tasks(_validate, tasks, limit=limit, start=START)
        for done, (number, result) in enumerate(results, start=1):
            if isinstance(result, WorkerError):
                place, name = names[number]
                raise ValidationError(f"{place}: {name}: {result}") from result
            report(f"{done} of {len(tasks)} kernels run")
    if use_cache:
        _save([*kept, *(keys[place] for place, _ in wanted)])


def _validate(task: tuple[Path, Path, str]) -> None:
    place, folder, name = task
    if (place, folder) not in _made:
        _made[place, folder] = tuple(make_subjects(load_paper(place), place, folder))
    validate(s for s in _made[place, folder] if s.quantity.name == name)


def _key(place: Path, paper: Paper, files: Mapping[str, str]) -> str:
    """Return a key of all that the values depend on: sources of the package and of the paper."""
    package = Path(__file__).parent
    sources = [p for layer in LAYERS for p in sorted((package / layer).rglob("*.py"))]
    sources += sorted(place.rglob("*.py")) if place.is_dir() else [place]
    sources += sorted(place.parent.glob("_*.py"))
    emitted = [text for name, text in sorted(files.items()) if Path(name).stem == paper.system]
    compiler = version("numba") if find_spec("numba") else ""
    parts = [sys.version, *map(version, VERSIONS), compiler, *emitted]
    digests = [sha256(path.read_bytes()).hexdigest() for path in sources]
    return sha256("\n".join([*parts, *digests]).encode()).hexdigest()


def _load() -> list[str]:
    with suppress(OSError, ValueError):
        found = json.loads((cache_folder() / "validated.json").read_bytes())
        if isinstance(found, list):
            return [key for key in found if isinstance(key, str)]
    return []


def _save(keys: list[str]) -> None:
    with suppress(OSError):
        text = json.dumps(list(dict.fromkeys(keys))[-MOST_KEPT:])
        write_whole(cache_folder() / "validated.json", text)
