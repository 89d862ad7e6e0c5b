"""Several compiled kernels in one pass: the bits of each, and kernels without a common pass."""

from __future__ import annotations

from dataclasses import replace
from importlib import import_module
from itertools import product
from typing import Any

import numpy as np
import pytest
from compiled import PHI, SIZES, TOGETHER, grouped
from derived import SYSTEMS, paper_of
from weights import first_of

from mechproof.codegen.backends.numba import render_compiled
from mechproof.compiled_support import loops
from mechproof.kernels.compiled import elliptic_planetary
from mechproof.record import OnePass

OF_SYSTEM = {
    "elliptic_planetary": [(66.0, 16.0, 0.475), (66.0, 16.0, np.array([[0.1], [0.9]])), (1, 2, 3)],
    "oval_planetary": [(0.2, 0.3), (0.2, np.array([[0.1], [0.3]])), (2.0, 0.1)],
}
CYLINDRICAL = [(20.0, 40.0, 0.2), (20.0, 40.0, np.array([[0.1], [0.9]])), (20.0, 40.0, 3.0)]


def test_all_that_is_computed_in_one_pass_is_tested_here() -> None:
    found = {
        f"{system}.{t.name}": t.quantities for system in SYSTEMS for t in paper_of(system).one_pass
    }
    assert found == TOGETHER


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "place"), first_of(product((float, np.float32), (1, 0, 2))))
@pytest.mark.parametrize("name", grouped(TOGETHER))
def test_one_pass_gives_the_bits_of_each_kernel(
    name: str, kind: type, place: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    system, _, function = name.partition(".")
    module = import_module(f"mechproof.kernels.compiled.{system}")
    together = getattr(module, function)
    kernels = [getattr(module, name) for name in TOGETHER[name]]
    sizes = (CYLINDRICAL if name.endswith("cylindrical") else OF_SYSTEM[system])[place]
    points = np.concatenate([PHI, [0.0, np.nan, np.inf, 1e9, 1e-300]]).astype(kind)
    for number in (1, 100):
        # With and without threads.
        monkeypatch.setattr(loops, "THREADED", loops.THREADED // number**2)
        for phi in (points, points[::3], kind(0.3)):
            wanted = np.array([kernel(phi, *sizes) for kernel in kernels])
            found = together(phi, *sizes)
            assert found.dtype == wanted.dtype
            assert np.array_equal(found, wanted, equal_nan=True)
            out = np.empty_like(wanted)
            assert together(phi, *sizes, out=out) is out
            assert np.array_equal(out, wanted, equal_nan=True)


def test_one_pass_inside_compiled_functions_and_its_errors() -> None:
    import numba

    @numba.njit
    def call(phi: float) -> Any:
        position, ratio, acceleration = elliptic_planetary.motion(phi, 66, 16, 0.475)
        return position + 10 * ratio + 100 * acceleration

    position, ratio, acceleration = elliptic_planetary.motion(0.3, *SIZES)
    assert call(0.3) == position + 10 * ratio + 100 * acceleration
    with pytest.raises(ValueError, match=r"out: expected shape \(3, 4000\)"):
        elliptic_planetary.motion(PHI, *SIZES, out=np.empty((4000, 3)))
    with pytest.raises(TypeError, match="R1: expected real numbers"):
        elliptic_planetary.motion(PHI, "x", 16.0, 0.5)


@pytest.mark.parametrize(
    ("system", "names", "message"),
    [
        ("elliptic_planetary", ("position", "speed"), r"no quantities with forms: \['speed'\]"),
        (
            "elliptic_planetary",
            ("position", "largest_ratio"),
            "quantities with different arguments",
        ),
        ("track_wheel", ("rotation", "rotation"), r"\['rotation', 'rotation'\] are not computed"),
    ],
)
def test_what_has_no_pass_in_common_is_refused(
    system: str, names: tuple[str, ...], message: str
) -> None:
    with pytest.raises((ValueError, NotImplementedError), match=message):
        render_compiled(replace(paper_of(system), one_pass=(OnePass("all", names),)))
    with pytest.raises(ValueError, match=r"quantities given twice: \['rotation'\]"):
        replace(paper_of("track_wheel"), one_pass=(OnePass("rotation", ("rotation",)),))
