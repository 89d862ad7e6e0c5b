"""The facts of a paper that its kernel module holds: conditions on parameters, published sizes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

# A size, or its nominal value with upper and lower limit deviation.
Size = float | tuple[float, float, float]


class Condition(NamedTuple):
    """A condition that the parameters `names` satisfy where the `quantities` are defined.

    `holds` takes them in this order; `parameter` is the one to blame, `text` states the condition.
    """

    parameter: str
    text: str
    names: tuple[str, ...]
    holds: Callable[..., Any]
    quantities: tuple[str, ...]


class Sizes(NamedTuple):
    """Sizes that the paper prints (mm, rad), and marks for what they rest on."""

    source: str
    sizes: Mapping[str, Size]
    marks: tuple[str, ...]
