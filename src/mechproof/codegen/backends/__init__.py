"""Backends: in, a paper; out, source in one language. Templates hold layout only."""
