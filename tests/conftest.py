"""What all tests share."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from mechproof.cache import VARIABLE

# What takes longest begins first: no worker waits for another at the end.
LONGEST = (
    *("workshop", "report", "cluster", "verdicts wedge_linkage"),
    *("tailoring/test_tailored_bounds.py", "verdicts elliptic_planetary"),
)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Keep the tests of a file in one worker, which loads and compiles what they share once."""
    groups = {item: _find_group(item) for item in items}
    for item, group in groups.items():
        item.add_marker(pytest.mark.xdist_group(group))
    items.sort(key=lambda item: groups[item] not in LONGEST)


def _find_group(item: pytest.Item) -> str:
    """Name the group that a test is marked with, or its file."""
    marked = item.get_closest_marker("xdist_group")
    return str(marked.args[0] if marked else item.path.relative_to(Path(__file__).parent))


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
