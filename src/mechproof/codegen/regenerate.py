"""Regenerate: in, papers; out, the files of the generated package, compared or written."""

from __future__ import annotations

import difflib
import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory

from mechproof.codegen.backend import NUMPY, Backend, render_init, render_module
from mechproof.record import Paper

REPAIR = "mechproof regenerate"
# Results of measurements, other backends and caches live in folders of their own.
FOREIGN_FOLDERS = ("measured", "compiled", "__pycache__")


def render_package(papers: Iterable[Paper], backend: Backend = NUMPY) -> dict[str, str]:
    """Render every file of the generated package, by its name relative to the package.

    Papers without quantities have no module.
    """
    modules = {p.system: render_module(p, backend) for p in papers if p.quantities}
    files = {f"{system}.py": text for system, text in sorted(modules.items())}
    return {"__init__.py": render_init(backend), **files}


def compare_or_update(directory: Path, files: Mapping[str, str], *, check: bool) -> list[str]:
    """Compare the directory with `files`; unless `check`, make it equal.

    Returns one entry for each missing, surplus or different file, a unified diff from the file
    to what it should be; empty if there is nothing to do. With `check` and a difference, the
    last entry names the command that repairs it. An interrupted write leaves old files whole.
    """
    present = _read_files(directory)
    names = sorted(set(present) | set(files))
    changed = [name for name in names if present.get(name) != files.get(name)]
    report = [_describe_change(name, present.get(name), files.get(name)) for name in changed]
    if check:
        return [*report, f"run `{REPAIR}`"] if report else []
    _write_files(directory, {name: files[name] for name in changed if name in files})
    for name in set(changed) - set(files):
        (directory / name).unlink()
    return report


def _read_files(directory: Path) -> dict[str, str]:
    """Read what lies in the directory, its foreign folders apart."""
    paths = (path.relative_to(directory) for path in directory.rglob("*") if path.is_file())
    own = sorted(path for path in paths if path.parts[0] not in FOREIGN_FOLDERS)
    # Bytes, because a line end or an encoding that is not ours is a difference to show, too.
    return {
        path.as_posix(): (directory / path).read_bytes().decode("utf-8", "backslashreplace")
        for path in own
    }


def _describe_change(name: str, present: str | None, wanted: str | None) -> str:
    what = "missing" if present is None else "surplus" if wanted is None else "different"
    lines = difflib.unified_diff(
        (present or "").splitlines(keepends=True),
        (wanted or "").splitlines(keepends=True),
        fromfile=f"{name} (present)",
        tofile=f"{name} (regenerated)",
    )
    return f"{what}: {name}\n{''.join(lines)}"


def _write_files(directory: Path, files: Mapping[str, str]) -> None:
    """Write all texts beside their targets first, then put each in place in one step."""
    directory.mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory(prefix=".regenerate-", dir=directory) as folder:
        for name, text in files.items():
            staged = Path(folder, name)
            staged.parent.mkdir(parents=True, exist_ok=True)
            staged.write_text(text, encoding="utf-8", newline="\n")
        for name in files:
            target = directory / name
            target.parent.mkdir(parents=True, exist_ok=True)
            os.replace(Path(folder, name), target)
