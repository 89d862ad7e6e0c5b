"""Support for generated kernels: arrays in blocks, domains, functions, error-free transformations.

Plain code that generated modules and the runtime import, and the order of doubles, which the
laboratory shares with the mechanisms; it imports only NumPy.
"""
