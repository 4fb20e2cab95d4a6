"""A season for people: the files, the league, the players, and warnings."""
