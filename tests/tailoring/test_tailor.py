"""`mechproof.tailor` returns a function that behaves like a kernel, in NumPy, numba and C."""

from __future__ import annotations

import copy
import ctypes
import importlib.util
import multiprocessing
import pickle
import shutil
import subprocess
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from codegen.c_libraries import STRICT
from typer.testing import CliRunner
from weights import first_of

import mechproof
from mechproof.cli.commands import app
from mechproof.kernels import elliptic_planetary
from mechproof.tailoring import tailored as kernels
from mechproof.tailoring.build import build
from mechproof.tailoring.request import read_request
from mechproof.tailoring.tailored import NUMBA, NUMPY, Tailored, make_kernel
from mechproof.tools import extras
from mechproof.tools.cache import VARIABLE

NAME = "elliptic_planetary.position"
SIZES = {"R1": 66, "R2": 16, "e": 0.475}
COMPILER = shutil.which("cc")
BACKENDS = [
    pytest.param(NUMBA, marks=pytest.mark.skipif(not importlib.util.find_spec("numba"), reason="")),
    NUMPY,
]


@cache
def tailored(backend: str) -> Tailored:
    request = read_request(NAME, 1e-6, SIZES)
    return make_kernel(request, build(request), backend)


def points() -> Any:
    rng = np.random.default_rng(20240711)
    kernel = tailored(NUMPY)
    near = np.linspace(-3, 3, 4001)
    edges = np.outer([-1, 1], kernel.edges).ravel()
    beside = [np.nextafter(edges, -np.inf), edges, np.nextafter(edges, np.inf)]
    far = rng.uniform(kernel.low, kernel.high, 4000)
    ends = [kernel.low, kernel.high, 0.0, -0.0, 5e-324, np.nan, np.inf, 2 * kernel.high]
    return np.concatenate([near, *beside, far, ends])


@pytest.mark.slow
@pytest.mark.parametrize("backend", BACKENDS)
def test_it_is_called_like_a_kernel(backend: str) -> None:
    kernel = tailored(backend)
    carrier = np.array([[0.5, 5.0], [50.0, np.nan]])
    right = elliptic_planetary.position(carrier, *SIZES.values())
    found = kernel(carrier)
    assert np.allclose(found, right, rtol=0, atol=kernel.bound, equal_nan=True)
    out = np.empty_like(carrier)
    assert kernel(carrier, out=out) is out
    assert np.array_equal(out, found, equal_nan=True)
    matrix = np.empty_like(carrier).view(np.matrix)
    assert kernel(carrier, out=matrix) is matrix
    assert np.array_equal(matrix, found, equal_nan=True)
    assert kernel(carrier, out=carrier) is carrier
    assert np.array_equal(carrier, found, equal_nan=True)
    value = kernel(5.0)
    assert isinstance(value, np.float64)
    assert value == found[0, 1]
    assert kernel(np.float32(5)).dtype == np.float32
    assert kernel([]).shape == (0,)
    with pytest.raises(ValueError, match="out"):
        kernel(carrier, out=np.empty(3))
    with pytest.raises(TypeError):
        kernel(1j)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("backend", BACKENDS)
def test_beyond_its_range_it_is_nan(backend: str) -> None:
    kernel = tailored(backend)
    beyond = [np.nextafter(kernel.high, np.inf), np.nextafter(kernel.low, -np.inf)]
    assert np.isnan(kernel([*beyond, np.inf, -np.inf, np.nan, 1.7e308])).all()
    assert np.isfinite(kernel([kernel.low, kernel.high])).all()


def test_it_shows_its_bound_and_its_degrees() -> None:
    kernel = tailored(NUMPY)
    text = repr(kernel)
    assert "elliptic_planetary.position(phi1; R1=66.0, R2=16.0, e=0.475)" in text
    assert "degrees 15, 15" in text
    assert "rad for -8388608 <= phi1 <= 8388608" in text
    shown = float(text.partition("<= ")[2].partition(" ")[0])
    assert kernel.bound <= shown <= 1.01 * kernel.bound
    assert kernel.bound <= kernel.asked == 1e-6


@pytest.mark.parametrize("number", [3.1415e-7, 1e-9, 9.999e-4, 9.9999e-4, 2.0])
def test_a_shown_bound_is_not_rounded_down(number: float) -> None:
    assert number <= float(kernels.round_up(number)) <= 1.011 * number


def test_numba_and_numpy_agree_within_their_bounds() -> None:
    pytest.importorskip("numba")
    apart = tailored(NUMBA)(points()) - tailored(NUMPY)(points())
    # Both use the same polynomials: only roundings differ, by a few ulps of 4e7 at the ends.
    assert np.nanmax(np.abs(apart)) <= 8 * 2.0**-53 * 4.3e7


