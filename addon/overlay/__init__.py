"""What is drawn over the 3D view while a terrain is touched."""
