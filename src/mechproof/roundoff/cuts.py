"""Cuts: in, the side across which each part of a box is cut; out, a short text, and back."""

from __future__ import annotations

import zlib
from base64 import b64decode, b64encode
from collections.abc import Sequence

import numpy as np

from mechproof.arithmetic.cover import Cuts


def write_cuts(cuts: Sequence[Cuts]) -> str:
    """Return the cuts of boxes, one box after the other, as a text."""
    return b64encode(zlib.compress(np.concatenate(cuts).tobytes(), 9)).decode("ascii")


def read_cuts(text: str) -> Cuts:
    """Return the cuts of a text; ValueError for a text that has none."""
    try:
        return np.frombuffer(zlib.decompress(b64decode(text, validate=True)), np.int8)
    except zlib.error as error:
        raise ValueError(f"{text[:20]!r}: no cuts: {error}") from error
