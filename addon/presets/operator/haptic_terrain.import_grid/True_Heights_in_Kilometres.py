import bpy

op = bpy.context.active_operator

op.vertex_budget = 250_000
op.scale = "KILOMETRE"
op.exaggeration = 1.0
op.fill_voids = False
