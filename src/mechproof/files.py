"""Files that are written in one step."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path


def write_whole(target: Path, text: str) -> None:
    """Write a file and the folders above it; an interrupted write leaves the old file."""
    target.parent.mkdir(parents=True, exist_ok=True)
    staged = target.with_name(f"{target.name}.{os.getpid()}")
    try:
        staged.write_text(text, encoding="utf-8")
        os.replace(staged, target)
    except OSError:
        with suppress(OSError):
            staged.unlink()
        raise
