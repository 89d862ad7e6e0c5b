"""No times are taken in these tests, so that measurements are the same in each run."""

from __future__ import annotations

import pytest

from mechproof.lab import measure as measuring


@pytest.fixture(autouse=True)
def _untimed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(measuring, "time_subject", lambda *given: ())
    monkeypatch.setattr(measuring, "time_ufuncs", dict)
