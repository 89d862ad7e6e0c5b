"""Machine operations for functions that compute one point, and decorators that compile these.

Functions marked `scalar` compute one point; those marked `loop` fill a flat array.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from inspect import signature
from typing import Any

try:
    from llvmlite import ir
    from numba import njit, typeof, types, vectorize
    from numba.extending import intrinsic, overload
except ImportError as error:
    from mechproof.tools.extras import suggest_install

    raise ImportError(
        f"compiled kernels and shares need numba, the extra fast: {suggest_install('fast')}"
    ) from error

from mechproof.compiled_support.keeping import compile_kept

_REAL = types.float64
__all__ = [
    "apart", "bare", "choose", "copysign", "floor", "fma", "inner", "is_finite", "loop", "maximum",
    "overload", "point_of", "power_of_two", "rint", "scalar", "stand_in", "typeof", "widen",
    "within",
]  # fmt: skip

_HOW = {"error_model": "numpy", "nogil": True, "no_cfunc_wrapper": True}
# Without an entry from Python, which takes as long to compile as a short function.
_INSIDE = {**_HOW, "no_cpython_wrapper": True}


def _call_inside(compiled: Callable[..., Any]) -> Callable[[Callable[..., Any]], Any]:
    """Return a decorator for what compiled functions call; Python calls a copy with an entry."""

    def decorate(function: Callable[..., Any]) -> Any:
        dispatcher = compiled(function)
        if dispatcher is not function:
            entered = cache(lambda: njit(**_HOW)(function))
            # Otherwise numba would jump to the missing entry.
            dispatcher._insert = lambda *overload: None
            dispatcher._compile_for_args = lambda *values: entered()
        return dispatcher

    return decorate


loop = compile_kept(**_HOW)
_entered = compile_kept(**_HOW, forceinline=True)
scalar = _call_inside(compile_kept(**_INSIDE, forceinline=True))
# A loop that is cached in a file with its caller, not on its own.
inner = _call_inside(njit(**_INSIDE))
# A function that is always inlined into its caller, and one that never is.
within = _call_inside(njit(**_INSIDE, forceinline=True))
apart = _call_inside(njit(**_INSIDE, forceinline=False))


def stand_in(function: Callable[..., Any], **options: Any) -> Callable[..., Any]:
    """Return a decorator whose function compiled code calls wherever `function` is called.

    A function may stand in for itself: compiled code then compiles it unchanged.
    """

    def register(implementation: Callable[..., Any]) -> Callable[..., Any]:
        kept = {"error_model": "numpy", "no_cfunc_wrapper": True, **options}
        taken = overload(function, jit_options=kept, strict=False)
        taken(lambda *values, **named: implementation)
        return implementation

    return register


def point_of(
    kernel: Callable[..., Any], *, spread: bool = False
) -> Callable[[Callable[..., Any]], Any]:
    """Return a decorator for the function that computes one point of a kernel.

    Compiled code that calls the kernel calls this function; with `spread`, it can also call the
    kernel with arrays, which broadcast.
    """

    def register(function: Callable[..., Any]) -> Any:
        if spread:
            overload(kernel, jit_options=_HOW, strict=False)(_spread(function))
        return _entered(stand_in(kernel)(function))

    return register


def _spread(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return the overload that gives numba a vectorised implementation if a type is an array."""

    @cache
    def write() -> Any:
        # Arguments may be given by name, so the implementation needs those names.
        taken = signature(function)
        names: dict[str, Any] = {"each": vectorize(function)}
        exec(f"def spread{taken}: return each({', '.join(taken.parameters)})", names)
        return names["spread"]

    def choose(*values: Any, **named: Any) -> Any:
        given = (*values, *named.values())
        return write() if any(isinstance(value, types.Array) for value in given) else None

    return choose


@intrinsic
def bare(typingctx: Any, function: Any) -> Any:
    """Return a compiled function without its address, which would prevent caching in a file.

    Its type determines what is called.
    """
    return function(function), lambda context, builder, signature, given: context.get_dummy_value()


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
    """Return the whole number nearest to a."""
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
    """Return 2**n for a whole number n, provided that the result is a normal number.

    The last bits of n + 3/2 * 2**52 + bias are those of the result's exponent.
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
    """Ask for the widest vectors, without scatter stores, in the loop that calls this.

    LLVM prefers vectors of half the width where it fears a lower clock rate; loops of products and
    sums gain up to a third from the full width. With scatter stores, results of several components
    take up to twice as long.
    """

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        attributes = builder.function.attributes
        # Inlined, it would be compiled with its caller's attributes.
        attributes.add("noinline")
        # Added by `set.add`, because llvmlite accepts only attributes without values.
        set.add(attributes, '"prefer-vector-width"="512"')
        features = context.codegen()._tm_features
        if "+avx512f" in features:
            set.add(attributes, f'"target-features"="{features},+prefer-no-scatter"')
        return context.get_dummy_value()

    return types.void(), generate


@scalar
def is_finite(a: float) -> bool:
    """Return whether a number is neither infinite nor NaN."""
    return abs(a) < math.inf


@scalar
def maximum(a: float, b: float) -> float:
    """Return the larger number, NaN if either is NaN."""
    return a if a >= b or a != a else b
