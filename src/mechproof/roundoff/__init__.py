"""Proved bounds of rounding errors: in, straight-line programs and boxes; out, certificates.

A stage of a kernel becomes `steps`, each with a rounding of its own; a chart's `regions` are boxes
of coordinates, which `arithmetic.cover` splits until `bound` is below the aim everywhere. Three
things are not in the tools that do the like. FPTaylor (Solovyev et al. 2018) bounds an absolute
error to the first order and the rest apart; here it is relative to a scale that may vanish with it
(`interval_monomials`), and no rest is left. Gappa (Daumas and Melquiond 2010) takes hints where
errors cancel; here low words are found and proved (`compensation`). Neither looks into the sine of
a library; compiled kernels bring their own, which is bounded as they are (`elementary_errors`,
`error_tables`). `worst` looks for the input that comes nearest to the bound.
"""
