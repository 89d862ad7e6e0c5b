"""Tools: files, caches, processes, and installed packages; they know no formulas."""
