"""No kernel warns where NaN is its documented answer: outside the domain, and for NaN.

Every argument is pushed through numbers inside and outside its set, alone and in arrays, in one
piece and in blocks. Infinity is left out where all reals are allowed: there an infinite angle or
length warns, as NumPy's sine or difference of infinities does.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator

import numpy as np
import pytest
import sympy as sp
from quantities import KERNELS, find_subject

from mechproof.lab.sampling.point_sets import list_workloads
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Arguments

PUSHED = (np.nan, -np.inf, -1e9, -1.0, -1e-9, 0.0, 0.5, 1.0, 1.5, 20.0, 1e9, np.inf)


@pytest.fixture(params=["one piece", "blocks"])
def _evaluation(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    if request.param != "one piece":
        monkeypatch.setattr("mechproof.kernel_support.blocks.BLOCK", 6)


def list_pushed(subject: Subject, index: int) -> Iterator[float]:
    symbol = subject.quantity.arguments[index].symbols[0]
    everywhere = isinstance(symbol, sp.IndexedBase) or subject.domain.set_of(symbol) == sp.S.Reals
    yield from (value for value in PUSHED if not (everywhere and np.isinf(value)))


def push(subject: Subject, index: int, usual: Arguments) -> Iterator[Arguments]:
    """Yield calls with one argument, or one of its elements, replaced by each pushed number."""
    before, at, after = usual[:index], usual[index], usual[index + 1 :]
    for value in list_pushed(subject, index):
        yield *before, np.full(np.shape(at), value), *after
        if np.ndim(at):
            one = np.array(at, float)
            one.flat[0] = value
            yield *before, one, *after


def call_usually(subject: Subject) -> Iterator[Arguments]:
    for _, make in list_workloads(subject):
        many = make(8)
        yield many
        yield tuple(a[0] if np.ndim(a) and len(a) == 8 else a for a in many)


@pytest.mark.slow
@pytest.mark.usefixtures("_evaluation")
@pytest.mark.parametrize("name", KERNELS)
def test_no_warning_outside_the_domain(name: str) -> None:
    subject = find_subject(name)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for usual in call_usually(subject):
            for index in range(len(usual)):
                for arguments in push(subject, index, usual):
                    try:
                        subject.kernel(*arguments)
                    except RuntimeWarning as warning:
                        raise AssertionError(f"{name}{arguments}: {warning}") from warning


@pytest.mark.usefixtures("_evaluation")
@pytest.mark.parametrize("name", KERNELS)
def test_nan_in_gives_nan_out(name: str) -> None:
    """NaN appears in some entry, since entries of a turn depend on only some of its angles."""
    subject = find_subject(name)
    for usual in call_usually(subject):
        for index, argument in enumerate(usual):
            nothing = np.full(np.shape(argument), np.nan)
            result = subject.kernel(*usual[:index], nothing, *usual[index + 1 :])
            assert np.isnan(result).any(), subject.quantity.arguments[index].name
