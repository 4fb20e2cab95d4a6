"""Sports other than baseball for people: words, tables, pictures."""
