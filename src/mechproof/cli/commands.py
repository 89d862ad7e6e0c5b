"""The commands: what is asked for, in which order, and the exit status."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from importlib.metadata import version
from pathlib import Path
from typing import Annotated

import typer
from rich.table import Table
from rich.text import Text

from mechproof.cli import options
from mechproof.cli.bound_command import bound
from mechproof.cli.certify_command import certify
from mechproof.cli.chart_command import chart, figures
from mechproof.cli.check_command import check
from mechproof.cli.emit_command import app as emit_app
from mechproof.cli.improve_command import SEARCH_LIMIT, improve, offer_forms
from mechproof.cli.ledger_command import print_ledgers
from mechproof.cli.new_command import new
from mechproof.cli.options import (
    RULE,
    Places,
    console,
    ending,
    fail,
    find_locations,
    find_places,
    refuse,
    say,
    show_progress,
)
from mechproof.cli.report_command import report
from mechproof.derivation import DerivationError, find_systems
from mechproof.ledger.judged import to_json
from mechproof.measured import FOLDER
from mechproof.pipeline.judging import PipelineError, read_ledgers, refuse_failures
from mechproof.pipeline.verification import LIMIT
from mechproof.proof.verdict import State, Verdict
from mechproof.sources.paper_files import SUFFIXES
from mechproof.tools.extras import list_other_versions, suggest_install
from mechproof.tools.made import Change

app = typer.Typer(
    add_completion=False,
    help=f"Prove or refute the formulas of mechanism papers; generate kernels from them.\n\n{RULE}",
    pretty_exceptions_show_locals=False,
    # Unlike the default, it fills the lines of a paragraph.
    rich_markup_mode="markdown",
)
# Command -> what it does; the words in capitals are replaced by names that exist here.
EXAMPLES = {
    "verify": "judge all papers: findings first",
    "verify SYSTEM": "judge one; --all shows every row",
    "new FILE.py": "begin a paper of your own (or FILE.tex)",
    "verify FILE.py": "judge it",
    "report": "all results as pages for a browser",
    r"check '\sin 2x=2\sin x'": "judge one equation",
    "figures": "the papers' figures, redrawn",
    "chart QUANTITY": "time against error",
    "emit c KERNELS --out c": "kernels as C99",
    "measure --quick": "accuracy and speed on this machine",
    "regenerate --check": "are the generated files up to date?",
}


app.command()(chart)
app.command()(check)
app.command()(bound)
app.command()(new)
app.command(epilog=RULE)(report)
app.command(epilog=RULE)(figures)
app.command(epilog=RULE)(improve)
app.command(epilog=RULE)(certify)
app.add_typer(emit_app, name="emit")

UNDECIDED = (Verdict.UNDECIDED.value, State.NOT_READ.value, State.NOT_JUDGED.value)


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
        show_welcome(find_places(None, None))


@app.command(epilog=RULE)
def verify(
    papers: options.Papers = None,
    json_file: options.Rows = None,
    show_all: Annotated[
        bool, typer.Option("--all", help="Show every row, with its evidence.")
    ] = False,
    show_findings: Annotated[
        bool,
        typer.Option(
            "--findings", help="Show for each finding what is right, why, and what the error costs."
        ),
    ] = False,
    derivations: options.Derivations = None,
    root: options.Root = None,
    fail_on: options.FailOn = None,
    no_cache: options.NoCache = False,
    limit: options.Limit = LIMIT,
) -> None:
    """Judge every row of the papers; print a line for each finding, the gravest first, and totals.

    A paper's own source (LaTeX or Markdown) is judged as by `check`: as far as no mechanics is
    needed.

    Exit status 0: every row is decided and every kernel is PROVED; 1: a row is UNDECIDED, not read
    or not judged (or has an outcome that --fail-on names instead), a kernel is not PROVED (rivals
    may be wrong: they are named as such), a row hangs or crashes, or a derivation fails; 2: bad
    usage.
    """
    outcomes = options.read_outcomes(fail_on, UNDECIDED)
    locations = find_locations(papers or (), find_places(derivations, root), SUFFIXES)
    options.clear_json(json_file)
    with ending(PipelineError, fail):
        ledgers = read_ledgers(
            locations, use_cache=not no_cache, limit=limit, progress=show_progress
        )
        if not any(ledger.failures for ledger in ledgers):
            options.write_json(json_file, to_json(ledgers))
        print_ledgers(ledgers, show_findings=show_findings, show_all=show_all)
        refuse_failures(ledgers)
    if any(ledger.outcomes & outcomes for ledger in ledgers):
        raise typer.Exit(1)


@app.command(epilog=RULE)
def regenerate(
    check: Annotated[
        bool, typer.Option("--check", help="Write nothing; fail on any difference.")
    ] = False,
    better: Annotated[
        bool,
        typer.Option("--improve", help="Search for better forms first, as improve --write does."),
    ] = False,
    derivations: options.Derivations = None,
    root: options.Root = None,
    no_cache: options.NoCache = False,
    limit: options.Limit = LIMIT,
) -> None:
    """Write kernels, certificates and the ledger of DIR into DIR/../generated.

    Only generated files are replaced or removed, and only if nobody has edited them since:
    mechproof-generated.sha256 lists them. Before anything is written, every kernel is read back
    from its source, must be PROVED (exactly, or within its bound) and is run against the oracle,
    and the bounds of the certificates are proved again.

    Exit status 0: written, or nothing to do; 1: with --check, a file is missing, superfluous or
    different; a file that was edited or not generated is in the way; a kernel is not PROVED, or
    does not compute what its derivation says; a row hangs or crashes, or a derivation fails;
    2: bad usage.
    """
    places = find_places(derivations, root)
    if not (derivations or root) and not Path("derivations").is_dir():
        refuse(
            "there is no folder derivations here: change to its parent, or give --derivations DIR"
        )
    if better and check:
        refuse("--improve and --check: give only one; a check writes nothing")
    if better:
        offer_forms((), places, write=True, limit=SEARCH_LIMIT)
    from mechproof.pipeline import stages

    with ending(PipelineError, fail):
        done = stages.regenerate(
            find_locations((), places),
            places.generated,
            check=check,
            use_cache=not no_cache,
            limit=limit,
            progress=show_progress,
        )
    for change in done.changes:
        step = f"{'removed' if change.is_removal else 'wrote'} {change.name}"
        say(change.describe() if check else step)
    say(f"{places.generated}: {len(done.files)} files, {_count(done.changes, check)}")
    if check and done.changes:
        say(f"run `mechproof regenerate{places.options}`")
        for other in list_other_versions("regenerate"):
            say(f"generated files may differ because of {other}: {suggest_install('regenerate')}")
        raise typer.Exit(1)
    if done.systems and not (check or places.is_packaged):
        folder, package = places.generated.absolute().parent, places.generated.name
        say(f"in Python, started in {folder}: from {package} import {', '.join(done.systems)}")


@app.command(epilog=RULE)
def measure(
    quantities: options.Quantities = None,
    quick: Annotated[
        bool,
        typer.Option("--quick", help="Use few points and short timings: seconds per quantity."),
    ] = False,
    processes: Annotated[
        int,
        typer.Option("--processes", metavar="N", min=1, help="Measure accuracy in N processes."),
    ] = 1,
    derivations: options.Derivations = None,
    root: options.Root = None,
) -> None:
    """Measure accuracy and time of all ways to compute; write DIR/../generated/measured.

    `mechproof chart` draws what was measured. A quick run writes into the folder `quick` there,
    which `chart` and `choose` read only if told to. Times are always taken in one process.

    Exit status 0: measured; 1: a derivation fails; 2: bad usage.
    """
    places = find_places(derivations, root)
    if not places.generated.is_dir():
        refuse(f"there is no folder {places.generated}: `mechproof regenerate` writes it")
    from mechproof.pipeline import stages

    directory = None if places.is_packaged else places.derivations
    with ending(ValueError, refuse), ending(DerivationError, fail):
        measured = stages.measure(
            quantities or (),
            directory,
            places.generated,
            quick=quick,
            processes=processes,
            progress=show_progress,
        )
    with ending(PipelineError, fail):
        for file, headline in measured:
            say(f"{file}: {headline}" if headline else str(file))


def _count(changes: Sequence[Change], check: bool) -> str:
    if not changes:
        return "all as regenerated"
    if check:
        return "differences found"
    removed = sum(change.is_removal for change in changes)
    return f"{len(changes) - removed} written, {removed} removed"


def show_welcome(places: Places) -> None:
    """Print which papers are here and what the commands do with them."""
    systems = list(find_systems(places.derivations))
    where = "that come with the package" if places.is_packaged else f"in {places.derivations}"
    say("Formulas of mechanism papers in; proved verdicts and fast, accurate kernels out.\n")
    say(f"Papers {where}: {', '.join(systems) or 'none'}\n")
    table = Table.grid(padding=(0, 2, 0, 0))
    table.add_column(no_wrap=True)
    table.add_column()
    for line, what in list_examples(places):
        table.add_row(Text(f"  mechproof {line}", style="bold"), Text(what))
    console.print(table)
    say("\nmechproof --help lists all commands, mechproof COMMAND --help their options.")


def list_examples(places: Places) -> Iterator[tuple[str, str]]:
    """Yield each command that works with what is here, and what it does."""
    systems = list(find_systems(places.derivations))
    kernels = [name for name in systems if (places.generated / f"{name}.py").is_file()]
    measured = [path.stem for path in (places.generated / FOLDER).glob("*.json")]
    names = {
        "SYSTEM": kernels or systems,
        "KERNELS": kernels,
        "QUANTITY": sorted(name for name in measured if name.startswith(tuple(kernels))),
        "figures": ["figures"] if any(places.derivations.glob("[!_.]*/pictures.py")) else [],
        "regenerate": ["regenerate"] if Path("derivations").is_dir() else [],
    }
    for line, what in EXAMPLES.items():
        if all(here or word not in line for word, here in names.items()):
            for word, here in names.items():
                line = line.replace(word, next(iter(here), ""))
            yield line, what
