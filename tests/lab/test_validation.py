"""Emitted kernels are run before they are written; wrong support code and sources are refused."""

from __future__ import annotations

import shutil
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest
from derived import paper_of
from quantities import GENERATED
from weights import first_of

from mechproof.codegen.source_reading import TranslationError
from mechproof.derivation import packaged_directory
from mechproof.kernel_support.functions import tangent_quotient
from mechproof.lab.subject import Subject, find_subjects, make_subjects
from mechproof.lab.validation import validate


@pytest.fixture
def position() -> Subject:
    (subject,) = find_subjects(("elliptic_planetary.position",))
    return subject


def changed(module: ModuleType, **names: Callable[..., Any]) -> ModuleType:
    """Return a copy of a module in which its functions find `names` in place of its own."""
    source = Path(str(module.__file__)).read_text(encoding="utf-8")
    copy = ModuleType(module.__name__)
    exec(compile(source, str(module.__file__), "exec"), copy.__dict__)
    copy.__dict__.update(names)
    return copy


def with_modules(subject: Subject, kernels: Any = None, forms: Any = None) -> Subject:
    return replace(subject, modules=(kernels or subject.modules[0], forms or subject.modules[1]))


@pytest.mark.slow
def test_the_shipped_kernels_pass(position: Subject) -> None:
    validate(iter([position]))


@pytest.mark.slow
@pytest.mark.parametrize("name", first_of(["_product_rest", "_quotient_rest", "_small_tangent"]))
@pytest.mark.parametrize("factor", [0.0, 2.0, -1.0], ids=["dropped", "doubled", "turned"])
def test_a_wrong_low_word_stops_it(position: Subject, name: str, factor: float) -> None:
    module = position.modules[0]
    right = getattr(module, name)
    wrong = changed(module, **{name: lambda *arguments: factor * right(*arguments)})
    with pytest.raises(TranslationError, match=r"position\(.*the oracle gives"):
        validate(iter([with_modules(position, kernels=wrong)]))


def test_a_wrong_rival_stops_it(position: Subject) -> None:
    forms = position.modules[1]
    right = forms.position_tan_half
    wrong = SimpleNamespace(**vars(forms))
    wrong.position_tan_half = lambda *arguments: right(*arguments) * (1 + 1e-13)
    with pytest.raises(TranslationError, match=r"position_tan_half\(.*its program gives"):
        validate(iter([with_modules(position, forms=wrong)]))


def test_a_fault_in_long_arrays_only_stops_it(position: Subject) -> None:
    """Blocks are support code, which is run as well."""
    module = position.modules[0]
    right = module._in_blocks

    def wrong(evaluate: Any, running: Any, *others: Any, **options: Any) -> Any:
        values = right(evaluate, running, *others, **options)
        return values if np.size(values) < 10_000 else values * (1 + 1e-12)

    with pytest.raises(TranslationError, match="position"):
        validate(iter([with_modules(position, kernels=changed(module, _in_blocks=wrong))]))


def test_a_wrong_function_of_the_support_stops_it(position: Subject) -> None:
    module = position.modules[0]

    def wrong(*given: Any) -> Any:
        return tangent_quotient(*given) * (1 + 1e-12)

    with pytest.raises(TranslationError, match="position"):
        validate(iter([with_modules(position, kernels=changed(module, _tangent_quotient=wrong))]))


@pytest.mark.slow
@pytest.mark.parametrize("way", ["together", "alone", "in rows"])
def test_a_fault_in_one_compiled_loop_stops_it(position: Subject, way: str) -> None:
    right = position.load_compiled().position

    def wrong(phi1: Any, *sizes: Any) -> Any:
        ranks = np.ndim(phi1), np.ndim(sizes[0])
        met = {(1, 1): "together", (0, 0): "alone", (1, 0): "in rows"}[ranks]
        return right(phi1, *sizes) * (1 + 1e-12 * (met == way))

    faulty = replace(position, load_compiled=lambda: SimpleNamespace(position=wrong))
    with pytest.raises(TranslationError, match=r"compiled: .*position\(.*the oracle gives"):
        validate(iter([faulty]))


def test_code_of_the_package_is_loaded_as_such_while_it_has_its_text(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its cached machine code is then found; a loaded module may be older than its file."""
    system, name = "tooth_thickness", "mechproof.kernels.compiled.tooth_thickness"
    copy = tmp_path / "generated"
    shutil.copytree(GENERATED, copy)

    def load() -> str:
        place = packaged_directory() / system
        module = next(make_subjects(paper_of(system), place, copy)).load_compiled()
        assert module is not None
        return module.__name__

    monkeypatch.delitem(sys.modules, name, raising=False)
    assert load() == name
    assert load() != name
    monkeypatch.delitem(sys.modules, name)
    file = copy / "compiled" / f"{system}.py"
    file.write_text(f"{file.read_text(encoding='utf-8')}\n", encoding="utf-8")
    assert load() != name
