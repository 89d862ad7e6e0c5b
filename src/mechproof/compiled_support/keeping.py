"""Compiled code cached in files, by the module that it was compiled as; optional if it fails."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from functools import cache
from hashlib import sha256
from typing import Any

from numba import njit
from numba.core.caching import CompileResultCacheImpl, FunctionCache


class _Files(CompileResultCacheImpl):  # type: ignore[misc]
    """Separate files for each module name, by which compiled code finds the functions it calls."""

    def __init__(self, function: Callable[..., Any]) -> None:
        super().__init__(function)
        self._filename_base += f"-{sha256(function.__module__.encode()).hexdigest()[:8]}"


class _Kept(FunctionCache):  # type: ignore[misc]
    """numba's cache of a function's machine code, but an unwritable folder is no error."""

    _impl_class = _Files

    def save_overload(self, sig: Any, data: Any) -> None:
        try:
            super().save_overload(sig, data)
        except OSError:
            _say_once()


def compile_kept(**options: Any) -> Callable[[Callable[..., Any]], Any]:
    """Return a decorator that compiles a function on its first call and caches it in a file."""
    compiled = njit(**options)

    def decorate(function: Callable[..., Any]) -> Any:
        dispatcher = compiled(function)
        # With numba's compiler disabled, `njit` returns the function itself.
        if dispatcher is not function:
            try:
                dispatcher._cache = _Kept(function)
            except RuntimeError:
                _say_once()
        return dispatcher

    return decorate


@cache
def _say_once() -> None:
    warnings.warn(
        "compiled kernels are recompiled in every process, as no cache folder can be written; "
        "name one in NUMBA_CACHE_DIR",
        RuntimeWarning,
        stacklevel=3,
    )
