"""Grids of NASA's Planetary Data System: PDS3 and PDS4 labels."""
