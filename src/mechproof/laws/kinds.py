"""The kinds of laws, and what is done with any of them."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.scalars import require
from mechproof.laws.normal import Normal
from mechproof.laws.truncated_normal import TruncatedNormal
from mechproof.laws.uniform import Uniform
from mechproof.laws.windows import Array

Law = Normal | Uniform | TruncatedNormal
LAWS = (Normal, Uniform, TruncatedNormal)


def check_law(name: str, law: Any, *kinds: type) -> None:
    """Raise a TypeError unless the law is of one of the kinds, any if none is given."""
    allowed = " or ".join(kind.__name__ for kind in kinds or LAWS)
    require(isinstance(law, kinds or LAWS), name, law, f"must be a law, {allowed}", TypeError)


def list_parameters(law: Law) -> list[Array]:
    """List the parameters of the law in the order of its constructor."""
    return [np.asarray(getattr(law, field.name), dtype=float) for field in fields(law)]


def select(law: Law, shape: tuple[int, ...], index: Any) -> Law:
    """Broadcast every parameter of the law to `shape`, flatten it and index it."""
    return type(law).of_checked(
        **{n: np.broadcast_to(p, shape).reshape(-1)[index] for n, p in vars(law).items()}
    )


def find_centre(law: Law) -> Array:
    """Find a place where the law has its mass, or within a width of it."""
    if isinstance(law, Uniform):
        return np.asarray(law.lower) / 2 + np.asarray(law.upper) / 2
    if isinstance(law, Normal):
        return np.asarray(law.mean)
    centre: Array = np.clip(law.mean, law.lower, law.upper)
    return centre


def move(law: Law, distance: ArrayLike) -> Law:
    """Return the law of the value plus `distance`: all parameters are places but the width."""
    moved = {n: p if n == "std" else np.add(p, distance) for n, p in vars(law).items()}
    return type(law).of_checked(**moved)