def test_it_is_called_in_compiled_functions() -> None:
    numba = pytest.importorskip("numba")
    function = tailored(NUMBA).function

    @numba.njit
    def total(values: Any) -> float:
        result = 0.0
        for value in values:
            result += function(value)
        return result

    carrier = np.linspace(0, 9, 10)
    assert total(carrier) == pytest.approx(tailored(NUMBA)(carrier).sum(), rel=1e-15)


def test_loops_ask_for_the_widest_vectors() -> None:
    numba = pytest.importorskip("numba")
    from mechproof.compiled_support import widen

    @numba.njit
    def double(values: Any) -> None:
        widen()
        for i in range(values.size):
            values[i] *= 2.0

    double(np.ones(3))
    (text,) = double.inspect_llvm().values()
    assert '"prefer-vector-width"="512"' in text


@pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
@pytest.mark.parametrize("name", ["drive", "point", "prepare"])
def test_c_has_the_bits_of_numba(name: str, tmp_path: Path) -> None:
    pytest.importorskip("numba")
    kernel = tailored(NUMBA)
    header, source = kernel.write_c(tmp_path, name=name)
    assert "3.1" in header.read_text()
    library = tmp_path / f"{name}.so"
    assert COMPILER is not None
    command = [COMPILER, *STRICT, "-shared", "-fPIC", str(source), "-o", str(library), "-lm"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    function = getattr(ctypes.CDLL(str(library)), f"{name}_position_array")
    pointer = ctypes.POINTER(ctypes.c_double)
    function.argtypes = [ctypes.c_size_t, pointer, pointer]
    carrier = points()
    found = np.empty_like(carrier)
    function(carrier.size, carrier.ctypes.data_as(pointer), found.ctypes.data_as(pointer))
    assert np.array_equal(found, kernel(carrier), equal_nan=True)


@pytest.mark.parametrize(
    ("name", "message"),
    [
        *(
            (name, f"name = {name!r}: must be a valid C identifier")
            for name in ("1st", "double", "a b", "größe", "_math", "")
        ),
        ("math", "math: C has a header math.h"),
        ("Features", "Features: C has a header features.h"),
        ("mp", "mp: mp_ is the prefix of helper functions"),
        ("mp_point", "mp_point: mp_ is the prefix of helper functions"),
        ("a" * 64, f"name = '{'a' * 64}': must have at most 63 characters"),
        (5, "name = 5: must be a string"),
        (b"x", "name = b'x': must be a string"),
    ],
)
def test_a_name_that_c_does_not_have_is_refused(name: Any, message: str, tmp_path: Path) -> None:
    kind = ValueError if isinstance(name, str) else TypeError
    with pytest.raises(kind, match=message):
        tailored(NUMPY).write_c(tmp_path, name=name)
    assert not list(tmp_path.iterdir())


@pytest.mark.slow
def test_the_command_emits_it(tmp_path: Path) -> None:
    sizes = [f"--let={name}={value}" for name, value in SIZES.items()]
    arguments = ["emit", "c", NAME, "--error", "1e-6", *sizes, "--out", str(tmp_path)]
    done = CliRunner().invoke(app, [*arguments, "--let=phi1=-10:10"])
    assert done.exit_code == 0, done.output
    text = (tmp_path / "elliptic_planetary_tailored.h").read_text()
    assert "-10 <= phi1 <= 10" in text
    assert "double elliptic_planetary_tailored_position(double phi1);" in text


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((NAME, "--error", "1e-6", "--let", "R1=x"), "--let R1=x: must be NAME=VALUE"),
        ((NAME, "--error", "1e-6", "--let", "R1=66"), "R2 = None: must be given"),
        ((NAME, "--let", "R1=66"), "--let needs --error"),
        (("--error", "1e-6"), "one SYSTEM.QUANTITY"),
        ((NAME, "--error", "1e-6", "--float32"), "--float32 and --derivatives exclude"),
        (("track_wheel", "--derivatives", "--float32"), "exclude each other"),
    ],
)
def test_the_command_refuses(arguments: tuple[str, ...], message: str) -> None:
    done = CliRunner().invoke(app, ["emit", "c", *arguments])
    assert done.exit_code == 2
    assert message in done.output


