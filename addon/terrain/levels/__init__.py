"""Nested levels of a grid around a place, fine there and coarser outward; without Blender."""
