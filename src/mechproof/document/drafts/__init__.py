"""Drafts of the block of letters: what displays and sentences propose, for a person to confirm."""
