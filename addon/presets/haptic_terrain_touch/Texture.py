import bpy

settings = bpy.context.scene.haptic_terrain

settings.max_force = 8.0
settings.passivity_control = False
settings.contact_model = "surface_walk"
settings.sub_step = "QUARTER"
settings.radius = 1.0
