"""Who may import whom, in one sentence: each layer the ones below it, without import cycles.

tools < support < kernels < the runtime of numbers; paper < latex, arithmetic < sources, domains <
nomenclature, programs < proof, roundoff, emission < ledger < documents, Coq, FPCore, comparison <
loading < the runtime that proves < tailoring < laboratory, figures < report < pipeline < command
line.
"""

from __future__ import annotations

from collections.abc import Mapping

import pytest
from import_graph import Kinds, circles, read_arrows, read_graph

Room = tuple[str, ...]

# From the lowest layer upwards: its rooms, each with its modules and packages. The longest matching
# name decides the room of a module. The rooms of one layer do not import each other.
LAYERS: tuple[Mapping[str, Room], ...] = (
    {
        "tools": ("tools",),
        "arguments": ("arguments",),
    },
    {
        "support": ("kernel_support", "compiled_support"),
        "executors": ("executors",),
        "laws": ("laws",),
        "measured": ("measured", "measured_ranges"),
    },
    {"kernels": ("kernels",), "choice": ("choice",)},
    {"derivatives": ("derivatives",)},
    {"conformity": ("conformity",), "measurement": ("measurement",)},
    {"paper": ("record",)},
    {"latex": ("latex",), "arithmetic": ("arithmetic",)},
    {"sources": ("sources",), "statement_domains": ("statement_domains",)},
    {"nomenclature": ("nomenclature",), "programs": ("programs",)},
    {"proof": ("proof",), "roundoff": ("roundoff",), "emission": ("codegen",)},
    {"ledger": ("ledger",)},
    {
        "documents": ("document",),
        "Coq": ("coq",),
        "FPCore": ("fpcore",),
        "comparison": ("comparison",),
    },
    {"loading": ("derivation",)},
    {"tolerance": ("tolerance",)},
    {"mechanisms": ("mechanisms",)},
    {"tailoring": ("tailoring",)},
    {"laboratory": ("lab",), "figures": ("plot",)},
    {
        "report": ("report",),
        "exports": ("exports",),
        "derivations": ("derivations",),
        "improvement": ("improvement",),
    },
    {"pipeline": ("pipeline",)},
    {"command line": ("__main__", "cli")},
    {"the whole": ("__init__",)},
)
# The rooms that compute but do not prove: on loading, they import only each other.
RUNTIME = {
    *("tools", "arguments", "support", "executors", "laws", "measured", "kernels", "choice"),
    *("derivatives", "measurement", "conformity", "tolerance", "mechanisms", "the whole"),
}
# The rooms of a paper, lowest first; its other modules (paper, peers, points) may import them all.
ROOMS = ("mechanics", "rows", "kernels", "pictures")
HEIGHTS = {room: height for height, layer in enumerate(LAYERS) for room in layer}
HOMES = {name: room for layer in LAYERS for room in layer for name in layer[room]}


def find_room(module: str) -> str:
    """Return the room of a module, or "" if `LAYERS` has none for it."""
    name = module.removeprefix("mechproof.") if module != "mechproof" else "__init__"
    parts = name.split(".")
    names = (".".join(parts[:length]) for length in range(len(parts), 0, -1))
    return next((HOMES[name] for name in names if name in HOMES), "")


def find_breaches(graph: Mapping[str, Kinds]) -> set[tuple[str, str]]:
    """Return the imports that go up or sideways, including those in functions or for types only."""
    return {
        (module, other)
        for module, kinds in graph.items()
        for other in kinds.run | kinds.typed
        if find_room(other) != find_room(module)
        and HEIGHTS[find_room(other)] >= HEIGHTS[find_room(module)]
    }


def find_loaded_proofs(graph: Mapping[str, Kinds]) -> set[tuple[str, str]]:
    """Return the imports of proving rooms that happen as soon as a runtime module is loaded."""
    return {
        (module, other)
        for module, kinds in graph.items()
        for other in kinds.loaded
        if find_room(module) in RUNTIME and find_room(other) not in RUNTIME
    }


def find_height(module: str) -> int:
    """Return the index in `ROOMS` of a module of a paper, or -1 if it is in no room."""
    room = [*module.split("."), "", ""][3]
    return ROOMS.index(room) if room in ROOMS else -1


def find_later_rooms(graph: Mapping[str, Kinds]) -> set[tuple[str, str]]:
    """Return the imports from a room of a paper to a later one."""
    return {
        (module, other)
        for module, kinds in graph.items()
        for other in kinds.run | kinds.typed
        if module.startswith("mechproof.derivations.")
        and -1 < find_height(module) < find_height(other)
    }


