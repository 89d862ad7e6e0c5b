"""Comparison: in, boxed programs; out, what other programs bound their rounding errors by.

Each is run where it is installed, on the same steps with the same conventions; nothing of them is
called but their commands.
"""
