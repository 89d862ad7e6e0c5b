"""The names of quantities, listed without loading a paper: each worker collects every test.

That they are those of the papers is tested in `lab/test_accuracy.py`.
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
# Quantities whose accuracy has a bound, with it, and those that have a kernel.
BOUNDED = {name: record["bound"] for name, record in _RECORDS.items() if record["bound"]}
KERNELS = tuple(
    f"{system}.{name}"
    for system in _SYSTEMS
    for name in import_module(f"mechproof.kernels.{system}").__all__
)


@cache
def find_subject(name: str) -> Subject:
    (found,) = find_subjects((name,))
    return found
