"""LaTeX as papers print it -> SymPy, driven by the symbols that a paper declares.

Nothing is guessed: a print that could be read in two ways is a `ReadingError` with its place and
the ways to declare it. Imports SymPy and the records alone.
"""

from mechproof.latex.errors import ReadingError
from mechproof.latex.expansion import read_paper
from mechproof.latex.reader import Reader

__all__ = ["Reader", "ReadingError", "read_paper"]
