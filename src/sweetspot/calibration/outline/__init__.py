"""A bat's outline, measured or drawn: a table of stations, a drawing, a photograph."""
