"""Entry point of the command line: checks its requirements, and reports system errors briefly."""

from __future__ import annotations

import gc
import os
import signal
import sys
from contextlib import suppress
from importlib.util import find_spec
from typing import NoReturn

from mechproof.tools.extras import describe_missing
from mechproof.tools.processes import ENDING

# Packages that the extra `derive` installs, by the names under which they are imported.
EXTRA = ("PIL", "flint", "jinja2", "latex2mathml", "matplotlib", "rich", "sympy", "typer")


def main() -> None:
    """Run the command line; exit with 2 if the extra `derive` is not installed.

    A signal to end lets the program tidy up first. A system error, such as a full disk or a folder
    that cannot be written to, is reported in a sentence, with status 1.
    """
    for number in ENDING:
        # Signals that the caller has set to be ignored stay ignored.
        if signal.getsignal(number) is signal.SIG_DFL:
            signal.signal(number, _end)
    _check_streams()
    try:
        try:
            _run()
        finally:
            sys.stdout.flush()
    except OSError as error:
        _give_up(error)


def _end(number: int, frame: object) -> NoReturn:
    sys.exit(128 + number)


def _check_streams() -> None:
    """Refuse to run without a stdout: the next file that is opened would take its place."""
    if sys.stderr is None:
        sys.stderr = open(os.devnull, "w")  # noqa: SIM115
    if sys.stdout is None:
        sys.exit("mechproof: stdout is closed")


def _give_up(error: OSError) -> NoReturn:
    """Report a system error, unless nobody reads the output any more, and exit with 1."""
    with suppress(OSError):
        if not isinstance(error, BrokenPipeError):
            print(f"mechproof: {error}", file=sys.stderr, flush=True)
    # Unwritten output would fail once more at exit.
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in (sys.stdout, sys.stderr):
        os.dup2(nowhere, stream.fileno())
    sys.exit(1)


def _run() -> None:
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="backslashreplace")  # type: ignore[union-attr]
    missing = [name for name in EXTRA if find_spec(name) is None]
    if missing:
        print(describe_missing("mechproof", "derive", *missing), file=sys.stderr)
        sys.exit(2)
    # SymPy makes many long-lived objects: a larger cache and rarer garbage collections save time.
    # SymPy reads this variable when it is imported.
    os.environ.setdefault("SYMPY_CACHE_SIZE", "20000")
    gc.set_threshold(1_000_000)
    from mechproof.cli import app

    app(prog_name="mechproof")


if __name__ == "__main__":
    main()
