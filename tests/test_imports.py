"""What an import loads, and which libraries and packages each package may use."""

from __future__ import annotations

import ast
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path

import pytest
from import_graph import split

import mechproof
from mechproof import derivations, kernels, mechanisms, record
from mechproof.tools.extras import suggest_install

HEAVY = frozenset({"sympy", "jinja2", "lark", "flint", "matplotlib", "numba", "scipy"})

PROBES = {
    "package": "mechproof.__version__",
    "kernel": "from mechproof.kernels import elliptic_planetary as k; k.position(1.0, 66, 16, 0.4)",
    "choose": "from mechproof import choose; choose('displacement', error=1e-3)",
    "EllipticPlanetary": "mechproof.EllipticPlanetary(66, 16, 0.4).ratio(1.0)",
    "carrier angle": "mechproof.EllipticPlanetary(66, 16, 0.4).carrier_angle([1.0, 2.0])",
    "thickness": "mechproof.ToothThickness.published().thickness_change(0.01)",
    "TrackWheel": "mechproof.TrackWheel(41.5, 3.75, 6, 20).planar_error(1.0)",
    "OvalPlanetary": "mechproof.OvalPlanetary.published(3).position(1.0)",
    "ToothThickness": "mechproof.ToothThickness.published().deepest",
    "WedgeLinkage": "mechproof.WedgeLinkage.published(1).position(-30.0)",
    "ThicknessInspection": "mechproof.ThicknessInspection",
    "conformity": "import mechproof.conformity",
    "tolerance": "from mechproof.tolerance import certified_range",
    "measurement": "import mechproof.measurement",
}

# The imports allowed to the files of a package: anywhere (`LOADED`), and additionally inside
# functions (`INSIDE`).
LOADED = {
    "kernel_support": {"numpy", "mechproof.arguments", "mechproof.kernel_support"},
    "compiled_support": {
        *("numpy", "numba", "llvmlite"),
        *("mechproof.compiled_support", "mechproof.tools.extras", "mechproof.kernel_support"),
        "mechproof.tools.processes",
    },
    "arguments": {"numpy", "mechproof.arguments"},
    "laws": {"numpy", "mechproof.arguments", "mechproof.laws"},
    "conformity": {
        *("numpy", "mechproof.arguments", "mechproof.conformity", "mechproof.executors"),
        "mechproof.laws",
    },
    "conformity.compiled": {
        *("numpy", "mechproof.compiled_support", "mechproof.conformity", "mechproof.executors"),
        *("mechproof.kernels", "mechproof.laws"),
    },
    "measurement": {
        *("numpy", "mechproof.arguments", "mechproof.kernel_support", "mechproof.measurement"),
        *("mechproof.kernels", "mechproof.derivatives", "mechproof.tools.extras"),
    },
    "tolerance": {
        *("numpy", "mechproof.arguments", "mechproof.executors", "mechproof.tools.extras"),
        *("mechproof.laws", "mechproof.tolerance"),
        *("mechproof.derivatives", "mechproof.measured"),
    },
    "mechanisms": {
        "numpy",
        "mechproof.arguments",
        "mechproof.conformity",
        "mechproof.kernel_support",
        "mechproof.kernels",
        "mechproof.laws",
        "mechproof.mechanisms",
        "mechproof.tools.extras",
        "mechproof.tools.notebook",
    },
    "record": {"sympy", "mechproof.tools.notebook", "mechproof.record"},
    "latex": {"sympy", "mechproof.latex", "mechproof.record"},
    "sources": {"mechproof.latex", "mechproof.sources"},
    "nomenclature": {
        *("sympy", "mechproof.latex", "mechproof.nomenclature", "mechproof.record"),
        "mechproof.sources",
    },
    "statement_domains": {
        "sympy",
        "mechproof.arithmetic",
        "mechproof.statement_domains",
        "mechproof.record",
    },
    "programs": {
        *("sympy", "mpmath", "flint"),
        *("mechproof.arithmetic", "mechproof.programs", "mechproof.record"),
    },
    "programs.plain": {"mechproof.kernel_support", "mechproof.programs"},
    "arithmetic": {"numpy", "sympy", "flint", "mechproof.arithmetic", "mechproof.record"},
    "proof": {
        *(
            "sympy",
            "flint",
            "mechproof.tools.notebook",
            "mechproof.arithmetic",
        ),
        *("mechproof.latex", "mechproof.proof", "mechproof.record"),
        *("mechproof.statement_domains", "mechproof.sources"),
    },
    "proof.newton": {
        *("numpy", "sympy", "flint", "mechproof.arithmetic", "mechproof.proof", "mechproof.record"),
        "mechproof.statement_domains",
    },
    "ledger": {
        *("sympy", "mechproof.tools.cache", "mechproof.tools.notebook", "mechproof.arithmetic"),
        *("mechproof.latex", "mechproof.statement_domains", "mechproof.ledger", "mechproof.proof"),
        *("mechproof.record", "mechproof.sources", "mechproof.tools.json_rows"),
    },
    "codegen": {
        *("sympy", "jinja2", "mechproof.codegen", "mechproof.programs", "mechproof.record"),
    },
    "roundoff": {
        *("numpy", "sympy", "flint"),
        *("mechproof.roundoff", "mechproof.programs", "mechproof.arithmetic", "mechproof.record"),
        *("mechproof.kernel_support", "mechproof.tools.cache", "mechproof.tools.json_rows"),
    },
    "tailoring": {
        *("numpy", "sympy", "flint", "mpmath", "mechproof.tailoring", "mechproof.arguments"),
        *("mechproof.executors", "mechproof.tools.extras"),
        *("mechproof.codegen", "mechproof.programs", "mechproof.arithmetic", "mechproof.proof"),
        *("mechproof.statement_domains", "mechproof.record", "mechproof.roundoff"),
        *("mechproof.tools.cache", "mechproof.tools.files"),
        *("mechproof.derivation", "mechproof.mechanisms"),
    },
    "exports": {
        *("numpy", "mechproof.exports", "mechproof.arguments", "mechproof.tools.files"),
        *("mechproof.tools.extras", "mechproof.mechanisms", "mechproof.plot"),
    },
    "lab": {
        *("numpy", "sympy", "flint", "matplotlib", "PIL"),
        *("mechproof.lab", "mechproof.codegen", "mechproof.programs", "mechproof.arithmetic"),
        *("mechproof.statement_domains", "mechproof.proof", "mechproof.record"),
        *("mechproof.kernel_support", "mechproof.derivation", "mechproof.measured"),
        *("mechproof.executors", "mechproof.tailoring", "mechproof.roundoff"),
    },
}
INSIDE = {
    # A linear program finds squares, whose sum is then checked exactly.
    "proof": {"scipy"},
    "laws": {"scipy"},
    "conformity": {"scipy"},
    "measurement": {"scipy", "uncertainties"},
    "tolerance": {
        *("sympy", "flint", "mechproof.derivation", "mechproof.arithmetic", "mechproof.proof"),
        *("mechproof.statement_domains", "mechproof.record"),
    },
    "mechanisms": {"scipy", "flint", "mechproof.executors", "mechproof.tolerance"},
    "codegen": {"ruff"},
    "exports": {"ezdxf", "matplotlib", "ncgears", "sympy"},
}


