"""Languages: how NumPy, numba, C and formulas spell the operations of a program."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from struct import pack, unpack
from types import MappingProxyType
from typing import Any

from mechproof.codegen.c_names import spell_in_c
from mechproof.codegen.syntax import Syntax
from mechproof.programs.elementary.function_programs import BODIES
from mechproof.programs.operations import (
    ATOM,
    CHOICE,
    HELPER,
    KINDS,
    Infix,
    Kind,
    Pattern,
    Spelling,
    Support,
)

# Prefix of elementary functions in compiled kernels, and the last argument of a compiled function
# that is valid only up to the largest angle.
ELEMENTARY, EXACT = "_elementary.", "_exact"
CONSTANTS = MappingProxyType({"#pi": "_np.pi", "#e": "_np.e", "#inf": "_np.inf", "#nan": "_np.nan"})


def _spell(spellings: Mapping[str, Spelling | None], bodies: str = "") -> Syntax:
    """Return the syntax of a language; functions with the prefix `bodies` replace library ones."""
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
    return f"_{spelling.name}" if isinstance(spelling, Support) else str(spelling)


def _change(syntax: Syntax, calls: Mapping[str, str], **more: Any) -> Syntax:
    """Return a language with some functions added or replaced."""
    return replace(syntax, calls=MappingProxyType({**syntax.calls, **calls}), **more)


def _name_constants(
    infinity: str, nan: str, write: Callable[[float], str] = repr
) -> Mapping[str, str]:
    written = {"#pi": write(math.pi), "#e": write(math.e)}
    return MappingProxyType({**written, "#inf": infinity, "#nan": nan})


NUMPY = _spell({k: row.numpy for k, row in KINDS.items()})
# In kernels whole numbers are written as floats, which NumPy combines with arrays faster; in a
# module's facts, which the runtime evaluates with fractions, they stay whole.
NUMPY_BODY = replace(NUMPY, number=lambda number: repr(float(number)))
# All whole numbers up to this are doubles.
_MOST_EXACT = 2**53


def _write_compiled(number: float) -> str:
    """Return a number's text; large whole ones as floats, since compiled integers have 64 bits."""
    return repr(number if abs(number) < _MOST_EXACT else float(number))


# The functions of a language's own library that reduce far angles themselves.
_LIBRARY = ("tan", "sin", "cos")
# Computes one number at a time; the argument `exact` decides whether far angles give their values,
# however long that takes, or NaN.
NUMBA = replace(
    _spell({k: row.numba for k, row in KINDS.items()}, ELEMENTARY),
    number=_write_compiled,
    last=MappingProxyType({kind: EXACT for kind, (_, _, far) in BODIES.items() if far}),
)
NUMBA_FAR = _change(NUMBA, {name: f"_math.{name}" for name in _LIBRARY}, last={})
C99 = replace(
    _spell({k: row.c for k, row in KINDS.items()}, HELPER),
    # Valid for every angle; only loops over points know that all their angles are near.
    last=MappingProxyType(dict.fromkeys(NUMBA.last, "1")),
    constants=_name_constants("HUGE_VAL", "NAN"),
    number=lambda number: repr(float(number)),
    name=spell_in_c,
)
C99_FAR = _change(C99, {name: name for name in _LIBRARY}, last={})


def _write_single(number: float) -> str:
    digits = f"{number:.9g}"
    return f"{digits}f" if "." in digits or "e" in digits else f"{digits}.0f"


# Functions of <math.h> for floats, with an f; isfinite is a macro for both types.
_SINGLE = {
    kind: f"{name}f"
    for kind, name in C99.calls.items()
    if not name.startswith(HELPER) and name != "isfinite"
}
C99_SINGLE = _change(
    C99,
    _SINGLE,
    constants=_name_constants("HUGE_VALF", "NAN", _write_single),
    number=_write_single,
)
C99_SINGLE_FAR = _change(C99_SINGLE, {name: f"{name}f" for name in _LIBRARY}, last={})


@dataclass(frozen=True)
class Script:
    """A language of formulas: how it spells operations, and how its files are laid out.

    If it takes arrays, all forms are computed and one is chosen for each element; if it takes
    vectors, a point may have components. `apart`: each function has its own file. `fuses`: its
    compilers may fuse sums and products, which loses the rests of roundings. `native` are the kinds
    that the language has, `helpers` the texts of functions that no program can express.
    """

    name: str
    syntax: Syntax
    suffix: str
    native: frozenset[str]
    helpers: Mapping[str, str]
    takes_arrays: bool = False
    takes_vectors: bool = True
    apart: bool = False
    ignores_case: bool = False
    fuses: bool = False

    @property
    def template(self) -> str:
        """Return the name of the language's template."""
        return f"{self.name}{self.suffix}.jinja"


