"""Flights for people: words, tables, pictures."""
