"""A play from pitch to fence for people: words, tables, pictures."""
