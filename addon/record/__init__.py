"""What was touched, as animation and as a trail over the terrain."""
