"""Compiled kernels in other processes, in other places, and where nothing can be written."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from mechproof import kernels

FORKED = """
import os, signal
import numpy as np
from mechproof.kernels.compiled import elliptic_planetary
phi = np.linspace(0, 6, 2**17)
expected = elliptic_planetary.position(phi, 66.0, 16.0, 0.475)
child = os.fork()
if not child:
    signal.alarm(60)
    found = elliptic_planetary.position(phi, 66.0, 16.0, 0.475)
    os._exit(not np.array_equal(found, expected))
raise SystemExit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
"""
AS_A_MODULE = """
import sys
from importlib.util import module_from_spec, spec_from_file_location
name, file = sys.argv[1:]
spec = spec_from_file_location(name, file)
module = sys.modules[name] = module_from_spec(spec)
spec.loader.exec_module(module)
print(module.largest_ratio(66.0, 16.0, 0.475))
"""
WITHOUT_A_HOME = """
import os, pathlib, warnings
from numba.core.caching import CacheImpl
CacheImpl._locator_classes = []
def refuse():
    raise RuntimeError("no home")
pathlib.Path.home = refuse
for name in ("MECHPROOF_CACHE", "XDG_CACHE_HOME"):
    os.environ.pop(name, None)
with warnings.catch_warnings(record=True) as told:
    warnings.simplefilter("always")
    import mechproof
    sizes = {"R1": 66, "R2": 16, "e": 0.475}
    position = mechproof.tailor("elliptic_planetary.position", error=1e-3, **sizes)
    from mechproof.kernels.compiled import elliptic_planetary
assert abs(position(50.0) - elliptic_planetary.position(50.0, *sizes.values())) <= 1e-3
print(len(told), *(str(w.message) for w in told))
"""


def run(code: str, *arguments: str, **variables: str) -> str:
    kept = {name: value for name, value in os.environ.items() if name != "NUMBA_CACHE_DIR"}
    done = subprocess.run(
        [sys.executable, "-c", code, *arguments],
        capture_output=True, text=True, env=kept | variables, check=False, timeout=240,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="nothing is forked here")
def test_a_forked_child_has_threads_of_its_own() -> None:
    run(FORKED)


@pytest.mark.slow
def test_kept_code_is_that_of_the_module(tmp_path: Path) -> None:
    """One file is loaded under two names, and copied along with its cached code."""
    source = Path(str(kernels.__file__)).with_name("compiled") / "elliptic_planetary.py"
    file = tmp_path / "here" / source.name
    file.parent.mkdir()
    shutil.copy(source, file)
    found = {run(AS_A_MODULE, name, str(file)) for name in ("one", "another")}
    shutil.copytree(file.parent, tmp_path / "there")
    found.add(run(AS_A_MODULE, "third", str(tmp_path / "there" / source.name)))
    assert len(found) == 1
    assert any(file.parent.rglob("*.nbi"))


@pytest.mark.thorough
def test_without_a_home_nothing_is_kept_and_this_is_said_once() -> None:
    assert run(WITHOUT_A_HOME).startswith("1 compiled kernels are recompiled in every process")
