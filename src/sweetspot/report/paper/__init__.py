"""The implemented paper for people."""
