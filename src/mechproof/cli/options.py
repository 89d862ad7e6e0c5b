"""Common parts of commands: options, the places of derivations, unwrapped output, progress."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryFile
from typing import Annotated, Any, NoReturn

import typer
from rich.console import Console
from rich.markup import escape
from rich.progress import Progress, SpinnerColumn, TextColumn, TimeElapsedColumn
from rich.text import Text

from mechproof.derivation import DerivationError, find_systems, packaged_directory
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import State, Verdict
from mechproof.tools.files import write_whole

console = Console(highlight=False, emoji=False)
errors = Console(stderr=True, highlight=False, emoji=False)
RULE = (
    "Derivations are taken from --derivations DIR (or ROOT/derivations with --root ROOT), else "
    "from the folder ./derivations if there is one, else from the package. Files generated from "
    "DIR go to DIR/../generated."
)


def say(text: str | Text) -> None:
    """Print to stdout; output that is piped or redirected is not wrapped."""
    console.print(text, markup=False, soft_wrap=not console.is_terminal)


def refuse(message: str) -> NoReturn:
    """Exit with status 2: bad usage."""
    _complain(message)
    raise typer.Exit(2)


def fail(message: str) -> NoReturn:
    """Exit with status 1: the request failed."""
    _complain(message)
    raise typer.Exit(1)


def _complain(message: str) -> None:
    errors.print(message, style="red", markup=False, soft_wrap=True)


@contextmanager
def ending(
    kinds: type[Exception] | tuple[type[Exception], ...],
    end: Callable[[str], NoReturn],
    said: str = "",
) -> Iterator[None]:
    """End the command with what was `said` and the message of an error of these kinds."""
    try:
        yield
    except kinds as error:
        end(f"{said}{error}")


@contextmanager
def show_progress(title: str) -> Iterator[Callable[[str], None]]:
    """Show progress on a terminal, redrawn only on reports, as forking is unsafe with a thread."""
    columns = (SpinnerColumn(), TextColumn("{task.description}"), TimeElapsedColumn())
    errors.print(title, markup=False, soft_wrap=True)
    progress = Progress(
        *columns, console=errors, transient=True, auto_refresh=False, disable=not errors.is_terminal
    )
    with progress:
        task = progress.add_task(escape(title), total=None)
        yield lambda text: progress.update(task, description=escape(text), refresh=True)


@dataclass(frozen=True)
class Places:
    """A folder of derivations, the folder generated from it, and the options that name them."""

    derivations: Path
    generated: Path
    options: str = ""

    @property
    def is_packaged(self) -> bool:
        """Return whether the derivations are those that come with the package."""
        return self.derivations.resolve() == packaged_directory().resolve()


def find_places(derivations: Path | None, root: Path | None) -> Places:
    """Return the folders by the rule; refuse an option that names no folder."""
    if derivations and root:
        refuse("--derivations and --root: give only one")
    if root:
        return _check(root / "derivations", f" --root {root}")
    if derivations:
        return _check(derivations, f" --derivations {derivations}")
    here = Path("derivations")
    return _check(here if here.is_dir() else packaged_directory(), "")


def _check(derivations: Path, options: str) -> Places:
    if not derivations.is_dir():
        refuse(f"{options.strip()}: there is no folder {derivations}")
    named = derivations if derivations.name.strip(".") else derivations.resolve()
    return Places(derivations, named.parent / "generated", options)


def read_out(text: str | Path, is_file: bool = False) -> Path:
    """Return the folder or file that --out names; refuse one that cannot be written.

    It need not exist.
    """
    if not str(text):
        refuse(f"--out: is empty; a {'file' if is_file else 'folder'} is needed")
    target = Path(text)
    places = target.parents if is_file else (target, *target.parents)
    nearest = next(place for place in places if os.path.lexists(place))
    if not nearest.is_dir():
        refuse(f"--out {target}: {nearest} is not a folder")
    try:
        with TemporaryFile(dir=nearest):
            return target
    except OSError as error:
        refuse(f"--out {target}: cannot write to {nearest.absolute()}: {error.strerror}")


def find_location(name: str, directory: Path, sources: Sequence[str] = ()) -> Path:
    """Return the place of a system in a folder, or of a file or folder named by its path.

    `sources` are the suffixes of papers' own sources, if the command accepts these.
    """
    systems = find_systems(directory)
    if name in systems:
        return systems[name]
    path = Path(name)
    if (path.suffix in (".py", *sources) and path.is_file()) or (path / "__init__.py").is_file():
        return path
    known = ", ".join(systems) or "none"
    also = " or FILE.tex" if sources else ""
    refuse(
        f"{name!r} is neither a file FILE.py{also}, nor a folder with an __init__.py, nor one of "
        f"the systems of {directory}: {known}"
    )


def find_locations(names: Iterable[str], places: Places, sources: Sequence[str] = ()) -> list[Path]:
    """Return the places of named papers, or of all derivations if none is named."""
    with ending(DerivationError, fail):
        if names:
            found = dict.fromkeys(names)
            return [find_location(name, places.derivations, sources) for name in found]
        locations = list(find_systems(places.derivations).values())
    if not locations:
        refuse(f"there is no derivation in {places.derivations}")
    return locations


Texts = list[str] | None
Names = Annotated[
    Texts, typer.Option("--name", help="A name of several letters for one quantity: AC.")
]
Factors = Annotated[
    Texts, typer.Option("--factor", help="A letter that multiplies the bracket after it: a(1+e).")
]
Values = Annotated[Texts, typer.Option("--let", help="The value of a letter: k=a/b, C=0.")]
Papers = Annotated[
    Texts,
    typer.Argument(
        metavar="[PAPER] ...",
        help="Systems, files FILE.py, folders of derivations, or papers FILE.tex; by default all "
        "systems.",
    ),
]
Systems = Annotated[
    Texts, typer.Argument(help="Systems, files FILE.py or folders of derivations; by default all.")
]
Quantities = Annotated[
    Texts, typer.Argument(help="Quantities, systems or system.quantity; by default all.")
]
Derivations = Annotated[
    Path | None,
    typer.Option("--derivations", metavar="DIR", help="The folder that holds the derivations."),
]
Root = Annotated[
    Path | None,
    typer.Option(
        "--root", metavar="ROOT", help="The folder that holds derivations/ and generated/."
    ),
]
NoCache = Annotated[
    bool,
    typer.Option(
        "--no-cache", help="Judge every row again; neither read nor keep stored verdicts."
    ),
]
Limit = Annotated[
    float,
    typer.Option(
        "--limit",
        metavar="SECONDS",
        min=0,
        help="Stop a row, or the loading of a derivation, after this time and report an error.",
    ),
]
Pictures = Annotated[
    Path,
    typer.Option(
        "--out", metavar="FOLDER", help="The folder to write the pictures to.", parser=read_out
    ),
]
Rows = Annotated[Path | None, typer.Option("--json", help="Also write the rows to this file.")]
FailOn = Annotated[
    list[str] | None,
    typer.Option(
        "--fail-on",
        metavar="OUTCOME",
        help="Exit with 1 if a row has this outcome: a verdict, not-read, not-judged; or none.",
    ),
]
NONE = "none"
# Outcomes by the words of the option: REFUTED as refuted, `not read` as not-read.
OUTCOMES = {
    str(outcome.value).lower().replace("_", "-").replace(" ", "-"): str(outcome.value)
    for outcome in (*Verdict, State.NOT_READ, State.NOT_JUDGED, State.SKIPPED)
}
# Files that would be overwritten if the value of an option were left out.
PAPERS = (".tex", ".md", ".py")


def paste(latex: str, said: Mapping[str, Texts], lower_limit: str = "") -> Pasted:
    """Return the pasted LaTeX together with what options say of its letters."""
    texts: dict[str, Any] = {name: tuple(one or ()) for name, one in said.items()}
    return Pasted(latex, lower_limit=lower_limit, **texts)


def read_outcomes(words: list[str] | None, default: Iterable[str]) -> frozenset[str]:
    """Return the outcomes that make a command fail; refuse unknown words."""
    if not words:
        return frozenset(default)
    said = [word.strip().lower().replace("_", "-") for x in words for word in x.split(",")]
    if unknown := [word for word in said if word not in (*OUTCOMES, NONE)]:
        refuse(f"--fail-on {unknown[0]}: must be one of {', '.join((*OUTCOMES, NONE))}")
    return frozenset(OUTCOMES[word] for word in said if word != NONE)


def clear_json(file: Path | None) -> None:
    """Refuse a path that cannot be the file of --json; remove that of an earlier run.

    This run may fail, and must not leave an old file behind.
    """
    if file is None:
        return
    folder = file.absolute().parent
    if file.suffix in PAPERS:
        refuse(f"--json {file}: has the name of a paper; choose another file")
    if file.is_dir():
        refuse(f"--json {file}: is a folder; a file is needed")
    if not folder.is_dir():
        refuse(f"--json {file}: the folder {folder} does not exist")
    try:
        if file.is_file():
            file.unlink()
    except OSError as error:
        refuse(f"--json {file}: {error.strerror}")


def write_json(file: Path | None, text: str) -> None:
    """Write the file of --json, if one is named."""
    try:
        if file:
            write_whole(file, text)
    except OSError as error:
        fail(f"--json {file}: {error.strerror}")
