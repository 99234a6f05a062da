"""Finding Lancret objects: hair Curves objects whose `lancret.enabled` is set."""

from __future__ import annotations

import bpy


def is_lancret(candidate: bpy.types.Object) -> bool:
    return candidate.type == "CURVES" and candidate.lancret.enabled


def lancret_objects(
    scene: bpy.types.Scene, rendered: bool = False
) -> list[bpy.types.Object]:
    """The Lancret objects of a scene, including those of instanced collections; if
    `rendered`, only those that are visible in renders."""
    found, seen = {}, set()

    def walk(collection: bpy.types.Collection) -> None:
        if collection in seen or (rendered and collection.hide_render):
            return
        seen.add(collection)
        for obj in collection.objects:
            if rendered and obj.hide_render:
                continue
            if is_lancret(obj):
                found[obj.name_full] = obj
            if obj.instance_type == "COLLECTION" and obj.instance_collection:
                walk(obj.instance_collection)
        for child in collection.children:
            walk(child)

    walk(scene.collection)
    return list(found.values())
