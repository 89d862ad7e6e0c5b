"""Search for all drives of a cylindrical and an oval pair that dwell, by teeth and eccentricity."""
