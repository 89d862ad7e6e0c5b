"""A paper's own source, LaTeX or Markdown -> its equations as rows, and their judgements.

A block of comments declares the letters; nothing else is typed. What every equation does is found
by rule (`roles`), and a rule that is not sure of an accusation makes none.
"""
