"""Tools: files, caches, processes, and what is installed; they know no formulas."""