@pytest.mark.parametrize(
    ("name", "changed", "kind", "message"),
    [
        (3, {}, TypeError, "name = 3: must be a string"),
        ("no.position", {}, ValueError, r"name = 'no.position': the system must be one of .*oval"),
        (f"{NAME}s", {}, ValueError, r"the quantity of elliptic_planetary must be one of ratio,"),
        ("track_wheel.rotation", {}, ValueError, "the quantity of track_wheel must be"),
        (NAME, {"error": 0}, ValueError, r"error = 0.0: must be positive"),
        (NAME, {"error": np.nan}, ValueError, "error = nan: must be finite"),
        (NAME, {"error": "small"}, TypeError, "error = 'small': must be a real number"),
        (NAME, {"e": 1}, ValueError, "e = 1.0: must satisfy 0 <= e < 1"),
        (NAME, {"e": [0.1, 0.2]}, TypeError, r"e = \[0.1, 0.2\]: must be a real number"),
        (NAME, {"f": 1}, ValueError, "f = 1: .* has no such argument: phi1, R1, R2, e"),
        (NAME, {"phi1": 3}, TypeError, "phi1 = 3: must be a pair"),
        (NAME, {"phi1": (3, 3)}, ValueError, r"phi1 = \(3, 3\): the lowest must be below"),
        (NAME, {"phi1": (0, 1e9)}, ValueError, r"must lie within 8388608 periods, 1.27\d*e\+07"),
    ],
)
def test_bad_arguments_are_refused(
    name: Any, changed: dict[str, Any], kind: type[Exception], message: str
) -> None:
    with pytest.raises(kind, match=message):
        mechproof.tailor(name, **{"error": 1e-6, **SIZES, **changed})


def test_missing_arguments_are_named() -> None:
    with pytest.raises(ValueError, match="e = None: must be given"):
        mechproof.tailor(NAME, error=1e-6, R1=66, R2=16)
    sizes = {"l_AB": 6, "l_BC": 49, "l_CD": 38}
    with pytest.raises(ValueError, match="x1 = None: the range must be given"):
        mechproof.tailor("wedge_linkage.lever_angle", error=1e-6, **sizes)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("ends", "least"),
    first_of([((-1000, 3000), 1e-12), (None, 1e-15)]),
)
def test_an_error_below_the_roundings_tells_the_smallest(
    ends: tuple[float, float] | None, least: float
) -> None:
    arguments = {**SIZES, **({} if ends is None else {"phi1": ends})}
    with pytest.raises(ValueError, match="must be at least") as refused:
        mechproof.tailor(NAME, error=1e-16, **arguments)
    told = float(str(refused.value).partition("at least ")[2].partition(":")[0])
    assert least < told < 10 * least
    request = read_request(NAME, told, arguments)
    assert build(request).bound.error <= told


@pytest.mark.parametrize("backend", BACKENDS)
def test_pickled_it_has_the_same_bits(backend: str, tmp_path: Path) -> None:
    kernel = tailored(backend)
    written = pickle.dumps(kernel)
    again = pickle.loads(written)
    assert pickle.loads(written) is again
    assert (again, hash(again)) == (kernel, hash(kernel))
    assert repr(again) == repr(kernel)
    assert [f.read_text() for f in again.write_c(tmp_path / "again")] == [
        f.read_text() for f in kernel.write_c(tmp_path / "first")
    ]
    assert copy.deepcopy(kernel) == kernel
    with pytest.raises(TypeError, match="does not support item assignment"):
        again.parameters["e"] = 0.1  # type: ignore[index]


@pytest.mark.thorough
def test_a_new_process_computes_the_same_bits() -> None:
    backends = (NUMBA, NUMPY) if importlib.util.find_spec("numba") else (NUMPY,)
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as executor:
        for kernel in map(tailored, backends):
            found = executor.submit(kernel, points()).result(timeout=60)
            assert np.array_equal(found.view(np.int64), kernel(points()).view(np.int64))


def test_a_range_of_its_own_is_sent() -> None:
    arguments = {"x1": (-40, -36), "l_AB": 6, "l_BC": 49, "l_CD": 38}
    request = read_request("wedge_linkage.lever_angle", 1e-3, arguments)
    assert pickle.loads(pickle.dumps(request)) == request


@pytest.mark.parametrize(
    ("backend", "module", "message"),
    [
        (NUMPY, "sympy", "a tailored kernel needs sympy, the extra derive"),
        pytest.param(
            NUMBA, "numba", "for numba needs numba, the extra fast", marks=BACKENDS[0].marks
        ),
    ],
)
def test_what_is_missing_where_it_arrives_is_named(
    backend: str, module: str, message: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    written = pickle.dumps(tailored(backend))
    monkeypatch.setattr(extras, "find_spec", lambda name: None if name == module else name)
    with pytest.raises(ImportError, match=message):
        pickle.loads(written)


def test_without_the_extra_it_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(extras, "find_spec", lambda name: None if name == "flint" else name)
    with pytest.raises(ImportError, match=r"needs flint, the extra derive"):
        mechproof.tailor(NAME, error=1e-6, **SIZES)


def test_without_numba_it_is_numpy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kernels, "find_spec", lambda name: None)
    assert mechproof.tailor(NAME, error=1e-3, **SIZES).backend == NUMPY


def test_a_folder_that_cannot_be_written_is_no_hindrance(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv(VARIABLE, str(tmp_path / "file"))
    request = read_request(NAME, 2e-3, SIZES)
    kernel = make_kernel(request, build(request), NUMPY)
    assert kernel(0.5) == pytest.approx(elliptic_planetary.position(0.5, *SIZES.values()), abs=2e-3)
