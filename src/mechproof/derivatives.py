"""Partial derivatives of a function of numbers, by a generated kernel if it has one.

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
    """Return the derivative kernel of a NumPy or compiled kernel; None for other functions."""
    module, name = (str(getattr(function, word, "")) for word in ("__module__", "__name__"))
    package, _, system = module.removeprefix(f"{KERNELS}.").rpartition(".")
    own = f"{KERNELS}.derivatives.{system}"
    if not module.startswith(f"{KERNELS}.") or package not in ("", "compiled"):
        return None
    found = getattr(import_module(own), name, None) if find_spec(own) else None
    return found if callable(found) else None


def differentiate(function: Function, arguments: Mapping[str, Any]) -> dict[str, Any] | None:
    """Return the derivatives of a kernel by all arguments; None if it has no derivative kernel.

    `arguments` are given by name, as arrays that broadcast; each derivative has their common shape.
    An argument that is left out has its default.
    """
    derivatives = find_derivatives(function)
    if derivatives is None:
        return None
    names = [name for name in inspect.signature(derivatives).parameters if name != "out"]
    columns = np.moveaxis(derivatives(**arguments), -1, 0)
    return {name: column[()] for name, column in zip(names, columns, strict=True)}
