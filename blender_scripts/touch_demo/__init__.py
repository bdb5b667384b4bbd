"""The parts of the demo: where the hand goes, the live session, the picture, the report."""
