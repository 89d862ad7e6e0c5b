"""FPCore: in, texts of FPBench's benchmarks; out, straight-line programs and the boxes they run on.

The language is FPCore 2.0 (Damouche et al. 2017), of which what is straight-line in doubles is
read: `+ - * / sqrt fma`, functions, `let` and `let*`. All else is refused by its name and line.
"""
