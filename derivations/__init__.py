"""Derivations: a file or a folder per system, found by looking into this folder.

They import SymPy and the records of `mechproof.record`; `peers` and `points` beside a paper, which
only the laboratory loads, also NumPy, SciPy and the package's own runtime.
"""
