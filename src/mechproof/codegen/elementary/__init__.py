"""Elementary functions in plain arithmetic: in, a float format; out, programs and their bounds.

`fits` approximates on an interval and encloses what that is off by, `trace` turns Python's
arithmetic into programs, `reduction`, `functions` and `rests` say how each function is computed.
Compiled backends print these programs, and `roundoff` proves what they are off by.
"""
