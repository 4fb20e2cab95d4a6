"""The other ways: what a user would write without sweetspot."""
