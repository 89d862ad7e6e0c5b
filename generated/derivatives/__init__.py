"""Derivatives of the kernels: one module per system.

Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from mechproof.kernel_support.packages import find_modules

__getattr__ = find_modules(__name__)
