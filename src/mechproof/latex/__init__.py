"""LaTeX as papers print it -> SymPy, guided by the symbols that a paper declares.

Nothing is guessed: a print that could be read in two ways raises a `ReadingError` that gives the
place and the ways to declare which is meant. Imports only SymPy and the records.
"""

from mechproof.latex.errors import ReadingError
from mechproof.latex.expansion import read_paper
from mechproof.latex.reader import Reader

__all__ = ["Reader", "ReadingError", "read_paper"]
