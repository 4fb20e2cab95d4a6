"""One collision for people: words, tables, pictures."""
