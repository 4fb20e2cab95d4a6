"""Bats, balls and what other sports hit with: frozen descriptions in SI, validated, without mechanics."""
