"""Drafts of the block of letters: proposals from displays and sentences, to be confirmed."""
