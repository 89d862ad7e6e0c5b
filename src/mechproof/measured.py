"""Measured: the results of `mechproof measure`, as tables, charts and `choose` read them.

One record is one quantity: its ways of computing, their errors on sets of points and in cells
(ranges of argument sizes), the worst input found, and times. A file holds one record as JSON, one
line per row, so that two measurements can be compared with `diff`; NaN and infinity are text.

>>> from mechproof.measured import find_files, read_record
>>> record = read_record(find_files()["track_wheel.displacement"])
>>> record.ways[0].kind, record.ways[0].verdict
('kernel', 'PROVED')
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import ROUND_UP, Context, Decimal
from importlib.resources import files
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any, Literal

from mechproof.tools.files import write_whole
from mechproof.tools.json_rows import read_fields, write_lines

Kind = Literal["kernel", "form", "source", "peer"]
Span = tuple[float, float]
# Arguments of one call: numbers, and tuples of numbers for arguments with axes of their own.
Point = tuple[Any, ...]
# Verdict of a way about which nothing is proved.
MEASURED = "MEASURED"
# The kernel as `mechproof emit c` writes it, measured if a compiler, or a GPU, is found.
IN_C, ON_GPU = "kernel, C", "kernel, GPU"
# Name of the time for copying the result, measured along with the ways.
COPY = "memory copy"
ERROR_DIGITS, TIME_DIGITS = 4, 3
SUFFIX = ".json"
# The package of generated kernels, and its folders of measurements.
KERNELS = "mechproof.kernels"
FOLDER, QUICK = "measured", "quick"


@dataclass(frozen=True)
class MeasuredWay:
    """One way of computing a quantity, as it was measured.

    `kind`: "kernel" (generated, shipped), "form" (a rival form), "source" (the kernel as it is
    written for another language) or "peer" (a solver, a library, a simulation, hand-written code).
    `verdict` and `rung`: what is proved about it on `proved_on` ("": the whole domain); nothing is
    proved about a source or a peer, whose verdict is MEASURED. `bound`: a proved bound of |way -
    definition|, "" if there is none. `ordered`: it needs samples in order from 0. `key`: the end of
    its function's name, <quantity>_<key>, "" without a function of its own. `needs`: the extra that
    must be installed for it.
    """

    name: str
    kind: Kind
    verdict: str = MEASURED
    rung: str = ""
    proved_on: str = ""
    bound: str = ""
    ordered: bool = False
    key: str = ""
    needs: str = ""
    note: str = ""

    def __post_init__(self) -> None:
        if self.kind in ("source", "peer") and self.verdict != MEASURED:
            raise ValueError(f"way {self.name!r}: a {self.kind} is {MEASURED}, not {self.verdict}")


@dataclass(frozen=True)
class SetErrors:
    """Errors of one way on one set of points.

    `nan`, `infinite` and `wrong_branch` count results; `undecided` counts points without a known
    truth, which have no errors (NaN if all are undecided). `worst_scaled` is in the record's unit
    of error, at points where the accuracy bound holds; None if it holds at none. `worst_at` is its
    point, for the first way only.
    """

    set: str
    way: str
    points: int
    undecided: int
    nan: int
    infinite: int
    wrong_branch: int
    worst_ulp: float
    mean_ulp: float
    mean_bits: float
    worst_absolute: float
    worst_scaled: float | None
    worst_at: Point | None = None

    @property
    def failed(self) -> int:
        """Return the number of results that are lost or on a wrong branch."""
        return self.nan + self.infinite + self.wrong_branch


@dataclass(frozen=True)
class Cell:
    """A cell of argument sizes, from and to; other arguments have any size measured."""

    sides: Mapping[str, Span]
    points: int
    undecided: int


@dataclass(frozen=True)
class CellErrors:
    """Largest absolute error of one way in one cell (its place in the list), and its bound there.

    `bound` is None for a way without one; `lost` counts NaN and infinite results.
    """

    cell: int
    way: str
    worst: float
    bound: float | None
    lost: int


@dataclass(frozen=True)
class Searched:
    """The worst input that the search found for a way, and the number of inputs tried."""

    way: str
    scaled: float
    tried: int
    at: Point


@dataclass(frozen=True)
class Timing:
    """Nanoseconds per point of one way for calls of `count` points.

    `lower`, `median` and `upper` are the quartiles of the rounds; `ratio` is the median of (this
    way : first way) within each round, None if the first way was not timed. A way is not timed if a
    call would take too long or too much memory.
    """

    workload: str
    way: str
    count: int
    rounds: int
    median: float
    lower: float
    upper: float
    ratio: float | None


@dataclass(frozen=True)
class MeasuredTailoring:
    """A kernel that was tailored to the sizes of one workload and to a given error.

    `bound`: its proved bound, for the first argument between `ends`. Its times are among those of
    the record, under its name.
    """

    name: str
    workload: str
    asked: float
    bound: float
    sizes: Mapping[str, float]
    ends: Span
    degrees: tuple[int, ...]


@dataclass(frozen=True)
class Machine:
    """The machine of a measurement: the processor, the SIMD that NumPy uses, and versions."""

    processor: str
    cores: int | None
    simd: tuple[str, ...]
    system: str
    python: str
    versions: Mapping[str, str]


@dataclass(frozen=True)
class Record:
    """All that was measured of one quantity.

    The first of `ways` is the shipped one; those that users call are `searched`. `bound` is its
    accuracy bound in eps of `scale`, None and "" without one: scaled errors are then in ulp of the
    value. `ranges` are the sizes of the arguments that the cells cover. `typical` names the set
    nearest to usual calls, if there is one. `ufuncs` has the times of NumPy's own functions, in ns
    per point; `load` is how busy the machine was.
    """

    quantity: str
    unit: str
    taken: str
    quick: bool
    machine: Machine
    load: float | None
    seeds: Mapping[str, int]
    scale: str
    bound: float | None
    typical: str | None
    ranges: Mapping[str, Span]
    searched: tuple[Searched, ...]
    ufuncs: Mapping[str, float]
    ways: tuple[MeasuredWay, ...]
    sets: tuple[SetErrors, ...]
    cells: tuple[Cell, ...]
    cell_errors: tuple[CellErrors, ...]
    tailored: tuple[MeasuredTailoring, ...]
    times: tuple[Timing, ...]

    @property
    def lacking(self) -> str:
        """Return a note if the kernel in C was not measured, for lack of a compiler."""
        shipped = any(way.kind == "kernel" for way in self.ways)
        in_c = any(way.name == IN_C for way in self.ways)
        return f"Not measured: {IN_C}." if shipped and not in_c else ""

    @property
    def error_unit(self) -> str:
        """Return the unit of scaled errors."""
        return "ulp of the value" if self.bound is None else f"eps of {self.scale}"

    def errors_of(self, way: str) -> tuple[SetErrors, ...]:
        """Return the errors of one way on all sets."""
        return tuple(errors for errors in self.sets if errors.way == way)

    def worst_of(self, way: str) -> float | None:
        """Return the worst scaled error of one way on all sets."""
        found = (errors.worst_scaled for errors in self.errors_of(way))
        return max((worst for worst in found if worst is not None), default=None)


def round_up(value: float) -> float:
    """Round a number away from zero to `ERROR_DIGITS` digits."""
    if not math.isfinite(value):
        return value
    near = round_off(value, ERROR_DIGITS)
    if abs(near) >= abs(value):
        return near
    return float(Context(prec=ERROR_DIGITS, rounding=ROUND_UP).plus(Decimal(value)))


def round_off(value: float, digits: int = TIME_DIGITS) -> float:
    """Round a number to the nearest with `digits` significant digits."""
    return float(f"{value:.{digits}g}")


def goes_by(quantity: str, name: str) -> bool:
    """Return whether a name means system.quantity: all of it, the system, or the quantity."""
    return name in (quantity, *quantity.split(".", 1))


MADE_BY = "`mechproof measure`, which writes into measured, with --quick into measured/quick"


def find_files(folder: Traversable | None = None) -> dict[str, Traversable]:
    """Return the files of a folder, by default those that come with the package, by quantity."""
    folder = files(KERNELS).joinpath(FOLDER) if folder is None else folder
    found = folder.iterdir() if folder.is_dir() else iter(())
    named = {file.name.removesuffix(SUFFIX): file for file in found if file.name.endswith(SUFFIX)}
    return dict(sorted(named.items()))


def find_all_files(generated: Traversable) -> dict[str, Traversable]:
    """Return the files of the kernels' records by quantity, quick ones if there are no others."""
    folder = generated.joinpath(FOLDER)
    return {**find_files(folder.joinpath(QUICK)), **find_files(folder)}


