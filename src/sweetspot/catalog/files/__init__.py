"""Bats and other implements as TOML files."""
