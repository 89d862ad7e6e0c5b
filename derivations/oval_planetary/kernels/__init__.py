"""The quantities of paper 2."""

from . import jerk, motion

QUANTITIES = (*motion.QUANTITIES, *jerk.QUANTITIES)
