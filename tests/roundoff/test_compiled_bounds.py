"""Bounds of compiled kernels are proved for the code that runs, and wrong ones are refused."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cache
from importlib import import_module
from importlib.resources import files
from typing import Any

import numpy as np
import pytest
from alterations import change
from compiled import grouped
from derived import paper_of
from flint import arb
from weights import first_of

from mechproof.arithmetic.balls import working_precision
from mechproof.arithmetic.intervals import EPS
from mechproof.measured import KERNELS
from mechproof.programs.kernel import input_names, list_functions
from mechproof.roundoff import computed_stages, kernel_stages
from mechproof.roundoff.certificate import RoundingClaim, holds
from mechproof.roundoff.certificate_files import find_certificate
from mechproof.roundoff.compiled_kernels import WAY, list_expansions
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.elementary_errors import prove
from mechproof.roundoff.error_tables import ErrorTable
from mechproof.roundoff.kernel_stages import list_computed_stages
from mechproof.roundoff.regions import list_regions
from mechproof.roundoff.running import IN_BALLS, IN_DOUBLES, run
from mechproof.roundoff.worst import draw

SYSTEMS = {
    "elliptic_planetary": ("ratio", "position", "acceleration"),
    "track_wheel": ("rotation", "displacement", "spatial_error"),
    "tooth_thickness": (
        *("constant_chord", "chord_height", "height_change", "thickness_change"),
        *("thickness_change_linear", "thickness_error"),
    ),
    "wedge_linkage": ("sensitivities",),
}
NAMES = [f"{system}.{name}" for system, names in SYSTEMS.items() for name in names]


@cache
def subjects() -> tuple[ComputedStage, ...]:
    found = []
    for system, names in SYSTEMS.items():
        paper = paper_of(system)
        kernels = [k for k in list_functions(paper) if k.name in names and k.is_shipped]
        found += [s for kernel in kernels for s in list_computed_stages(kernel, paper)]
    return tuple(found)


def compiled_subjects(name: str) -> Iterator[ComputedStage]:
    return (s for s in subjects() if s.way == WAY and s.kernel.name == name.partition(".")[2])


def draw_points(subject: ComputedStage, count: int, seed: int) -> Iterator[dict[str, Any]]:
    rng = np.random.default_rng(seed)
    for chart in subject.form.charts:
        for region in list_regions(chart):
            points = draw(subject, region, region.box, count, rng)
            inside = np.broadcast_to(subject.holds(points), count)
            yield {name: column[inside] for name, column in points.items()}


def list_arguments(subject: ComputedStage, points: Mapping[str, Any]) -> list[Any]:
    """Return the kernel's arguments, with the components of vectors stacked."""
    names = input_names(subject.kernel.quantity)
    columns = [
        np.stack([points[names[s]] for s in argument.symbols], axis=-1)
        for argument in subject.kernel.quantity.arguments
    ]
    return [column[:, 0] if column.shape[1] == 1 else column for column in columns]


