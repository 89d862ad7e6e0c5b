"""Checks of arguments: an error reads "name = value: what is allowed".

`scalars` checks single numbers and counts and imports nothing, `array_checks` checks array-likes
and imports NumPy. Every package of the runtime may import them.
"""
