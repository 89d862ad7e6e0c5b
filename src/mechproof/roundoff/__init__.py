"""Proved bounds of rounding errors: in, straight-line programs and boxes; out, certificates.

A stage of a kernel becomes `steps`, each with its own rounding; a chart's `regions` are boxes of
coordinates, which `arithmetic.cover` splits until `bound` is below the target everywhere. Three
things set this apart from similar tools. FPTaylor (Solovyev et al. 2018) bounds the first order of
an absolute error and its remainder separately; here the error is relative to a scale that may
vanish along with it (`interval_monomials`), and there is no remainder. Gappa (Daumas and Melquiond
2010) takes hints where errors cancel; here low words are found and proved (`compensation`). Neither
looks inside a library's sine; compiled kernels bring their own, whose error is bounded by the same
means (`elementary_errors`, `error_tables`). `worst` searches for the input nearest to the bound.
"""
