"""The letters of a paper: what its block and words say of them, their units, shapes, symbols."""
