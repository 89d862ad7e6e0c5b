"""`--one-in N` keeps one in N thorough tests, chosen by their names alone, and all other tests."""

from __future__ import annotations

import random
from dataclasses import dataclass, replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest


@dataclass(frozen=True)
class Item:
    """A stand-in for a test, with the attributes that the choice reads."""

    path: Path
    name: str
    mark: str = "thorough"

    def get_closest_marker(self, name: str) -> bool:
        return name == self.mark


ITEMS = [Item(Path(f"test_{f}.py"), f"test_it[{number}]") for f in "abc" for number in range(35)]


def choose(plugin: Any, count: int, items: list[Item]) -> tuple[set[str], set[str]]:
    """Return the names of the tests kept, and of those reported as deselected."""
    left_out: list[Item] = []
    hook = SimpleNamespace(pytest_deselected=lambda items: left_out.extend(items))
    kept = [*items]
    plugin.pytest_choose_share(SimpleNamespace(getoption=lambda name: count, hook=hook), kept)
    named = [[f"{item.path} {item.name}" for item in part] for part in (kept, left_out)]
    assert sorted(named[0] + named[1]) == sorted(f"{item.path} {item.name}" for item in items)
    return set(named[0]), set(named[1])


@pytest.fixture(scope="module")
def plugin(pytestconfig: pytest.Config) -> Any:
    found = pytestconfig.pluginmanager.get_plugin(str(Path(__file__).with_name("conftest.py")))
    assert found is not None
    return found


def test_a_part_is_the_same_in_every_order_and_of_every_file(plugin: Any) -> None:
    kept, _ = choose(plugin, 7, ITEMS)
    assert len(kept) == 15
    assert {name.partition(" ")[0] for name in kept} == {f"test_{file}.py" for file in "abc"}
    for seed in range(3):
        mixed = random.Random(seed).sample(ITEMS, len(ITEMS))
        assert choose(plugin, 7, mixed)[0] == kept
    assert choose(plugin, 1, ITEMS) == ({f"{item.path} {item.name}" for item in ITEMS}, set())


def test_what_is_not_thorough_is_kept(plugin: Any) -> None:
    slow = [replace(item, name=f"{item.name} slow", mark="slow") for item in ITEMS]
    kept, _ = choose(plugin, 7, [*ITEMS, *slow])
    assert kept == {*choose(plugin, 7, ITEMS)[0], *choose(plugin, 1, slow)[0]}


@pytest.mark.parametrize("count", [0, -1])
def test_what_is_no_part_is_refused(count: int, plugin: Any) -> None:
    config = SimpleNamespace(getoption=lambda name: count)
    with pytest.raises(pytest.UsageError, match=f"--one-in = {count}: must be at least 1"):
        plugin.pytest_configure(config)
