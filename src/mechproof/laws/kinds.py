"""The kinds of laws, and what is done with any of them."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

import numpy as np

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
    return type(law)(*(np.broadcast_to(p, shape).reshape(-1)[index] for p in list_parameters(law)))
