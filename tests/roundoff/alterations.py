"""Programs of elementary functions with a step altered, and what is then proved of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from mechproof.programs.elementary.formats import DOUBLE
from mechproof.programs.elementary.function_programs import Function, build
from mechproof.programs.program import Operation, Program
from mechproof.roundoff import elementary_errors
from mechproof.roundoff.elementary_errors import prove


def change(kind: str, edit: Callable[[Operation], Operation]) -> Function:
    function = build(kind, DOUBLE)
    operations = tuple(map(edit, function.program.operations))
    assert operations != function.program.operations
    program = Program(function.program.inputs, operations, function.program.outputs)
    return replace(function, program=program)


def prove_changed(kind: str, changed: Function, monkeypatch: pytest.MonkeyPatch) -> float:
    # What is proved of the function itself is kept: it must not be of the changed one.
    with monkeypatch.context() as patch:
        patch.setattr(elementary_errors, "build", lambda *_: changed)
        return prove.__wrapped__(kind).most
