"""Drapes the garment of a folder with Blender's cloth; run by Toile as templates/simulators/blender.toml says.

A rest shape key holds one position per vertex, so the panels are loose: one vertex per `vt`. The key "rest" is the flat layout,
"Basis" the start. Loose edges between the copies of a seam's vertex are sewing springs. Positions stay in Toile's axes (Y up),
gravity is turned instead.
"""

import json
import math
import os
import sys

import bpy

FPS = 24
CONTACT = 1e-3  # m, between cloth and body; the least that Blender takes


def read_obj(path):
    """Vertices, texture vertices, faces as lists of (v, vt), from 0."""
    v, vt, faces = [], [], []
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            words = line.split()
            if not words:
                continue
            if words[0] == "v":
                v.append(tuple(map(float, words[1:4])))
            elif words[0] == "vt":
                vt.append(tuple(map(float, words[1:3])))
            elif words[0] == "f":
                corners = [word.split("/") for word in words[1:]]
                faces.append([(int(c[0]) - 1, int(c[1]) - 1 if len(c) > 1 and c[1] else -1) for c in corners])
    return v, vt, faces


def new_object(name, positions, edges, faces):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(positions, edges, faces)
    mesh.update()
    made = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(made)
    return made


def add_body(folder, friction):
    v, _, faces = read_obj(os.path.join(folder, "body.obj"))
    body = new_object("body", v, [], [[corner[0] for corner in face] for face in faces])
    body.modifiers.new("collision", "COLLISION")
    body.collision.thickness_outer = CONTACT
    body.collision.cloth_friction = 80 * min(friction, 1.0)
    body.collision.damping = 0


def add_garment(path):
    v, vt, faces = read_obj(path)
    owner = [0] * len(vt)
    for face in faces:
        for vertex, corner in face:
            owner[corner] = vertex
    copies = {}
    for corner, vertex in enumerate(owner):
        copies.setdefault(vertex, []).append(corner)
    sewing = [pair for same in copies.values() for pair in zip(same, same[1:])]
    garment = new_object("garment", [v[vertex] for vertex in owner], sewing, [[c for _, c in face] for face in faces])
    garment.shape_key_add(name="Basis")
    rest = garment.shape_key_add(name="rest", from_mix=False)
    for corner, (s, t) in enumerate(vt):
        rest.data[corner].co = (s, t, 0.0)
    return garment


def set_cloth(garment, given):
    cloth = garment.modifiers.new("cloth", "CLOTH")
    settings, touching = cloth.settings, cloth.collision_settings
    edge = given["edge_length"]
    # Young's modulus of the sheet, warp and weft averaged; a triangular net of springs k has 2 k / sqrt(3), and Blender's k is
    # its stiffness / mean edge.
    warp, weft, cross = given["stretch_warp"], given["stretch_weft"], given["stretch_cross"]
    young = ((warp - cross * cross / weft) + (weft - cross * cross / warp)) / 2
    settings.tension_stiffness = settings.compression_stiffness = math.sqrt(3) / 2 * young * edge
    settings.shear_stiffness = settings.tension_stiffness
    settings.tension_damping = settings.compression_damping = settings.shear_damping = 1
    # Hinges k give a sheet sqrt(3) / 2 k (Seung and Nelson 1988); Blender's k is 0.1 stiffness * edge.
    settings.bending_model = "ANGULAR"
    settings.bending_stiffness = (given["bend_warp"] + given["bend_weft"]) / 2 * 2 / math.sqrt(3) / (0.1 * edge)
    settings.bending_damping = 0
    settings.mass = given["vertex_mass"]
    # Drag on a vertex is 0.01 * air_damping * velocity.
    settings.air_damping = min(given["damping_rate"] * given["vertex_mass"] / 0.01, 10)
    settings.quality = max(1, round(given["steps_per_second"] / FPS))
    settings.time_scale = 1
    settings.use_dynamic_mesh = False
    settings.use_sewing_springs = True
    settings.sewing_force_max = 0  # as much as it takes
    settings.rest_shape_key = garment.data.shape_keys.key_blocks["rest"]
    touching.use_collision = True
    touching.distance_min = CONTACT
    touching.collision_quality = 4
    touching.friction = 80 * min(given["friction"], 1.0)
    touching.damping = 0
    touching.use_self_collision = False
    return cloth


def positions(garment):
    evaluated = garment.evaluated_get(bpy.context.evaluated_depsgraph_get())
    return [tuple(vertex.co) for vertex in evaluated.data.vertices]


def write_obj(path, points):
    with open(path, "w", encoding="utf-8") as out:
        for point in points:
            out.write("v %.9g %.9g %.9g\n" % point)


def main(folder):
    with open(os.path.join(folder, "settings.json"), encoding="utf-8") as file:
        given = json.load(file)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.fps = FPS
    scene.use_gravity = True
    scene.gravity = (0.0, -9.81, 0.0)
    add_body(folder, given["friction"])
    garment = add_garment(os.path.join(folder, given["garment"]))
    cloth = set_cloth(garment, given)
    frames = max(2, math.ceil(given["seconds"] * FPS))
    cloth.point_cache.frame_start, cloth.point_cache.frame_end = 1, frames + 1
    scene.frame_start, scene.frame_end = 1, frames + 1
    apart = max(1, round(given["between"] * FPS))
    earlier = []  # the last `apart` frames, oldest first
    for frame in range(1, frames + 2):
        scene.frame_set(frame)
        earlier.append(positions(garment))
        if len(earlier) <= apart:
            continue
        before, now = earlier.pop(0), earlier[-1]
        moved = max(math.dist(a, b) for a, b in zip(before, now))
        print("frame %d, moved %.3f mm in %.2f s" % (frame, 1e3 * moved, apart / FPS), flush=True)
        if moved <= 0.5 * given["still"]:
            break
    write_obj(os.path.join(folder, given["before"]), before)
    write_obj(os.path.join(folder, given["result"]), now)


main(sys.argv[sys.argv.index("--") + 1])
