"""JAX in a process of its own: its threads are unsafe in a process that forks."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import cache, partial
from multiprocessing import get_context
from typing import Any

import numpy as np

from mechproof.tools.processes import end_with_parent


def compute(text: str, name: str, points: Sequence[Any], **how: Any) -> Any:
    """Evaluate the function `name` of the source `text` at points, in float64.

    With `slopes`, return its derivatives with respect to every argument, stacked along a last axis.
    With `compiled=False`, run it operation by operation; `options` go to the compiler.
    """
    return _open().submit(_compute, text, name, points, **how).result()


@cache
def _open() -> ProcessPoolExecutor:
    return ProcessPoolExecutor(1, get_context("spawn"), end_with_parent)


def _compute(
    text: str,
    name: str,
    points: Sequence[Any],
    *,
    slopes: bool = False,
    compiled: bool = True,
    options: dict[str, Any] | None = None,
) -> Any:
    import jax
    import jax.numpy as jnp

    jax.config.update("jax_enable_x64", True)
    scope: dict[str, Any] = {}
    exec(text, scope)
    function = partial(scope[name], xp=jnp)
    if slopes:
        function = jax.vmap(jax.grad(function, argnums=tuple(range(len(points)))))
    if compiled:
        function = jax.jit(function, compiler_options=options)
    given = [jnp.asarray(p) if isinstance(p, np.ndarray) else p for p in points]
    found = function(*given)
    return np.stack(found, -1) if slopes else np.asarray(found)
