"""Names in C: in, a name of a paper; out, the same, or with an underscore if it is taken.

Taken are words of C and of C++, where headers are included too, what <math.h> and headers that it
may come with define, and what the kernels themselves are made of.
"""

from __future__ import annotations

import re

from mechproof.programs.operations import HELPER, KINDS

# Functions of <math.h>, for doubles and for floats.
_FUNCTIONS = [row.c for row in KINDS.values() if isinstance(row.c, str) and row.c.isidentifier()]
# Names of parameters in headers, beside the names of the paper.
DECLARED = ("count", "terms", "out")
# Arrays of the results of several kernels begin with this.
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
    # C++ besides.
    "and", "and_eq", "bitand", "bitor", "catch", "char16_t", "char32_t", "char8_t", "class",
    "co_await", "co_return", "co_yield", "compl", "concept", "const_cast", "consteval",
    "constinit", "decltype", "delete", "dynamic_cast", "explicit", "export", "friend", "mutable",
    "namespace", "new", "noexcept", "not", "not_eq", "operator", "or", "or_eq", "private",
    "protected", "public", "reinterpret_cast", "requires", "static_cast", "template", "this",
    "throw", "try", "typeid", "typename", "using", "virtual", "wchar_t", "xor", "xor_eq",
    # Types, functions and macros that sources use.
    "size_t", "uint32_t", "uint64_t", "isnan", "NAN", *_FUNCTIONS, *(f"{n}f" for n in _FUNCTIONS),
    "sin", "cos", "tan", "sinf", "cosf", "tanf", "fma", "fmaf",
    # Macros of the headers that may stand before, of systems and of processors.
    "DOMAIN", "EDOM", "EOF", "ERANGE", "I", "INFINITY", "NDEBUG", "NULL", "OVERFLOW", "PLOSS",
    "SING", "TLOSS", "UNDERFLOW", "complex", "errno", "far", "huge", "i386", "imaginary",
    "interface", "linux", "math_errhandling", "near", "noreturn", "offsetof", "small", "unix",
})  # fmt: skip
MACROS = re.compile(r"(M|FP|MATH|HUGE)_[A-Z0-9_]+|[A-Z][A-Z0-9_]*_(MAX|MIN|WIDTH|C)")


def spell_in_c(name: str, file: str = "") -> str:
    """Return a name that nothing in the sources of a file has; different ones for different names.

    Kernels begin with the name of their file.
    """
    begun = (HELPER, STORED, f"{file}_")
    free = name.rstrip("_")
    is_taken = free in WORDS or MACROS.fullmatch(free) or name.startswith(begun)
    return f"{name}_" if is_taken else name
