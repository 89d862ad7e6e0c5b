"""Measure: accuracy, proofs and time of every form of a subject, into one JSON record.

The tables report the points of the seed REPORT; the search climbs from those of the seed TUNE.
"""

from __future__ import annotations

import json
import math
import os
import platform
import sys
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from mechproof.lab.bounds import bound_over
from mechproof.lab.error import find_errors, summarise
from mechproof.lab.oracle import Truth, count_points, find_truth
from mechproof.lab.points import REPORT, TUNE, draw_points, list_boxes, list_sets
from mechproof.lab.search import find_worst, within_bar
from mechproof.lab.specimen import Arguments, Array, Specimen
from mechproof.lab.subject import Box, PointSet, Subject, judge_specimen
from mechproof.lab.timing import FULL, QUICK, Effort, time_subject, time_ufuncs
from mechproof.proof.verdict import Judgement

VERSIONS = ("mechproof", "numpy", "scipy", "sympy", "python-flint")
# Simulations and solvers are measured on this many points of a set.
SLOW_SAMPLE = 30


@dataclass(frozen=True)
class Depth:
    """How much is measured: at most so many points of a set, rounds of the search, times."""

    points: int | None
    rounds: int
    effort: Effort


DEPTHS = {False: Depth(None, 20, FULL), True: Depth(24, 2, QUICK)}

Report = Callable[[str], None]


def measure(subject: Subject, *, quick: bool = False, report: Report = lambda text: None) -> Any:
    """Return the record of one subject: forms, accuracy, boxes, worst input, times."""
    depth = DEPTHS[quick]
    report("proofs")
    forms = _describe_forms(subject)
    accuracy = []
    for point_set in list_sets(subject):
        report(f"accuracy, {point_set.name}")
        accuracy += _measure_set(subject, point_set, depth)
    report("boxes")
    boxes, ranges = _measure_boxes(subject, depth)
    report("search")
    worst = _search(subject, depth)
    report("time")
    ufuncs = time_ufuncs()
    times = [row.as_dict() for row in time_subject(subject, depth.effort)]
    bar = subject.quantity.bar
    return {
        "quantity": subject.name,
        "unit": subject.quantity.unit,
        "taken": datetime.now(UTC).isoformat(timespec="seconds"),
        "quick": quick,
        "machine": describe_machine(),
        "versions": {name: version(name) for name in VERSIONS},
        "seeds": {"tune": TUNE, "report": REPORT},
        "scale": bar.of if bar else "the value",
        "bar": bar.ulp if bar else None,
        "forms": forms,
        "accuracy": accuracy,
        "ranges": ranges,
        "boxes": boxes,
        "worst_found": worst,
        "ufuncs": ufuncs,
        "times": times,
    }


def describe_machine() -> dict[str, Any]:
    """Describe the processor, what NumPy uses of it, and how busy the machine was."""
    simd = np.show_config(mode="dicts")["SIMD Extensions"]
    return {
        "processor": _processor(),
        "cores": os.cpu_count(),
        "simd": simd["found"],
        "system": platform.system(),
        "python": ".".join(map(str, sys.version_info[:3])),
        "load": round(os.getloadavg()[0], 2) if hasattr(os, "getloadavg") else None,
    }


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8").splitlines() if info.is_file() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor()


def _describe_forms(subject: Subject) -> list[dict[str, Any]]:
    """Describe every form; what several of them state is decided once."""
    judged: dict[tuple[int, ...], Judgement | None] = {}
    forms = []
    for specimen in subject.specimens:
        stated = id(specimen.says), id(specimen.on), id(specimen.holds_on)
        if stated not in judged:
            judged[stated] = judge_specimen(subject, specimen)
        forms.append(_describe(specimen, judged[stated]))
    return forms


def _describe(specimen: Specimen, judged: Judgement | None) -> dict[str, Any]:
    return {
        "name": specimen.name,
        "source": specimen.source,
        "verdict": judged.verdict.value if judged else None,
        "rung": judged.rung if judged else None,
        "proved_on": specimen.on.text if specimen.on else None,
        "bound": str(specimen.bound) if specimen.bound is not None else None,
        "ordered": specimen.ordered,
        "note": specimen.note,
    }


def _measure_set(subject: Subject, point_set: PointSet, depth: Depth) -> list[dict[str, Any]]:
    """Measure every form on one set; an ordered form is measured on ordered sets only."""
    arguments = draw_points(point_set, REPORT)
    if not point_set.ordered:
        arguments = _thin(subject, arguments, depth.points)
    truth = find_truth(subject, arguments)
    held = np.broadcast_to(within_bar(subject, arguments), truth.decided.shape)
    rows = []
    for specimen in subject.specimens:
        if specimen.ordered <= point_set.ordered:
            row = _measure_form(subject, specimen, arguments, truth, held, point_set.ordered)
            rows.append({"set": point_set.name, "form": specimen.name, **row})
    return rows


