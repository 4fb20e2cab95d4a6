"""The hit: closed form for a rigid bat, coupled in time for a real one, and many hits at once."""
