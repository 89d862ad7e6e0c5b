"""Kernels in C as functions of arrays: the code of `mechproof emit c`, compiled with its flags.

For a GPU, NVRTC compiles the same code through CuPy.
"""

from __future__ import annotations

import ctypes
import importlib
import shutil
import subprocess
from functools import cached_property
from importlib.util import find_spec
from itertools import chain
from math import prod
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechproof.codegen.backends.c99 import FLAGS, render_c_formula
from mechproof.programs.kernel import Kernel, build_functions
from mechproof.programs.scalar import list_arguments
from mechproof.record import Paper

Array = NDArray[Any]
Shape = tuple[int, ...]
COMPILER = "cc"
# Name of a loop over the function of one point, for calls in which arguments other than the first
# vary, too.
EACH = "call_each"


class KernelInC:
    """The C kernel of a quantity, called from Python and compiled on its first call."""

    def __init__(self, kernel: Kernel, paper: Paper) -> None:
        self._kernel, self._paper = kernel, paper
        self._arguments = list_arguments(kernel)
        self._ranks = tuple(a.axes or int(a.width > 0) for a in self._arguments)
        self._sums = any(a.axes for a in self._arguments)

    def __call__(self, *arguments: Any) -> Array:
        """Compute at points that broadcast, as the NumPy kernel does."""
        given = [np.asarray(a, float) for a in arguments]
        own, sizes = self._find_sizes(given)
        pairs = zip(given[1:], self._ranks[1:], strict=True)
        call = self._call_each if any(a.ndim > rank for a, rank in pairs) else self._call_many
        return call(given, own, sizes)

    def _find_sizes(self, given: list[Array]) -> tuple[list[Shape], list[int]]:
        """Return the shape of each argument at one point, and the number of terms of sums."""
        tails = (a.shape[-x.axes :] for a, x in zip(given, self._arguments, strict=True) if x.axes)
        sizes = [max(chain(*tails), default=0)] if self._sums else []
        return [(a.width,) if a.width else (*sizes,) * a.axes for a in self._arguments], sizes

    def _call_many(self, given: list[Array], own: list[Shape], sizes: list[int]) -> Array:
        points = given[0].shape[: max(given[0].ndim - self._ranks[0], 0)]
        shapes = [points + own[0], *own[1:]]
        first, *others = map(spread, given, shapes)
        ranked = zip(others, self._ranks[1:], strict=True)
        found = np.empty(points + self._kernel.code.shape)
        values = [a.ctypes.data if rank else a.item() for a, rank in ranked]
        many, _ = self._functions
        many(prod(points), *sizes, first.ctypes.data, *values, found.ctypes.data)
        return found

    def _call_each(self, given: list[Array], own: list[Shape], sizes: list[int]) -> Array:
        points, rows, strides = self._lay_out(given, own)
        found = np.empty(points + self._kernel.code.shape)
        places = chain(*zip((a.ctypes.data for a in rows), strides, strict=True))
        _, each = self._functions
        each(prod(points), *sizes, *places, found.ctypes.data)
        return found

    def _lay_out(
        self, given: list[Array], own: list[Shape]
    ) -> tuple[Shape, list[Array], list[int]]:
        """Return the shape of the points, the arguments row by row, and the rows' strides."""
        shapes = [a.shape[: max(a.ndim - r, 0)] for a, r in zip(given, self._ranks, strict=True)]
        points = np.broadcast_shapes(*shapes)
        wholes = [(points if shape else ()) + one for shape, one in zip(shapes, own, strict=True)]
        strides = [prod(one) if shape else 0 for shape, one in zip(shapes, own, strict=True)]
        return points, [*map(spread, given, wholes)], strides

    @cached_property
    def _functions(self) -> tuple[Any, Any]:
        """Compile the functions for shared parameters, and for parameters point by point."""
        system, name = self._paper.system, self._kernel.name
        with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
            source, made = (Path(folder, f"{system}{end}") for end in (".c", ".so"))
            text = f"{render_c_formula(self._kernel, self._paper)}\n{self._write_loop()}"
            source.write_text(text, encoding="utf-8")
            paths = (str(source), "-o", str(made))
            command = [COMPILER, *FLAGS.split(), "-shared", "-fPIC", *paths, "-lm"]
            subprocess.run(command, check=True, capture_output=True)
            library = ctypes.CDLL(str(made))
        size, pointer = ctypes.c_size_t, ctypes.c_void_p
        sizes = [size] * (1 + self._sums)
        others = [pointer if rank else ctypes.c_double for rank in self._ranks[1:]]
        many, each = getattr(library, f"{system}_{name}_array"), getattr(library, EACH)
        many.argtypes = [*sizes, pointer, *others, pointer]
        each.argtypes = [*sizes, *[pointer, size] * len(self._ranks), pointer]
        many.restype = each.restype = None
        return many, each

    def _write_loop(self) -> str:
        return (
            f"void {EACH}({self._write_parameters()})\n"
            f"{{\n    for (size_t i = 0; i < count; ++i)\n        {self._write_call()};\n}}\n"
        )

    def _write_parameters(self) -> str:
        terms = "size_t terms, " if self._sums else ""
        given = "".join(f"const double *a{n}, size_t s{n}, " for n, _ in enumerate(self._ranks))
        return f"size_t count, {terms}{given}double *out"

    def _write_call(self) -> str:
        count = prod(self._kernel.code.shape)
        values = [
            f"a{n} + i * s{n}" if rank else f"a{n}[i * s{n}]" for n, rank in enumerate(self._ranks)
        ]
        values = [*(["terms"] if self._sums else []), *values]
        function = f"{self._paper.system}_{self._kernel.name}"
        if self._kernel.code.shape:
            return f"{function}({', '.join([*values, f'out + i * {count}'])})"
        return f"out[i] = {function}({', '.join(values)})"


