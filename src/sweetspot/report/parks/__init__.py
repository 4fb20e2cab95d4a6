"""Ball parks for people: tables and pictures of their fences."""
