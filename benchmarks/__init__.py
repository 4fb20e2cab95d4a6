"""Measured figures: how fast sweetspot is, beside other ways to the same answer, on the machine at hand."""
