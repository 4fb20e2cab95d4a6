"""A player: swings read from a file, what they say about speed and scatter, and which bat and contact point serve."""
