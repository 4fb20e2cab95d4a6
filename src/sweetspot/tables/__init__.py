"""Tables that people bring: what their headings mean, by whichever system, in which units."""
