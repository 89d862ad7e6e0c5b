"""Command line: verify papers, regenerate kernels and ledger, measure what they lose and cost."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Any, NoReturn

import typer
from rich.console import Console
from rich.markup import escape
from rich.progress import Progress, SpinnerColumn, TextColumn, TimeElapsedColumn
from rich.table import Table
from rich.text import Text

from mechproof.codegen.forms import form_rows
from mechproof.codegen.regenerate import compare_or_update, render_package
from mechproof.derivation import DerivationError, find_systems, load_paper, packaged_directory
from mechproof.proof.ledger import PLAIN, judge_paper, show_totals, to_json, to_markdown
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Paper

app = typer.Typer(
    add_completion=False,
    no_args_is_help=True,
    help="Prove or refute the formulas of mechanism papers; generate kernels from them.",
    pretty_exceptions_show_locals=False,
)
console = Console(highlight=False)
errors = Console(stderr=True, highlight=False)

STYLES = {
    Verdict.PROVED: "green",
    Verdict.DEFINITION: "dim",
    Verdict.REFUTED: "bold red",
    Verdict.ILL_FORMED: "bold red",
    Verdict.CONDITIONAL: "yellow",
    Verdict.CONVENTION: "yellow",
    Verdict.UNDERDETERMINED: "cyan",
    Verdict.ENCLOSED: "magenta",
    Verdict.UNDECIDED: "bold magenta",
}


@app.command()
def verify(
    papers: Annotated[
        list[str] | None,
        typer.Argument(help="Systems of the package, or files FILE.py; all systems if none."),
    ] = None,
    json_file: Annotated[
        Path | None, typer.Option("--json", help="Also write the rows to this file.")
    ] = None,
) -> None:
    """Derive and judge every row of the papers, and print the ledger.

    Exit status 0: every row has a verdict, and every UNDECIDED one says why it must stay open;
    1: a row is UNDECIDED without that, or a derivation fails; 2: bad usage.
    """
    files = [_find_file(name) for name in papers or sorted(find_systems(packaged_directory()))]
    if json_file and json_file.is_dir():
        _refuse(f"--json {json_file}: is a folder, a file is needed")
    if json_file and not json_file.absolute().parent.is_dir():
        _refuse(f"--json {json_file}: the folder {json_file.absolute().parent} does not exist")
    judged = [(paper, _judge(paper)) for paper in map(_load, files)]
    for paper, judgements in judged:
        _print_ledger(paper, judgements)
    rows = [row for _, judgements in judged for row in judgements]
    if json_file:
        json_file.write_text(to_json(rows), encoding="utf-8")
    if any(row.verdict is Verdict.UNDECIDED and not row.may_stay_open for row in rows):
        raise typer.Exit(1)


@app.command()
def regenerate(
    check: Annotated[
        bool, typer.Option("--check", help="Write nothing; fail on any difference.")
    ] = False,
    root: Annotated[
        Path, typer.Option(help="The folder that holds derivations/ and generated/.")
    ] = Path(),
) -> None:
    """Write the kernels and the ledger of ROOT/derivations into ROOT/generated.

    Exit status 0: nothing to do or written; 1: with --check, a file is missing, surplus or
    different, or a derivation fails; 2: bad usage.
    """
    source, target = root / "derivations", root / "generated"
    if not source.is_dir():
        _refuse(f"--root {root}: there is no folder {source}; run it where derivations/ lies")
    papers = [_load(file) for file in find_systems(source).values()]
    judged = [(paper, _judge(paper)) for paper in papers]
    files = render_package(papers)
    files["ledger.json"] = to_json([row for _, judgements in judged for row in judgements])
    files["LEDGER.md"] = to_markdown(judged)
    differences = compare_or_update(target, files, check=check)
    for difference in differences:
        console.print(difference if check else difference.splitlines()[0], markup=False)
    console.print(f"{target}: {len(files)} files, {_count(differences, check)}")
    if check and differences:
        raise typer.Exit(1)


@app.command()
def measure(
    quantities: Annotated[
        list[str] | None,
        typer.Argument(help="Quantities, systems or system.quantity; all if none."),
    ] = None,
    quick: Annotated[
        bool, typer.Option("--quick", help="Few points, short times, no charts: under a minute.")
    ] = False,
    root: Annotated[Path, typer.Option(help="The folder that holds generated/.")] = Path(),
) -> None:
    """Measure accuracy and time of all forms and peers; write ROOT/generated/measured.

    A quick run writes into its folder `quick`, which nothing else reads.

    Exit status 0: measured; 2: bad usage.
    """
    from mechproof.lab.chart import draw_charts
    from mechproof.lab.measure import measure as measure_subject
    from mechproof.lab.measure import write_record
    from mechproof.lab.subject import find_subjects
    from mechproof.lab.table import write_tables

    if not (root / "generated").is_dir():
        _refuse(f"--root {root}: there is no folder {root / 'generated'}")
    target = root / "generated" / "measured" / ("quick" if quick else "")
    try:
        subjects = find_subjects(tuple(quantities or ()))
    except ValueError as error:
        _refuse(str(error))
    for number, subject in enumerate(subjects, start=1):
        where = f"{subject.name} ({number} of {len(subjects)})"
        with _show_progress(where) as report:
            record = measure_subject(subject, quick=quick, report=report)
            if not quick:
                report("charts")
                draw_charts(subject, record, target)
        file = write_record(record, target)
        console.print(f"{file}: {show_record(record)}", markup=False)
    console.print(str(write_tables(target)), markup=False)


def show_record(record: Mapping[str, Any]) -> str:
    """Return the headline of a record: the worst error of the kernel against its bar."""
    rows = [r for r in record["accuracy"] if r["form"] == "kernel"]
    held = [w for r in rows if (w := r["worst_where_the_bar_holds"]) is not None]
    worst = max([*held, record["worst_found"]["scaled"]])
    undecided = sum(r["undecided"] for r in rows)
    points = sum(r["points"] for r in rows)
    return (
        f"worst {worst:.3g} of {record['bar']:.3g} eps of {record['scale']}; "
        f"{points} points, {undecided} undecided"
    )


@contextmanager
def _show_progress(title: str) -> Iterator[Callable[[str], None]]:
    columns = (SpinnerColumn(), TextColumn("{task.description}"), TimeElapsedColumn())
    errors.print(f"{title}: measuring", markup=False)
    with Progress(*columns, console=errors, transient=True) as progress:
        task = progress.add_task(title, total=None)
        yield lambda text: progress.update(task, description=f"{title}: {text}")


def _count(differences: Sequence[str], check: bool) -> str:
    if not differences:
        return "all as regenerated"
    return "differences found" if check else f"{len(differences)} written"


def _find_file(name: str) -> Path:
    systems = find_systems(packaged_directory())
    if name in systems:
        return systems[name]
    if name.endswith(".py") and Path(name).is_file():
        return Path(name)
    _refuse(f"{name!r} is neither a file FILE.py nor one of the systems {', '.join(systems)}")


def _refuse(message: str) -> NoReturn:
    errors.print(message, style="red", markup=False)
    raise typer.Exit(2)


def _load(file: Path) -> Paper:
    try:
        return load_paper(file)
    except DerivationError as error:
        errors.print(str(error), style="red", markup=False)
        raise typer.Exit(1) from error


def _judge(paper: Paper) -> list[Judgement]:
    """Judge all rows and the forms of the kernels, showing which row is at work."""
    extra = form_rows(paper)
    errors.print(f"{paper.system}: judging {len(paper.rows) + len(extra)} rows", markup=False)
    columns = (SpinnerColumn(), TextColumn("{task.description}"), TimeElapsedColumn())
    with Progress(*columns, console=errors, transient=True) as progress:
        task = progress.add_task(escape(paper.system), total=None)
        count = len(paper.rows) + len(extra)
        return judge_paper(paper, extra, _report_to(progress, task, paper.system, count))


def _report_to(progress: Progress, task: object, system: str, count: int) -> Callable[[str], None]:
    done = iter(range(1, count + 1))

    def report(number: str) -> None:
        text = f"{system}: row {next(done)} of {count}, {number}"
        progress.update(task, description=escape(text))  # type: ignore[arg-type]

    return report


def _print_ledger(paper: Paper, judgements: Sequence[Judgement]) -> None:
    title = Text(f"{paper.system}: {paper.citation}")
    table = Table(title=title, title_justify="left", expand=True)
    table.add_column("number", ratio=3)
    table.add_column("verdict", no_wrap=True, min_width=15)
    table.add_column("rung", ratio=2)
    table.add_column("reason", ratio=5, no_wrap=True, overflow="ellipsis")
    for row in judgements:
        marks = f" ({', '.join(row.marks)})" if row.marks else ""
        verdict = Text(row.verdict, style=STYLES[row.verdict])
        table.add_row(Text(f"{row.number}{marks}"), verdict, Text(row.rung), Text(row.reason))
    console.print(table)
    for row in judgements:
        if row.verdict not in PLAIN:
            _print_details(row)
    for label, ours in (("printed", False), ("ours", True)):
        console.print(f"{paper.system}, {label}: {show_totals(judgements, ours)}", markup=False)
    console.print()


def _print_details(row: Judgement) -> None:
    console.print(Text(f"{row.number}: ").append(row.verdict, style=STYLES[row.verdict]))
    lines = [("printed", _plain(row.printed_latex)), ("reason", row.reason)]
    for item in row.evidence:
        at = ", ".join(f"{name} = {value}" for name, value in item.at.items())
        sides = [f"at {at}"] if at else []
        sides += [f"printed {item.printed}"] if item.printed else []
        sides += [f"rebuilt {item.rebuilt}"] if item.rebuilt else []
        lines.append(("evidence", "; ".join([item.what, *sides])))
    if row.corrected_latex:
        proof = f"   (proved: {row.corrected_by})" if row.corrected_by else ""
        lines.append(("corrected", row.corrected_latex + proof))
    for label, text in lines:
        console.print(Text(f"  {label:9} ", style="dim").append(Text(text, style="default")))


def _plain(latex: str) -> str:
    r"""Drop the \text{} around a sentence."""
    sentence = re.fullmatch(r"\\text\{([^\\{}]*)\}", latex)
    return sentence[1] if sentence else latex


def main() -> None:
    """Run the command line."""
    app()
