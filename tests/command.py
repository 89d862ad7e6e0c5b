"""Run the command line in this process or in another, and write a user's derivation."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

from typer.testing import CliRunner, Result

from mechproof.cli import app
from mechproof.tools.processes import WorkerError, _answer

HEAD = """
from sympy import Function, Integral, Interval, S, Symbol, cos, gamma, oo, pi, sin, symbols
from mechproof.record import *
x, y = symbols("x y", real=True)
def paper(*rows):
    variables = (Variable(x, "a number"), Variable(y, "another"))
    return Paper("mine", "my notes", variables, rows)
"""
PROVED = 'Equation("(1)", "1", Equality(sin(x)**2 + cos(x)**2, S.One))'
OPEN = 'Equation("(2)", "2", Equality(gamma(x**2 + 1), x**2 * gamma(x**2)))'


def run(*arguments: str) -> Result:
    return CliRunner().invoke(app, list(arguments))


def write(folder: Path, *rows: str) -> Path:
    file = folder / "mine.py"
    file.write_text(f"{HEAD}\nPAPER = paper({', '.join(rows)})\n", encoding="utf-8")
    return file


def in_process(*arguments: str, **variables: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "mechproof", *arguments]
    environment = {**os.environ, **variables}
    return subprocess.run(command, capture_output=True, text=True, env=environment)


def answer_here(
    function: Callable[[Any], Any], tasks: Sequence[Any], *, limit: float
) -> Iterator[tuple[int, Any]]:
    """Yield the same answers as `run_tasks`, but in this process and without a time limit."""
    for number, task in enumerate(tasks):
        succeeded, answer = _answer(function, task)
        yield number, answer if succeeded else WorkerError(answer)


def hear_hangups() -> None:
    """Let SIGHUP end a new process, as in a terminal: under `nohup` it would be ignored."""
    signal.signal(signal.SIGHUP, signal.SIG_DFL)
