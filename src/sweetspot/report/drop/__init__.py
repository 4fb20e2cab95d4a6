"""Drop tests for people."""
