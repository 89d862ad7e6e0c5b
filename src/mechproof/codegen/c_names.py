"""Names in C: in, a name of a paper; out, the same, or with an underscore appended if it is taken.

Taken are keywords of C and of C++, where the headers may be included too, names that <math.h> and
headers included along with it define, and names that the kernels' own sources use.
"""

from __future__ import annotations

import re

from mechproof.programs.operations import HELPER, KINDS

# Functions of <math.h>, for doubles and for floats.
_FUNCTIONS = [row.c for row in KINDS.values() if isinstance(row.c, str) and row.c.isidentifier()]
# Names of parameters in headers, in addition to those of the paper.
DECLARED = ("count", "terms", "out")
# Prefix of the arrays for the results of several kernels.
STORED = "out_"
WORDS = frozenset({
    *DECLARED,
    # C, up to C23.
    "alignas", "alignof", "auto", "bool", "break", "case", "char", "const", "constexpr",
    "continue", "default", "do", "double", "else", "enum", "extern", "false", "float", "for",
    "goto", "if", "inline", "int", "long", "nullptr", "register", "restrict", "return", "short",
    "signed", "sizeof", "static", "static_assert", "struct", "switch", "thread_local", "true",
    "typedef", "typeof", "typeof_unqual", "union", "unsigned", "void", "volatile", "while",
    "asm", "fortran",
    # C++ in addition.
    "and", "and_eq", "bitand", "bitor", "catch", "char16_t", "char32_t", "char8_t", "class",
    "co_await", "co_return", "co_yield", "compl", "concept", "const_cast", "consteval",
    "constinit", "decltype", "delete", "dynamic_cast", "explicit", "export", "friend", "mutable",
    "namespace", "new", "noexcept", "not", "not_eq", "operator", "or", "or_eq", "private",
    "protected", "public", "reinterpret_cast", "requires", "static_cast", "template", "this",
    "throw", "try", "typeid", "typename", "using", "virtual", "wchar_t", "xor", "xor_eq",
    # Types, functions and macros that sources use.
    "size_t", "uint32_t", "uint64_t", "isnan", "NAN", *_FUNCTIONS, *(f"{n}f" for n in _FUNCTIONS),
    "sin", "cos", "tan", "sinf", "cosf", "tanf", "fma", "fmaf",
    # Macros of headers that may be included earlier, of systems and of processors.
    "DOMAIN", "EDOM", "EOF", "ERANGE", "I", "INFINITY", "NDEBUG", "NULL", "OVERFLOW", "PLOSS",
    "SING", "TLOSS", "UNDERFLOW", "complex", "errno", "far", "huge", "i386", "imaginary",
    "interface", "linux", "math_errhandling", "near", "noreturn", "offsetof", "small", "unix",
})  # fmt: skip
MACROS = re.compile(r"(M|FP|MATH|HUGE)_[A-Z0-9_]+|[A-Z][A-Z0-9_]*_(MAX|MIN|WIDTH|C)")


def spell_in_c(name: str, file: str = "") -> str:
    """Return a name that clashes with nothing in a file's sources; distinct for distinct names.

    Kernels' names begin with the name of their file, so such names are taken too.
    """
    begun = (HELPER, STORED, f"{file}_")
    free = name.rstrip("_")
    is_taken = free in WORDS or MACROS.fullmatch(free) or name.startswith(begun)
    return f"{name}_" if is_taken else name
