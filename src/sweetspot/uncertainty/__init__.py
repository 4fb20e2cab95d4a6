"""Answers for many bats, balls and swings that may be meant: how sure each number is, and what its doubt comes from."""
