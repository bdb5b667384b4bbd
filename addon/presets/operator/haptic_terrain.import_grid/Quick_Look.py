import bpy

op = bpy.context.active_operator

op.vertex_budget = 60_000
op.scale = "FIT"
op.exaggeration = 0.0
op.fill_voids = False
