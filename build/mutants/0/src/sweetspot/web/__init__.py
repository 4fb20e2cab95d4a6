"""The page: a small server on this machine, its API, and the views that a browser shows."""
