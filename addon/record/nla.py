"""A take's action on an NLA track, where it can be moved, stretched and mixed."""

from __future__ import annotations

import bpy


def push_down(take: bpy.types.Object, action: bpy.types.Action) -> bpy.types.NlaStrip:
    """Move the action from use onto a track of its own, at the frames that it has."""
    animation = take.animation_data
    slot = getattr(animation, "action_slot", None)  # from 4.4
    track = animation.nla_tracks.new()
    track.name = take.name
    strip = track.strips.new(action.name, int(action.frame_start), action)
    if slot is not None and strip.action_slot is None:
        strip.action_slot = slot
    # Beside the strip other takes play: this one holds still before and after only where nothing else does.
    strip.extrapolation = "HOLD_FORWARD"
    animation.action = None
    return strip


def off_tracks(take: bpy.types.Object, action: bpy.types.Action) -> None:
    """Remove the strips of an action, and the tracks that held nothing else."""
    tracks = take.animation_data.nla_tracks
    for track in list(tracks):
        own = [strip for strip in track.strips if strip.action == action]
        for strip in own:
            track.strips.remove(strip)
        if own and not len(track.strips):
            tracks.remove(track)
