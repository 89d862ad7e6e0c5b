"""The quantities of paper 1."""

from . import design, motion, peaks

QUANTITIES = (*motion.QUANTITIES, *peaks.QUANTITIES, *design.QUANTITIES)
