"""A synthetic, Mars-like planet: the terrain of the demo where no real grid is given.

Only elementwise arithmetic with correctly rounded operations is done on arrays (no numpy
transcendentals, whose last bit differs between versions and processors), so that the grid has
the same bytes everywhere.
"""
