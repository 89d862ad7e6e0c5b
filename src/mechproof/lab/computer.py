"""The machine that times are taken on."""

from __future__ import annotations

import os
import platform
import sys
from collections.abc import Iterator
from contextlib import suppress
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import numpy as np

from mechproof.measured import Machine

VERSIONS = ("mechproof", "numpy", "scipy", "sympy", "python-flint", "numba")


def describe_machine() -> Machine:
    """Describe the processor, what NumPy uses of it, and the versions that decide results."""
    simd = np.show_config(mode="dicts")["SIMD Extensions"]
    return Machine(
        processor=_processor(),
        cores=os.cpu_count(),
        simd=tuple(simd["found"]),
        system=platform.system(),
        python=".".join(map(str, sys.version_info[:3])),
        versions=dict(_list_versions()),
    )


def _list_versions() -> Iterator[tuple[str, str]]:
    """Yield what is installed of the packages that decide results."""
    for name in VERSIONS:
        with suppress(PackageNotFoundError):
            yield name, version(name)


def find_load() -> float | None:
    """Return how many processes ran on average over the last minute, where that is known."""
    return round(os.getloadavg()[0], 2) if hasattr(os, "getloadavg") else None


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8").splitlines() if info.is_file() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor()
