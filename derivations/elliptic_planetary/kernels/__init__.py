"""What can be computed of paper 1."""

from .design import DESIGN
from .motion import MOTION
from .peaks import PEAKS

QUANTITIES = (*MOTION, *PEAKS, *DESIGN)
