"""What all tests share."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from mechproof.proof.cache import VARIABLE


@pytest.fixture(autouse=True, scope="session")
def cache_apart(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Keep the verdicts of tests out of the user's cache."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(VARIABLE, str(tmp_path_factory.mktemp("cache")))
        yield
