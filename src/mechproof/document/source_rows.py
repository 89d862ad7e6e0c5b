"""Equations of a source -> rows to be judged, each with its role; unread ones with the reason."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TypeVar

import sympy as sp

from mechproof.document import mentions
from mechproof.document.checked_rows import UNFORESEEN
from mechproof.document.double_signs import (
    find_double_signs,
    find_following,
    find_imaginary_unit,
    is_complex,
)
from mechproof.document.example_values import SaidCases, collect_values, lend_values
from mechproof.document.known import CHAIN_RULE, Known, Later, define_later, find_later
from mechproof.document.law_pieces import LawPiece
from mechproof.document.numbers.calculated_sizes import calculate_sizes
from mechproof.document.numbers.letter_sizes import RestatedSizes, collect_sizes
from mechproof.document.numbers.size_tables import SizeTables
from mechproof.document.numbers.stated_numbers import StatedNumbers
from mechproof.document.printed_signs import find_roles, give_values
from mechproof.document.special_cases import make_seams
from mechproof.document.task_maker import TaskMaker
from mechproof.document.tasks import Sign, Task
from mechproof.latex import Reader, ReadingError
from mechproof.latex.errors import TOO_DEEP
from mechproof.latex.latex_signs import DOUBLE
from mechproof.latex.tree import Measure, walk
from mechproof.nomenclature import shown_letters
from mechproof.nomenclature.block import Declared, read_block
from mechproof.nomenclature.declarations import add_shown, declare
from mechproof.nomenclature.defined_functions import find_defined
from mechproof.nomenclature.inline import find_inline
from mechproof.nomenclature.possible_matrices import find_possible_matrices, list_units
from mechproof.nomenclature.said import find_pi, find_said
from mechproof.nomenclature.shapes import find_sizes
from mechproof.nomenclature.symbol_names import add_pairs, leave_pairs
from mechproof.nomenclature.symbols import add_chained_rates, add_scopes, give_chained_rates
from mechproof.proof.verdict import Left, State
from mechproof.record import Paper
from mechproof.record.estimates import without_estimates
from mechproof.sources.displays import Printed, find_displays, join_thousands, mark_decimals
from mechproof.sources.located_text import Place
from mechproof.sources.paper_files import Source
from mechproof.sources.tabulars import find_tabulars
from mechproof.tools.processes import limit_time

T = TypeVar("T")
_ZERO = re.compile(r"(.*?)\s*=\s*0")
_NUMBER = re.compile(r"\b(?:number|scalar|magnitude|modulus)", re.IGNORECASE)
_MEMBER = ", a member of a family: declare it as a separate letter"
_NO_RELATION = "it has no relation sign"
UNFIT = "numbers and matrices do not fit together here, or values of letters cannot be substituted"
# Raised by SymPy when values are put in that do not fit.
_UNFIT = (TypeError, ValueError, AttributeError, NotImplementedError)


class Document:
    """The equations of a paper and the declarations of its block."""

    def __init__(self, source: Source) -> None:
        """Read the block; raises `BlockError`, or `ValueError` for letters that conflict."""
        source = replace(source, text=join_thousands(mark_decimals(source.text)))
        self.source, self.files = source, source.files
        # A paper is named after its file, in letters, digits and underscores.
        name = re.sub(r"\W", "_", Path(source.files.names[0]).stem).strip("_")
        self.system = name if name.isidentifier() else f"paper_{name}"
        self.printed = list(find_displays(source.text))
        self.tables = list(find_tabulars(source.text))
        self.told: list[tuple[Place, str]] = []
        self.pi = find_pi(dict(find_said(source)))
        self.block = read_block(source.lines, source.files)
        groups = 2 + max((one.group for one in self.printed), default=0)
        for number, latex in enumerate(self.block.claims, 1):
            self.printed.append(Printed(f"claim {number}", latex, group=groups + number))
        self.limit = 0.0
        self.has_units = False
        self.papers: dict[bool, Paper] = {}
        self.taken: tuple[str, ...] = ()
        self._uncollected: Mapping[str, ReadingError] = {}
        if not source.has_block:
            self._take_letters()
        self.chained = add_chained_rates(self.block)
        self.pairs = add_pairs(self.block, (one.latex.string for one in self.printed))
        mentions.refuse_unknown(self.block, self.printed)
        self._declare({}, {})

    def _take_letters(self) -> None:
        """Take undeclared letters as numbers, or as matrices if they are printed as such.

        The size of a vector may also follow from how it is used.
        """
        prints = [p.latex.string for p in self.printed]
        self.block.imaginary = find_imaginary_unit(prints)
        collected = shown_letters.collect_letters(prints, imaginary=self.block.imaginary)
        self._uncollected = collected.unread
        letters = shown_letters.drop_transposition([*collected.letters, *collected.guessed], prints)
        letters = leave_pairs(letters, prints)
        shapes = dict(shown_letters.find_shapes(prints))
        if vectors := {shown_letters.name_symbol(x) for x in letters if shown_letters.is_vector(x)}:
            sizes = find_sizes(prints, collected, has_plain_matrices=False).known
            shapes = {name: sizes[name] for name in vectors & sizes.keys()} | shapes
        self.taken = tuple(
            x
            for x in letters
            if not shown_letters.is_vector(x) or shown_letters.name_symbol(x) in shapes
        )
        called: dict[str, str] = {}
        for letter, by in find_defined(prints):
            called.setdefault(shown_letters.name_symbol(letter), by)
        for names in shown_letters.group_alike(self.taken):
            by = called.get(shown_letters.name_symbol(names[0]), "")
            whole = f"{names[0]}({by})" if by else names[0]
            shape = shapes.get(shown_letters.name_symbol(whole))
            self.block.letters.append(_take(names, shape, by))

    def _declare(self, laws: Mapping[sp.Basic, list[LawPiece]], later: Later) -> None:
        declared = add_shown(declare(self.block), [one.latex.string for one in self.printed])
        self.symbols = add_scopes(declared, self.block, self.printed)
        self.known = Known(self.symbols)
        for text in (*self.block.values, *list_units(self.block)):
            with self.block.blame(text):
                give_values(text, self.known)
        self.block.refuse_faults()
        for rate, value in give_chained_rates(self.chained, self.symbols):
            if rate not in self.known.values:
                self.known.define(rate, value, CHAIN_RULE)
        define_later(later, self.known)
        self.known.define_laws(laws)

    def _parse_all(self) -> list[list[Sign] | Left]:
        """Read all equations until the letters are settled, and return their signs.

        They are read again if letters turn out to be matrices, if laws have pieces, or if a matrix
        is made of others that are printed after it.
        """
        laws: dict[sp.Basic, list[LawPiece]] = {}
        later: Later = {}
        while True:
            reader = self.symbols.reader()
            read = [self._parse(printed, reader) for printed in self.printed]
            sizes = {
                shown_letters.name_symbol(str(s)): shape for s, shape in self.known.sizes.items()
            }
            if self.taken and sizes:
                self.block.letters = [
                    replace(x, shape=sizes.get(shown_letters.name_symbol(x.names[0]), x.shape))
                    for x in self.block.letters
                ]
                self._declare(laws, later)
                continue
            if not laws and (laws := self.known.join_pieces()):
                self._declare(laws, later)
                continue
            if len(found := find_later(self.known)) > len(later):
                later = found
                self._declare(laws, later)
                continue
            symbols, entries = self.symbols.show_entries(self.known.values)
            if not entries or self.known.entries:
                return read
            self._declare(laws, later)
            self.symbols = self.known.symbols = symbols
            self.known.entries = entries

    def find_sizes(self, limit: float) -> dict[str, tuple[int, int]]:
        """Return the sizes of letters that are printed as matrices, by symbol name."""
        self.limit = limit
        self._parse_all()
        return {
            shown_letters.name_symbol(x.names[0]): x.shape for x in self.block.letters if x.shape
        }

    def find_possible_matrices(self) -> dict[sp.Basic, str]:
        """Return letters taken as numbers but printed the way matrices are, with that print.

        They include letters that the block declares in bold without a size, unless it calls them
        numbers.
        """
        prints = [one.latex.string for one in self.printed]
        names = self.symbols.names
        found = dict(find_possible_matrices(self.taken, prints)) if self.taken else {}
        found |= {
            shown_letters.name_symbol(name): name
            for one in self.block.letters
            for name in one.names
            if not (one.shape or _NUMBER.search(one.meaning)) and shown_letters.is_vector(name)
        }
        found = {x: shown for x, shown in found.items() if x in names}
        return {names[x]: shown for x, shown in found.items() if names[x].is_Symbol}

    @without_estimates()
    def read(self, limit: float) -> list[Task | Left]:
        """Read all equations in order: first their definitions, then their claims.

        An equation that takes longer than `limit` seconds is left unjudged.
        """
        self.limit = limit
        read = self._parse_all()
        if self.has_units:
            self.symbols = self.known.symbols = self.symbols.with_units()
        values = self.known.values = {**self.known.values, **self.known.entries}
        real = {symbol: v for symbol, v in values.items() if not is_complex(self.known.settle(v))}
        self.papers = {
            with_units: self.symbols.paper(self.system, real, with_units=with_units)
            for with_units in (True, False)
        }
        again = self.symbols.reader({**self.known.tied, **values})
        tables = SizeTables(self.known, self.files, self.papers[False])
        compared = list(tables.read(self.tables))
        start = Place(self.files.names[0], 1, 1)
        faults = [(place or start, reason) for place, reason in self.symbols.faults]
        characters = mentions.describe_characters(self.printed, self.files)
        self.told = [*faults, *tables.told, *characters]
        unread = [one.printed_latex for one in read if isinstance(one, Left)]
        self.known.unread = "\n".join([*unread, *self.block.where, *self.block.values])
        inline = [*find_inline(self.source, self.symbols.prints)]
        restated = RestatedSizes(self.source, inline, self.symbols)
        sizes = collect_sizes(zip(self.printed, read, strict=True), self.known, restated)
        examples = collect_values(inline, self.printed, self.known)
        numbers = StatedNumbers(self.known, sizes, examples)
        known, papers = self.known, self.papers
        said = examples, SaidCases(self.source, inline, self.printed, self.known)
        maker = TaskMaker(self.printed, self.block, known, papers, self.files, numbers, *said)
        rows: list[Task | Left] = []
        for printed, signs in zip(self.printed, read, strict=True):
            if isinstance(signs, Left):
                rows.append(signs)
                continue
            made = self._guard(printed, partial(maker.make, printed, signs, again))
            rows += [made] if isinstance(made, Left) else made
        seams = make_seams(self.printed, self.known, self.papers, self.files)
        return [*rows, *seams, *compared]

    def _parse(self, printed: Printed, reader: Reader) -> list[Sign] | Left:
        if printed.fault:
            return self._leave(printed, State.NOT_READ, printed.fault)
        if reason := mentions.look_up(printed, self.block.skipped):
            return self._leave(printed, State.SKIPPED, reason)
        if mentions.says_constant(printed.latex.string):
            return self._leave(printed, State.NOT_JUDGED, "it only says that something is constant")
        if not mentions.may_relate(printed.latex.string):
            return self._leave(printed, State.NOT_JUDGED, _NO_RELATION)
        return self._guard(printed, lambda: self._find_roles(printed, reader))

    def _find_roles(self, printed: Printed, reader: Reader) -> list[Sign] | Left:
        self.known.said = printed.announced
        with lend_values(self.known, printed.name) as signs:
            found = self._find_signs(printed, reader)
            signs += [] if isinstance(found, Left) else found
        return found

    def _find_signs(self, printed: Printed, reader: Reader) -> list[Sign] | Left:
        latex, branch = printed.latex.string, reader.notation.branch
        held = [s for s in self._list_zeros_after(printed) if s in self.known.constrained]
        self.known.held[printed.name] = held
        read = reader.parse(latex, printed.name, int(branch is None))
        read = calculate_sizes(read, self.symbols.bare)
        self.has_units |= any(isinstance(n, Measure) and n.factor != 1 for n in walk(read.chains))
        if not any(chain.relations for chain in read.chains):
            return self._leave(printed, State.NOT_JUDGED, _NO_RELATION)
        mentions.refuse_units(read)
        if letter := mentions.find_assignment(read):
            reason = f"an assignment: as an equation it would say nothing about {letter}"
            return self._leave(printed, State.NOT_JUDGED, reason)
        mentions.refuse_units_in_italics(read)
        mentions.refuse_powers_of_zero(read)
        mentions.refuse_numbers_of_equations(read, self.printed)
        mentions.refuse_differentials(read, self.printed)
        mentions.refuse_pi(read, self.pi)
        if branch is None and DOUBLE.search(latex):
            return find_double_signs(printed, read, reader, self.known, self.pairs)
        if mentions.is_listed(printed, [*self.block.follows]):
            return find_following(printed.name, read, self.known)
        return find_roles(printed.name, read, self.known)

    def _list_zeros_after(self, printed: Printed) -> Iterator[sp.Basic]:
        """Yield the letters that are said to be zero after an equation on its line."""
        names = self.symbols.names
        line = printed.locate(self.files).line
        for one in self.printed[self.printed.index(printed) + 1 :]:
            said = _ZERO.fullmatch(one.latex.string)
            if one.group != printed.group or one.locate(self.files).line != line:
                return
            if said and (letter := names.get(shown_letters.name_symbol(said[1]))):
                yield letter

    def _guard(self, printed: Printed, act: Callable[[], T]) -> T | Left:
        """Call `act` for an equation; if it fails, return the equation as left, with the reason."""
        try:
            with limit_time(self.limit):
                return act()
        except ReadingError as error:
            # If letters could not be collected here, the missing declarations are not the reason.
            return self._refuse(printed, self._uncollected.get(printed.latex.string, error))
        except RecursionError:
            return self._leave(printed, State.NOT_READ, TOO_DEEP)
        except TimeoutError as error:
            return self._leave(printed, State.NOT_JUDGED, str(error))
        except _UNFIT as error:
            _, told, reason = str(error).partition(f"row {printed.name!r}: ")
            # The rest of the message tells authors of modules what to declare.
            known = reason.partition(":")[0] if reason.startswith("nothing is known") else reason
            known += _MEMBER if known != reason and known.endswith("]") else ""
            return self._leave(printed, State.NOT_JUDGED, known if told else UNFIT)
        except Exception as error:
            # No single equation may end the run.
            told = f"{UNFORESEEN} ({type(error).__name__})"
            return self._leave(printed, State.NOT_JUDGED, told)

    def _leave(self, printed: Printed, state: State, reason: str) -> Left:
        latex = printed.latex.string
        return Left(printed.name, printed.locate(self.files), latex, state, reason)

    def _refuse(self, printed: Printed, error: ReadingError) -> Left:
        place = printed.locate(self.files, error.place)
        latex, reason = printed.latex.string, error.args[0]
        return Left(printed.name, place, latex, State.NOT_READ, reason, error.remedy)


def _take(names: tuple[str, ...], shape: tuple[int, int] | None, by: str) -> Declared:
    """Declare a letter under all its names; a matrix, or one of several arguments, by its print."""
    if by and (shape or "," in by):
        return Declared((f"{names[0]}({by})", *names), shape=shape)
    return Declared(names, shape=shape, running=by)
