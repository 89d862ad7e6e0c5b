"""The names of quantities, listed without loading a paper, since each worker collects every test.

`lab/test_accuracy.py` tests that they agree with the papers, `kernels/test_derivatives.py` that
the derivatives do.
"""

from __future__ import annotations

import json
from functools import cache
from importlib import import_module
from pathlib import Path

import mechproof.kernels
from mechproof.lab.subject import Subject, find_subjects

GENERATED = Path(next(iter(mechproof.kernels.__path__)))
_RECORDS = {
    file.stem: json.loads(file.read_text(encoding="utf-8"))
    for file in sorted((GENERATED / "measured").glob("*.json"))
}
_SYSTEMS = sorted(file.stem for file in GENERATED.glob("[!_]*.py"))


def _list_kernels(package: str) -> tuple[str, ...]:
    return tuple(
        f"{system}.{name}"
        for system in _SYSTEMS
        for name in import_module(f"{package}.{system}").__all__
    )


# Quantities with a bound of their accuracy, mapped to it; those with a kernel; and derivatives.
BOUNDED = {name: record["bound"] for name, record in _RECORDS.items() if record["bound"]}
KERNELS = _list_kernels("mechproof.kernels")
DERIVATIVES = _list_kernels("mechproof.kernels.derivatives")


@cache
def find_subject(name: str) -> Subject:
    (found,) = find_subjects((name,))
    return found
