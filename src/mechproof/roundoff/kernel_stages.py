"""Kernel stages: in, a kernel; out, its stages in every way of computing them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from mechproof.programs.kernel import Kernel, input_names
from mechproof.programs.program import Stage, map_affinely
from mechproof.programs.scalar import adapt_stage, put_off_divisions
from mechproof.record import Form, Paper, Quantity
from mechproof.roundoff.affine import AffineMap
from mechproof.roundoff.branches import list_bounded_branches
from mechproof.roundoff.compensation import find_compensated, find_scaled
from mechproof.roundoff.compiled_kernels import WAY as COMPILED_WAY, list_expansions
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.steps import (
    CHOICE,
    FUNCTIONS,
    IN_NUMPY,
    WAY,
    StraightLineProgram,
    flatten_stage,
    keep_needed,
)
from mechproof.roundoff.symmetry import check_signs
from mechproof.roundoff.term_sums import take_sum
from mechproof.roundoff.written_scales import WrittenScale, share_equal_steps, write_scale


def list_computed_stages(kernel: Kernel, paper: Paper) -> Iterator[ComputedStage]:
    """Yield the stages of a kernel that have charts, in every way of computing them."""
    for form, stage in zip(kernel.forms, kernel.code.stages, strict=True):
        if not form.charts:
            continue
        if kernel.code.indexed:
            yield from _list_totals(kernel, paper)
            continue
        scale = write_scale(kernel.quantity, form, stage, paper)
        straight = find_compensated(flatten_stage(stage, IN_NUMPY))
        check_signs(straight, form, input_names(kernel.quantity))
        affine = _find_map(kernel.quantity, stage, straight)
        whole = affine.apply() if affine else straight
        # In exact arithmetic all branches are the same function. Where this one loses digits, the
        # search in long doubles sees a little less, but balls judge what it finds.
        exact = list_bounded_branches(whole)[0].straight
        yield ComputedStage(kernel, form, stage, WAY, whole, exact, scale, map=affine)
        if kernel.is_shipped:
            yield _compile(kernel, form, stage, exact, scale)


def _list_totals(kernel: Kernel, paper: Paper) -> Iterator[ComputedStage]:
    """Yield the stage of a kernel with a sum over a set, in every way of computing it."""
    ways = [(WAY, kernel, IN_NUMPY)]
    if kernel.is_shipped:
        ways.append((COMPILED_WAY, put_off_divisions(kernel), list_expansions()))
    for way, own, expansions in ways:
        is_compiled = way == COMPILED_WAY
        total, reduced, known = take_sum(own, expansions, keeps_rests=is_compiled)
        (form,), (stage,) = reduced.forms, reduced.code.stages
        straight = flatten_stage(stage, known)
        if is_compiled:
            _check_functions(straight)
        exact = list_bounded_branches(straight)[0].straight
        scale = write_scale(reduced.quantity, form, stage, paper)
        computed = flatten_stage(stage, {}) if is_compiled else None
        yield ComputedStage(
            reduced, form, stage, way, straight, exact, scale, computed, total=total
        )


def _compile(
    kernel: Kernel,
    form: Form,
    stage: Stage,
    exact: StraightLineProgram,
    scale: WrittenScale | None,
) -> ComputedStage:
    compiled = adapt_stage(stage)
    expanded = keep_needed(flatten_stage(compiled, list_expansions()))
    straight = find_scaled(find_compensated(expanded))
    _check_functions(straight)
    check_signs(straight, form, input_names(kernel.quantity))
    affine = _find_map(kernel.quantity, stage, straight)
    if affine:
        affine = replace(affine, is_fused=True)
        straight, points = affine.apply(), affine.points
        compiled = replace(compiled, running=points, evaluate=map_affinely(points))
    # So that a ValueError is raised here rather than later, when a bound is requested.
    list_bounded_branches(straight)
    computed = flatten_stage(compiled, {})
    return ComputedStage(
        kernel, form, stage, COMPILED_WAY, straight, exact, scale, computed, affine
    )


def _check_functions(straight: StraightLineProgram) -> None:
    """Raise ValueError for functions of NumPy: compiled kernels must bring their own."""
    assumed = {step.kind for step in straight.steps if not step.proved} & FUNCTIONS.keys()
    if assumed:
        raise ValueError(
            f"nothing is proved about compiled {', '.join(sorted(assumed))}: leave out the charts"
        )


def _find_map(quantity: Quantity, stage: Stage, straight: StraightLineProgram) -> AffineMap | None:
    """Return the map of an affine stage, None for others; ValueError for a computed shift."""
    if not stage.affine:
        return None
    if any(step.kind == CHOICE for step in straight.steps):
        raise ValueError("an affine map must not contain choices")
    names = input_names(quantity)
    points = tuple(names[s] for s in quantity.arguments[0].symbols)
    shift = tuple(map(str, straight.outputs[-len(points) :]))
    if not {*shift} <= {*straight.inputs}:
        raise ValueError("the shift of an affine map must consist of inputs")
    inputs = (*points, *stage.parameters)
    return AffineMap(share_equal_steps(replace(straight, inputs=inputs)), points, shift)
