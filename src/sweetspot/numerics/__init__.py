"""Numbers that know nothing of bats: quadrature, interpolation, eigenvalues, vectorised functions, threads."""
