"""A bat's outline as somebody measured or drew it: a table of stations, a drawing, a photograph."""
