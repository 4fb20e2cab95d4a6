"""A season told: what was read, the league, the players, and what to beware of."""
