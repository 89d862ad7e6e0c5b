"""Choice of model: the cheapest way to compute a quantity to a given error over stated ranges.

Based on what `mechproof measure` measured and proved: for cells of argument sizes, the worst error
of every way, a form or a peer, and an approximation's proved bound; and the time per point.

>>> from mechproof import choose
>>> choice = choose("displacement", error=1e-3, points=(0, 50), angles=(0, 1e-3))
>>> choice.error <= 1e-3
True
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from importlib.util import find_spec
from pathlib import Path

from mechproof.arguments.scalars import check_count, check_number, refuse, require
from mechproof.measured import (
    FOLDER as MEASURED,
    KERNELS,
    MADE_BY,
    MeasuredWay,
    Record,
    Timing,
    find_files,
    read_record,
)
from mechproof.measured_ranges import Size, check_ranges, find_cells
from mechproof.tools.extras import suggest_install

# Ways with these verdicts compute something else somewhere in the domain.
NOT_EQUAL = ("REFUTED", "CONDITIONAL", "ILL_FORMED", "UNDECIDED", "ENCLOSED")
SIZE = 100_000
# For each extra, a package that shows that it is installed, and the folder of its kernels.
EXTRAS = {"fast": "numba", "derive": "flint"}
TAILORING = "derive,fast"
FOLDERS = {"": "", "fast": "compiled."}
# The next better way has at most half the error.
BETTER = 2


@dataclass(frozen=True)
class Choice:
    """A way to compute, its error over the stated ranges, and its time.

    `error`, in the unit of the quantity, is the larger of the worst measured error and the proved
    bound; `bound` is the proved bound, rounding apart, or None. `function` is the dotted name from
    which a form is imported (for your own paper, from the folder above `generated`), or the call
    that tailors it; it is empty for other libraries and the like. `needs` lists the extras
    required, separated by commas. `asked` is the largest error permitted. `time` is in nanoseconds
    per point at `count` points on the machine of the record: the median of rounds with these
    `quartiles`. `better` is the cheapest way with at most half the error. `faster` is the cheapest
    way that needs an extra not installed, if it is faster than the installed ways. `others` are all
    other ways available, cheapest first.
    """

    quantity: str
    way: str
    error: float
    bound: float | None
    time: float
    quartiles: tuple[float, float]
    count: int
    unit: str
    asked: float
    function: str = ""
    needs: str = ""
    better: Choice | None = None
    faster: Choice | None = None
    others: tuple[Choice, ...] = field(default=(), repr=False, compare=False)

    def explain(self) -> str:
        """Return the choice and, line by line, why each of the others was not chosen."""
        return "\n".join([str(self), *map(self._compare, self.others)])

    def _compare(self, other: Choice) -> str:
        """Return whether and why a way is slower, no better, or too coarse."""
        if other.error > self.asked:
            reason = "not accurate enough"
        elif other._may_be_as_fast_as(self) or other.time < self.time:
            reason = "not shown to be slower, but not more accurate"
        else:
            reason = f"{other.time / self.time:.3g} times the time"
        return f"not {other._describe()}: {reason}"

    def _may_be_as_fast_as(self, other: Choice) -> bool:
        """Return whether the quartiles of the times overlap."""
        (low, high), (lowest, highest) = self.quartiles, other.quartiles
        return low <= highest and lowest <= high

    def __str__(self) -> str:
        """Return the reason in a sentence or two."""
        text = f"{self.quantity}: {self._describe()}"
        if self.better is None:
            text += "; nothing measured has half the error."
        else:
            text += f"; the next more accurate: {self.better._describe()}."
        if self.faster is None:
            return text
        return f"{text} With {suggest_install(self.faster.needs)}: {self.faster._describe()}."

    def _describe(self) -> str:
        how = "proved bound" if self.bound == self.error else "measured"
        unit = "" if self.unit == "1" else f" {self.unit}"
        return f"{self.way}, error {self.error:.2g}{unit} ({how}), {self.time:.3g} ns per point"


def choose(
    quantity: str,
    *,
    error: float,
    size: int = SIZE,
    measured: str | os.PathLike[str] | None = None,
    **ranges: Size,
) -> Choice:
    """Return the cheapest way whose error over the ranges is at most `error`.

    Parameters
    ----------
    quantity : str
        A measured quantity, as quantity or system.quantity.
    error : float
        Largest permitted absolute error, in the unit of the quantity, positive.
    size : int
        Number of points per call. The time is taken at the nearest size measured, for the most
        expensive workload (one pose and many points, or many poses).
    measured : path, optional
        Folder of records written by `mechproof measure`; by default those of the package.
    **ranges : float or pair of floats
        Sizes of the arguments (absolute values; for a vector, of its largest component): a number,
        or a pair (from, to). An argument left out may have any size measured.

    Raises
    ------
    TypeError
        If the error or the size is not a real number, or a range is not a pair.
    ValueError
        If the quantity or an argument is unknown, a range was not measured, the folder has no
        records or a broken one, or no way is accurate enough; the message then says what is
        reachable.

    Notes
    -----
    A measured error is the worst at points chosen to be difficult, not a bound. A way is left out
    if it lost a single result (NaN, infinity) in the ranges, if the ledger refutes it or proves it
    on part of the domain only, or if it is written in C. Peers (other libraries, solvers,
    simulations), about which nothing is proved, count by their measured errors. Ways that need an
    extra of mechproof that is not installed (`fast`: compiled kernels) are not chosen, but named in
    `faster`. If all arguments but the first are fixed numbers, a kernel tailored to them and to
    `error` is one of the ways: its bound is the error asked for, and its time is that of a kernel
    tailored to other sizes and no larger an error. Of ways whose times cannot be told apart because
    their quartiles overlap, the most accurate is chosen.

    """
    record = _find_record(quantity, measured)
    require(check_number("error", error) > 0, "error", error, "must be positive")
    check_count("size", size)
    pairs = check_ranges(record, ranges)
    cells = list(find_cells(record, pairs))
    home = KERNELS if measured is None else _find_home(Path(measured), record)
    rated = list(_rate_ways(record, cells, size, error, home))
    rated += _rate_tailored(record, pairs, size, error, home)
    ways = sorted(filter(_is_installed, rated), key=lambda c: c.time)
    good = [way for way in ways if way.error <= error]
    if not good:
        best = min(ways, key=lambda c: c.error)
        reach = f"no way of computing {record.quantity} is this accurate"
        refuse("error", error, f"{reach}{_describe_open(record, pairs)}; {best}")
    alike = [way for way in good if way._may_be_as_fast_as(good[0])]
    first = min(alike, key=lambda c: c.error)
    better = [way for way in ways if way.error < first.error / BETTER]
    return replace(
        first,
        better=better[0] if better else None,
        faster=_find_faster(rated, first),
        others=tuple(way for way in ways if way is not first),
    )


def _rate_tailored(
    record: Record, pairs: Mapping[str, tuple[float, float]], size: int, asked: float, home: str
) -> Iterator[Choice]:
    """Rate the tailored kernel made for the same or a smaller error, if sizes are fixed numbers.

    Its time is that at the sizes measured; its bound is proved when the kernel is made.
    """
    _, *parameters = record.ranges
    if any(name not in pairs or pairs[name][0] != pairs[name][1] for name in parameters):
        return
    fixed = [f"{name}={pairs[name][0]!r}" for name in parameters]
    own = [] if home == KERNELS else ["derivations='derivations'"]
    said = ", ".join([f"{record.quantity!r}", f"error={asked!r}", *own, *fixed])
    for found in sorted(record.tailored, key=lambda t: -t.asked):
        timed = _find_time(record, found.name, size)
        if timed is not None and found.asked <= asked:
            rated = _rate(record, timed, "tailored", asked, asked)
            function = f"mechproof.tailor({said})"
            yield replace(rated, asked=asked, function=function, needs=TAILORING)
            return


def _rate(record: Record, timed: Timing, way: str, error: float, bound: float | None) -> Choice:
    """Return the measurements of a way as a choice, with its error as the error asked for."""
    quartiles = timed.lower, timed.upper
    facts = timed.median, quartiles, timed.count, record.unit
    return Choice(record.quantity, way, error, bound, *facts, asked=error)


def _is_installed(way: Choice) -> bool:
    return all(find_spec(EXTRAS[extra]) is not None for extra in way.needs.split(",") if extra)


def _find_faster(rated: Sequence[Choice], first: Choice) -> Choice | None:
    """Return the cheapest way that is accurate enough and lacks only an extra."""
    lacking = [way for way in rated if not _is_installed(way) and way.error <= first.asked]
    fastest = min(lacking, key=lambda way: way.time, default=None)
    return fastest if fastest and fastest.quartiles[1] < first.quartiles[0] else None


def _find_record(quantity: str, measured: str | os.PathLike[str] | None) -> Record:
    """Read the record of a quantity, from the package or from a folder."""
    is_path = measured is None or isinstance(measured, str | os.PathLike)
    require(is_path, "measured", measured, "must be the path of a folder", TypeError)
    files = find_files(None if measured is None else Path(measured))
    found = measured is None or files
    require(found, "measured", measured, f"must be a folder with records of {MADE_BY}")
    named = [name for name in files if quantity in (name, name.partition(".")[2])]
    if len(named) > 1:
        refuse("quantity", quantity, f"several systems have it; give one of {', '.join(named)}")
    if not named:
        known = ", ".join(files) or "none; run `mechproof measure`"
        others = "" if measured else "; for records of your own, give measured=FOLDER"
        refuse("quantity", quantity, f"must be one of those measured: {known}{others}")
    record = read_record(files[named[0]])
    require(record.cells, "quantity", quantity, "was not measured over ranges of its arguments")
    return record


def _describe_open(record: Record, pairs: Mapping[str, tuple[float, float]]) -> str:
    """Return the arguments that may have any size measured, which may be the reason."""
    left = [f"{n} {lo:g} to {hi:g}" for n, (lo, hi) in record.ranges.items() if n not in pairs]
    return f" for all sizes of {', '.join(left)}" if left else ""


def _find_home(folder: Path, record: Record) -> str:
    """Return the package of the kernels that a record describes: the one next to it, if any.

    `folder` is `measured` in the folder of the generated files, or `quick` in that one.
    """
    place = folder.resolve()
    generated = place.parent if place.name == MEASURED else place.parent.parent
    known = find_spec(KERNELS)
    packaged = known.submodule_search_locations if known else None
    is_packaged = any(Path(path).resolve() == generated for path in packaged or ())
    is_there = (generated / f"{record.quantity.partition('.')[0]}.py").is_file()
    return generated.name if is_there and not is_packaged else KERNELS


def _rate_ways(
    record: Record, cells: list[int], size: int, asked: float, home: str
) -> Iterator[Choice]:
    """Rate each way that equals the quantity or is bounded, and lost no result in the cells."""
    errors = {(found.way, found.cell): found for found in record.cell_errors}
    for way in filter(lambda way: _is_the_quantity(way, record.ways[0]), record.ways):
        found = [errors[way.name, cell] for cell in cells]
        timed = _find_time(record, way.name, size)
        if timed is None or any(f.lost for f in found):
            continue
        bounds = [f.bound for f in found if f.bound is not None]
        bound = max(bounds) if len(bounds) == len(found) else None
        if way.bound and bound is None:
            continue
        error = max([f.worst for f in found] + ([] if bound is None else [bound]))
        rated = _rate(record, timed, way.name, error, bound)
        function = _locate(record.quantity, way, home)
        yield replace(rated, asked=asked, function=function, needs=way.needs)


def _locate(quantity: str, way: MeasuredWay, home: str) -> str:
    """Return the dotted name of a generated function; "" for any other way."""
    system, _, name = quantity.partition(".")
    if way.kind == "form":
        return f"{home}.forms.{system}.{name}_{way.key}"
    if way.kind == "kernel":
        return f"{home}.{FOLDERS[way.needs]}{system}.{name}"
    return ""


def _is_the_quantity(way: MeasuredWay, shipped: MeasuredWay) -> bool:
    """Return whether a way computes single points in Python and may equal the quantity."""
    part = way.proved_on not in ("", shipped.proved_on)
    return not (way.kind == "source" or way.ordered or way.verdict in NOT_EQUAL or part)


def _find_time(record: Record, way: str, size: int) -> Timing | None:
    """Return the time at the measured size nearest to `size`, for the most expensive workload."""
    rows = [row for row in record.times if row.way == way]
    nearest = [
        min(
            (row for row in rows if row.workload == workload),
            key=lambda row: max(row.count, size) / min(row.count, size),
        )
        for workload in {row.workload for row in rows}
    ]
    return max(nearest, key=lambda row: row.median, default=None)
