"""Bats designed for a batter: variables, limits, wants, fronts, and what of a gain can be seen."""
