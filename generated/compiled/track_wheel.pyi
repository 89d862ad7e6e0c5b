"""Types of the kernels of `track_wheel`.

Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from ..track_wheel import *
