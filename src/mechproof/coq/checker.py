"""Coq itself: runs the files of a folder, and reads what their theorems assume."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from mechproof.coq.folder import PRELUDE
from mechproof.processes import count_processors

# Seconds for a file; what is recorded as accepted took a sixth of it at most.
LIMIT = 120.0
RECORD_LIMIT = 20.0
# What Coq's real numbers rest on, by name, and the modules of the machine integers and floats with
# which coq-interval computes. Nothing else may be assumed.
ASSUMED = frozenset(
    {
        "ClassicalDedekindReals.sig_forall_dec",
        "ClassicalDedekindReals.sig_not_dec",
        "FunctionalExtensionality.functional_extensionality_dep",
        "Classical_Prop.classic",
    }
)
ASSUMED_MODULES = frozenset({"PrimInt63", "Uint63", "Sint63", "PrimFloat", "FloatAxioms"})
_ASSUMPTION = re.compile(r"^([A-Za-z_][\w.']*)\s*:|^([A-Za-z_][\w.']*)$", re.MULTILINE)


class CheckerError(RuntimeError):
    """Coq is not there, or does not take what all files require."""


def find_version() -> str:
    """Return the version of Coq. Raises `CheckerError` where it is not installed."""
    if shutil.which("coqc") is None:
        raise CheckerError(
            "coqc is not installed; on Debian: apt-get install coq libcoq-interval "
            "libcoq-coquelicot libcoq-flocq"
        )
    told = subprocess.run(["coqc", "--version"], capture_output=True, text=True, check=True)
    found = re.search(r"version (\S+)", told.stdout)
    return found[1] if found else told.stdout.strip()


def check_files(
    folder: Path,
    names: Iterable[str],
    tell: Callable[[str], None] = lambda text: None,
    *,
    limit: float = LIMIT,
) -> Mapping[str, str]:
    """Have Coq check files of a folder; return of each what is wrong, nothing if it is accepted.

    Raises `CheckerError` where Coq is not installed or refuses what all of them require.
    """
    find_version()
    if wrong := _check(folder, PRELUDE, limit):
        raise CheckerError(f"{PRELUDE}: {wrong}")
    listed = list(names)
    found = {}
    with ThreadPoolExecutor(count_processors()) as threads:
        outcomes = threads.map(lambda name: _check(folder, name, limit), listed)
        for name, wrong in zip(listed, outcomes, strict=True):
            tell(name)
            found[name] = wrong
    return found


def _check(folder: Path, name: str, limit: float) -> str:
    try:
        done = subprocess.run(
            ["coqc", "-q", name], cwd=folder, capture_output=True, text=True, timeout=limit
        )
    except subprocess.TimeoutExpired:
        return f"Coq takes longer than {limit:g} s"
    if done.returncode:
        return f"Coq: {_find_fault(done.stderr)}"
    if beyond := find_assumptions(done.stdout):
        return f"assumes {', '.join(sorted(beyond))}"
    return ""


def _find_fault(told: str) -> str:
    """Return the place and the message of the error, in one line."""
    place = re.search(r"line (\d+)", told)
    message = " ".join(told.partition("Error:")[2].split())
    return f"line {place[1] if place else '?'}: {message or told.strip()}"


def find_assumptions(told: str) -> set[str]:
    """Return of what `Print Assumptions` tells that which is not on the published list."""
    names = {first or second for first, second in _ASSUMPTION.findall(told)} - {"Axioms"}
    return {
        name
        for name in names
        if name not in ASSUMED and name.rpartition(".")[0].split(".")[-1] not in ASSUMED_MODULES
    }
