"""A paper's own source, LaTeX or Markdown -> its equations as rows, and their judgements.

A comment block declares the letters; nothing else is typed. The role of each equation is found by
rule (`printed_signs`), and a rule that is not sure of an accusation makes none.
"""
