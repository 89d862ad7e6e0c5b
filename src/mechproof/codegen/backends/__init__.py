"""Backends: in, a paper; out, source in one language. Templates only have the layout."""
