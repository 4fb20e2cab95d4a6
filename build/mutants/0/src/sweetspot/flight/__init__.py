"""The ball in the air: forces, one flight to read, many flights at once."""
