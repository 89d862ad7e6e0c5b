"""Entry point of the command line: says what is missing before anything heavy is imported."""

from __future__ import annotations

import sys
from importlib.util import find_spec

# What the extra `derive` installs, as it is imported.
EXTRA = ("PIL", "flint", "jinja2", "latex2mathml", "matplotlib", "rich", "ruff", "sympy", "typer")


def main() -> None:
    """Run the command line; exit with 2 if the extra `derive` is not installed."""
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="backslashreplace")  # type: ignore[union-attr]
    missing = [name for name in EXTRA if find_spec(name) is None]
    if missing:
        names = ", ".join(missing)
        print(
            f"mechproof needs {names}, the extra derive: in the folder of the sources, "
            "pip install '.[derive]'",
            file=sys.stderr,
        )
        sys.exit(2)
    from mechproof.cli import app

    app(prog_name="mechproof")


if __name__ == "__main__":
    main()
