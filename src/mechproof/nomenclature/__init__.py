"""The letters of a paper: what its block and text say of them, their units, shapes and symbols."""
