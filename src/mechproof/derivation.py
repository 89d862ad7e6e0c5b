"""The sources of papers: derivations of the package, of a folder, or a single one of a user.

A derivation is a file `<system>.py`, or a folder `<system>/` whose `__init__.py` binds the paper.
Names that begin with an underscore are shared by the papers of a folder and are no systems. Next to
a derivation are its chosen forms, `system.forms.json` or `forms.json` in the folder: quantity ->
names of rewrites that were found, with which its definition is computed. The form that it ships
otherwise is kept as a rival.
"""

from __future__ import annotations

import importlib
import importlib.util
import json
import os
import re
import sys
import traceback
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from hashlib import sha256
from importlib.abc import MetaPathFinder
from importlib.machinery import FileFinder, ModuleSpec, SourceFileLoader
from itertools import count
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any, Literal, NoReturn

from mechproof.arguments.scalars import require
from mechproof.latex import read_paper
from mechproof.measured import KERNELS
from mechproof.programs.rewrites import REWRITES
from mechproof.record import Form, Paper, Quantity
from mechproof.statement_domains.dimension_inference import check_derived
from mechproof.tools.files import import_file, write_whole
from mechproof.tools.processes import limit_time

Chosen = Mapping[str, tuple[str, ...]]
# The key of the form that the derivation itself ships.
STATED = "as_stated"
PACKAGE = "mechproof.derivations"
# Prefix of package names: each load of a folder from elsewhere gets a new one.
LOADED = "_mechproof_derivations_"
_numbers = count(1)
# Names of the modules last loaded, by the place of the paper, and the places by name.
_modules: dict[Path, str] = {}
_places: dict[str, Path] = {}


def find_file(place: Path) -> Path:
    """Return the file of chosen forms of a derivation."""
    place = place.parent if place.name == "__init__.py" else place
    return place / "forms.json" if place.is_dir() else place.with_suffix(".forms.json")


def read_chosen(place: Path) -> Chosen:
    """Return the chosen forms; raises ValueError, naming the file, if its content is invalid."""
    file = find_file(place)
    if not file.is_file():
        return {}
    try:
        kept = json.loads(file.read_text(encoding="utf-8"))
        chosen = {str(name): tuple(rewrites) for name, rewrites in kept.items()}
    except (ValueError, TypeError, AttributeError) as error:
        raise ValueError(f"{file}: {error}; must be {{quantity: [rewrites]}}") from error
    for name, rewrites in chosen.items():
        if unknown := [r for r in rewrites if r not in REWRITES]:
            raise ValueError(f"{file}: {name}: {unknown} are not among {sorted(REWRITES)}")
    return chosen


def add_chosen(place: Path, chosen: Chosen) -> Path:
    """Add to the chosen forms, and return the file."""
    file, known = find_file(place), read_chosen(place)
    write_whole(file, json.dumps({**known, **chosen}, indent=1, sort_keys=True) + "\n")
    return file


def choose_forms(paper: Paper, place: Path) -> Paper:
    """Return the paper with the chosen forms shipped; raises ValueError for an unknown quantity."""
    chosen = read_chosen(place)
    if unknown := sorted(chosen.keys() - {q.name for q in paper.quantities}):
        raise ValueError(f"{find_file(place)}: {paper.system} has no quantities {unknown}")
    if not chosen:
        return paper
    quantities = (_choose(q, chosen[q.name]) if q.name in chosen else q for q in paper.quantities)
    return replace(paper, quantities=tuple(quantities))


def describe(rewrites: tuple[str, ...]) -> str:
    """Name a form by its rewrites."""
    return ", ".join(name.replace("_", " ") for name in rewrites) or "as defined"


def rewrite_definition(quantity: Quantity, rewrites: tuple[str, ...]) -> Form:
    """Return the form of the definition with rewrites."""
    return Form(describe(rewrites), quantity.definition, rewrites)


def _choose(quantity: Quantity, rewrites: tuple[str, ...]) -> Quantity:
    stated = (replace(form, key=STATED, charts=()) for form in quantity.shipped)
    others = (form for form in quantity.rivals if form.key != STATED)
    return replace(quantity, forms=(rewrite_definition(quantity, rewrites), *stated, *others))


