"""Sampling: in, what a derivation states of its arguments; out, points chosen to hurt."""
