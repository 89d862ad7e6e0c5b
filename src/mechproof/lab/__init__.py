"""The laboratory: how many digits, how fast, and where other ways of computing fail.

`subject` finds what is measured and `ways` every way of computing it; `sampling` makes the points
from the derivation; `oracle` knows the truth and counts what is lost, `worst_search` climbs to
the worst input, `timing` takes the time, `measure` puts it into a record (`mechproof.measured`),
which `record_tables`, `chart` and `overview` show: `chart_points` reads time and error from a
record, `panel` draws them, `labels` finds room for their names. `validation` runs emitted kernels
before they are written. It imports all of the package but the command line and the mechanisms.
"""
