"""A season's table: every ball in play, where on which bat it was hit, and what another bat would have done."""
