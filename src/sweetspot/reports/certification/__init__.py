"""Tests and rules for people: words, tables, pictures."""
