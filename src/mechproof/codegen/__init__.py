"""From programs to kernel source, in one direction; imports Jinja2 and `mechproof.programs`.

`mechproof.programs` -> `syntax` (text in one of the `languages`) -> `backends` (template and
formatter) -> `regenerate` (files). And back: `source_reading` (the operations that the emitted text
performs on recording values) -> `kernel_reading` and `compiled_reading` (the operations it is meant
to perform) -> `form_rows` (rows of the ledger, from the mathematics raised from the programs).

Form compilers (FFC: Kirby and Logg 2006) turn mathematics into loops in the same way. The
difference is the way back: no text is trusted to be as meant until it has been read.
"""
