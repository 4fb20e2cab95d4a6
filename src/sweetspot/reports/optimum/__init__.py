"""Best swings and launches for people: words, tables, pictures."""
