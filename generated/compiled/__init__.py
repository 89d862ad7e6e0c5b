"""Compiled kernels: one module per system.

Regenerate with `mechproof regenerate`; edits are overwritten.
"""
