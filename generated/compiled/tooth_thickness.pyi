"""Types of the kernels of `tooth_thickness`.

Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from ..tooth_thickness import *
