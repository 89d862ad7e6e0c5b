"""What the command line says: full lines where no terminal wraps them, refusals, progress."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import NoReturn

import typer
from rich.console import Console
from rich.markup import escape
from rich.progress import Progress, SpinnerColumn, TextColumn, TimeElapsedColumn
from rich.text import Text

console = Console(highlight=False, emoji=False)
errors = Console(stderr=True, highlight=False, emoji=False)


def say(text: str | Text) -> None:
    """Print to stdout; what is piped or kept in a file is not wrapped."""
    console.print(text, markup=False, soft_wrap=not console.is_terminal)


def refuse(message: str) -> NoReturn:
    """End with 2: bad usage."""
    _complain(message)
    raise typer.Exit(2)


def fail(message: str) -> NoReturn:
    """End with 1: what was asked for failed."""
    _complain(message)
    raise typer.Exit(1)


def _complain(message: str) -> None:
    errors.print(message, style="red", markup=False, soft_wrap=True)


@contextmanager
def show_progress(title: str) -> Iterator[Callable[[str], None]]:
    """Show what is at work on a terminal; drawn when told, as a thread could not be forked."""
    columns = (SpinnerColumn(), TextColumn("{task.description}"), TimeElapsedColumn())
    errors.print(title, markup=False, soft_wrap=True)
    progress = Progress(
        *columns, console=errors, transient=True, auto_refresh=False, disable=not errors.is_terminal
    )
    with progress:
        task = progress.add_task(escape(title), total=None)
        yield lambda text: progress.update(task, description=escape(text), refresh=True)