def find_in_c(name: str, paper: Paper) -> KernelInC | None:
    """Return a quantity's kernel in C, or None without a compiler or without a kernel."""
    kernels = build_functions(paper).kernels if shutil.which(COMPILER) else ()
    return next((KernelInC(k, paper) for k in kernels if k.name == name), None)


def spread(values: Array, shape: Shape) -> Array:
    """Return values as a contiguous array of a shape that they broadcast to."""
    if values.shape == shape and values.flags.c_contiguous:
        return values
    whole = np.empty_like(values, shape=shape, order="C")
    whole[...] = values
    return whole


LIBRARY, DRIVER = "cupy", "nvidia-smi"
# No fused multiply-adds: they would change last digits, and error-free transformations.
GPU_FLAGS = ("--fmad=false", "-default-device")
THREADS = 256


class KernelOnGpu(KernelInC):
    """The kernel of a quantity on a GPU, one thread per point, compiled on its first call."""

    def __call__(self, *arguments: Any) -> Any:
        """Compute at points that broadcast; the result is on the GPU if an argument is.

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
        return self._cupy.RawModule(code=text, options=GPU_FLAGS).get_function(EACH)


def find_on_gpu(name: str, paper: Paper) -> KernelOnGpu | None:
    """Return a quantity's kernel on a GPU, or None without CuPy, a GPU or a kernel."""
    kernels = build_functions(paper).kernels if find_gpu() else ()
    return next((KernelOnGpu(k, paper) for k in kernels if k.name == name), None)


def find_gpu() -> str:
    """Return the name of the first GPU, or "" without one or without CuPy.

    CUDA is not called, as a process forked later could then not use it.
    """
    if not (find_spec(LIBRARY) and shutil.which(DRIVER)):
        return ""
    command = [DRIVER, "--query-gpu=name", "--format=csv,noheader"]
    told = subprocess.run(command, capture_output=True, text=True, check=False)
    return told.stdout.partition("\n")[0].strip() if told.returncode == 0 else ""
