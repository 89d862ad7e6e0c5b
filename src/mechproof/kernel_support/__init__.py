"""What generated kernels call: arrays in blocks, error-free transformations, fast quotients.

Plain code that generated modules import; it imports NumPy and nothing of the package.
"""
