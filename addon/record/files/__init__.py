"""Takes as files that other programs read; without Blender."""
