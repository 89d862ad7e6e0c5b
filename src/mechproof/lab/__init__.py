"""The laboratory: how many digits, how fast, and where other ways of computing fail.

`subject` finds what is measured and `ways` every way of computing it; `facts`, `singular_points`
and `sizes` make the points of `sets` from the derivation; `oracle` knows the truth, `error` counts
what is lost, `search` climbs to the worst input, `timing` takes the time, `measure` puts it into a
record (`mechproof.measured`), which `table` and `chart` show. `validation` runs emitted kernels
before they are written. It imports all of the package but the command line and the mechanisms.
"""
