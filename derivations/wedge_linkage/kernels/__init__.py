"""The quantities of paper 4."""

from . import chain, inputs, motion, proofs, stages

QUANTITIES = (*stages.QUANTITIES, *motion.QUANTITIES)
VARIABLES = (*chain.VARIABLES, *inputs.VARIABLES, *proofs.VARIABLES)
