"""Words, tables, pictures and files of designs."""
