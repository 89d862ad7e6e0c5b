"""Kernels on a GPU: what `mechproof emit c` writes, compiled by NVRTC through CuPy."""

from __future__ import annotations

import importlib
import shutil
import subprocess
from functools import cached_property
from importlib.util import find_spec
from itertools import chain
from math import prod
from typing import Any

import numpy as np

from mechproof.codegen.backends.c99 import render_c_formula
from mechproof.lab.c_kernels import EACH, KernelInC
from mechproof.programs.kernel import build_functions
from mechproof.record import Paper

LIBRARY, DRIVER = "cupy", "nvidia-smi"
# Fused products and sums would change last digits, and what must be exact.
FLAGS = ("--fmad=false", "-default-device")
THREADS = 256


class KernelOnGpu(KernelInC):
    """The kernel of a quantity on a GPU, one thread a point; it is compiled by its first call."""

    def __call__(self, *arguments: Any) -> Any:
        """Compute at points that broadcast; the result lies on the GPU if an argument does.

        It is complete when the call returns.
        """
        given = [self.place(a) for a in arguments]
        own, sizes = self._find_sizes(given)
        points, rows, strides = self._lay_out(given, own)
        found = self._cupy.empty(points + self._kernel.code.shape)
        if count := prod(points):
            numbers = map(np.uint64, (count, *sizes))
            pairs = zip(rows, map(np.uint64, strides), strict=True)
            places = chain.from_iterable(pairs)
            self._function((-(-count // THREADS),), (THREADS,), (*numbers, *places, found))
        self._cupy.cuda.get_current_stream().synchronize()
        there = any(isinstance(a, self._cupy.ndarray) for a in arguments)
        return found if there else found.get()

    def place(self, argument: Any) -> Any:
        """Return an argument as an array of doubles on the GPU."""
        return self._cupy.asarray(argument, float)

    @cached_property
    def _cupy(self) -> Any:
        return importlib.import_module(LIBRARY)

    @cached_property
    def _function(self) -> Any:
        loop = (
            f'extern "C" __global__ void {EACH}({self._write_parameters()})\n'
            "{\n    const size_t i = blockIdx.x * (size_t)blockDim.x + threadIdx.x;\n"
            f"    if (i < count) {self._write_call()};\n}}\n"
        )
        text = f"{render_c_formula(self._kernel, self._paper)}\n{loop}"
        return self._cupy.RawModule(code=text, options=FLAGS).get_function(EACH)


def find_on_gpu(name: str, paper: Paper) -> KernelOnGpu | None:
    """Find a quantity's kernel on a GPU, None without CuPy, a GPU or a kernel."""
    kernels = build_functions(paper).kernels if find_gpu() else ()
    return next((KernelOnGpu(k, paper) for k in kernels if k.name == name), None)


def find_gpu() -> str:
    """Return the name of the first GPU; empty without one, and without CuPy.

    CUDA is not called: a process that is forked later could not use it then.
    """
    if not (find_spec(LIBRARY) and shutil.which(DRIVER)):
        return ""
    command = [DRIVER, "--query-gpu=name", "--format=csv,noheader"]
    told = subprocess.run(command, capture_output=True, text=True, check=False)
    return told.stdout.partition("\n")[0].strip() if told.returncode == 0 else ""
