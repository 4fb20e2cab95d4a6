"""A bat's report for people: words, tables, pictures."""
