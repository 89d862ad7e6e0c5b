"""The pipeline: from the places of derivations to the generated package, in five stages.

1. Judge: every row and every form of each paper gets a verdict; what is shipped must be PROVED.
2. Bound: the rounding errors of kernels are proved, unless a certificate still holds.
3. Render: every form becomes a program and source in each language, which is read back; verdicts
   and bounds become the ledger, the certificates and the tables.
4. Validate: the emitted kernels are run against the oracle.
5. Write: files that differ are replaced in one step, if they were generated and not edited.

A stage that finds a fault ends the run with `PipelineError`, and nothing is written. The generated
kernels can then be measured.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory

from mechproof.codegen.form_rows import read_derivatives_back
from mechproof.codegen.regenerate import LIST, render_package
from mechproof.codegen.source_reading import TranslationError
from mechproof.coq.folder import read_checks
from mechproof.derivation import find_systems, load_paper, packaged_directory
from mechproof.lab import measure as measuring
from mechproof.lab.record_tables import PAGE, headline, list_lines, select_claims
from mechproof.lab.subject import Subject, find_subjects, make_subjects
from mechproof.lab.validation import check_meaning, validate
from mechproof.ledger.judged import JudgedPaper, to_json, to_markdown
from mechproof.measured import FOLDER, QUICK, find_known, read_records, write_record
from mechproof.pipeline.judging import (
    Progress,
    judge_papers,
    name_faults,
    refuse_failures,
    report_nothing,
)
from mechproof.pipeline.verification import LIMIT
from mechproof.programs.kernel import build_functions, list_functions
from mechproof.record import Paper
from mechproof.roundoff.certificate import Certificate, RoundingClaim, describe_proofs
from mechproof.roundoff.certificate_files import (
    CERTIFIED,
    certify_kernel,
    read_claims,
    write_certificates,
)
from mechproof.tools.cache import Store, make_key
from mechproof.tools.extras import require_modules
from mechproof.tools.made import Change, ForeignFileError, Made
from mechproof.tools.processes import WorkerError, run_tasks, start_executor

# Papers of this process by their places; forked processes find those of their parent here.
_papers: dict[Path, Paper] = {}
# Packages that a validation depends on, besides the emitted source and the derivation.
LAYERS = (
    *("arguments", "kernel_support", "compiled_support", "record", "latex", "programs"),
    *("arithmetic", "sources", "statement_domains", "codegen", "proof", "roundoff", "lab"),
)
PACKAGES = ("sympy", "numpy", "python-flint")
PASSED = Store("validated.json")


@dataclass(frozen=True)
class Regenerated:
    """The text of every file of the package by its name, and the changes made or to be made."""

    files: Mapping[str, str]
    changes: tuple[Change, ...]

    @property
    def systems(self) -> tuple[str, ...]:
        """Return the systems that have kernels."""
        modules = (Path(name) for name in self.files if name != "__init__.py")
        return tuple(m.stem for m in modules if len(m.parts) == 1 and m.suffix == ".py")


def regenerate(
    locations: Sequence[Path],
    generated: Path,
    *,
    check: bool = False,
    use_cache: bool = True,
    limit: float = LIMIT,
    progress: Progress = report_nothing,
) -> Regenerated:
    """Generate the package of the derivations at these places into the folder `generated`.

    With `check` nothing is written, and the changes are those that would be made. Without
    `use_cache` no results of earlier runs are reused. A row that takes longer than `limit` seconds
    is a fault, and so is a derivation that takes longer to load. `progress` is called with the
    title of each stage that takes its time; it returns a context in which the stage runs.
    """
    if not locations:
        raise ValueError("locations: must have at least one derivation")
    with name_faults(ImportError):
        require_modules("generated code", "regenerate", ("ruff",))
    ledgers = judge_papers(locations, use_cache=use_cache, limit=limit, progress=progress)
    refuse_failures(ledgers)
    papers = [ledger.paper for ledger in ledgers]
    with name_faults(ValueError, NotImplementedError), progress("bounding the rounding errors"):
        placed = dict(zip(locations, papers, strict=True))
        certificates = certify_derivations(placed, generated, use_cache=use_cache)
    with name_faults(ValueError, NotImplementedError, where=f"{locations[0].parent}: "):
        files = _render(ledgers, certificates, read_checks(generated))
    with name_faults(ValueError):
        files |= _render_tables(generated, certificates)
    with name_faults(ValidationError), progress("running the emitted kernels") as report:
        validate_derivations(placed, files, use_cache=use_cache, limit=limit, report=report)
    with name_faults(ForeignFileError, OSError):
        made = Made(generated, LIST)
        return Regenerated(files, tuple(made.compare(files) if check else made.update(files)))


def _render(
    ledgers: Sequence[JudgedPaper],
    certificates: Sequence[Certificate | None],
    checks: Mapping[str, str],
) -> dict[str, str]:
    pairs = zip((ledger.paper for ledger in ledgers), certificates, strict=True)
    papers = [describe_proofs(paper, certificate) for paper, certificate in pairs]
    for paper in papers:
        read_derivatives_back(paper)
    # Only the package itself has all of these systems.
    is_own = {paper.system for paper in papers} >= set(find_systems(packaged_directory()))
    return {
        **render_package(papers, is_own=is_own),
        **write_certificates(c for c in certificates if c),
        "ledger.json": to_json(ledgers),
        "LEDGER.md": to_markdown(ledgers, checks),
    }


def _render_tables(generated: Path, certificates: Sequence[Certificate | None]) -> dict[str, str]:
    """Return the page of the measurements, with the bounds now proved."""
    known = [certificate for certificate in certificates if certificate]
    records = read_records(generated / FOLDER)
    lines = list_lines(records, lambda record: select_claims(record, known))
    return {f"{FOLDER}/{PAGE}": "\n".join(lines)} if records else {}


def measure(
    names: Sequence[str],
    derivations: Path | None,
    generated: Path,
    *,
    quick: bool = False,
    processes: int = 1,
    progress: Progress = report_nothing,
) -> Iterator[tuple[Path, str]]:
    """Measure the errors and times of the ways of computing quantities.

    `names` are quantities, systems or system.quantity, or all quantities if empty; they are sought
    in the folder `derivations`, or without one in those of the package. Accuracy is measured in
    `processes` processes. Yields each record's file once it is written, with a headline, and
    finally the page of all records with "". Raises ValueError for an unknown name and
    `DerivationError` for a derivation that fails, both before anything is run.
    """
    target = generated / FOLDER / (QUICK if quick else "")
    subjects = find_subjects(tuple(names), derivations)
    known = {s.name: find_known(target, s.name, len(s.quantity.arguments)) for s in subjects}

    def run() -> Iterator[tuple[Path, str]]:
        with start_executor(processes) as executor:
            for number, subject in enumerate(subjects, start=1):
                title = f"{subject.name} ({number} of {len(subjects)}): measuring"
                with progress(title) as report:
                    record = measuring.measure(
                        subject,
                        quick=quick,
                        report=report,
                        executor=executor,
                        known=known[subject.name],
                    )
                yield write_record(record, target), headline(record)
        # Records of a quick run are kept apart, and so is the list of them.
        root = target if quick else generated
        lines = list_lines(read_records(target))
        with name_faults(ForeignFileError, OSError):
            page = {(target / PAGE).relative_to(root).as_posix(): "\n".join(lines)}
            Made(root, LIST).update(page, and_remove=False)
        yield target / PAGE, ""

    return run()


# Time limit for a kernel, in seconds: a search for bounds not known yet may take most of an hour.
LONGEST = 6 * 3600.0
# The place of a paper, the number of one of its kernels, the known claims about it, and whether
# the cache is used.
_Certifying = tuple[Path, int, tuple[RoundingClaim, ...], bool]


def certify_derivations(
    papers: Mapping[Path, Paper], directory: Path, *, use_cache: bool
) -> list[Certificate | None]:
    """Prove the bounds of papers, given by their places; None for a paper without charts.

    With the cache, bounds that were proved before are not proved again. Raises ValueError for a
    chart that cannot be used.
    """
    tasks: list[_Certifying] = []
    for place, paper in papers.items():
        known = read_claims(directory, paper.system)
        for number, kernel in enumerate(list_functions(paper)):
            claims = tuple(claim for claim in known if claim.quantity == kernel.name)
            tasks.append((place, number, claims, use_cache))
    # The last kernels of a paper, derivatives of the others, take the longest.
    tasks.reverse()
    found: dict[int, tuple[tuple[RoundingClaim, ...], str]] = {}
    _papers.update(papers)
    try:
        for number, result in run_tasks(_certify, tasks, limit=LONGEST):
            if isinstance(result, WorkerError):
                raise ValueError(f"{tasks[number][0]}: {result}") from result
            found[number] = result
    finally:
        _papers.clear()
    proved: dict[Path, tuple[RoundingClaim, ...]] = dict.fromkeys(papers, ())
    for number in sorted(found, reverse=True):
        proved[tasks[number][0]] += found[number][0]
    if use_cache:
        CERTIFIED.add(key for _, key in found.values())
    return [
        Certificate(paper.system, proved[place]) if proved[place] else None
        for place, paper in papers.items()
    ]


def _certify(task: _Certifying) -> tuple[tuple[RoundingClaim, ...], str]:
    place, number, known, use_cache = task
    paper = _find_paper(place)
    return certify_kernel(list_functions(paper)[number], paper, known, use_cache=use_cache)


def _find_paper(place: Path) -> Paper:
    """Return the paper of the process that this one was forked from, or load it once."""
    if place not in _papers:
        _papers[place] = load_paper(place)
    return _papers[place]


def list_unmeant(paper: Paper, place: Path) -> list[str]:
    """Return kernels whose rows say less than their definition and that compute something else."""
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


# Subjects that this process has made, by the place of the derivation and of the emitted files.
_made: dict[tuple[Path, Path], tuple[Subject, ...]] = {}


def validate_derivations(
    papers: Mapping[Path, Paper],
    files: Mapping[str, str],
    *,
    use_cache: bool,
    limit: float,
    report: Callable[[str], None],
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
        _made[place, folder] = tuple(make_subjects(_find_paper(place), place, folder))
    validate(s for s in _made[place, folder] if s.quantity.name == name)


def _key(place: Path, paper: Paper, files: Mapping[str, str]) -> str:
    """Return a key of everything the values depend on: sources of the package and of the paper."""
    package = Path(__file__).parents[1]
    sources = [p for layer in LAYERS for p in sorted((package / layer).rglob("*.py"))]
    sources += sorted(place.rglob("*.py")) if place.is_dir() else [place]
    sources += sorted(place.parent.glob("_*.py"))
    emitted = [text for name, text in sorted(files.items()) if Path(name).stem == paper.system]
    compiler = version("numba") if find_spec("numba") else ""
    return make_key(sources, PACKAGES, compiler, *emitted)
