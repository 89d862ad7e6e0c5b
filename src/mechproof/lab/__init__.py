"""The laboratory: how many digits, how fast, and where other ways of computing fail.

`subject` finds what is measured, `points` says where, `oracle` knows the truth, `error` counts
what is lost, `search` climbs to the worst input, `timing` takes the time, `measure` writes the
results down and `chart` draws them.
"""
