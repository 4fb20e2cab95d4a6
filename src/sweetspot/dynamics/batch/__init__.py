"""Many bats reduced at once: the same beams, modes and walls as one at a time, in compiled kernels."""
