"""The quantities of paper 5."""

from . import design, poses, sums, track

QUANTITIES = (*poses.QUANTITIES, *track.QUANTITIES, *sums.QUANTITIES, *design.QUANTITIES)
