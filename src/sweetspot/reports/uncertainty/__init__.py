"""Intervals beside the numbers of any document, and what they come from."""