def loaded_after(code: str) -> set[str]:
    done = subprocess.run(
        [sys.executable, "-c", f"import mechproof\n{code}\nimport sys; print(*sys.modules)"],
        capture_output=True,
        text=True,
        check=True,
    )
    return {name.partition(".")[0] for name in done.stdout.split()}


@pytest.mark.parametrize("name", PROBES)
def test_runtime_loads_nothing_heavy(name: str) -> None:
    assert loaded_after(PROBES[name]).isdisjoint(HEAVY)


def test_every_mechanism_has_a_probe() -> None:
    pairs = {"OvalPair", "CylindricalPair"}
    assert set(mechanisms.__all__) - pairs <= set(PROBES)


def test_packages_are_reached_without_an_import_of_their_own() -> None:
    code = "assert mechproof.kernels.elliptic_planetary.position(0.0, 66, 16, 0.4) == 0.0"
    assert loaded_after(code).isdisjoint(HEAVY)
    for name in mechproof.PACKAGES:
        assert loaded_after(f"assert mechproof.{name}.__name__ == 'mechproof.{name}'")
        assert name in dir(mechproof)


def test_package_itself_loads_no_numpy() -> None:
    assert "numpy" not in loaded_after("")


def test_a_choice_loads_no_numpy() -> None:
    assert "numpy" not in loaded_after(PROBES["choose"])


def test_the_probe_sees_a_heavy_import() -> None:
    assert "sympy" in loaded_after("import mechproof.record")


def imported(nodes: Iterable[ast.AST]) -> set[str]:
    """Return the packages that the nodes import, without those of the standard library.

    Our own packages are given by their first two names, tools by three.
    """
    names: set[str] = set()
    for node in nodes:
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            module = f"{'.' * node.level}{node.module or ''}"
            inner = [f"{module}.{alias.name}" for alias in node.names]
            names |= set(inner) if module == "mechproof" else {module}
    parts = [name.split(".") for name in names]
    others = [part for part in parts if part[0] not in sys.stdlib_module_names]
    lengths = [3 if p[:2] == ["mechproof", "tools"] else 1 + (p[0] == "mechproof") for p in others]
    return {".".join(part[:length]) for part, length in zip(others, lengths, strict=True)}


def breaches(source: str, package: str) -> set[str]:
    """Return the imports of a file that `LOADED` and `INSIDE` do not allow to its package."""
    loaded, inside, _ = (imported(nodes) for nodes in split(ast.parse(source)))
    allowed = LOADED[package]
    return (loaded - allowed) | (inside - allowed - INSIDE.get(package, set()))


