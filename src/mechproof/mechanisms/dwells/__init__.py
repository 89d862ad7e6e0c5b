"""Every drive of a cylindrical and an oval pair that dwells, by whole teeth and eccentricities."""
