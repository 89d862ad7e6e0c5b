"""Programs of elementary functions with altered steps, and the bounds then proved for them."""

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
    # `prove` caches the bound of the function itself: that of the changed one must not enter.
    with monkeypatch.context() as patch:
        patch.setattr(elementary_errors, "build", lambda *_: changed)
        return prove.__wrapped__(kind).most
