"""Languages: how NumPy, numba and C spell the operations of a program."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from mechproof.codegen.c_names import spell_in_c
from mechproof.codegen.syntax import Syntax
from mechproof.programs.elementary.functions import BODIES
from mechproof.programs.operations import (
    HELPER,
    KINDS,
    AxisReduction,
    Infix,
    Pattern,
    Spelling,
    Support,
)

# Where compiled kernels find the elementary functions, and the last argument of a compiled function
# that is right up to the largest angle only.
ELEMENTARY, EXACT = "_elementary.", "_exact"
CONSTANTS = MappingProxyType({"#pi": "_np.pi", "#e": "_np.e", "#inf": "_np.inf", "#nan": "_np.nan"})


def _spell(spellings: Mapping[str, Spelling | None], bodies: str = "") -> Syntax:
    """Return the syntax of a language, its own functions in place of those it does not spell."""
    spelled = {k: s for k, s in spellings.items() if s is not None}
    calls = {k: _name_function(s) for k, s in spelled.items() if not isinstance(s, Infix | Pattern)}
    if bodies:
        calls |= {kind: f"{bodies}{kind}" for kind in BODIES}
    return Syntax(
        infix={k: s for k, s in spelled.items() if isinstance(s, Infix)},
        calls=calls,
        last={},
        patterns={k: s for k, s in spelled.items() if isinstance(s, Pattern)},
        constants=CONSTANTS,
    )


def _name_function(spelling: Spelling) -> str:
    return f"_{spelling.name}" if isinstance(spelling, Support | AxisReduction) else str(spelling)


NUMPY = _spell({k: row.numpy for k, row in KINDS.items()})
# In kernels whole numbers are floats, which NumPy converts faster beside an array; in the facts of
# a module, which the runtime asks of fractions, they are not.
NUMPY_BODY = replace(NUMPY, number=lambda number: repr(float(number)))
# The functions of a language's own library, for angles that are reduced there.
_LIBRARY = ("tan", "sin", "cos")
# One number at a time; `exact` says whether what angles far out give is wanted, however long it
# takes, or NaN.
NUMBA = replace(
    _spell({k: row.numba for k, row in KINDS.items()}, ELEMENTARY),
    last=MappingProxyType({kind: EXACT for kind, (_, _, far) in BODIES.items() if far}),
)
NUMBA_FAR = replace(
    NUMBA,
    calls=MappingProxyType({**NUMBA.calls, **{name: f"_math.{name}" for name in _LIBRARY}}),
    last=MappingProxyType({}),
)
C99 = replace(
    _spell({k: row.c for k, row in KINDS.items()}, HELPER),
    # Wherever an angle lies: loops over points alone know that all are near.
    last=MappingProxyType(dict.fromkeys(NUMBA.last, "1")),
    constants=MappingProxyType(
        {
            "#pi": repr(math.pi),
            "#e": repr(math.e),
            "#inf": "HUGE_VAL",
            "#nan": "NAN",
        }
    ),
    number=lambda number: repr(float(number)),
    name=spell_in_c,
)
C99_FAR = replace(
    C99,
    calls=MappingProxyType({**C99.calls, **{n: n for n in _LIBRARY}}),
    last=MappingProxyType({}),
)


def _write_single(number: float) -> str:
    digits = f"{number:.9g}"
    return f"{digits}f" if "." in digits or "e" in digits else f"{digits}.0f"


# What <math.h> has for doubles and, with an f, for floats; isfinite is a macro for both.
_SINGLE = {
    kind: f"{name}f"
    for kind, name in C99.calls.items()
    if not name.startswith(HELPER) and name != "isfinite"
}
C99_SINGLE = replace(
    C99,
    calls=MappingProxyType({**C99.calls, **_SINGLE}),
    constants=MappingProxyType(
        {
            **C99.constants,
            "#pi": _write_single(math.pi),
            "#e": _write_single(math.e),
            "#inf": "HUGE_VALF",
        }
    ),
    number=_write_single,
)
C99_SINGLE_FAR = replace(
    C99_SINGLE,
    calls=MappingProxyType({**C99_SINGLE.calls, **{n: f"{n}f" for n in _LIBRARY}}),
    last=MappingProxyType({}),
)
