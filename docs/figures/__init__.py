"""Figures of the documentation, each a function that returns a matplotlib Figure."""
