"""Sampling: from the facts that a derivation states of its arguments to points chosen to hurt."""
