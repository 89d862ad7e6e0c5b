"""Optional dependencies: missing packages, and the command that installs them."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from importlib.metadata import PackageNotFoundError, distribution, requires, version
from importlib.util import find_spec
from pathlib import Path
from urllib.parse import urlsplit


def suggest_install(extra: str) -> str:
    """Return the command that installs an extra, from the sources if mechproof came from them."""
    return f"pip install '{_find_source()}[{extra}]'"


def describe_missing(what: str, extra: str, *names: str | None) -> str:
    """Return a sentence that `what` needs missing packages, with the command that installs them."""
    missing = ", ".join(name or "a package" for name in names)
    return f"{what} needs {missing}, the extra {extra}: {suggest_install(extra)}"


def require_modules(what: str, extra: str, modules: Iterable[str]) -> None:
    """Raise ImportError, which names the command to run, if a module is not installed."""
    missing = [module for module in modules if find_spec(module) is None]
    if missing:
        raise ImportError(describe_missing(what, extra, *missing))


def list_other_versions(extra: str) -> list[str]:
    """Return the packages that an extra pins but that have another version here, or are missing."""
    pinned = re.compile(rf"([\w.-]+)==([\w.]+) *; *extra == .{extra}.")
    found = (pinned.match(line) for line in requires("mechproof") or ())
    wanted = {match[1]: match[2] for match in found if match}
    here = {name: _find_version(name) for name in wanted}
    return [f"{n} {here[n]} instead of {wanted[n]}" for n in wanted if here[n] != wanted[n]]


def _find_version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "missing"


def _find_source() -> str:
    """Return pip's argument: the folder mechproof was installed from, if it exists, or the name.

    Installers record a folder as `direct_url.json` next to the metadata (PEP 610).
    """
    from urllib.request import url2pathname

    try:
        recorded = distribution("mechproof").read_text("direct_url.json")
    except PackageNotFoundError:
        recorded = None
    url = urlsplit(json.loads(recorded)["url"]) if recorded else None
    if url is None or url.scheme != "file":
        return "mechproof"
    folder = Path(url2pathname(url.path))
    return str(folder) if (folder / "pyproject.toml").exists() else "mechproof"