def _measure_form(
    subject: Subject,
    specimen: Specimen,
    arguments: Arguments,
    truth: Truth,
    held: Array,
    ordered: bool,
) -> dict[str, Any]:
    if specimen.slow and not ordered:
        chosen = _sample(len(truth.high), SLOW_SAMPLE)
        arguments, truth, held = _take(subject, arguments, chosen), truth[chosen], held[chosen]
    with np.errstate(all="ignore"):
        errors = find_errors(specimen.compute(*arguments), truth)
    summary = summarise(errors, truth, subject.study.period)
    # The bar of the kernel speaks of these points only.
    inside = errors.scaled[held & truth.decided]
    worst = float(np.max(inside)) if inside.size else None
    at = _point(subject, arguments, summary.worst_point)
    record = {**asdict(summary), "worst_where_the_bar_holds": worst, "worst_at": at}
    del record["worst_point"]
    return record


def _measure_boxes(subject: Subject, depth: Depth) -> tuple[list[dict[str, Any]], Any]:
    """Measure every single-point form on boxes of sizes: largest absolute error and bound."""
    study, boxes, spans = subject.study, [], []
    for number, box in enumerate(list_boxes(subject)):
        assert study.in_cell is not None
        arguments = study.in_cell(np.random.default_rng([REPORT, number]), box)
        arguments = _thin(subject, arguments, depth.points)
        truth = find_truth(subject, arguments)
        spans.append([_span(a) for a in arguments])
        boxes.append(
            {
                "box": {name: list(edges) for name, edges in box.items()},
                "points": len(truth.high),
                "undecided": truth.undecided,
                "errors": {
                    s.name: _measure_box(subject, s, arguments, truth, box)
                    for s in subject.specimens
                    if not s.ordered
                },
            }
        )
    return boxes, _find_ranges(subject, spans)


def _find_ranges(subject: Subject, spans: list[list[list[float]]]) -> dict[str, list[float]]:
    """Return the sizes measured: the edges of the boxes, and what else the points spanned."""
    if not spans:
        return {}
    lows, highs = np.min(spans, axis=0)[:, 0], np.max(spans, axis=0)[:, 1]
    names = [argument.name for argument in subject.quantity.arguments]
    found = {n: [float(lo), float(hi)] for n, lo, hi in zip(names, lows, highs, strict=True)}
    edges = {c.argument: [c.edges[0], c.edges[-1]] for c in subject.study.cells}
    return {**found, **edges}


def _measure_box(
    subject: Subject, specimen: Specimen, arguments: Arguments, truth: Truth, box: Box
) -> dict[str, Any]:
    if specimen.slow:
        chosen = _sample(len(truth.high), SLOW_SAMPLE)
        arguments, truth = _take(subject, arguments, chosen), truth[chosen]
    with np.errstate(all="ignore"):
        summary = summarise(find_errors(specimen.compute(*arguments), truth), truth)
    bound = bound_over(subject, specimen, box)
    lost = summary.nan + summary.infinite
    return {"worst": summary.worst_absolute, "bound": bound, "lost": lost}


def _search(subject: Subject, depth: Depth) -> dict[str, Any]:
    found = find_worst(subject, subject.kernel, depth.rounds)
    at = [np.asarray(a).tolist() for a in found.arguments]
    return {"scaled": found.scaled, "tried": found.tried, "at": at}


def _span(argument: Array) -> list[float]:
    """Return the least and the largest size; numbers of both signs enclose zero."""
    size = np.abs(argument)
    least = 0.0 if np.min(argument) < 0 < np.max(argument) else float(np.min(size))
    return [least, float(np.max(size))]


def _sample(count: int, wanted: int | None) -> Array:
    """Choose indices evenly spread over a set."""
    if wanted is None or wanted >= count:
        return np.arange(count)
    return np.linspace(0, count - 1, wanted).astype(int)


def _thin(subject: Subject, arguments: Arguments, wanted: int | None) -> Arguments:
    return _take(subject, arguments, _sample(count_points(subject, arguments), wanted))


def _take(subject: Subject, arguments: Arguments, chosen: Array) -> Arguments:
    """Take some of the points; what all points share stays as it is."""
    count = count_points(subject, arguments)
    return tuple(a[chosen] if np.shape(a)[:1] == (count,) else a for a in arguments)


def _point(subject: Subject, arguments: Arguments, index: int) -> list[Any]:
    """Return one point of a set as numbers that read back to the same doubles."""
    count = count_points(subject, arguments)
    shared = (a[index] if np.shape(a)[:1] == (count,) else a for a in arguments)
    return [np.asarray(a).tolist() for a in shared]


def write_record(record: Mapping[str, Any], folder: Path) -> Path:
    """Write a record as <system>.<quantity>.json; an interrupted write leaves the old one."""
    folder.mkdir(parents=True, exist_ok=True)
    target = folder / f"{record['quantity']}.json"
    staged = target.with_suffix(".json.new")
    text = json.dumps(_in_json(record), indent=1, ensure_ascii=False, allow_nan=False)
    staged.write_text(_join_short_lists(text) + "\n", encoding="utf-8")
    os.replace(staged, target)
    return target


def _in_json(value: Any) -> Any:
    """Turn NaN and infinity, which JSON has not, into text."""
    if isinstance(value, Mapping):
        return {key: _in_json(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_in_json(item) for item in value]
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value


def _join_short_lists(text: str) -> str:
    """Put lists of numbers and records of a few numbers on one line each."""
    import re

    short = re.compile(r"([\[{])\n\s+([^\[\]{}]{1,240}?)\n\s+([\]}])")
    return short.sub(lambda m: m[1] + re.sub(r"\s*\n\s*", " ", m[2]) + m[3], text)
