"""How a ball and an implement move before they meet."""