def test_every_module_has_a_room_and_every_name_a_module() -> None:
    graph = read_graph()
    assert len(graph) > 400
    assert [module for module in graph if not find_room(module)] == []
    known = {module.removeprefix("mechproof.") for module in graph} | {"__init__"}
    assert [name for name in HOMES if name not in known] == []


def test_no_import_goes_up_or_aside() -> None:
    assert find_breaches(read_graph()) == set()


def test_no_import_leads_back() -> None:
    """There is no cycle among modules or packages, apart from imports for type checkers only."""
    graph = read_graph()
    assert circles({module: kinds.run for module, kinds in graph.items()}) == set()
    packages: dict[str, set[str]] = {}
    for module, kinds in graph.items():
        beside = {package_of(other) for other in kinds.run} - {package_of(module)}
        packages.setdefault(package_of(module), set()).update(beside)
    assert circles(packages) == set()


def package_of(module: str) -> str:
    return ".".join(module.split(".")[:2])


def test_the_runtime_reaches_for_proofs_inside_functions_alone() -> None:
    assert find_loaded_proofs(read_graph()) == set()


def made_up(module: str, source: str) -> Mapping[str, Kinds]:
    """Return the graph with `source` added to one module."""
    graph = dict(read_graph())
    found = read_arrows(module, source, False, graph)
    kinds = zip(graph[module], found, strict=True)
    return {**graph, module: Kinds(*(known | new for known, new in kinds))}


@pytest.mark.parametrize(
    ("module", "source", "other"),
    [
        ("record.papers", "import mechproof.proof.judge", "proof.judge"),
        ("record.papers", "from mechproof import latex", "latex"),
        ("arithmetic.balls", "def f():\n    from ..statement_domains.domain import Domain",
            "statement_domains.domain"),
        ("latex.tree", "if TYPE_CHECKING:\n    import mechproof.proof.verdict", "proof.verdict"),
        ("programs.argument_conditions", "from ..proof.signs import find_sign", "proof.signs"),
        ("roundoff.bound", "from mechproof.codegen import form_rows", "codegen.form_rows"),
        ("pipeline.verification", "def f():\n    import mechproof.cli.options", "cli.options"),
        ("lab.ways", "def f():\n    from mechproof import plot", "plot"),
    ],
)  # fmt: skip
def test_an_arrow_up_or_aside_is_seen(module: str, source: str, other: str) -> None:
    breaches = find_breaches(made_up(f"mechproof.{module}", source))
    assert breaches == {(f"mechproof.{module}", f"mechproof.{other}")}


def test_the_whole_package_is_the_highest() -> None:
    (breach,) = find_breaches(made_up("mechproof.cli.options", "from mechproof import choose"))
    assert breach == ("mechproof.cli.options", "mechproof")


def test_no_room_of_a_paper_knows_a_later_one() -> None:
    assert find_later_rooms(read_graph()) == set()


@pytest.mark.parametrize(
    ("module", "source", "other"),
    [
        ("rows.design", "from ..kernels import motion", "kernels.motion"),
        ("mechanics", "def f():\n    from .rows.peaks import PROPER", "rows.peaks"),
        ("kernels.motion", "from .. import pictures", "pictures"),
    ],
)
def test_an_arrow_to_a_later_room_is_seen(module: str, source: str, other: str) -> None:
    paper = "mechproof.derivations.elliptic_planetary"
    found = find_later_rooms(made_up(f"{paper}.{module}", source))
    assert (f"{paper}.{module}", f"{paper}.{other}") in found


def test_a_circle_is_seen() -> None:
    graph = made_up("mechproof.latex.numerals", "def f():\n    from .letters import read_letter")
    found = circles({module: kinds.run for module, kinds in graph.items()})
    assert {"mechproof.latex.letters", "mechproof.latex.numerals"} <= found
    assert find_breaches(graph) == set()
    typed = made_up("mechproof.latex.numerals", "if TYPE_CHECKING:\n    from . import letters")
    assert circles({module: kinds.run for module, kinds in typed.items()}) == set()
    assert circles({"a": ["b"], "b": ["c"], "c": ["b"], "d": ["a"]}) == {"b", "c"}


def test_a_proof_that_the_runtime_loads_is_seen() -> None:
    arrow = ("mechproof.tolerance.corners", "mechproof.arithmetic.balls")
    assert find_loaded_proofs(made_up(arrow[0], "from mechproof.arithmetic import balls")) == {
        arrow
    }
    lazy = made_up(arrow[0], "def f():\n    from mechproof.arithmetic import balls")
    assert find_loaded_proofs(lazy) == find_breaches(lazy) == set()


def test_a_module_without_a_room_is_seen() -> None:
    assert (find_room("mechproof.news"), find_room("mechproof.news.paper")) == ("", "")
    assert find_room("mechproof.proof.new_rung") == "proof"
