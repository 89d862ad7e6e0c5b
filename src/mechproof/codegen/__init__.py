"""From programs to kernel source, in one direction; imports Jinja2 and what makes programs.

`mechproof.programs` -> `syntax` (text in one of the `languages`) -> `backends` (template and
formatter) -> `regenerate` (files). And back: `source_reading` (what the emitted text does to values
that record it) -> `kernel_reading` and `compiled_reading` (what it is meant to do) -> `form_rows`
(rows of the ledger, of the mathematics that is raised from the programs).

Form compilers (FFC: Kirby and Logg 2006) turn mathematics into loops in this way. What differs is
the way back: no text is believed to say what was meant until it has been read.
"""
