"""One answer over what is varied: table and picture."""
