"""From programs to kernel source, in one direction; imports Jinja2 and what makes programs.

`mechproof.programs` -> `syntax` (text in one of the `languages`) -> `backends` (template and
formatter) -> `regenerate` (files). And back: `reading` (what the emitted text does to values
that record it) -> `kernel_reading` and `compiled_reading` (what it is meant to do) -> `forms` (rows
of the ledger, of the mathematics that is raised from the programs).
"""
