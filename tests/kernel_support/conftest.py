"""Blocks of few points, for all tests of the kernels' support."""

from __future__ import annotations

import pytest


@pytest.fixture
def small_blocks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mechproof.kernel_support.blocks.BLOCK", 6)
