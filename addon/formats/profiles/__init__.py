"""Heights along a line."""
