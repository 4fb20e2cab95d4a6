"""What the cases ask the package for: small functions in SI, grouped by theme, listed in `registry`."""
