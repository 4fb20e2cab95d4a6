"""The paper behind the package: its formulas, and each claim beside the full model."""
