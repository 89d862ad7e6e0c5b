"""A paper's own files -> its text, displays, lines and tables, and what words say of displays."""
