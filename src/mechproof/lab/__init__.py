"""The laboratory: how accurate and how fast kernels are, and where other ways of computing fail.

`subject` finds what is measured and `ways` every way of computing it; `sampling` makes the points
from the derivation; `oracle` computes true values and measures errors, `worst_search` climbs to
the worst input, `timing` takes times, and `measure` puts all this into a record
(`mechproof.measured`), which `record_tables` and `chart` show: `chart_points` reads time and error
from a record, and `labels` draws the panels and finds room for names. `validation` runs emitted
kernels before they are written. The laboratory imports all of the package except the command line
and the mechanisms.
"""
