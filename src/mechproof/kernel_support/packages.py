"""Lazy modules: attributes of a package that are imported when they are first used."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from types import ModuleType


def find_modules(package: str) -> Callable[[str], ModuleType]:
    """Return a `__getattr__` for a package that imports its modules when they are first used.

    It raises AttributeError for a name that is no module of the package.
    """

    def find(name: str) -> ModuleType:
        full = f"{package}.{name}"
        if not name.startswith("_"):
            try:
                return import_module(full)
            except ModuleNotFoundError as error:
                if error.name != full:
                    raise
        raise AttributeError(f"module {package!r} has no attribute {name!r}")

    return find
