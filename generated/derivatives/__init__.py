"""Derivatives of the kernels: one module per system.

Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""
