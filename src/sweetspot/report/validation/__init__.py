"""Published cases for people."""
