"""What can be computed of paper 4."""

from . import chain, conditioning, motion, proofs, stages

QUANTITIES = (*stages.QUANTITIES, *motion.QUANTITIES)
VARIABLES = (*chain.VARIABLES, *conditioning.VARIABLES, *proofs.VARIABLES)
