"""Which module imports which: on loading, inside functions, and for type checkers only."""

from __future__ import annotations

import ast
from collections.abc import Container, Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import NamedTuple

import mechproof
from mechproof import derivations, kernels


class Kinds(NamedTuple):
    """The modules that a file imports on loading, inside functions, and for type checkers only."""

    loaded: frozenset[str]
    inside: frozenset[str]
    typed: frozenset[str]

    @property
    def run(self) -> frozenset[str]:
        """All modules imported when the program runs."""
        return self.loaded | self.inside


def split(tree: ast.Module) -> tuple[list[ast.AST], list[ast.AST], list[ast.AST]]:
    """Return the nodes run on loading, those inside functions, and those for type checkers."""
    loaded: list[ast.AST] = []
    inside: list[ast.AST] = []
    typed: list[ast.AST] = []
    open_nodes: list[ast.AST] = [tree]
    while open_nodes:
        node = open_nodes.pop()
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            inside += ast.walk(node)
        elif isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            open_nodes += node.orelse
            typed += [inner for statement in node.body for inner in ast.walk(statement)]
        else:
            loaded.append(node)
            open_nodes += ast.iter_child_nodes(node)
    return loaded, inside, typed


def read_arrows(name: str, source: str, is_package: bool, known: Container[str]) -> Kinds:
    """Return the modules among `known` that a module imports, other than itself."""
    above = name.split(".") if is_package else name.split(".")[:-1]
    kinds = (_find_modules(nodes, above, known) for nodes in split(ast.parse(source)))
    return Kinds(*(frozenset(found - {name}) for found in kinds))


def _find_modules(nodes: Iterable[ast.AST], above: list[str], known: Container[str]) -> set[str]:
    found: set[str] = set()
    for node in nodes:
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            start = above[: len(above) + 1 - node.level] if node.level else []
            base = ".".join([*start, *([node.module] if node.module else [])])
            inner = {f"{base}.{alias.name}" for alias in node.names}
            found |= {module if module in known else base for module in inner}
    return {module for module in found if module in known}


@cache
def read_graph() -> Mapping[str, Kinds]:
    """Return the imports of every module of the package, its kernels and its derivations."""
    homes = {"mechproof": mechproof, "mechproof.kernels": kernels}
    homes["mechproof.derivations"] = derivations
    files = {
        ".".join((package, *path.relative_to(folder).with_suffix("").parts)).removesuffix(
            ".__init__"
        ): path
        for package, module in homes.items()
        for folder in [Path(module.__path__[0])]
        for path in folder.rglob("*.py")
    }
    return {
        name: read_arrows(name, path.read_text(encoding="utf-8"), path.stem == "__init__", files)
        for name, path in files.items()
    }


def find_reached(graph: Mapping[str, Iterable[str]], *starts: str) -> set[str]:
    """Return the nodes that can be reached from `starts`, including these."""
    reached: set[str] = set()
    waiting = list(starts)
    while waiting:
        node = waiting.pop()
        if node not in reached:
            reached.add(node)
            waiting += graph[node]
    return reached


def circles(graph: Mapping[str, Iterable[str]]) -> set[str]:
    """Return the nodes that can be reached from themselves."""
    reached = {node: set(graph[node]) for node in graph}
    for middle in graph:
        for node in graph:
            if middle in reached[node]:
                reached[node] |= reached[middle]
    return {node for node in graph if node in reached[node]}
