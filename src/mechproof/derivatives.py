"""Partial derivatives of a function of numbers: by the generated kernel where it has one.

>>> from mechproof.kernels.elliptic_planetary import largest_ratio
>>> slopes = differentiate(largest_ratio, {"R1": 66.0, "R2": 16.0, "e": 0.475})
>>> round(float(slopes["e"]), 3)
29.932
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import numpy as np

from mechproof.measured import KERNELS

Function = Callable[..., Any]


def find_derivatives(function: Function) -> Function | None:
    """Return the kernel of the derivatives of a kernel, NumPy's or compiled; None for others."""
    module, name = (str(getattr(function, word, "")) for word in ("__module__", "__name__"))
    package, _, system = module.removeprefix(f"{KERNELS}.").rpartition(".")
    own = f"{KERNELS}.derivatives.{system}"
    if not module.startswith(f"{KERNELS}.") or package not in ("", "compiled"):
        return None
    found = getattr(import_module(own), name, None) if find_spec(own) else None
    return found if callable(found) else None


def differentiate(function: Function, arguments: Mapping[str, Any]) -> dict[str, Any] | None:
    """Return the derivative by every argument of a kernel; None for what has no such kernel.

    `arguments` are by name, arrays that broadcast; so is each derivative. An argument that is
    left out counts with its default.
    """
    derivatives = find_derivatives(function)
    if derivatives is None:
        return None
    names = [name for name in inspect.signature(derivatives).parameters if name != "out"]
    columns = np.moveaxis(derivatives(**arguments), -1, 0)
    return {name: column[()] for name, column in zip(names, columns, strict=True)}
