"""Functions that modules of NumPy have beside their kernels: each is written once in a module."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from mechproof.programs.code import KernelCode

# How functions of conditions are called.
CHECK = "_check_of_"


def name_functions(codes: Iterable[KernelCode]) -> dict[str, str]:
    """Return what each function is called: like the first of the module that does the same."""
    first: dict[object, str] = {}
    return {name: first.setdefault(made, name) for code in codes for name, made in _list(code)}


def list_suffixes(code: KernelCode) -> list[str]:
    """List how the functions of stages end, the last one like the kernel."""
    others = [f"_{number}_of_{code.name}" for number in range(1, len(code.stages))]
    return [*others, f"_of_{code.name}"]


def _list(code: KernelCode) -> Iterator[tuple[str, object]]:
    """List the functions of a kernel with all that their text is made of."""
    if code.inside:
        made = code.masked, code.terms, code.inside.operations, code.inside.outputs
        yield f"{CHECK}{code.name}", made
    for stage, suffix in zip(code.stages, list_suffixes(code), strict=True):
        if stage.prepares:
            yield f"_prepare{suffix}", (stage.parameters, stage.prepare)
        if stage.evaluate and not code.indexed:
            yield f"_form{suffix}", (bool(code.shape), stage.evaluate)
