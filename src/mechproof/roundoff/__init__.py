"""Proved bounds of rounding errors: in, straight-line programs and boxes; out, certificates."""
