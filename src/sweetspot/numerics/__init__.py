"""Numerical methods independent of bats: quadrature, interpolation, eigenvalues, vectorised functions, threads."""
