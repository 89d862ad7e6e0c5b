"""Kernels in C for tests: the compiler and its flags, the sources, and loaded libraries."""

from __future__ import annotations

import ctypes
import platform
import shutil
import subprocess
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from derived import paper_of

from mechproof.codegen.backends.c99 import render_c
from mechproof.programs.kernel import Kernel
from mechproof.programs.scalar import list_scalars

COMPILER = shutil.which("cc")
needs_compiler = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
WARNED = ("-O2", "-Wall", "-Wextra", "-Wconversion", "-Werror", "-pedantic")
# Without a fused multiply-add in hardware, the default target of compilers.
PORTABLE = ("-std=c99", *WARNED, "-ffp-contract=off")


def list_fused() -> tuple[str, ...]:
    """List the flags that make sources call fma, which is libm's where the hardware has none."""
    if platform.machine().lower() not in ("x86_64", "amd64"):
        return ()
    known = Path("/proc/cpuinfo")
    has_fma = known.is_file() and " fma " in known.read_text(encoding="utf-8")
    return ("-mfma",) if has_fma else ("-D__FMA__",)


STRICT = (*PORTABLE, *list_fused())
ELLIPTIC = ("position", "ratio", "acceleration")
POINTER = np.ctypeslib.ndpointer(float)


@cache
def kernels_of(system: str) -> dict[str, Kernel]:
    return {kernel.name: kernel for kernel in list_scalars(paper_of(system))}


def find_kernel(name: str) -> Kernel:
    """Return the kernel named `system.quantity`."""
    system, _, quantity = name.partition(".")
    return kernels_of(system)[quantity]


def build(folder: Path, system: str, single: bool, flags: tuple[str, ...]) -> ctypes.CDLL:
    """Compile the kernels of a system without a warning, and load them."""
    return compile_files(folder, render(system, single), flags)


@cache
def render(system: str, single: bool) -> dict[str, str]:
    """Render the kernels of a system; in float, skip the search for their errors."""
    errors = dict.fromkeys(kernels_of(system), "not searched for")
    return render_c(paper_of(system), errors=errors if single else None)


def compile_files(folder: Path, files: dict[str, str], flags: tuple[str, ...]) -> ctypes.CDLL:
    """Compile a source and its header without a warning, and load them."""
    for name, text in files.items():
        (folder / name).write_text(text)
    (source,) = (name for name in files if name.endswith(".c"))
    target = folder / f"{source}{flags[-1]}.so"
    assert COMPILER is not None
    command = [COMPILER, *flags, "-shared", "-fPIC", source, "-o", str(target), "-lm"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return ctypes.CDLL(str(target))


def assert_same_bits(found: Any, wanted: Any) -> None:
    assert np.array_equal(found, wanted, equal_nan=True)
    numbers = ~np.isnan(found)
    assert np.array_equal(np.signbit(found[numbers]), np.signbit(wanted[numbers]))
