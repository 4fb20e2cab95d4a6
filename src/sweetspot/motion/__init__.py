"""Motion of a ball and an implement before contact."""
