"""The command that proves bounds of the rounding errors of programs in doubles."""

from __future__ import annotations

from decimal import ROUND_CEILING, ROUND_FLOOR
from pathlib import Path
from typing import Annotated

import typer

from mechproof.cli import options
from mechproof.cli.options import fail, refuse, say, show_progress
from mechproof.coq.checker import CheckerError
from mechproof.fpcore import FPCoreError
from mechproof.pipeline import bounding
from mechproof.pipeline.bound_scripts import DIGITS, prove_in_coq, round_digits
from mechproof.pipeline.bounds_page import CITED, compare
from mechproof.pipeline.pasted import PastedError
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.roundoff.boxed import Convention
from mechproof.tools.files import write_whole
from mechproof.tools.made import ForeignFileError


def bound(
    sources: Annotated[
        list[str],
        typer.Argument(
            metavar="FILE.fpcore ... | EXPRESSION",
            help="FPCore files; or, in LaTeX, an expression, or an equation for its right side.",
        ),
    ],
    where: Annotated[
        options.Texts, typer.Option("--where", help="The range of a letter: 1<=x<=2.")
    ] = None,
    values: options.Values = None,
    names: options.Names = None,
    factors: options.Factors = None,
    relative: Annotated[
        bool,
        typer.Option(
            "--relative", help="Bound the relative error: the error over the exact value."
        ),
    ] = False,
    rounded_inputs: Annotated[
        bool,
        typer.Option(
            "--rounded-inputs",
            help="Inputs are real numbers that are first rounded, not doubles.",
        ),
    ] = False,
    ulps: Annotated[
        float,
        typer.Option(
            "--ulps", metavar="N", help="The largest error of sin, exp and the like, in ulps."
        ),
    ] = 1.0,
    tolerance: Annotated[
        float,
        typer.Option(
            "--tolerance",
            metavar="SHARE",
            help="How close a bound must come to the best one, as a share.",
        ),
    ] = bounding.TOLERANCE,
    parts: Annotated[
        int,
        typer.Option("--parts", metavar="N", min=1, help="Divide the box into at most N parts."),
    ] = bounding.PARTS,
    table: Annotated[
        Path | None,
        typer.Option(
            "--table",
            metavar="PAGE.md",
            help="Write a page that compares these bounds with those of Gappa and FPTaylor, if "
            "installed, and with those in cited.json next to the first file.",
        ),
    ] = None,
    coq: Annotated[
        Path | None,
        typer.Option(
            "--coq",
            metavar="FOLDER",
            help="Also have Coq prove the bounds, and write the scripts that it accepts.",
        ),
    ] = None,
    json_file: Annotated[
        Path | None, typer.Option("--json", help="Also write the bounds to this file.")
    ] = None,
) -> None:
    """Prove bounds on the rounding errors of straight-line programs in doubles.

    An FPCore file gives each program and, by :pre, the box of its arguments. An expression is
    computed as it would be emitted; --where gives the ranges of its letters. The proved bound holds
    for every input in the box. The worst input that a search finds is printed next to it.

    Exit status 0: every program is bounded; 1: one is not; 2: bad usage, or a program that cannot
    be read or is not straight-line.
    """
    options.clear_json(json_file)
    try:
        convention = Convention(rounded_inputs, relative, ulps)
        said = {"where": where, "values": values, "names": names, "factors": factors}
        pasted = options.paste(sources[0], said)
        boundings = _read(sources, pasted, any(said.values()))
        if not 0 < tolerance < 1:
            refuse(f"--tolerance {tolerance}: must be above 0 and below 1")
        if table:
            _write_table(table, sources, boundings)
            return
        bounds = []
        with show_progress("bounding rounding errors") as report:
            for found in bounding.bound_all(boundings, convention, tolerance, parts, report):
                bounds.append(found)
                for line in _describe(found):
                    say(line)
        if coq:
            _prove(boundings, bounds, convention, coq)
    except (FPCoreError, PastedError, ForeignFileError, ValueError) as error:
        refuse(str(error))
    except (ArithmeticError, CheckerError) as error:
        fail(str(error))
    except OSError as error:
        fail(f"--coq {coq}: {error.strerror}")
    options.write_json(json_file, bounding.bounds_to_json(bounds))
    if any(found.open for found in bounds):
        raise typer.Exit(1)


def _prove(
    boundings: list[bounding.Bounding],
    bounds: list[bounding.ProvedBound],
    convention: Convention,
    folder: Path,
) -> None:
    with show_progress("running Coq") as report:
        proved = [found.proved for found in bounds]
        checked = prove_in_coq(boundings, proved, convention, folder, report)
    for one in checked:
        told = f"no proof in Coq: {one.reason}"
        if one.bound is not None:
            told = f"Coq proves {float(one.bound):.{DIGITS}g} ({folder / one.file})"
        say(f"{one.name}: {told}")


def _write_table(page: Path, sources: list[str], boundings: list[bounding.Bounding]) -> None:
    if not sources[0].endswith(bounding.FPCORE) or page.suffix != ".md":
        refuse(f"--table {page}: the page must end in .md, and the sources must be FPCore files")
    with show_progress("comparing bounds") as report:
        text = compare(boundings, Path(sources[0]).parent / CITED, report)
    try:
        write_whole(page, text)
    except OSError as error:
        fail(f"--table {page}: {error.strerror}")
    say(f"wrote {page}")


def _read(sources: list[str], pasted: Pasted, is_said: bool) -> list[bounding.Bounding]:
    files = [source for source in sources if source.endswith(bounding.FPCORE)]
    if len(files) < len(sources):
        if len(sources) > 1:
            other = next(source for source in sources if source not in files)
            refuse(f"{other}: does not end in .fpcore; give an expression alone, in quotes")
        return [bounding.read_pasted(pasted)]
    if is_said:
        refuse("a file gives the ranges of its own arguments, in :pre")
    return [one for file in files for one in bounding.read_boundings(Path(file))]


def _describe(found: bounding.ProvedBound) -> list[str]:
    """Return the lines about a bound; the proved bound is rounded up, the error found down."""
    kind = "relative error" if found.relative else "error"
    if found.open:
        return [f"{found.name}: no bound of the {kind} is proved where {found.open}"]
    inputs = ", inputs rounded" if found.rounded_inputs else ""
    lines = [
        f"{found.name}: {kind} at most {round_digits(found.proved, ROUND_CEILING):g}{inputs}"
        f" ({found.parts} parts, {found.seconds:.1f} s)"
    ]
    if found.at:
        at = ", ".join(f"{name} = {float(value)!r}" for name, value in found.at.items())
        lines.append(f"  found {round_digits(found.found, ROUND_FLOOR):g} at {at}")
    lines.append(f"  as long as {' and '.join(found.assumptions)}")
    return lines
