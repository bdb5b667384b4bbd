"""The terrain object: what is seen of a grid, and where it is on its body."""
