"""A user's own paper is one file: verdicts, kernels, measurements, charts and `choose`."""

from __future__ import annotations

import importlib.util
import json
import math
import pickle
import re
import shutil
import subprocess
import sys
from contextlib import chdir
from pathlib import Path
from types import ModuleType

import mpmath as mp
import numpy as np
import pytest
from command import run

from mechproof import choose, tailor

OWN = Path(__file__).parent / "own_paper" / "derivations"
EPS = float(np.finfo(float).eps)


def run_in(folder: Path, *arguments: str) -> None:
    """Run the command line with a folder as working directory; it must succeed."""
    with chdir(folder):
        done = run(*arguments)
    assert done.exit_code == 0, done.output


@pytest.fixture(scope="module")
def workshop(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the derivation, its kernels and a quick measurement."""
    folder = tmp_path_factory.mktemp("workshop")
    shutil.copytree(OWN, folder / "derivations")
    for command in (["regenerate"], ["measure", "--quick", "ratio"]):
        run_in(folder, *command)
    return folder


def load(file: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(file.stem, file)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.slow
@pytest.mark.xdist_group("workshop")
def test_the_misprint_is_found_standing_in_the_folder(workshop: Path) -> None:
    run_in(workshop, "verify", "--json", "rows.json")
    rows = json.loads((workshop / "rows.json").read_text())["rows"]
    verdicts = {row["number"]: row["verdict"] for row in rows}
    assert verdicts["(1)"] == verdicts["(3)"] == "PROVED"
    assert verdicts["(2)"] == "REFUTED"
    assert verdicts["kernel position"] == verdicts["kernel ratio"] == "PROVED"
    assert verdicts["kernel ratio_printed"] == "REFUTED"


@pytest.mark.slow
@pytest.mark.xdist_group("workshop")
def test_the_folder_is_as_regenerated_from_elsewhere(workshop: Path, tmp_path: Path) -> None:
    run_in(tmp_path, "regenerate", "--check", "--derivations", str(workshop / "derivations"))
    assert not list(tmp_path.iterdir())


@pytest.mark.slow
@pytest.mark.xdist_group("workshop")
def test_the_kernels_keep_their_digits(workshop: Path) -> None:
    kernels = load(workshop / "generated" / "universal_joint.py")
    rng = np.random.default_rng(5)
    with mp.workdps(60):
        for theta, beta in zip(rng.uniform(-500, 500, 60), rng.uniform(0, 1.57, 60), strict=True):
            t, b = mp.mpf(float(theta)), mp.mpf(float(beta))
            lead = mp.atan2(
                (1 - mp.cos(b)) * mp.sin(t) * mp.cos(t),
                mp.cos(b) * mp.cos(t) ** 2 + mp.sin(t) ** 2,
            )
            # The bound that the derivation states.
            error = abs(mp.mpf(float(kernels.position(theta, beta))) - (t + lead))
            assert error <= 8 * EPS * abs(t + lead)
            ratio = mp.cos(b) / (1 - mp.sin(b) ** 2 * mp.cos(t) ** 2)
            # Roundings of some ten operations; the argument is exact.
            assert abs(mp.mpf(float(kernels.ratio(theta, beta))) - ratio) <= 16 * EPS * ratio


@pytest.mark.slow
@pytest.mark.xdist_group("workshop")
def test_measured_quantities_are_offered_and_charted(workshop: Path) -> None:
    measured = workshop / "generated" / "measured" / "quick"
    choice = choose("universal_joint.ratio", error=1e-6, beta=(0, 0.5), measured=measured)
    assert choice.error <= 1e-6
    assert "misprinted" not in {choice.way, *(other.way for other in choice.others)}
    assert choose("ratio", error=1e-6, beta=(0, 0.5), measured=measured) == choice
    assert choice.quantity == "universal_joint.ratio"
    ways = {way.function for way in (choice, *choice.others)}
    assert "generated.universal_joint.ratio" in ways
    assert not any(way.startswith("mechproof.kernels") for way in ways)
    run_in(workshop, "chart", "--measured", str(measured), "--out", "charts")
    assert list((workshop / "charts").glob("universal_joint.ratio*.svg"))


@pytest.mark.slow
@pytest.mark.xdist_group("workshop")
def test_a_kernel_is_tailored_to_sizes_and_written_in_c(workshop: Path) -> None:
    place = workshop / "derivations"
    sizes = {"theta": (-4, 4), "beta": 0.5}
    kernel = tailor("universal_joint.ratio", error=1e-6, derivations=place, **sizes)
    again = pickle.loads(pickle.dumps(kernel))
    for theta in (-3.0, 0.0, 1.0, 4.0):
        right = mp.cos(0.5) / (1 - (mp.sin(0.5) * mp.cos(theta)) ** 2)
        assert abs(kernel(theta) - right) <= kernel.bound <= 1e-6
        assert again(theta) == kernel(theta)
    ask = ["emit", "c", "universal_joint.ratio", "--error", "1e-6", "--let", "beta=0.5"]
    ask += ["--let", "theta=0:6"]
    run_in(workshop, *ask, "--out", "c")
    assert (workshop / "c" / "universal_joint_tailored.h").is_file()


@pytest.mark.parametrize(
    ("folder", "told"),
    [("nowhere", "must be the path of a folder"), (OWN, "has no kernels of universal_joint")],
)
def test_without_a_derivation_or_its_kernels_nothing_is_tailored(
    folder: str | Path, told: str
) -> None:
    with pytest.raises(ValueError, match=f"derivations = .*{told}"):
        tailor("universal_joint.ratio", error=1e-6, derivations=folder, beta=0.5)


@pytest.mark.slow
@pytest.mark.xdist_group("workshop")
def test_the_report_shows_what_was_measured_and_how_the_kernel_is_called(workshop: Path) -> None:
    run_in(workshop, "report")
    page = workshop / "report" / "quantities" / "universal_joint.ratio.html"
    text = page.read_text(encoding="utf-8")
    assert "A quick measurement" in text
    assert re.search(r"; quickly measured 20\d\d-", text)
    assert "<svg" in text
    (call,) = re.findall(r"<code>(import numpy.*?ratio\(.*?\))</code>", text, re.DOTALL)[:1]
    code = f"theta = 1.0\n{call.replace('ratio(', 'print(ratio(', 1)})"
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=workshop, capture_output=True, text=True
    )
    ratio = math.cos(math.pi / 6) / (1 - (math.sin(math.pi / 6) * math.cos(1.0)) ** 2)
    assert float(done.stdout) == pytest.approx(ratio, rel=1e-14), done.stderr
