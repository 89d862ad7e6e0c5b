"""Languages: how NumPy, numba and C spell the operations of a program."""

from __future__ import annotations

import math
from dataclasses import replace
from types import MappingProxyType

from mechproof.codegen.c_names import HELPER, spell_in_c
from mechproof.codegen.elementary.functions import BODIES
from mechproof.codegen.syntax import (
    ATOM,
    BOTH,
    CHOICE,
    EITHER,
    INFIX,
    POWER,
    SIGN,
    Syntax,
)

NUMPY = Syntax(
    infix=INFIX,
    calls=MappingProxyType(
        {
            **{
                name: f"_np.{name}"
                for name in (
                    "sqrt", "sin", "cos", "tan", "arcsin", "arccos", "arctan", "arctan2", "exp",
                    "log", "copysign", "sign",
                )
            },
            "absolute": "_abs",
            "choose": "_choose_where",
            **{
                name: f"_{name}"
                for name in (
                    "is_finite", "is_positive", "is_nonnegative", "product_rest", "sum_rest",
                    "quotient_rest", "small_tangent", "tangent_quotient", "small_arctan", "single",
                    "whole_turns_off", "maximum", "floor", "nonnegative_form", "quadratic_form",
                    "square", "hypot",
                )
            },
        }
    ),
    # The constants of the module that a function takes.
    last=MappingProxyType({"small_arctan": "_ARCTANGENT", "tangent_quotient": "_TANGENT"}),
    patterns=MappingProxyType(
        {
            "negate": ("-{}", SIGN, SIGN),
            "power": ("{} ** {}", ATOM, POWER),
            "along_first": ("{}[..., :, _np.newaxis]", ATOM, ATOM),
            "along_last": ("{}[..., _np.newaxis, :]", ATOM, ATOM),
            "transpose": ("_np.swapaxes({}, -1, -2)", CHOICE, ATOM),
            "diagonal": ("_np.diagonal({}, axis1=-2, axis2=-1)", CHOICE, ATOM),
        }
    ),
    constants=MappingProxyType(
        {"#pi": "_np.pi", "#e": "_np.e", "#inf": "_np.inf", "#nan": "_np.nan"}
    ),
)  # fmt: skip
# In kernels whole numbers are floats, which NumPy converts faster beside an array; in the facts of
# a module, which the runtime asks of fractions, they are not.
NUMPY_BODY = replace(NUMPY, number=lambda number: repr(float(number)))
# The functions of a language's own library, for angles that are reduced there.
_LIBRARY = ("tan", "sin", "cos")
# One number at a time; `exact` says whether what angles far out give is wanted, however long it
# takes, or NaN.
NUMBA = Syntax(
    infix=INFIX,
    calls=MappingProxyType(
        {
            **{kind: f"_elementary.{kind}" for kind in BODIES},
            **{
                n: f"_{n}"
                for n in (
                    "floor", "rint", "fma", "copysign", "is_finite", "maximum", "choose",
                    "power_of_two",
                )
            },
            "sqrt": "_np.sqrt",
            "absolute": "_abs",
        }
    ),
    last=MappingProxyType({kind: "_exact" for kind, (_, _, far) in BODIES.items() if far}),
    patterns=MappingProxyType(
        {
            "negate": ("-{}", SIGN, SIGN),
            "square": ("{} ** 2", ATOM, POWER),
        }
    ),
    constants=NUMPY.constants,
)  # fmt: skip
NUMBA_FAR = replace(
    NUMBA,
    calls=MappingProxyType({**NUMBA.calls, **{name: f"_math.{name}" for name in _LIBRARY}}),
    last=MappingProxyType({}),
)
C99 = Syntax(
    infix=MappingProxyType({**INFIX, "both": ("&&", BOTH), "either": ("||", EITHER)}),
    calls=MappingProxyType(
        {
            **{kind: f"{HELPER}{kind}" for kind in (*BODIES, "square", "maximum", "power_of_two")},
            "sqrt": "sqrt",
            "floor": "floor",
            "rint": "rint",
            "fma": "fma",
            "copysign": "copysign",
            "absolute": "fabs",
            "is_finite": "isfinite",
        }
    ),
    # Wherever an angle lies: loops over points alone know that all are near.
    last=MappingProxyType(dict.fromkeys(NUMBA.last, "1")),
    patterns=MappingProxyType(
        {"negate": ("-{}", SIGN, SIGN), "choose": ("{} ? {} : {}", EITHER, CHOICE)}
    ),
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
)  # fmt: skip
C99_FAR = replace(
    C99,
    calls=MappingProxyType({**C99.calls, **{n: n for n in _LIBRARY}}),
    last=MappingProxyType({}),
)


def _write_single(number: float) -> str:
    digits = f"{number:.9g}"
    return f"{digits}f" if "." in digits or "e" in digits else f"{digits}.0f"


_SINGLE = {
    kind: f"{C99.calls[kind]}f" for kind in ("sqrt", "floor", "rint", "fma", "copysign", "absolute")
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
