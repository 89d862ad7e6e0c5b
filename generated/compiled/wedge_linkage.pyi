"""Types of the kernels of `wedge_linkage`.

Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from ..wedge_linkage import *
