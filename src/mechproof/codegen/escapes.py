"""Escapes: in, a text of a paper; out, what stands for it in a comment, a docstring or a string.

Templates take them as filters; a record has refused what cannot be shown.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from types import MappingProxyType


def fold(text: str) -> str:
    """Write a text in one line; the blanks that begin it stay."""
    return re.sub(r"\s*[\n\t]\s*", " ", text)


def write_c_comment(text: str) -> str:
    """Write a line of a comment in C, which it does not end."""
    return fold(text).replace("*/", "* /").replace("/*", "/ *")


def write_docstring(text: str) -> str:
    """Write what a docstring has between its quotes; its lines stay."""
    return text.replace("\\", "\\\\").replace('"""', r"\"\"\"")


ESCAPES: Mapping[str, Callable[[str], str]] = MappingProxyType(
    {
        "comment": fold,
        "c_comment": write_c_comment,
        "docstring": write_docstring,
        "python_string": repr,
    }
)
