"""Records as JSON with a line per row: any dataclass of plain values and of tables of others.

A table, a tuple of dataclasses, is written once as the names of its columns and then row by row,
so that two files can be compared with `diff`; within a row it is a list of objects. NaN and
infinity, which JSON lacks, are text. Reading accepts exactly what is written: everything else is an
error that names its place.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache
from types import UnionType
from typing import Any, TypeVar, get_args, get_origin, get_type_hints

NON_FINITE = ("nan", "inf", "-inf")
R = TypeVar("R")


def write_lines(record: object) -> Iterator[str]:
    """Yield the lines of a dataclass's JSON: one for each field, in tables one for each row."""
    kind: type = type(record)
    kinds = _kinds_of(kind)
    last = list(kinds)[-1]
    yield "{"
    for name in kinds:
        comma = "" if name == last else ","
        yield from _write_field(name, kinds[name], getattr(record, name), comma)
    yield "}\n"


def _write_field(name: str, kind: Any, value: Any, comma: str) -> Iterator[str]:
    row = _row_kind(kind)
    if row is None:
        yield f'"{name}": {_dump(value)}{comma}'
        return
    columns = list(_kinds_of(row))
    yield f'"{name}": {{"columns": {_dump(columns)}, "rows": ['
    rows = [_dump([getattr(item, column) for column in columns]) for item in value]
    yield from (f"{line}," for line in rows[:-1])
    yield from rows[-1:]
    yield f"]}}{comma}"


def _dump(value: Any) -> str:
    return json.dumps(as_json(value), ensure_ascii=False, allow_nan=False, separators=(",", ":"))


def as_json(value: Any) -> Any:
    """Turn records into objects, sets into lists, and NaN and infinity into text."""
    if is_dataclass(value):
        return {f.name: as_json(getattr(value, f.name)) for f in fields(value)}
    if isinstance(value, Mapping):
        return {key: as_json(item) for key, item in value.items()}
    if isinstance(value, frozenset):
        return as_json(sorted(value))
    if isinstance(value, list | tuple):
        return [as_json(item) for item in value]
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value


@cache
def _kinds_of(record: type) -> dict[str, Any]:
    """Return the type of every field."""
    hints = get_type_hints(record)
    return {f.name: hints[f.name] for f in fields(record)}


def _row_kind(kind: Any) -> type | None:
    """Return the dataclass that a field is a table of, or None if it is no table."""
    first = next(iter(get_args(kind)), None)
    is_table = get_origin(kind) is tuple and isinstance(first, type) and is_dataclass(first)
    return first if is_table else None


def read_fields(kind: type[R], found: Any, where: str) -> R:
    """Build a record from what `write_lines` wrote: an object with exactly its fields."""
    return _build(kind, found, where, _decode_field)


def read_object(kind: type[R], found: Any, where: str) -> R:
    """Build a record from what `as_json` made of it; raises ValueError."""
    return _build(kind, found, where, _decode)


def _build(kind: type[R], found: Any, where: str, decode: Callable[[Any, Any, str], Any]) -> R:
    record: type = kind
    kinds = _kinds_of(record)
    if not isinstance(found, dict):
        raise ValueError(f"{where}: {found!r} is not of type {kind.__name__}")
    for problem, names in (("unknown", found.keys() - kinds), ("missing", kinds.keys() - found)):
        if names:
            raise ValueError(f"{where}: {problem} in a {kind.__name__}: {', '.join(sorted(names))}")
    values = {name: decode(kinds[name], found[name], f"{where}: {name}") for name in kinds}
    try:
        return kind(**values)
    except ValueError as error:
        raise ValueError(f"{where}: {error}") from error


def _decode_field(kind: Any, found: Any, where: str) -> Any:
    row = _row_kind(kind)
    return _decode(kind, found, where) if row is None else _decode_table(row, found, where)


def _decode_table(kind: type[R], found: Any, where: str) -> tuple[R, ...]:
    if not isinstance(found, dict) or found.keys() != {"columns", "rows"}:
        raise ValueError(f"{where}: a table must have columns and rows")
    columns, rows = found["columns"], found["rows"]
    for number, row in enumerate(rows):
        if len(row) != len(columns):
            raise ValueError(f"{where}, row {number}: {len(row)} of {len(columns)} columns")
    named = (dict(zip(columns, row, strict=True)) for row in rows)
    return tuple(read_object(kind, row, f"{where}, row {n}") for n, row in enumerate(named))


def _decode(kind: Any, found: Any, where: str) -> Any:
    """Build a value of a field's type."""
    if type(found) is kind:
        return found
    if isinstance(kind, type) and is_dataclass(kind):
        return read_object(kind, found, where)
    if isinstance(kind, type) and issubclass(kind, Enum):
        return kind(found)
    origin, parts = get_origin(kind), get_args(kind)
    if origin is UnionType:
        return None if found is None else _decode(parts[0], found, where)
    if origin is tuple and isinstance(found, list):
        kinds = parts[:1] * len(found) if parts[-1] is Ellipsis else parts
        if len(kinds) == len(found):
            return tuple(_decode(k, f, where) for k, f in zip(kinds, found, strict=True))
    if origin is frozenset and isinstance(found, list):
        return frozenset(_decode(parts[0], item, where) for item in found)
    if origin in (Mapping, dict) and isinstance(found, dict):
        return {name: _decode(parts[1], value, where) for name, value in found.items()}
    if kind is Any and isinstance(found, list):
        return tuple(_decode(Any, item, where) for item in found)
    return _decode_plain(kind, found, where)


def _decode_plain(kind: Any, found: Any, where: str) -> Any:
    """Build a number, a text or a flag."""
    if kind in (float, Any) and (type(found) in (int, float) or found in NON_FINITE):
        return float(found)
    if found in get_args(kind):
        return found
    raise ValueError(f"{where}: {found!r} is not of type {getattr(kind, '__name__', kind)}")
