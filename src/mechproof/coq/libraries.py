"""The files of lemmas and tactics that scripts require, each of which requires those before it."""

from __future__ import annotations

import re
from functools import cache
from hashlib import sha256
from importlib.resources import files

# From what all scripts require to what few do.
LIBRARIES = ("Mechproof", "Calculus", "Sums")
# What scripts on bounds of roundings require, and nothing else.
ROUNDINGS = "Roundings"
_NAMED = re.compile(r"^(?:Definition|Fixpoint|Lemma|Ltac) (\w+)", re.MULTILINE)
# What a library takes from others and scripts use by its name.
_EXPORTED = {"Calculus": ("RInt", "is_derive")}


@cache
def read_library(name: str) -> str:
    """Return the text of a library."""
    return files(__package__).joinpath(f"{name}.v").read_text(encoding="utf-8")


def find_library(text: str) -> str:
    """Return the last library of which a text uses a name; all before it come with it."""
    words = set(re.findall(r"\w+", text))
    used = [name for name in LIBRARIES if words & _list_names(name)]
    return used[-1] if used else LIBRARIES[0]


def list_required(text: str) -> tuple[str, ...]:
    """Return the libraries that a script requires, by what it says itself."""
    found = re.search(r"^Require Import (\w+)\.", text, re.MULTILINE)
    if found and found[1] == ROUNDINGS:
        return (ROUNDINGS,)
    return LIBRARIES[: LIBRARIES.index(found[1]) + 1] if found else ()


def digest_required(text: str) -> str:
    """Return the SHA-256 of a script together with all that it requires."""
    whole = "".join((*map(read_library, list_required(text)), text))
    return sha256(whole.encode()).hexdigest()


def digest_libraries() -> str:
    """Return the SHA-256 of all libraries of rows."""
    return sha256("".join(map(read_library, LIBRARIES)).encode()).hexdigest()


@cache
def _list_names(library: str) -> frozenset[str]:
    return frozenset((*_NAMED.findall(read_library(library)), *_EXPORTED.get(library, ())))
