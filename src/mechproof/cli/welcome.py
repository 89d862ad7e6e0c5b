"""What can be done here: the commands as one would type them, with the papers of this place."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from rich.table import Table
from rich.text import Text

from mechproof.cli.console import console, say
from mechproof.cli.paths import Places
from mechproof.derivation import find_systems
from mechproof.measured import FOLDER

# Command -> what it does; the words in capitals stand for what is here.
EXAMPLES = {
    "verify": "judge all papers: findings first",
    "verify SYSTEM": "judge one, with --all every row",
    "new FILE.py": "begin a paper of your own, or FILE.tex",
    "verify FILE.py": "judge it",
    "report": "all of it as pages for a browser",
    r"check '\sin 2x=2\sin x'": "judge one equation",
    "figures": "the papers' figures, redrawn",
    "chart QUANTITY": "time against error",
    "emit c KERNELS --out c": "kernels as C99",
    "measure --quick": "accuracy and speed on this machine",
    "regenerate --check": "is what is generated up to date?",
}


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
