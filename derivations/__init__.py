"""Derivations: one module per system, found by looking into this folder."""
