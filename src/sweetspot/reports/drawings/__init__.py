"""Drawings of implements for workshops: solids, tool paths, templates and tables."""
