"""What all tests share."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from mechproof.cache import VARIABLE


@pytest.fixture(autouse=True, scope="session")
def cache_apart(request: pytest.FixtureRequest) -> Iterator[None]:
    """Keep the verdicts of tests out of the user's cache, in one that `--cache-clear` empties.

    A row is judged anew when the prover or the row differs: all processes of a run, and the runs
    that follow, may share what one of them has judged.
    """
    cache = request.config.cache
    assert cache is not None
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(VARIABLE, str(cache.mkdir("mechproof")))
        yield
