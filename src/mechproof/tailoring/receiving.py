"""Receiving: what is needed to tailor, and to read a kernel that was pickled elsewhere.

Nothing of the extra is loaded before it is known to be there.
"""

from __future__ import annotations

import pickle
from functools import lru_cache
from typing import Any

from mechproof.executors import BALLS
from mechproof.tools.extras import require_modules

# What tailoring needs of the extra, as it is imported.
NEEDED = ("flint", "jinja2", "mpmath", "sympy")
# Backends that are modules of the extra fast.
FAST = ("numba",)


def receive(backend: str, written: bytes) -> Any:
    """Make a pickled kernel again; ImportError naming the extra that its backend needs.

    What is written holds the function that makes it, which loads the extra, and what that takes.
    """
    require_modules("a tailored kernel", "derive", NEEDED)
    require_modules(f"a kernel tailored for {backend}", "fast", [m for m in FAST if m == backend])
    return _make(written)


# A process that is sent one kernel with each of its tasks prints and reads it once.
@lru_cache
def _make(written: bytes) -> Any:
    make, *arguments = pickle.loads(written)
    with BALLS:
        return make(*arguments)
