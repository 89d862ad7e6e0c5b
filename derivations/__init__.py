"""Derivations: a file or a folder per system; this folder is searched for them.

They import only SymPy and the records of `mechproof.record`; the modules `peers` and `points` next
to a paper, which only the laboratory loads, also import NumPy, SciPy and the package's own runtime.
"""
