import bpy

settings = bpy.context.scene.haptic_terrain

settings.max_force = 3.0
settings.passivity_control = True
settings.contact_model = "virtual_proxy"
settings.sub_step = "OFF"
settings.radius = 3.0
