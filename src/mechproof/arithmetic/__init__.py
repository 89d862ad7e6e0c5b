"""Arithmetics: one `layout` of an expression, run in `balls` and `series`; its `slopes` by duals.

`intervals` are arrays of doubles, for many boxes at once. Imports SymPy and flint.
"""
