"""Libraries of kernels in C, shared by all tests of emitted code."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import cache

import pytest


@pytest.fixture(scope="session")
def libraries(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., ctypes.CDLL]:
    from c_libraries import STRICT, build

    folder = tmp_path_factory.mktemp("c")

    @cache
    def load(system: str, single: bool, flags: tuple[str, ...] = STRICT) -> ctypes.CDLL:
        return build(folder, system, single, flags)

    return load