def _script(
    name: str, suffix: str, syntax: Syntax, helpers: Mapping[str, str], **more: bool
) -> Script:
    """Return a language whose kinds without a spelling are helper functions next to the formula."""
    native = frozenset({*syntax.infix, *syntax.patterns, *syntax.calls, "copy"})
    lacking = {kind: f"{HELPER}{kind}" for kind in KINDS if kind not in native}
    return Script(name, _change(syntax, lacking), suffix, native, MappingProxyType(helpers), **more)


# Prefixes of variables in formulas, in addition to the paper's names.
FORM, RESULT = "form_", "result"


def _avoid(words: str, name: str) -> str:
    own = name.startswith((HELPER, FORM, RESULT))
    return f"{name}_" if own or name.rstrip("_") in words.split() else name


def _write_long_real(number: float) -> str:
    """Return a number in Structured Text, typed unless a single-precision REAL can hold it."""
    digits = repr(float(number))
    return digits if unpack("f", pack("f", number))[0] == number else f"LREAL#{digits}"


def _spell_python(row: Kind) -> Spelling | None:
    found = row.python or (row.numpy if isinstance(row.numpy, str) else None)
    return found.replace("_np.", "np.") if isinstance(found, str) else found


_PYTHON = replace(
    _spell({k: _spell_python(row) for k, row in KINDS.items()}),
    constants=_name_constants("np.inf", "np.nan"),
    number=lambda number: repr(float(number)),
    name=partial(_avoid, "np abs values"),
)


def _spell_array_api(row: Kind) -> Spelling | None:
    found = row.array_api or _spell_python(row)
    if isinstance(found, str):
        return found.replace("np.arc", "xp.a").replace("np.", "xp.")
    return found


# The operation that makes an array of a number, as functions of the standard require arrays.
ARRAY = "array"
_ARRAY_API = replace(
    _spell(
        {ARRAY: Pattern("xp.asarray({}, dtype=dtype)", CHOICE, ATOM)}
        | {k: _spell_array_api(row) for k, row in KINDS.items()}
    ),
    constants=_name_constants("xp.inf", "xp.nan"),
    number=lambda number: repr(float(number)),
    name=partial(_avoid, "abs dtype given ones types v xp"),
    # Helper functions next to the formula take the namespace too.
    last=MappingProxyType({k: "xp" for k, row in KINDS.items() if not _spell_array_api(row)}),
)
# The words are Octave's keywords, and functions that a formula may call.
_OCTAVE = replace(
    _spell({k: row.octave for k, row in KINDS.items()}),
    constants=_name_constants("Inf", "NaN"),
    number=lambda number: repr(float(number)),
    name=partial(
        _avoid,
        "break case catch classdef continue do else elseif end endfunction endif for function "
        "global if logical nan o ones otherwise parfor persistent return rem size switch try until "
        "while NaN Inf " + " ".join(r.octave for r in KINDS.values() if isinstance(r.octave, str)),
    ),
)
_JAVASCRIPT = replace(
    _spell({k: row.javascript for k, row in KINDS.items()}),
    constants=_name_constants("Infinity", "NaN"),
    number=lambda number: repr(float(number)),
    name=partial(
        _avoid,
        "arguments async await break case catch class const continue debugger default delete do "
        "else enum eval export extends false finally for function if implements import in "
        "instanceof interface let new null package private protected public return static super "
        "switch this throw true try typeof undefined var void while with yield Infinity Math NaN "
        "Number",
    ),
)
_STRUCTURED_TEXT = replace(
    _spell({k: row.structured_text for k, row in KINDS.items()}),
    constants=_name_constants("", ""),
    number=_write_long_real,
)
# Words of IEC 61131-3, which ignores case.
STRUCTURED_TEXT_WORDS = (
    "abs acos action and any array asin at atan atan2 bool by byte case configuration cos date "
    "dint do dt dword else elsif end exit exp expt false for from function if int interface ld le "
    "limit lint ln log lreal lt lword max method min mod mux ne not of on or pointer program real "
    "repeat result resource retain return sel shl shr sin sint sqrt st step string struct super "
    "tan task then this time to tod true type udint uint ulint until usint valid var while with "
    "word xor en eno ge gt eq r_edge f_edge"
)
_CHOOSE = """function r = mp_choose(c, a, b)
  % a where c holds, elsewhere b; arrays of one size, or numbers beside them.
  o = ones(size(c + a + b));
  c = logical(c .* o);
  a = a .* o;
  r = b .* o;
  r(c) = a(c);
end
"""
SCRIPTS: Mapping[str, Script] = MappingProxyType(
    {
        script.name: script
        for script in (
            _script("python", ".py", _PYTHON, {}, takes_arrays=True),
            _script("array_api", ".py", _ARRAY_API, {}, takes_arrays=True, fuses=True),
            _script("octave", ".m", _OCTAVE, {"choose": _CHOOSE}, takes_arrays=True, apart=True),
            _script("javascript", ".mjs", _JAVASCRIPT, {}),
            _script(
                *("structured_text", ".st", _STRUCTURED_TEXT, {}),
                takes_vectors=False,
                ignores_case=True,
            ),
        )
    }
)
