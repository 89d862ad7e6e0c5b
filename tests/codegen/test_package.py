"""The contents of the generated package."""

from __future__ import annotations

import dataclasses

from derived import declared_paper_of

from mechproof.codegen.backends.numpy import REGENERATED
from mechproof.codegen.regenerate import render_package
from mechproof.record import Paper


def test_package_has_modules_for_systems_with_forms_and_no_others() -> None:
    paper = dataclasses.replace(declared_paper_of("tooth_thickness"), system="system")
    bare = Paper("bare", "", (), ())
    files = render_package([paper, bare])
    folders = ("", "forms/", "derivatives/", "compiled/")
    modules = {f"{d}{n}.py" for d in folders for n in ("__init__", "system")}
    assert set(files) == modules | {"system.pyi", "compiled/system.pyi"}
    assert all(text.endswith("\n") and REGENERATED in text for text in files.values())
    own = render_package([paper, bare], is_own=True)
    assert set(own) - set(files) == {"compiled/elementary.py"}
    assert REGENERATED in own["compiled/elementary.py"]
