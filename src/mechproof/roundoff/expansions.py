"""Expansions: operations written out as programs of others, before their steps are bounded."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import partial
from types import MappingProxyType

from mechproof.programs.operations import KINDS
from mechproof.programs.program import Program
from mechproof.programs.trace import TRACED, trace


@dataclass(frozen=True)
class Expansion:
    """A program in place of one operation; `errors` are those of approximations, in eps.

    `proved` are the functions of which the error is proved; what is `scaled` is so by a factor
    that depends on the first operand alone.
    """

    program: Program
    errors: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))
    proved: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))
    scaled: frozenset[str] = frozenset()


def _write_out(kind: str, *inputs: str) -> Expansion:
    """Take the operations that a kind is put together of for its program."""
    meaning = KINDS[kind].meaning
    assert meaning is not None
    return Expansion(trace(partial(meaning, TRACED), inputs))


# What NumPy computes by its own tan and arctan; a test compares every bit.
WAY = "NumPy's functions"
IN_NUMPY: Mapping[str, Expansion] = MappingProxyType(
    {
        "tangent_quotient": _write_out("tangent_quotient", "y", "a", "b"),
        "small_arctan": _write_out("small_arctan", "y"),
    }
)
