"""The command line: bad usage, help, instructive errors, missing packages."""

from __future__ import annotations

import importlib.metadata
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from command import PROVED, hear_hangups, in_process, run, write
from weights import first_of

from mechproof.__main__ import EXTRA
from mechproof.tools.extras import suggest_install


@pytest.mark.parametrize(
    "arguments",
    [
        ["verify", "no_such_system"],
        ["verify", "missing.py"],
        ["verify", "elliptic_planetary", "--json", "no/such/folder/rows.json"],
        ["verify", "elliptic_planetary", "--json", "."],
        ["verify", "--no-such-option"],
        ["verify", "--derivations", "no/such/folder"],
        ["verify", "--derivations", "derivations", "--root", "."],
        ["regenerate", "--root", "no/such/folder"],
        ["regenerate", "--derivations", "no/such/folder"],
        ["measure", "--root", "no/such/folder"],
    ],
)
def test_bad_usage_is_2(arguments: list[str]) -> None:
    assert run(*arguments).exit_code == 2


def test_the_rule_stands_in_the_help() -> None:
    for arguments in (["--help"], ["verify", "--help"], ["regenerate", "--help"]):
        assert "else from the package" in " ".join(run(*arguments).output.split())


@pytest.mark.slow
def test_the_module_runs_and_tells_its_version() -> None:
    done = in_process("--version")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"mechproof {importlib.metadata.version('mechproof')}\n"


def test_a_plain_install_is_told_what_it_lacks(tmp_path: Path) -> None:
    """A finder that refuses to find packages stands in for their absence."""
    code = (
        "import sys, runpy, importlib.machinery as m; find = m.PathFinder.find_spec\n"
        "gone = ('sympy', 'typer', 'rich')\n"
        "m.PathFinder.find_spec = classmethod(lambda cls, name, *rest: None if "
        "name.partition('.')[0] in gone else find(name, *rest))\n"
        "sys.argv = ['mechproof', 'verify']; runpy.run_module('mechproof', run_name='__main__')"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == (
        f"mechproof needs rich, sympy, typer, the extra derive: {suggest_install('derive')}\n"
    )


def test_the_check_names_what_the_extra_installs() -> None:
    homes = importlib.metadata.packages_distributions()
    required = {
        re.match(r"[\w.-]+", requirement)[0]  # type: ignore[index]
        for requirement in importlib.metadata.requires("mechproof") or ()
        if re.search(r"extra == .derive.", requirement)
    }
    assert {homes[name][0].lower() for name in EXTRA} == required


@pytest.mark.parametrize("derivations", [None, (), ("mine.py",)])
def test_without_a_command_it_says_what_can_be_done_here(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, derivations: tuple[str, ...] | None
) -> None:
    if derivations is not None:
        (tmp_path / "derivations").mkdir()
        for _ in derivations:
            write(tmp_path / "derivations", PROVED)
    monkeypatch.chdir(tmp_path)
    result = run()
    assert result.exit_code == 0
    assert ("elliptic_planetary" in result.output) == (derivations is None)
    assert ("mechproof verify mine" in result.output) == bool(derivations)
    assert ("regenerate" in result.output) == (derivations is not None)
    for line in re.findall(r"^  mechproof (\S+)", result.output, re.MULTILINE):
        assert run(line, "--help").exit_code == 0


def test_a_parameter_given_twice_is_named(tmp_path: Path) -> None:
    sizes = ("--let", "e=0.475", "--let", "R1=66", "--let", "R2=16", "--let", "e=0.3")
    tailored = ("emit", "c", "elliptic_planetary.position", "--error", "1e-6")
    result = run(*tailored, *sizes, "--out", str(tmp_path))
    assert result.exit_code == 2
    assert "--let e: given twice" in result.output
    assert not any(tmp_path.iterdir())


def test_a_single_quantity_is_told_to_need_an_error(tmp_path: Path) -> None:
    result = run("emit", "c", "elliptic_planetary.position", "--out", str(tmp_path))
    assert result.exit_code == 2
    assert "a single quantity needs --error, and --let" in result.output


@pytest.mark.thorough
def test_a_second_tailored_kernel_does_not_replace_the_first(tmp_path: Path) -> None:
    sizes = ("--let", "R1=66", "--let", "R2=16", "--let", "e=0.475", "--out", str(tmp_path))
    first = ("emit", "c", "elliptic_planetary.position", "--error", "1e-3", *sizes)
    second = ("emit", "c", "elliptic_planetary.ratio", "--error", "1e-2", *sizes)
    assert run(*first).exit_code == 0
    written = {file.name: file.read_bytes() for file in tmp_path.iterdir()}
    refused = run(*second)
    assert refused.exit_code == 2
    assert "exists with other content; give the new" in " ".join(refused.output.split())
    assert {file.name: file.read_bytes() for file in tmp_path.iterdir()} == written
    assert run(*first).exit_code == 0
    assert run(*second, "--name", "drive_ratio").exit_code == 0
    assert {"drive_ratio.h", "drive_ratio.c"} < {file.name for file in tmp_path.iterdir()}
    assert "--name = 'int': must be a valid C identifier" in run(*second, "--name", "int").output
    whole = run("emit", "c", "elliptic_planetary", "--name", "drive", "--out", str(tmp_path))
    assert whole.exit_code == 2
    assert "--name needs --error" in whole.output


@pytest.mark.slow
@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
@pytest.mark.parametrize(
    ("streams", "said"),
    first_of(
        [
            (">/dev/full", "mechproof: [Errno 28] No space left on device\n"),
            (">&-", "mechproof: stdout is closed\n"),
            (">&- 2>&-", ""),
            (">/dev/full 2>/dev/full", ""),
            ("2>/dev/full >/dev/null", ""),
        ]
    ),
)
@pytest.mark.parametrize("arguments", ["check x=x", "--help"])
def test_what_cannot_be_said_is_a_sentence_and_status_1(
    arguments: str, streams: str, said: str
) -> None:
    command = f"{sys.executable} -m mechproof {arguments} {streams}"
    done = subprocess.run(command, shell=True, capture_output=True, text=True)
    quiet = arguments == "--help" and streams.startswith("2>")
    assert done.returncode == (0 if quiet else 1)
    assert done.stderr.removeprefix("judging the equation\n") == said


@pytest.mark.slow
def test_a_reader_that_has_enough_is_no_error() -> None:
    command = f"{sys.executable} -m mechproof --help | head -c 1"
    done = subprocess.run(command, shell=True, capture_output=True, text=True)
    assert done.stderr == ""


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
@pytest.mark.parametrize("ending", [signal.SIGTERM, signal.SIGHUP])
def test_what_is_asked_to_end_tidies_up(tmp_path: Path, ending: signal.Signals) -> None:
    code = (
        "import sys, time, mechproof.__main__ as m\n"
        "from pathlib import Path\n"
        "from mechproof.tools import made\n"
        "def run():\n"
        "    with made._stage(Path(sys.argv[1])):\n"
        "        print('ready', flush=True)\n"
        "        time.sleep(60)\n"
        "m._run = run\n"
        "m.main()\n"
    )
    command = [sys.executable, "-c", code, str(tmp_path)]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, text=True, preexec_fn=hear_hangups
    ) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "ready\n"
        assert list(tmp_path.iterdir())
        process.send_signal(ending)
        assert process.wait(30) == 128 + ending
    assert list(tmp_path.iterdir()) == []
