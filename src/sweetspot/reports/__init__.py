"""What people get to read: words, tables, JSON and the printed page."""
