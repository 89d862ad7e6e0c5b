"""Elementary functions in plain arithmetic: in, a float format; out, programs.

`formats` has what depends on the format, `fits` approximates on an interval and encloses what that
is off by, and `function_programs` says how each function is computed. Compiled backends print these
programs. Of those that kernels with charts call, `roundoff` proves what they are off by.
"""
