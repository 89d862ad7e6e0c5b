"""Tables of the records: what every form loses and costs, relative to what, as one page."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from mechproof.lab.timing import COPY, REFERENCE

Record = Mapping[str, Any]
PAGE = "TABLES.md"
FORM_HEAD = (
    "form", "verdict", "points", "undecided", "worst, eps of scale", "worst, ulp", "mean, ulp",
    "worst, bits", "mean, bits", "worst, absolute", "wrong branch", "nan", "inf", "fails first on",
)  # fmt: skip
COUNTED = ("wrong_branch", "nan", "infinite")
SHIPPED_HEAD = ("quantity", "bar", "worst on the sets", "worst searched", "eps of")
INTRODUCTION = """# What the kernels and the other ways lose and cost

Errors are taken against balls at the exact doubles, on the points of the reporting seed; the
search climbed from the points of the tuning seed. *eps of scale*: the error in units of 2**-52
times the scale named with each quantity, where the bar of the kernel holds; the other columns are
over all points. *bits*: log2(1 + ulps). Times are medians of rounds in which all forms took turns,
quartiles in brackets, in ns per point; *: ratio to the kernel of the same round.
"""


def read_records(folder: Path) -> list[Record]:
    """Read the records of a folder, in the order of their names."""
    return [json.loads(file.read_text(encoding="utf-8")) for file in sorted(folder.glob("*.json"))]


def write_tables(folder: Path) -> Path:
    """Write the page of all records in a folder."""
    target = folder / PAGE
    target.write_text("\n".join(_list_lines(read_records(folder))), encoding="utf-8")
    return target


def _list_lines(records: Sequence[Record]) -> Iterator[str]:
    yield INTRODUCTION
    yield from _table(SHIPPED_HEAD, map(_describe_kernel, records))
    for record in records:
        yield f"\n## {record['quantity']}\n"
        yield f"Scale: {record['scale']}. {_describe_run(record)}\n"
        yield from _table(FORM_HEAD, (_describe_form(record, form) for form in record["forms"]))
        for workload in dict.fromkeys(row["workload"] for row in record["times"]):
            yield f"\n{workload}\n"
            yield from _list_times(record, workload)
    yield ""


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    yield _line(head)
    yield _line(["---"] * len(head))
    for row in rows:
        yield _line(row)


def _line(cells: Sequence[str]) -> str:
    return "| " + " | ".join(cell.replace("|", r"\|") for cell in cells) + " |"


def _describe_run(record: Record) -> str:
    machine, versions = record["machine"], record["versions"]
    simd = machine["simd"][-1] if machine["simd"] else "no SIMD"
    quick = ", quick" if record["quick"] else ""
    ufuncs = ", ".join(f"{name} {time:.3g}" for name, time in record["ufuncs"].items())
    return (
        f"Taken {record['taken'][:10]} on {machine['processor']}, {simd}, load {machine['load']}, "
        f"numpy {versions['numpy']}{quick}. NumPy's own functions in cache, ns per point: {ufuncs}."
    )


def _describe_kernel(record: Record) -> Sequence[str]:
    held = _held_errors(record, REFERENCE)
    bar = f"{record['bar']:.3g}" if record["bar"] else "none"
    searched = f"{float(record['worst_found']['scaled']):.3g}"
    return record["quantity"], bar, _number(max(held, default=None)), searched, record["scale"]


def _held_errors(record: Record, form: str) -> list[float]:
    rows = (row for row in record["accuracy"] if row["form"] == form)
    found = (row["worst_where_the_bar_holds"] for row in rows)
    return [float(worst) for worst in found if worst is not None]


def _describe_form(record: Record, form: Mapping[str, Any]) -> Sequence[str]:
    rows = [row for row in record["accuracy"] if row["form"] == form["name"]]
    verdict = (form["verdict"] or "") + (", with its bound" if form["bound"] else "")
    verdict += f" on {form['proved_on']}" if form["proved_on"] else ""
    held = _number(max(_held_errors(record, form["name"]), default=None))
    return (
        form["name"], verdict, _total(rows, "points"), _total(rows, "undecided"), held,
        _number(_worst(rows, "worst_ulp")), _number(_mean(rows, "mean_ulp")),
        _number(_worst(rows, "worst_bits")), _number(_mean(rows, "mean_bits")),
        _number(_worst(rows, "worst_absolute")), *(_total(rows, key) for key in COUNTED),
        _name_first_failure(rows),
    )  # fmt: skip


def _total(rows: Iterable[Mapping[str, Any]], key: str) -> str:
    return str(sum(row[key] for row in rows))


def _mean(rows: Iterable[Mapping[str, Any]], key: str) -> float | None:
    """Average over the decided points of all sets."""
    counted = [(row["points"] - row["undecided"], float(row[key])) for row in rows]
    known = [(count, mean) for count, mean in counted if count]
    return sum(n * m for n, m in known) / sum(n for n, _ in known) if known else None


def _worst(rows: Iterable[Mapping[str, Any]], key: str) -> float | None:
    values = [float(row[key]) for row in rows if row["points"] > row["undecided"]]
    return max(values, default=None)


def _name_first_failure(rows: Iterable[Mapping[str, Any]]) -> str:
    """Name the first set with lost results or a wrong branch."""
    return next((row["set"] for row in rows if any(row[key] for key in COUNTED)), "")


def _number(value: float | None) -> str:
    return "" if value is None else f"{value:.3g}"


def _list_times(record: Record, workload: str) -> Iterator[str]:
    rows = [row for row in record["times"] if row["workload"] == workload]
    counts = sorted({row["count"] for row in rows})
    forms = dict.fromkeys(row["form"] for row in rows if row["form"] != COPY)
    by_place = {(row["form"], row["count"]): row for row in rows}
    head = ("form", *(f"N = {count}" for count in counts))
    lines = ([f, *(_time(by_place.get((f, n))) for n in counts)] for f in (*forms, COPY))
    yield from _table(head, lines)


def _time(row: Mapping[str, Any] | None) -> str:
    """Write median, quartiles and ratio; a form that was too slow for a size is not timed."""
    if row is None or not row["rounds"]:
        return "not timed"
    ratio = f", {row['ratio']:.3g}*" if row["ratio"] else ""
    return f"{row['median']:.3g} [{row['lower']:.3g}, {row['upper']:.3g}]{ratio}"
