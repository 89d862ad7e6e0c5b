"""Arithmetics: one `layout` of an expression, run in `balls`, `series` and `duals`; its `slopes`.

`intervals` are arrays of doubles, for many boxes at once. Imports SymPy and flint.
"""
