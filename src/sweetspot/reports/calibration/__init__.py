"""A calibrated bat for people: words, tables, JSON."""
