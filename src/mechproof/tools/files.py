"""Files that are written in one step, and modules imported from files anywhere."""

from __future__ import annotations

import os
import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType


def write_whole(target: Path, text: str) -> None:
    """Write a file and the folders above it; an interrupted write leaves the old file.

    If something else exists there, such as a pipe or a terminal, it is written to and not replaced.
    """
    target.parent.mkdir(parents=True, exist_ok=True)
    if target.exists() and not target.is_file():
        target.write_text(text, encoding="utf-8", newline="\n")
        return
    staged = target.with_name(f"{target.name}.{os.getpid()}")
    try:
        staged.write_text(text, encoding="utf-8", newline="\n")
        os.replace(staged, target)
    finally:
        staged.unlink(missing_ok=True)


def import_file(name: str, file: Path) -> ModuleType:
    """Run a Python file as a new module with the given name."""
    spec = spec_from_file_location(name, file)
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module
