"""The motions of a bat, shown."""