def read_records(folder: Traversable) -> list[Record]:
    """Read the records of a folder, in the order of their names."""
    return [read_record(file) for file in find_files(folder).values()]


def read_record(file: Traversable) -> Record:
    """Read one record.

    Raises ValueError, naming the file and the place, for anything but an exact record.
    """
    try:
        found = json.loads(file.read_text(encoding="utf-8"))
    except ValueError as error:
        raise ValueError(f"{file}: not JSON: {error}") from error
    return read_fields(Record, found, str(file))


def find_known(folder: Path, quantity: str, count: int) -> tuple[Point, ...]:
    """Return the worst inputs of a quantity's record, of `count` arguments; none without a record.

    Raises ValueError, naming the file, for an invalid record or one with other arguments.
    """
    file = folder / f"{quantity}{SUFFIX}"
    known = tuple(found.at for found in read_record(file).searched) if file.is_file() else ()
    if wrong := [len(at) for at in known if len(at) != count]:
        raise ValueError(f"{file}: its inputs have {wrong[0]} arguments, {quantity} has {count}")
    return known


def write_record(record: Record, folder: Path) -> Path:
    """Write a record as <quantity>.json; an interrupted write leaves the old file."""
    target = folder / f"{record.quantity}{SUFFIX}"
    write_whole(target, "\n".join(write_lines(record)))
    return target
