"""Compiled shares only: threads, imports, and the code that numba caches."""

from __future__ import annotations

import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest
from cases import GROUP, NAMES

from mechproof import conformity
from mechproof.conformity import Normal, Uniform, compiled

pytestmark = pytest.mark.xdist_group(GROUP)


def draw_sets(count: int) -> tuple[Any, ...]:
    """Draw errors of 0.01 to 10 times the spread, limits at 1 to 7 times both, guard bands."""
    rng = np.random.default_rng(5)
    s = 10 ** rng.uniform(-2, 1, count)
    reach = rng.uniform(1, 7, (2, count)) * np.hypot(1, s)
    laws = Normal(rng.uniform(-0.5, 0.5, count), 1), Normal(rng.uniform(-0.5, 0.5, count) * s, s)
    guard = rng.choice([0, 0.5, 1e-3], count) * s
    return *laws, (-reach[0], reach[1]), (-reach[0] + guard, reach[1] + 2 * guard)


def same(one: conformity.Shares, other: conformity.Shares) -> bool:
    return all(np.array_equal(getattr(one, n), getattr(other, n), equal_nan=True) for n in NAMES)


def test_both_ways_agree_wherever_shares_do_not_underflow() -> None:
    sets = draw_sets(20_000)
    arrays, loops = conformity.shares(*sets), compiled.shares(*sets)
    for name in NAMES:
        wanted = getattr(arrays, name)
        seen = wanted > 1e-100
        np.testing.assert_allclose(getattr(loops, name)[seen], wanted[seen], rtol=1e-12)


def test_sets_do_not_depend_on_those_beside_them() -> None:
    """Enough sets for threads to share, few enough to end within a block, and a single one."""
    true, error, tolerance, acceptance = draw_sets(2 * compiled.THREADED + 37)
    whole = compiled.shares(true, error, tolerance, acceptance)
    for part in (slice(0, 1), slice(63, 66), slice(compiled.PART - 1, compiled.PART + 200)):
        laws = (
            Normal(
                np.broadcast_to(law.mean, error.std.shape)[part],
                np.broadcast_to(law.std, error.std.shape)[part],
            )
            for law in (true, error)
        )
        limits = ([side[part] for side in pair] for pair in (tolerance, acceptance))
        few = compiled.shares(*laws, *limits)
        for name in NAMES:
            assert np.array_equal(getattr(few, name), getattr(whole, name)[part])


def test_four_threads_at_once() -> None:
    sets = draw_sets(compiled.THREADED + 1000)
    wanted = compiled.shares(*sets)
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda _: compiled.shares(*sets), range(16)))
    assert all(same(one, wanted) for one in found)


def test_other_laws_take_the_quadrature() -> None:
    laws = Uniform(-4, 4), Normal(0, 0.5)
    assert same(compiled.shares(*laws, (-3, 3)), conformity.shares(*laws, (-3, 3)))


def test_without_numba_the_error_names_the_extra() -> None:
    code = "import sys; sys.modules['numba'] = None; import mechproof.conformity.compiled"
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert "need numba, the extra fast" in done.stderr


def test_numba_keeps_the_loop_until_a_formula_changes() -> None:
    """Numba's cache key includes the loop's closure, which holds the hash of the formula files."""
    (enclosed,) = compiled._fill.py_func.__closure__
    assert enclosed.cell_contents == compiled._hash_sources(*compiled.SOURCES)
    assert compiled._hash_sources(*compiled.SOURCES[1:]) != enclosed.cell_contents
    compiled.shares(Normal(0, 1), Normal(0, 0.3), (-3, 3))
    stats = compiled._fill.stats
    assert sum(stats.cache_hits.values()) + sum(stats.cache_misses.values()) == 1
