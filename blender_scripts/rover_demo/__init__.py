"""The parts of the rover's picture: the rover, its way, and what its wheels feel."""
