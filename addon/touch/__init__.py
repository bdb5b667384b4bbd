"""The live session: one hand on one terrain, shown by a timer."""
