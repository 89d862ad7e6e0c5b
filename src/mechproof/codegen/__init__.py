"""From programs to kernel source, in one direction; imports Jinja2 and what makes programs.

`mechproof.programs` -> `syntax` (text in one of the `languages`) -> `backends` (template and
formatter) -> `regenerate` (files). And back: `reading` (the emitted text as a program) -> `forms`
(rows of the ledger, of the mathematics that is raised from it).
"""
