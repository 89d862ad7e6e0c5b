"""What generated kernels call: arrays in blocks, error-free transformations, fast quotients, facts.

Plain code that generated modules and the runtime import; it imports NumPy alone.
"""
