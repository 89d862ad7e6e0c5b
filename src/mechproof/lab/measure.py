"""Measure: accuracy, proofs and time of every way of computing a quantity, in one record.

Records report on points drawn with the seed REPORT; the search starts from those of the seed TUNE.
"""

from __future__ import annotations

import os
import platform
import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import Executor
from contextlib import suppress
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import numpy as np

from mechproof.executors import check_executor
from mechproof.lab.accuracy import Report, measure_accuracy
from mechproof.lab.sampling.named_sets import REPORT, TUNE
from mechproof.lab.sampling.point_sets import list_sets
from mechproof.lab.subject import Subject
from mechproof.lab.timing import FULL, QUICK, Effort, list_tailored, time_subject, time_ufuncs
from mechproof.lab.ways import Way
from mechproof.measured import Machine, MeasuredWay, Point, Record
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import Accuracy


@dataclass(frozen=True)
class Depth:
    """How much is measured: points per set at most, rounds of the search, and effort of timing."""

    points: int | None
    rounds: int
    effort: Effort


DEPTHS = {False: Depth(None, 20, FULL), True: Depth(24, 1, QUICK)}


def measure(
    subject: Subject,
    *,
    quick: bool = False,
    report: Report = lambda text: None,
    executor: Executor | None = None,
    known: Sequence[Point] = (),
) -> Record:
    """Return the record of one quantity: its ways, errors on sets and in cells, search, times.

    Bad inputs `known` from an earlier record count unless the search finds worse ones. An executor
    of `concurrent.futures` spreads the measurement of accuracy, without changing the result. Times
    are taken in this process, when the executor has nothing left to do.
    """
    check_executor(executor)
    depth, accuracy = DEPTHS[quick], subject.quantity.accuracy
    report("proofs")
    ways = describe_ways(subject)
    found = measure_accuracy(subject, depth.points, depth.rounds, report, executor, known)
    report("tailoring")
    tailored = list_tailored(subject, depth.effort.sizes[-1])
    report("time")
    return Record(
        quantity=subject.name,
        unit=subject.quantity.unit,
        taken=datetime.now(UTC).isoformat(timespec="seconds"),
        quick=quick,
        machine=describe_machine(),
        load=round(os.getloadavg()[0], 2) if hasattr(os, "getloadavg") else None,
        seeds={"tune": TUNE, "report": REPORT},
        scale=_name_scale(accuracy),
        bound=float(accuracy.ulp) if accuracy else None,
        typical=list_sets(subject)[0].name,
        ranges=found.ranges,
        searched=found.searched,
        ufuncs=time_ufuncs(),
        ways=ways,
        sets=found.sets,
        cells=found.cells,
        cell_errors=found.cell_errors,
        tailored=tuple(about for about, _ in tailored),
        times=tuple(time_subject(subject, depth.effort, tailored)),
    )


def _name_scale(accuracy: Accuracy | None) -> str:
    if accuracy is None:
        return ""
    return accuracy.scale.name if accuracy.scale else "the value"


def describe_ways(subject: Subject) -> tuple[MeasuredWay, ...]:
    """Describe every way; the ledger's rows about its source are judged here."""
    return tuple(_describe(subject, way) for way in subject.ways)


def _describe(subject: Subject, way: Way) -> MeasuredWay:
    bound = "" if way.bound is None else str(way.bound)
    about = MeasuredWay(
        way.name,
        way.kind,
        bound=bound,
        ordered=way.ordered,
        key=way.key,
        needs=way.needs,
        note=way.note,
    )
    if not way.rows:
        return about
    judged = [judge(row, subject.paper) for row in way.rows]
    worst = next((j for j in judged if j.verdict is not Verdict.PROVED), judged[-1])
    parts = {row.on.text for row in way.rows if row.on} if way.kind == "form" else set()
    return replace(
        about, verdict=worst.verdict.value, rung=worst.rung, proved_on="; ".join(sorted(parts))
    )


VERSIONS = ("mechproof", "numpy", "scipy", "sympy", "python-flint", "numba")


def describe_machine() -> Machine:
    """Describe the processor, the SIMD extensions NumPy uses, and versions that affect results."""
    simd = np.show_config(mode="dicts")["SIMD Extensions"]
    return Machine(
        processor=_processor(),
        cores=os.cpu_count(),
        simd=tuple(simd["found"]),
        system=platform.system(),
        python=".".join(map(str, sys.version_info[:3])),
        versions=dict(_list_versions()),
    )


def _list_versions() -> Iterator[tuple[str, str]]:
    """Yield the installed versions of the packages that affect results."""
    for name in VERSIONS:
        with suppress(PackageNotFoundError):
            yield name, version(name)


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8").splitlines() if info.is_file() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor()
