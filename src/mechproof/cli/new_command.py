"""The command that begins a paper: a file that verifies, to be changed line by line."""

from __future__ import annotations

from importlib.resources import files
from pathlib import Path
from string import Template
from typing import Annotated

import typer

from mechproof.cli.options import ending, refuse, say
from mechproof.document.transcription import Transcription
from mechproof.record import RESERVED
from mechproof.record.exactness import is_name
from mechproof.sources.paper_files import MARKDOWN, SUFFIXES
from mechproof.tools.files import write_whole

SKELETONS = files("mechproof.cli").joinpath("skeletons")


def new(
    file: Annotated[
        Path, typer.Argument(metavar="FILE.py|FILE.tex", help="The file to be written.")
    ],
) -> None:
    """Write a small paper that verifies, as a start.

    FILE.tex is a source with its block of letters; FILE.py is a derivation with a row and a kernel,
    which takes letters and prints from a source of the same name if there is one next to it.

    Exit status 0: written; 2: the file exists already, or its name is not allowed.
    """
    if file.exists():
        hint = "; `mechproof check --draft` writes a block of letters for it"
        refuse(f"{file}: exists already{hint if file.suffix == '.tex' else ''}")
    if file.suffix == ".tex":
        write_whole(file, SKELETONS.joinpath("paper.tex").read_text(encoding="utf-8"))
        say(f"{file}: written; mechproof check {file}")
        return
    if file.suffix != ".py" or not is_name(file.stem) or file.stem in RESERVED:
        refuse(
            f"{file}: must end in .tex for a paper or in .py for a derivation, whose name may "
            f"have letters, digits and underscores only and must not be {', '.join(RESERVED)}"
        )
    write_whole(file, _write_derivation(file))
    say(f"{file}: written; mechproof verify {file}")


def _write_derivation(file: Path) -> str:
    values = {"system": file.stem, "title": file.stem.replace("_", " ").capitalize()}
    beside = (file.with_suffix(s) for s in SUFFIXES if s not in MARKDOWN)
    source = next((one for one in beside if one.is_file()), None)
    if source is None:
        return _fill("derivation.txt", values)
    with ending(ValueError, refuse):
        letters = [v.symbol.name for v in Transcription(source).variables]
    names = [name for name in letters if is_name(name)]
    symbols = f'{", ".join(names)}{","[: len(names) == 1]} = PRINT.symbols("{" ".join(names)}")\n'
    return _fill(
        "derivation_of_source.txt",
        {**values, "source": source.name, "symbols": symbols if names else ""},
    )


def _fill(skeleton: str, values: dict[str, str]) -> str:
    text = SKELETONS.joinpath(skeleton).read_text(encoding="utf-8")
    return Template(text).substitute(values)
