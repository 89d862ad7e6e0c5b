"""Tailored kernels: in, a quantity, its parameters and an error; out, the cheapest loop for them."""
