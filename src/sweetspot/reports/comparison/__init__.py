"""Bats side by side for people: words, tables, pictures."""
