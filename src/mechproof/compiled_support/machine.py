"""Machine operations for functions that compute one point, and how these are compiled.

Functions marked `scalar` compute one point; `loop` ones fill a flat array.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

try:
    from llvmlite import ir
    from numba import njit, typeof, types
    from numba.extending import intrinsic, overload
except ImportError as error:
    raise ImportError(
        "compiled kernels and shares need numba, the extra fast: in the folder of the sources, "
        "pip install '.[fast]'"
    ) from error

from mechproof.compiled_support.keeping import compile_kept

# What a fast loop leaves as NaN is looked at again after so many points.
BLOCK = 1024
_REAL = types.float64
__all__ = [
    "BLOCK", "choose", "copysign", "floor", "fma", "has_nan", "inner", "is_finite", "loop",
    "maximum", "overload", "power_of_two", "rint", "scalar", "stand_in", "typeof", "widen",
]  # fmt: skip

scalar = compile_kept(forceinline=True)
loop = compile_kept()
# A loop that is kept with the one that calls it, not on its own.
inner = njit(error_model="numpy", nogil=True)


def stand_in(function: Callable[..., Any], **options: Any) -> Callable[..., Any]:
    """Have compiled code call the decorated function wherever `function` is called.

    A function may stand in for itself: compiled code takes it as it is.
    """

    def register(implementation: Callable[..., Any]) -> Callable[..., Any]:
        kept = {"error_model": "numpy", **options}
        overload(function, jit_options=kept, strict=False)(lambda *values: implementation)
        return implementation

    return register


def _machine(name: str, count: int) -> Any:
    """Return an operation of the machine on `count` doubles."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        real = ir.DoubleType()
        function = ir.FunctionType(real, [real] * count)
        return builder.call(builder.module.declare_intrinsic(name, [real], function), arguments)

    return _REAL(*[_REAL] * count), generate


@intrinsic
def fma(typingctx: Any, a: Any, b: Any, c: Any) -> Any:
    """Return a*b + c with one rounding."""
    return _machine("llvm.fma", 3)


@intrinsic
def rint(typingctx: Any, a: Any) -> Any:
    """Return the whole number next to a."""
    return _machine("llvm.rint", 1)


@intrinsic
def floor(typingctx: Any, a: Any) -> Any:
    """Return the largest whole number that is not above a."""
    return _machine("llvm.floor", 1)


@intrinsic
def copysign(typingctx: Any, a: Any, b: Any) -> Any:
    """Return |a| with the sign of b."""
    return _machine("llvm.copysign", 2)


@intrinsic
def power_of_two(typingctx: Any, n: Any) -> Any:
    """Return 2**n for a whole number n, where that is a normal number.

    The last bits of n + 3/2 * 2**52 + bias are those of the exponent.
    """

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        real, whole = ir.DoubleType(), ir.IntType(64)
        shifted = builder.fadd(arguments[0], real(1.5 * 2.0**52 + 1023))
        bits = builder.shl(builder.bitcast(shifted, whole), whole(52))
        return builder.bitcast(bits, real)

    return _REAL(_REAL), generate


@intrinsic
def choose(typingctx: Any, condition: Any, a: Any, b: Any) -> Any:
    """Return a where the condition holds, b elsewhere, without a branch."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.select(*arguments)

    return _REAL(types.boolean, _REAL, _REAL), generate


@intrinsic
def widen(typingctx: Any) -> Any:
    """Ask for the widest vectors in the loop that calls this, and for none that scatter.

    LLVM prefers half of them where it fears for the clock; loops of products and sums gain up to a
    third from the whole. With vectors that scatter, results of several components take up to
    twice as long.
    """

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        # llvmlite knows attributes without values alone.
        attributes = builder.function.attributes
        set.add(attributes, '"prefer-vector-width"="512"')
        features = context.codegen()._tm_features
        if "+avx512f" in features:
            set.add(attributes, f'"target-features"="{features},+prefer-no-scatter"')
        return context.get_dummy_value()

    return types.void(), generate


@scalar
def is_finite(a: float) -> bool:
    """Say whether a number is neither infinite nor NaN."""
    return abs(a) < math.inf


@scalar
def maximum(a: float, b: float) -> float:
    """Return the larger number, NaN if one is."""
    return a if a >= b or a != a else b


@loop
def has_nan(values: Any) -> bool:
    """Say whether there is a NaN among the numbers of a flat array."""
    count = 0
    for i in range(values.size):
        count += values[i] != values[i]
    return count > 0