def measure_apart(
    subject: ComputedStage, points: Mapping[str, Any], one: np.ndarray, other: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the distance between two results, and its scale as computed in doubles."""
    if subject.scale is None:
        return np.abs(one - other), np.abs(one)
    scale = np.broadcast_to(run(subject.scale.straights[0], points, IN_DOUBLES)[0], len(one))
    if subject.map is None:
        return np.abs(one - other), scale.reshape(-1, *[1] * (one.ndim - 1))
    point, shift = (
        np.linalg.norm([points[name] for name in names], axis=0)
        for names in (subject.map.points, subject.map.shift)
    )
    return np.linalg.norm(one - other, axis=-1), scale * point + shift


@pytest.mark.slow
@pytest.mark.parametrize("name", grouped(NAMES, 1))
def test_what_is_proved_is_what_runs(name: str) -> None:
    """The steps run in doubles give the bits of the kernels that numba compiles.

    Point by point, they take the first form whose condition holds.
    """
    system, _, quantity = name.partition(".")
    kernel = getattr(import_module(f"mechproof.kernels.compiled.{system}"), quantity)
    subjects = list(compiled_subjects(name))
    for number, subject in enumerate(subjects):
        compared = 0
        for points in draw_points(subject, 400, 8):
            earlier = [one.holds(points) for one in subjects[:number] if one.stage.when]
            taken = ~np.logical_or.reduce(
                [np.zeros(len(next(iter(points.values()))), bool), *earlier]
            )
            points = {name: column[taken] for name, column in points.items()}
            wanted = kernel(*list_arguments(subject, points))
            found = subject.compute(points)
            compared += found.shape[1]
            assert np.array_equal(np.moveaxis(found, 0, -1).ravel(), wanted.ravel())
        assert compared > 50


@cache
def claims(system: str) -> tuple[RoundingClaim, ...]:
    certificate = find_certificate(files(KERNELS), system)
    assert certificate is not None
    return certificate.claims


@pytest.mark.slow
@pytest.mark.parametrize("name", grouped(NAMES))
def test_both_kernels_differ_by_no_more_than_both_bounds(name: str) -> None:
    """On drawn points, and within some ulps of the worst inputs of both kernels."""
    system, _, quantity = name.partition(".")
    plain, fast = (
        getattr(import_module(f"mechproof.kernels{package}.{system}"), quantity)
        for package in ("", ".compiled")
    )
    rng = np.random.default_rng(3)
    for subject in compiled_subjects(name):
        told = [c for c in claims(system) if (c.quantity, c.form) == (quantity, subject.form.name)]
        (proved,) = (c.proved for c in told if c.way == WAY)
        both = proved + max(c.proved for c in told if c.way != WAY)
        hurting = {
            argument: np.concatenate([shake(float.fromhex(c.at[argument]), rng) for c in told])
            for argument in told[0].at
        }
        inside = np.broadcast_to(subject.holds(hurting), (len(told) * SHAKEN,))
        hurting = {argument: column[inside] for argument, column in hurting.items()}
        for points in (*draw_points(subject, 1000, 12), hurting):
            given = list_arguments(subject, points)
            apart, scale = measure_apart(subject, points, plain(*given), fast(*given))
            assert np.all(apart <= both * EPS * scale * (1 + 2.0**-40))


SHAKEN = 200


def shake(value: float, rng: np.random.Generator) -> np.ndarray:
    moved: np.ndarray = value + rng.integers(-9, 10, SHAKEN) * np.spacing(value)
    return moved


@pytest.mark.slow
@pytest.mark.parametrize("name", first_of(["track_wheel.rotation", "elliptic_planetary.position"]))
def test_a_bound_lowered_by_a_tenth_is_refused(name: str) -> None:
    system, _, quantity = name.partition(".")
    subject = next(compiled_subjects(name))
    (claim,) = (
        c
        for c in claims(system)
        if (c.quantity, c.form, c.way) == (quantity, subject.form.name, WAY)
    )
    assert not holds(subject, replace(claim, proved=0.9 * claim.proved))


@pytest.mark.slow
def test_a_claim_about_other_steps_or_functions_is_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    subject = next(compiled_subjects("track_wheel.rotation"))
    (claim,) = (c for c in claims("track_wheel") if (c.quantity, c.way) == ("rotation", WAY))
    assert subject.computed is not None
    for field in ("straight", "computed"):
        steps = getattr(subject, field)
        lost = replace(steps, steps=steps.steps[:-1])
        assert not holds(replace(subject, **{field: lost}), claim)
    changed = change("cos", lambda step: replace(step, kind="add") if step.kind == "fma" else step)
    monkeypatch.setattr(computed_stages, "build", lambda *_: changed)
    assert not holds(subject, claim)


def test_what_is_proved_of_a_function_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    """With less accurate functions a kernel's bound is higher, with exact ones lower."""
    subject = next(compiled_subjects("elliptic_planetary.position"))
    region = next(list_regions(subject.form.charts[0]))
    boxes = np.array([[(0.3, 0.31) if np.isfinite(side[1]) else side for side in region.box]])
    whole = subject.bound(region, boxes)
    for factor in (0.0, 2.0):

        def scaled(kind: str, factor: float = factor) -> ErrorTable:
            error_table = prove(kind)
            unreduced = None if error_table.unreduced is None else factor * error_table.unreduced
            return replace(error_table, highest=factor * error_table.highest, unreduced=unreduced)

        monkeypatch.setattr(computed_stages, "prove", scaled)
        assert np.sign(subject.bound(region, boxes) - whole) == np.sign(factor - 1)


@pytest.mark.parametrize("name", NAMES)
def test_without_roundings_compiled_steps_have_the_value_of_the_others(name: str) -> None:
    for subject in compiled_subjects(name):
        for points in draw_points(subject, 5, 4):
            for values in zip(*points.values(), strict=True):
                with working_precision(300):
                    given = dict(zip(points, map(arb, map(float, values)), strict=True))
                    pairs = zip(
                        run(subject.straight, given, IN_BALLS),
                        run(subject.exact, given, IN_BALLS),
                        strict=True,
                    )
                    assert all(abs(one - other) < arb(2) ** -150 for one, other in pairs)


def test_a_function_of_another_library_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """The error of NumPy's tangent says nothing about that of a compiled kernel."""
    paper = paper_of("tooth_thickness")
    (kernel,) = (k for k in list_functions(paper) if k.name == "thickness_change_linear")
    known = {kind: e for kind, e in list_expansions().items() if kind != "tan"}
    monkeypatch.setattr(kernel_stages, "list_expansions", lambda: known)
    with pytest.raises(ValueError, match="nothing is proved about compiled tan"):
        list(list_computed_stages(kernel, paper))
