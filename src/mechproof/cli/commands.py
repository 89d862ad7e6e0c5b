"""The commands: what is asked for, in which order, and the exit status."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib.metadata import version
from pathlib import Path
from typing import Annotated

import typer

from mechproof.cli.chart import chart
from mechproof.cli.check import check
from mechproof.cli.console import fail, refuse, say, show_progress
from mechproof.cli.emit import app as emit_app
from mechproof.cli.figures import figures
from mechproof.cli.json_file import clear_json, write_json
from mechproof.cli.judging import (
    LimitOption,
    NoCacheOption,
    judge_papers,
    read_ledgers,
    refuse_failures,
)
from mechproof.cli.ledger import print_ledgers
from mechproof.cli.places import RULE, DerivationsOption, Places, find_locations, find_places
from mechproof.cli.report import report
from mechproof.cli.start import show_start
from mechproof.codegen.regenerate import LIST, render_package
from mechproof.derivation import DerivationError, find_systems, packaged_directory
from mechproof.made import Change, ForeignFileError, Made
from mechproof.proof.ledger import JudgedPaper, to_json, to_markdown
from mechproof.proof.verdict import Verdict
from mechproof.record import Paper
from mechproof.roundoff.certificate import Certificate, tell_proofs
from mechproof.roundoff.files import certify_papers, write_certificates
from mechproof.validation import ValidationError, validate_derivations
from mechproof.verification import LIMIT

app = typer.Typer(
    add_completion=False,
    help=f"Prove or refute the formulas of mechanism papers; generate kernels from them.\n\n{RULE}",
    pretty_exceptions_show_locals=False,
)
app.command()(chart)
app.command()(check)
app.command(epilog=RULE)(report)
app.command(epilog=RULE)(figures)
app.add_typer(emit_app, name="emit")

RootOption = Annotated[
    Path | None,
    typer.Option(
        "--root", metavar="ROOT", help="The folder that holds derivations/ and generated/."
    ),
]


def _print_version(asked: bool) -> None:
    if asked:
        say(f"mechproof {version('mechproof')}")
        raise typer.Exit


@app.callback(invoke_without_command=True)
def _main(
    context: typer.Context,
    show_version: Annotated[
        bool,
        typer.Option(
            "--version", is_eager=True, callback=_print_version, help="Show the version and exit."
        ),
    ] = False,
) -> None:
    if context.invoked_subcommand is None:
        show_start(find_places(None, None))


@app.command(epilog=RULE)
def verify(
    papers: Annotated[
        list[str] | None,
        typer.Argument(
            help="Systems, files FILE.py or folders of derivations; all systems if none."
        ),
    ] = None,
    json_file: Annotated[
        Path | None, typer.Option("--json", help="Also write the rows to this file.")
    ] = None,
    show_all: Annotated[
        bool, typer.Option("--all", help="Show every row, with the evidence where there is any.")
    ] = False,
    derivations: DerivationsOption = None,
    root: RootOption = None,
    no_cache: NoCacheOption = False,
    limit: LimitOption = LIMIT,
) -> None:
    """Judge every row of the papers; print what was found, then what is not plainly proved.

    Exit status 0: every row is decided and every kernel is PROVED; 1: a row is UNDECIDED, a kernel
    is not PROVED (rivals may be wrong: they are named as such), a row hangs or crashes, or a
    derivation fails; 2: bad usage.
    """
    locations = find_locations(papers or (), find_places(derivations, root))
    clear_json(json_file)
    ledgers = read_ledgers(locations, use_cache=not no_cache, limit=limit)
    if not any(ledger.failures for ledger in ledgers):
        write_json(json_file, to_json(ledgers))
    print_ledgers(ledgers, show_all=show_all)
    refuse_failures(ledgers)
    rows = (row for ledger in ledgers for row in ledger.judgements)
    if any(row.verdict is Verdict.UNDECIDED for row in rows):
        raise typer.Exit(1)


@app.command(epilog=RULE)
def regenerate(
    check: Annotated[
        bool, typer.Option("--check", help="Write nothing; fail on any difference.")
    ] = False,
    derivations: DerivationsOption = None,
    root: RootOption = None,
    no_cache: NoCacheOption = False,
    limit: LimitOption = LIMIT,
) -> None:
    """Write kernels, certificates and the ledger of DIR into DIR/../generated.

    Only what was generated is replaced or removed, and only while it is as it was generated:
    mechproof-generated.sha256 there lists it. Every kernel is read back from its source, has to be
    PROVED (exactly, or within its bound), and is run against the oracle first; the bounds of the
    certificates are proved anew.

    Exit status 0: nothing to do or written; 1: with --check, a file is missing, surplus or
    different; a file that was edited or not generated is in the way; a kernel is not PROVED, or
    computes something else than its derivation; a row hangs or crashes, or a derivation fails;
    2: bad usage.
    """
    places = find_places(derivations, root)
    if not (derivations or root) and not Path("derivations").is_dir():
        refuse("there is no folder derivations: run it where it lies, or give --derivations DIR")
    locations = find_locations((), places)
    ledgers = judge_papers(locations, use_cache=not no_cache, limit=limit)
    refuse_failures(ledgers)
    papers = [ledger.paper for ledger in ledgers]
    certificates = _certify(papers, places, use_cache=not no_cache)
    files = _render(ledgers, certificates, places)
    _validate(locations, papers, files, use_cache=not no_cache, limit=limit)
    changes = _compare_or_update(places.generated, files, check)
    for change in changes:
        say(change.describe() if check else _describe_step(change))
    say(f"{places.generated}: {len(files)} files, {_count(changes, check)}")
    if check and changes:
        say(f"run `mechproof regenerate{places.options}`")
        raise typer.Exit(1)


@app.command(epilog=RULE)
def measure(
    quantities: Annotated[
        list[str] | None,
        typer.Argument(help="Quantities, systems or system.quantity; all if none."),
    ] = None,
    quick: Annotated[
        bool, typer.Option("--quick", help="Few points, short times: under a minute.")
    ] = False,
    processes: Annotated[
        int,
        typer.Option("--processes", metavar="N", min=1, help="Measure accuracy in N processes."),
    ] = 1,
    derivations: DerivationsOption = None,
    root: RootOption = None,
) -> None:
    """Measure accuracy and time of all ways to compute; write DIR/../generated/measured.

    `mechproof chart` draws what was measured. A quick run writes into its folder `quick`, which
    `chart` and `choose` read only when told to. Times are taken alone, whatever N is.

    Exit status 0: measured; 1: a derivation fails; 2: bad usage.
    """
    places = find_places(derivations, root)
    if not places.generated.is_dir():
        refuse(f"there is no folder {places.generated}: `mechproof regenerate` writes it")
    from mechproof.executors import start_executor
    from mechproof.lab.measure import measure as measure_subject
    from mechproof.lab.subject import find_subjects
    from mechproof.lab.table import PAGE, headline, list_lines
    from mechproof.measured import FOLDER, find_known, read_records, write_record

    target = places.generated / FOLDER / ("quick" if quick else "")
    directory = None if places.is_packaged else places.derivations
    try:
        subjects = find_subjects(tuple(quantities or ()), directory)
        known = {s.name: find_known(target, s.name, len(s.quantity.arguments)) for s in subjects}
    except DerivationError as error:
        fail(str(error))
    except ValueError as error:
        refuse(str(error))
    with start_executor(processes) as executor:
        for number, subject in enumerate(subjects, start=1):
            title = f"{subject.name} ({number} of {len(subjects)})"
            with show_progress(f"{title}: measuring") as report:
                record = measure_subject(
                    subject,
                    quick=quick,
                    report=report,
                    executor=executor,
                    known=known[subject.name],
                )
            say(f"{write_record(record, target)}: {headline(record)}")
    # What a quick run writes is kept apart, and so is what lists it.
    root = target if quick else places.generated
    page = {
        (target / PAGE).relative_to(root).as_posix(): "\n".join(list_lines(read_records(target)))
    }
    try:
        Made(root, LIST).update(page, and_remove=False)
    except (ForeignFileError, OSError) as error:
        fail(str(error))
    say(str(target / PAGE))


def _certify(
    papers: Sequence[Paper], places: Places, *, use_cache: bool
) -> list[Certificate | None]:
    try:
        with show_progress("bounding the rounding errors"):
            return certify_papers(papers, places.generated, use_cache=use_cache)
    except (ValueError, NotImplementedError) as error:
        fail(str(error))


def _render(
    ledgers: Sequence[JudgedPaper], certificates: Sequence[Certificate | None], places: Places
) -> dict[str, str]:
    pairs = list(zip((ledger.paper for ledger in ledgers), certificates, strict=True))
    papers = [tell_proofs(paper, certificate) for paper, certificate in pairs]
    # Nobody else has all of our systems.
    is_own = {paper.system for paper in papers} >= set(find_systems(packaged_directory()))
    try:
        files = render_package(papers, is_own=is_own)
    except (ValueError, NotImplementedError) as error:
        fail(f"{places.derivations}: {error}")
    files.update(write_certificates(c for c in certificates if c))
    files["ledger.json"] = to_json(ledgers)
    files["LEDGER.md"] = to_markdown(ledgers)
    files.update(_render_tables(places.generated, certificates))
    return files


def _render_tables(generated: Path, certificates: Sequence[Certificate | None]) -> dict[str, str]:
    """Write the page of what was measured, with what is now proved beside it."""
    from mechproof.lab.proofs import select_claims
    from mechproof.lab.table import PAGE, list_lines
    from mechproof.measured import FOLDER, read_records

    known = [certificate for certificate in certificates if certificate]
    try:
        records = read_records(generated / FOLDER)
    except ValueError as error:
        fail(str(error))
    lines = list_lines(records, lambda record: select_claims(record, known))
    return {f"{FOLDER}/{PAGE}": "\n".join(lines)} if records else {}


def _validate(
    locations: Sequence[Path],
    papers: Sequence[Paper],
    files: Mapping[str, str],
    *,
    use_cache: bool,
    limit: float,
) -> None:
    placed = list(zip(locations, papers, strict=True))
    try:
        with show_progress("running the emitted kernels") as report:
            validate_derivations(placed, files, use_cache=use_cache, limit=limit, report=report)
    except ValidationError as error:
        fail(str(error))


def _compare_or_update(directory: Path, files: Mapping[str, str], check: bool) -> list[Change]:
    made = Made(directory, LIST)
    try:
        return made.compare(files) if check else made.update(files)
    except (ForeignFileError, OSError) as error:
        fail(str(error))


def _describe_step(change: Change) -> str:
    return f"{'removed' if change.is_removal else 'wrote'} {change.name}"


def _count(changes: Sequence[Change], check: bool) -> str:
    if not changes:
        return "all as regenerated"
    if check:
        return "differences found"
    removed = sum(change.is_removal for change in changes)
    return f"{len(changes) - removed} written, {removed} removed"
