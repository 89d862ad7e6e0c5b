"""The quantities of paper 3."""

from . import chords

QUANTITIES = chords.QUANTITIES
