"""Elementary functions in plain arithmetic: in, a float format; out, programs.

`formats` has the parameters of each format, `fits` approximates on an interval and encloses the
error, and `function_programs` defines how each function is computed. Compiled backends print these
programs. `roundoff` proves error bounds for those that kernels with charts call.
"""
