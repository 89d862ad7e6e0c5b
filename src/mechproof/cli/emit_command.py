"""The command that writes kernels for other languages."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from mechproof.cli import options
from mechproof.cli.options import (
    Places,
    ending,
    fail,
    find_locations,
    find_places,
    read_out,
    refuse,
    say,
    show_progress,
)
from mechproof.derivation import DerivationError, find_systems, packaged_directory
from mechproof.pipeline.judging import PipelineError
from mechproof.tools.files import write_whole

if TYPE_CHECKING:
    from mechproof.pipeline.emission import Emitted

Sizes = dict[str, float | tuple[float, ...]]

app = typer.Typer(
    help="Write kernels for other languages.", no_args_is_help=True, rich_markup_mode="markdown"
)


@app.command(name="c")
def emit_c(
    systems: options.Systems = None,
    out: Annotated[
        Path,
        typer.Option(metavar="FOLDER", help="The folder to write the files to.", parser=read_out),
    ] = Path("c"),
    float32: Annotated[
        bool,
        typer.Option(
            "--float32", help="Compute in float, for processors without double precision."
        ),
    ] = False,
    derivatives: Annotated[
        bool,
        typer.Option(
            "--derivatives", help="Write the derivatives with respect to every argument instead."
        ),
    ] = False,
    error: Annotated[
        float | None,
        typer.Option("--error", help="Tailor one SYSTEM.QUANTITY to this absolute error bound."),
    ] = None,
    let: Annotated[
        list[str] | None,
        typer.Option(
            "--let",
            metavar="NAME=VALUE",
            help="With --error: the value of a parameter, or its range LOW:HIGH.",
        ),
    ] = None,
    name: Annotated[
        str | None,
        typer.Option(
            "--name",
            help="With --error: the name of the files, and the prefix of the functions; by default "
            "SYSTEM_tailored.",
        ),
    ] = None,
    derivations: options.Derivations = None,
) -> None:
    """Write a header and a source in C99 for each system; they need `<math.h>` and `<stddef.h>`.

    A Makefile next to them builds shared libraries; link with -lm.

    Each kernel is a function of one point; the function with _array after its name takes many.
    Sums over axes of any length take the number of their terms first. Quantities that are computed
    in one pass are returned through pointers.

    With --derivatives the functions are called SYSTEM_derivatives_QUANTITY, store one number for
    each argument, and are written to separate files.

    With --error a kernel for fixed parameters is written, as cheap as the error permits:
    elliptic_planetary.position --error 1e-9 --let R1=66 --let R2=16 --let e=0.475, with
    --let phi1=0:10 for the range of the running variable. A file that holds something else is not
    overwritten: give a second kernel another --name.

    Nothing is written unless every kernel is PROVED, as `mechproof verify` shows.

    Exit status 0: written; 1: a kernel is not PROVED, or a derivation fails or has no kernel for C;
    2: bad usage.
    """
    if error is None and (let or name is not None):
        refuse(f"{'--let' if let else '--name'} needs --error")
    if float32 + derivatives + (error is not None) > 1:
        refuse("--error, --float32 and --derivatives exclude each other")
    if error is not None:
        folder = _find_folder(systems or [], find_places(derivations, None))
        _emit_tailored(systems or [], error, _read_sizes(let or []), out, name, folder)
        return
    _refuse_quantities(systems or [])
    from mechproof.pipeline import emission

    locations = find_locations(systems or (), find_places(derivations, None))
    emitted = emission.emit_c(
        locations, float32=float32, derivatives=derivatives, progress=show_progress
    )
    _write_all(emitted, out, must_have=bool(systems))


# What is written for a system, by the name of the command.
SCRIPTS = {
    "octave": "Write each kernel as a function file for Octave or MATLAB, for numbers or arrays.",
    "array-api": "Write array functions for each system, for JAX, PyTorch and others.",
    "javascript": "Write a JavaScript module for each system, with functions of numbers.",
    "structured-text": "Write functions of Structured Text (IEC 61131-3) for each system.",
}


def _add_script(language: str, text: str) -> None:
    def emit(
        systems: options.Systems = None,
        out: Annotated[
            Path | None,
            typer.Option(
                metavar="FOLDER", help="The folder to write the files to.", parser=read_out
            ),
        ] = None,
        derivations: options.Derivations = None,
    ) -> None:
        from mechproof.pipeline import emission

        _refuse_quantities(systems or [])
        locations = find_locations(systems or (), find_places(derivations, None))
        emitted = emission.emit_scripts(
            language.replace("-", "_"), locations, progress=show_progress
        )
        _write_all(emitted, out or Path(language))

    emit.__doc__ = f"""{text}

    The operations are those of the NumPy kernels, with the functions of the language's own library.
    Where there is no fused multiply-add, rounding errors of products come from error-free products.
    Kernels that the language cannot compute, or that its compilers may spoil, are left out and
    named.

    Nothing is written unless every kernel is PROVED, as `mechproof verify` shows.

    Exit status 0: written; 1: a kernel is not PROVED, or a derivation fails; 2: bad usage.
    """
    app.command(name=language)(emit)


for _language, _text in SCRIPTS.items():
    _add_script(_language, _text)


def _refuse_quantities(names: list[str]) -> None:
    """Refuse SYSTEM.QUANTITY: without --error only whole systems are written."""
    known = find_systems(packaged_directory())
    for name in names:
        system, dot, quantity = name.partition(".")
        if dot and system in known and quantity != "py":
            refuse(
                f"{name}: a single quantity needs --error, and --let for each of its sizes; "
                f"without --error, name the system {system}"
            )


def _find_folder(names: list[str], places: Places) -> Path | None:
    """Return the folder of the derivation that is tailored, None for one of the package."""
    if len(names) != 1:
        refuse("--error needs exactly one SYSTEM.QUANTITY")
    is_there = names[0].partition(".")[0] in find_systems(places.derivations)
    return places.derivations if is_there and not places.is_packaged else None


def _emit_tailored(
    names: list[str], error: float, sizes: Sizes, out: Path, called: str | None, folder: Path | None
) -> None:
    from mechproof.tailoring import tailor

    arguments: dict[str, Any] = {**sizes}
    with ending((ValueError, TypeError), refuse), ending(DerivationError, fail):
        kernel = tailor(names[0], error=error, derivations=folder, **arguments)
    say(repr(kernel))
    try:
        files = kernel.write_c(out, name=called)
    except FileExistsError as there:
        refuse(f"--out: {there}; give the new ones another --name")
    except ValueError as wrong:
        refuse(f"--{wrong}")
    except OSError as failed:
        fail(f"--out: {failed}")
    for file in files:
        say(str(file))


def _read_sizes(texts: list[str]) -> Sizes:
    sizes: Sizes = {}
    for name, value in map(_read_size, texts):
        if name in sizes:
            refuse(f"--let {name}: given twice; a parameter has one value or one range")
        sizes[name] = value
    return sizes


def _read_size(text: str) -> tuple[str, float | tuple[float, ...]]:
    """Read NAME=VALUE or NAME=LOW:HIGH."""
    name, _, value = text.partition("=")
    try:
        numbers = tuple(map(float, value.split(":")))
    except ValueError:
        refuse(f"--let {text}: must be NAME=VALUE or NAME=LOW:HIGH")
    return name, numbers[0] if len(numbers) == 1 else numbers


def _write_all(emitted: Iterable[Emitted], out: Path, *, must_have: bool = False) -> None:
    """Write files as they come; fail if there `must_have` been some but there are none."""
    with ending(PipelineError, fail):
        for one in emitted:
            if must_have and not one.files:
                fail(*one.left_out)
            for reason in one.left_out:
                say(f"left out: {reason}")
            for name, text in one.files.items():
                _write(out / name, text)


def _write(file: Path, text: str) -> None:
    # A Makefile that somebody else wrote is left alone.
    if file.name == "Makefile" and file.exists():
        return
    with ending(OSError, fail, "--out: "):
        write_whole(file, text)
    say(str(file))
