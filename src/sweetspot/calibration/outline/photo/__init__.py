"""A bat's outline from a photograph of it on a plain ground."""