def layer_files() -> list[tuple[str, Path]]:
    root = Path(mechproof.__file__).parent
    found = ((package, path) for package in LOADED for path in (root / package).rglob("*.py"))
    apart = ((f"{package}.{path.stem}", package, path) for package, path in found)
    return [(file if file in LOADED else package, path) for file, package, path in apart]


@pytest.mark.parametrize(
    ("package", "path"), layer_files(), ids=lambda v: v.stem if isinstance(v, Path) else v
)
def test_packages_keep_to_their_layer(package: str, path: Path) -> None:
    assert breaches(path.read_text(encoding="utf-8"), package) == set()


@pytest.mark.parametrize(
    ("source", "package", "breach"),
    [
        ("import scipy.special", "conformity", "scipy"),
        ("if True:\n    from scipy import special", "conformity", "scipy"),
        ("class A:\n    import sympy", "mechanisms", "sympy"),
        ("def f():\n    import sympy", "mechanisms", "sympy"),
        ("def f():\n    from mechproof import proof", "mechanisms", "mechproof.proof"),
        ("from mechproof.record import Paper", "tolerance", "mechproof.record"),
        ("from mechproof.mechanisms import TrackWheel", "tolerance", "mechproof.mechanisms"),
        ("if TYPE_CHECKING:\n    pass\nelse:\n    import flint", "tolerance", "flint"),
    ],
)
def test_the_checker_sees_a_breach(source: str, package: str, breach: str) -> None:
    assert breaches(source, package) == {breach}


def test_the_checker_lets_pass_what_is_allowed() -> None:
    source = (
        "import math\nimport numpy\ndef f():\n    import scipy\nif TYPE_CHECKING:\n    import sympy"
    )
    assert breaches(source, "conformity") == set()


def test_derivations_import_sympy_the_records_and_the_readers_alone() -> None:
    for path in Path(derivations.__path__[0]).rglob("*.py"):
        if path.stem.strip("_") in ("peers", "points", "pictures"):
            continue
        tree = ast.parse(path.read_text(encoding="utf-8"))
        found = imported(ast.walk(tree)) - {""}  # relative imports have no first name
        readers = {"mechproof.document", "mechproof.latex"}
        assert found <= {"sympy", "mechproof.record", *readers}, path


# As imported from a file next to the mechanics, and from one in a room.
MECHANICS = (".mechanics", "..mechanics")


def list_stars(source: str) -> list[str]:
    """List the modules star-imported by a derivation, except its mechanics and the records."""
    found = (node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.ImportFrom))
    names = (f"{'.' * n.level}{n.module}" for n in found if n.names[0].name == "*")
    return [name for name in names if name not in (*MECHANICS, "mechproof.record")]


def list_words_taken(source: str) -> set[str]:
    """Return the public names of the records that a derivation rebinds."""
    nodes = list(ast.walk(ast.parse(source)))
    names = {n.id for n in nodes if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
    defined = {n.name for n in nodes if isinstance(n, ast.FunctionDef | ast.ClassDef)}
    return (names | defined) & set(record.__all__)


def test_derivations_import_all_of_their_mechanics_and_words_and_of_nothing_else() -> None:
    for path in Path(derivations.__path__[0]).rglob("*.py"):
        source = path.read_text(encoding="utf-8")
        assert list_stars(source) == [], path
        assert list_words_taken(source) == set(), path
    stars = ("..mechanics", "mechproof.record", "sympy", "..rows.peaks")
    found = list_stars("\n".join(f"from {module} import *" for module in stars))
    assert found == ["sympy", "..rows.peaks"]
    assert list_words_taken("Part, e = 1, 2\ndef less(): pass") == {"Part", "less"}


def test_kernels_import_numpy_and_their_support_alone() -> None:
    for path in Path(kernels.__path__[0]).rglob("*.py"):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        allowed = {"numpy", "mechproof.kernel_support"}
        if path.parent.name == "compiled":
            # The elementary functions are in a neighbouring package.
            allowed |= {"mechproof.compiled_support", "mechproof.kernels"}
        assert imported(ast.walk(tree)) <= allowed, path.name


def test_public_names() -> None:
    assert set(mechproof.__all__) <= set(dir(mechproof))
    assert mechproof.EllipticPlanetary.__module__ == "mechproof.mechanisms.elliptic_planetary"
    for package in (mechproof, mechanisms):
        with pytest.raises(AttributeError, match="no attribute 'Gearbox'"):
            _ = package.Gearbox


def test_compiled_kernels_say_what_they_need() -> None:
    code = """
import sys
sys.modules["numba"] = None
try:
    import mechproof.kernels.compiled.elliptic_planetary
except ImportError as error:
    print(error)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert suggest_install("fast") in done.stdout
