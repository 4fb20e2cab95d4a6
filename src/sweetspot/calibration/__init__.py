"""From measurements of one bat to what it is made of: taps that ring, and what they say."""
