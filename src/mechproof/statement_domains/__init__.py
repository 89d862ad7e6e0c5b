"""Where statements are meant to hold: sets of letters and relations, exact points, dimensions."""
