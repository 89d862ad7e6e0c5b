"""Run Coq on the files of a folder, and read what their theorems assume."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from mechproof.coq.scripts import LIBRARIES, ROUNDINGS, list_required, write_assumptions
from mechproof.tools.processes import count_processors

# Processor time for a file, in seconds; files recorded as accepted took at most a third of it.
LIMIT = 150.0
RECORD_LIMIT = 50.0
# Processor time for the bound of a program, in seconds: if the bound fails somewhere, Coq mostly
# finds out soon.
BOUND_LIMIT = 60.0
# Number of files whose assumptions Coq prints at once; beyond it, the time grows faster than the
# number.
BATCH = 64
# Names of the axioms that Coq's real numbers rest on, and modules of the machine integers and
# floats with which coq-interval computes. Nothing else may be assumed.
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
    """Coq is not installed, or refuses a library that the files require."""


def is_installed() -> bool:
    """Return whether Coq is installed."""
    return shutil.which("coqc") is not None


def find_version() -> str:
    """Return the version of Coq. Raises `CheckerError` if it is not installed."""
    if not is_installed():
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
    """Have Coq check files of a folder; return what is wrong with each, "" if it is accepted.

    `tell` is called with each name checked. Raises `CheckerError` if Coq is not installed or
    refuses a library that the files require.
    """
    find_version()
    listed = list(names)
    texts = ((folder / name).read_text(encoding="utf-8") for name in listed)
    required = {library for text in texts for library in list_required(text)}
    for library in (one for one in (*LIBRARIES, ROUNDINGS) if one in required):
        if wrong := _run(folder, f"{library}.v", limit)[0]:
            raise CheckerError(f"{library}.v: {wrong}")
    found = {}
    with ThreadPoolExecutor(count_processors()) as threads:
        outcomes = threads.map(lambda name: _run(folder, name, limit)[0], listed)
        for name, wrong in zip(listed, outcomes, strict=True):
            tell(name)
            found[name] = wrong
    accepted = [name for name in listed if not found[name]]
    for start in range(0, len(accepted), BATCH):
        found |= _check_assumptions(folder, accepted[start : start + BATCH])
    return found


def _check_assumptions(folder: Path, names: Sequence[str]) -> Mapping[str, str]:
    """Return, by file name, what accepted files assume beyond the published list.

    Coq takes hardly longer for many files than for one; if too much is assumed, each half is
    searched.
    """
    wrong = _find_beyond(folder, names)
    if not wrong or len(names) == 1:
        return dict.fromkeys(names, wrong)
    half = len(names) // 2
    return {
        **_check_assumptions(folder, names[:half]),
        **_check_assumptions(folder, names[half:]),
    }


def _find_beyond(folder: Path, names: Sequence[str]) -> str:
    """Report what accepted files together assume beyond the published list, or return ""."""
    file = folder / "All_assumptions.v"
    modules = [name.removesuffix(".v") for name in names]
    file.write_text(write_assumptions(modules), encoding="utf-8")
    wrong, told = _run(folder, file.name, LIMIT)
    for left in folder.glob("*All_assumptions.*"):
        left.unlink()
    beyond = find_assumptions(told)
    return wrong or (f"assumes {', '.join(sorted(beyond))}" if beyond else "")


def _run(folder: Path, name: str, limit: float) -> tuple[str, str]:
    """Return what is wrong with a file, "" if Coq accepts it, and what Coq printed."""
    limited = f'ulimit -t {limit:.0f}; exec coqc -q -w none "$0"'
    done = subprocess.run(
        ["sh", "-c", limited, name], cwd=folder, capture_output=True, text=True, check=False
    )
    if done.returncode < 0 or done.returncode > 128:
        return f"Coq takes longer than {limit:g} s of processor time", ""
    return (f"Coq: {_find_fault(done.stderr)}" if done.returncode else ""), done.stdout


def _find_fault(told: str) -> str:
    """Return the line and the message of the error as one line of text."""
    place = re.search(r"line (\d+)", told)
    message = " ".join(told.partition("Error:")[2].split())
    return f"line {place[1] if place else '?'}: {message or told.strip()}"


def find_assumptions(told: str) -> set[str]:
    """Return the assumptions in the output of `Print Assumptions` that are not published ones."""
    names = {first or second for first, second in _ASSUMPTION.findall(told)} - {"Axioms"}
    return {
        name
        for name in names
        if name not in ASSUMED and name.rpartition(".")[0].split(".")[-1] not in ASSUMED_MODULES
    }
