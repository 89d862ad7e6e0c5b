"""Search for all drives with a cylindrical and an oval pair that dwell: teeth, eccentricities."""
