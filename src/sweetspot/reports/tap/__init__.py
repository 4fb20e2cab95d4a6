"""A tap test as words, tables, JSON and picture."""
