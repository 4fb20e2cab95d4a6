"""The drawing of a turned bat as a file for a lathe, a draughtsman or a printer: CSV, SVG, DXF, STL."""