class DerivationError(RuntimeError):
    """A derivation could not be loaded, or does not bind a `Paper` to the name PAPER."""


class _SourceLoader(SourceFileLoader):
    """Reads the source each time: bytecode would miss an edit within the same second."""

    def get_code(self, fullname: str) -> CodeType:
        path = self.get_filename(fullname)
        return self.source_to_code(self.get_data(path), path)


class _FolderFinder(MetaPathFinder):
    """Finds the modules of folders loaded under a name of their own."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        if not fullname.startswith(LOADED) or path is None:
            return None
        if fullname in _places:
            return _specify(fullname, _places[fullname])
        return FileFinder(next(iter(path)), (_SourceLoader, [".py"])).find_spec(fullname)


def _specify(name: str, place: Path) -> ModuleSpec | None:
    """Return the import spec of a file of any name, or of a folder."""
    file = place / "__init__.py" if place.is_dir() else place
    inside = [str(place)] if place.is_dir() else None
    return importlib.util.spec_from_file_location(
        name, file, loader=_SourceLoader(name, str(file)), submodule_search_locations=inside
    )


sys.meta_path.insert(0, _FolderFinder())


def packaged_directory() -> Path:
    """Return the folder of the derivations that come with the package."""
    spec = importlib.util.find_spec(PACKAGE)
    if spec is None or not spec.submodule_search_locations:
        raise DerivationError(f"the package {PACKAGE} is not installed")
    return Path(next(iter(spec.submodule_search_locations)))


def find_systems(directory: Path) -> dict[str, Path]:
    """Return system -> place (a file or a folder) of a folder's derivations, in order.

    Raises `DerivationError` for a system that exists twice, as a file and as a folder.
    """
    files = [path for path in directory.glob("[!_.]*.py") if path.is_file()]
    folders = [path.parent for path in directory.glob("[!_.]*/__init__.py")]
    if twice := sorted({path.stem for path in files} & {path.name for path in folders}):
        raise DerivationError(f"{directory}: both a file and a folder of {', '.join(twice)}")
    systems = {path.stem: path for path in files} | {path.name: path for path in folders}
    return dict(sorted(systems.items()))


def load_paper(location: Path) -> Paper:
    """Run a derivation, a file or a folder, and return its paper with its prints read.

    It is read anew each time, with its relative imports: its folder serves as a package (whose own
    `__init__.py` is only run for the derivations that come with mechproof). Raises
    `DerivationError`, which names the file and the line at fault.
    """
    place = _to_place(location)
    if not place.exists():
        raise DerivationError(f"{location}: does not exist")
    return _run(place)


def load_packaged(system: str) -> Paper:
    """Return the paper of a system of the package, imported once, without reading its prints."""
    paper: Paper = importlib.import_module(f"{PACKAGE}.{system}").PAPER
    return paper


def _run(place: Path) -> Paper:
    name = _name_module(place)
    _modules[place] = name
    module = _import(name, place)
    paper = getattr(module, "PAPER", None)
    if not isinstance(paper, Paper):
        raise DerivationError(
            f"{module.__file__}: must bind a mechproof.record.Paper to the name PAPER"
        )
    try:
        check_derived(paper)
        return choose_forms(read_paper(paper), place)
    except ValueError as error:
        raise DerivationError(f"{module.__file__}: {error}") from error


def load_part(location: Path, part: Literal["peers", "points", "pictures"]) -> ModuleType | None:
    """Import an optional module of a derivation that is a folder; None if there is none.

    It shares the modules of the paper that was last loaded from there. Raises `DerivationError` as
    `load_paper` does.
    """
    place = _to_place(location)
    if not (place / f"{part}.py").is_file():
        return None
    if place not in _modules:
        load_paper(place)
    return _import(f"{_modules[place]}.{part}", place)


def load_kernels(name: str, generated: Path | None) -> ModuleType | None:
    """Import a generated module, of the package or of a folder; None if there is none.

    The name of a module must find its file, as compiled code is cached next to it. A file with the
    same text as the package's module is that module, unless that was loaded before, perhaps from an
    older text.
    """
    full = f"{KERNELS}.{name}"
    packaged = importlib.util.find_spec(full)
    if generated is None:
        return importlib.import_module(full) if packaged is not None else None
    file = generated.joinpath(*name.split(".")).with_suffix(".py")
    if not file.is_file():
        return None
    known = Path(packaged.origin) if packaged and packaged.origin else None
    if known and file.samefile(known):
        return importlib.import_module(full)
    if known and full not in sys.modules and file.read_bytes() == known.read_bytes():
        return importlib.import_module(full)
    own = f"_mechproof_kernels_{sha256(str(file.resolve()).encode()).hexdigest()[:16]}"
    return import_file(own, file)


def check_folder(derivations: Any) -> Path:
    """Return the given folder of derivations; raises TypeError or ValueError if it is none."""
    allowed = "must be the path of a folder of derivations"
    is_path = isinstance(derivations, str | os.PathLike)
    require(is_path, "derivations", derivations, allowed, TypeError)
    require(Path(derivations).is_dir(), "derivations", derivations, allowed)
    return Path(derivations).resolve()


def check_names(places: dict[str, Path], system: str, place: Path) -> None:
    """Enter a paper into name -> place; raises `DerivationError` if another paper has its name."""
    other = places.setdefault(system, place)
    if other != place:
        raise DerivationError(
            f"{place}: its paper has the same name as that of {other}, {system!r}"
        )


def _to_place(location: Path) -> Path:
    place = location.resolve()
    return place.parent if place.name == "__init__.py" else place


def _name_module(place: Path) -> str:
    """Name the module of a place in a package from which nothing old is loaded."""
    if place.parent == packaged_directory().resolve():
        name = f"{PACKAGE}.{place.stem}"
        _forget(name, f"{PACKAGE}._")
        importlib.invalidate_caches()
        return name
    if place in _modules:
        _forget(_modules[place].partition(".")[0])
    package = ModuleType(f"{LOADED}{next(_numbers)}")
    package.__path__ = [str(place.parent)]
    sys.modules[package.__name__] = package
    name = f"{package.__name__}.{re.sub(r'[^0-9A-Za-z_]', '_', place.stem)}"
    _places[name] = place
    return name


def _forget(name: str, *shared: str) -> None:
    for module in [m for m in sys.modules if m == name or m.startswith((f"{name}.", *shared))]:
        del sys.modules[module]


@contextmanager
def stop_after(seconds: float, location: Path) -> Iterator[None]:
    """Stop the block after some seconds with a `DerivationError` that names the derivation."""
    try:
        with limit_time(seconds):
            yield
    except TimeoutError:
        raise DerivationError(f"{location}: did not load within {seconds:g} s") from None


@contextmanager
def _refuse_exit() -> Iterator[None]:
    """Turn an exit, which would end the process with a plausible status, into an error."""
    end = os._exit

    def refuse(status: int) -> NoReturn:
        raise SystemExit(f"os._exit({status})")

    os._exit = refuse
    try:
        yield
    finally:
        os._exit = end


def _import(name: str, place: Path) -> ModuleType:
    try:
        with _refuse_exit():
            return importlib.import_module(name)
    except (Exception, SystemExit) as error:
        where = _find_fault(error, place)
        raise DerivationError(f"{where}: {type(error).__name__}: {_describe(error)}") from error


def _describe(error: BaseException) -> str:
    return error.msg if isinstance(error, SyntaxError) else str(error)


def _find_fault(error: BaseException, place: Path) -> str:
    """Return file:line of the innermost line of the derivation, or of its folder, at fault."""
    if isinstance(error, SyntaxError) and error.filename and Path(error.filename).is_file():
        return f"{error.filename}:{error.lineno}"
    frames = traceback.extract_tb(error.__traceback__)
    own = [frame for frame in frames if _is_own(Path(frame.filename), place)]
    return f"{own[-1].filename}:{own[-1].lineno}" if own else str(place)


def _is_own(file: Path, place: Path) -> bool:
    """Return whether a file is in the folder of a derivation, or shared next to it."""
    folders = file.resolve().parents
    return file.is_file() and (folders[0] == place.parent or place in folders)
