"""A player's swings for people: words, tables, pictures."""
