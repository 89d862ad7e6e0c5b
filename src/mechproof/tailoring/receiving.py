"""Receiving: the modules needed to tailor a kernel, and to read one pickled elsewhere.

Nothing from an extra is loaded before it is known to be installed.
"""

from __future__ import annotations

import pickle
from functools import lru_cache
from typing import Any

from mechproof.executors import BALLS
from mechproof.tools.extras import require_modules

# What tailoring needs of the extra, by import name.
NEEDED = ("flint", "jinja2", "mpmath", "sympy")
# Backends that are modules of the extra `fast`.
FAST = ("numba",)


def receive(backend: str, written: bytes) -> Any:
    """Rebuild a pickled kernel; an ImportError names the extra that its backend needs.

    `written` is the pickle of the function that makes the kernel, which loads the extra, and its
    arguments.
    """
    require_modules("a tailored kernel", "derive", NEEDED)
    require_modules(f"a kernel tailored for {backend}", "fast", [m for m in FAST if m == backend])
    return _make(written)


# Cached, so that a process that receives one kernel with each task prints and reads it only once.
@lru_cache
def _make(written: bytes) -> Any:
    make, *arguments = pickle.loads(written)
    with BALLS:
        return make(*arguments)
