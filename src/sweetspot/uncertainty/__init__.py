"""Answers for sampled bats, balls and swings: the uncertainty of each number, and its sources."""
