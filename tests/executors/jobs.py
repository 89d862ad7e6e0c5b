"""Jobs for executors, and executors of each kind."""

from __future__ import annotations

import multiprocessing
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from typing import Any

import numpy as np
import sympy as sp

from mechproof import ThicknessInspection, WedgeLinkage
from mechproof.conformity import Normal, Uniform
from mechproof.kernels import wedge_linkage
from mechproof.lab import measure as measuring
from mechproof.lab.subject import find_subjects
from mechproof.record import Argument, Form, Paper, Quantity, Variable
from mechproof.tolerance import Size, certified_range, corner_range, monte_carlo_range
from mechproof.tolerance.scatter import DRAWN
from mechproof.tools.processes import START

SIZES = WedgeLinkage.published_sizes(1)
WHEEL = {"R": Size(41.5, 0.1, -0.1), "A": Size(3.75, 0.2, -0.1), "z": Size(6)}
x, a, b = sp.symbols("x a b", real=True)
ARGUMENTS = tuple(Argument(str(s), (s,), str(s)) for s in (x, a, b))
VALUE = x * b + sp.Max(0, a - a**2 / 2)
OWN = Paper(
    "own",
    "",
    tuple(Variable(s, str(s)) for s in (x, a, b)),
    (),
    quantities=(Quantity("f", "Compute f.", ARGUMENTS, VALUE, (Form("f", VALUE),), "here"),),
)
BOX = {"a": Size(0.0, 1.5, -1.0), "b": Size(2.0, 0.5, -0.5)}
X1 = np.array([-40.0, -37.1, np.nan, -20.0, -1.0, 0.0])


def make_executor(kind: str) -> Executor:
    if kind == "threads":
        return ThreadPoolExecutor(3)
    context = multiprocessing.get_context(START)
    return ProcessPoolExecutor(1 if kind == "one process" else 2, context)


def corners(executor: Executor | None) -> Any:
    return corner_range(wedge_linkage.position, X1, SIZES, chunk=64, executor=executor)


def boundaries(executor: Executor | None) -> Any:
    deviations = {"l_BC": (1.0, -1.0), "alpha_KL": (0.02, -0.01)}
    return WedgeLinkage.published(1).tolerance_range(X1, deviations, executor=executor)


def scatter(executor: Executor | None) -> Any:
    return monte_carlo_range(
        wedge_linkage.position,
        X1,
        SIZES,
        laws=Size.uniform,
        rng=np.random.default_rng(7),
        count=2 * DRAWN + 1,
        executor=executor,
    )


def bounds(executor: Executor | None) -> Any:
    angles = np.append(np.linspace(0, 6, 9), np.nan)
    return certified_range("track_wheel", "radius", angles, WHEEL, executor=executor)


def own(executor: Executor | None) -> Any:
    return certified_range(OWN, "f", [0.0, 1.0], BOX, executor=executor)


def shares(executor: Executor | None) -> Any:
    gauge = Normal.from_width(0, 0.004, 4)
    inspection = ThicknessInspection.published(
        true=Normal.from_width(-0.0345, 0.045, 6),
        tip_diameter=Uniform(-0.03, 0.03),
        height=gauge,
        thickness=gauge,
    )
    rng = np.random.default_rng(8)
    return inspection.simulate(rng=rng, count=100_001, chunk=10_000, executor=executor)


def accuracy(executor: Executor | None) -> Any:
    (subject,) = find_subjects(("track_wheel.planar_error",))
    record = measuring.measure(subject, quick=True, executor=executor)
    return record.sets, record.cells, record.cell_errors, record.ranges, record.searched


JOBS = (corners, boundaries, scatter, bounds, own, shares, accuracy)
