"""Opens a scene by the add-on in Blender, changes it as asked, and writes it:
blender -b --factory-startup --python run_add_on.py -- ADD_ON_FOLDER GRFCONVERT IN OUT [CHANGE]"""
import sys
import traceback

import addon_utils
import bpy


def empty_scene():
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)


def principled(name):
    return next(node for node in bpy.data.materials[name].node_tree.nodes if node.type == "BSDF_PRINCIPLED")


def change_material():
    principled("white").inputs["Base Color"].default_value = (0.25, 0.5, 0.75, 1)
    principled("white").inputs["Roughness"].default_value = 0.25
    principled("white").inputs["Specular"].default_value = 0.5


def change_lamp():
    node = bpy.data.materials["light"].node_tree.nodes
    next(n for n in node if n.type == "EMISSION").inputs["Strength"].default_value = 2


def edit_vertex():
    """Moves a vertex in edit mode, and stays there."""
    import bmesh
    obj = bpy.data.objects["floor"]
    bpy.context.view_layer.objects.active = obj
    bpy.ops.object.mode_set(mode="EDIT")
    mesh = bmesh.from_edit_mesh(obj.data)
    mesh.verts.ensure_lookup_table()
    mesh.verts[1].co.z += 7
    bmesh.update_edit_mesh(obj.data)


def move_object():
    bpy.data.objects["short block"].location.z = 25


def move_back():
    move_object()
    bpy.data.objects["short block"].location.z = 0


def new_cube():
    bpy.ops.mesh.primitive_cube_add(size=2, location=(1, 2, 3))
    cube = bpy.context.object
    cube.name = "new cube"
    material = bpy.data.materials.new("paint")
    material.use_nodes = True
    cube.data.materials.append(material)
    principled("paint").inputs["Base Color"].default_value = (0.5, 0.25, 0.125, 1)
    principled("paint").inputs["Metallic"].default_value = 1
    copy = cube.copy()  # which shares the mesh
    copy.location.x = 9
    bpy.context.collection.objects.link(copy)


def textured_plane():
    """A plane whose image is in no file, times a colour, cut out by its alpha."""
    bpy.ops.mesh.primitive_plane_add(size=2)
    material = bpy.data.materials.new("poster")
    material.use_nodes = True
    material.blend_method, material.alpha_threshold = "CLIP", 0.25
    bpy.context.object.data.materials.append(material)
    tree = material.node_tree
    image, product = tree.nodes.new("ShaderNodeTexImage"), tree.nodes.new("ShaderNodeMixRGB")
    image.image = bpy.data.images.new("drawn", 4, 4, alpha=True)
    product.blend_type = "MULTIPLY"
    product.inputs[0].default_value = 1
    product.inputs[1].default_value = (0.5, 0.75, 1, 1)
    tree.links.new(image.outputs["Color"], product.inputs[2])
    tree.links.new(product.outputs[0], principled("poster").inputs["Base Color"])
    tree.links.new(image.outputs["Alpha"], principled("poster").inputs["Alpha"])


def new_lamp():
    lamp = bpy.data.lights.new("lamp", "AREA")
    lamp.shape, lamp.size, lamp.size_y, lamp.energy = "RECTANGLE", 2, 1, 100
    lamp.color = (1, 0.5, 0.25)
    obj = bpy.data.objects.new("lamp", lamp)
    obj.location = (0, 0, 5)
    bpy.context.collection.objects.link(obj)


def edit_text():
    bpy.data.materials["white"].granada_definitions = "def white = brdf oren s=0.3 r=0.5"


def preview_text():
    edit_text()
    with bpy.context.temp_override(material=bpy.data.materials["white"]):
        assert bpy.ops.material.granada_check() == {"FINISHED"}
    base = principled("white").inputs["Base Color"].default_value
    assert abs(base[0] - 0.5) < 0.01, list(base)


def sheared_cube():
    """A cube that is turned below a parent whose scale differs by axis; its world positions go to a file."""
    bpy.ops.object.empty_add(location=(1, 2, 3), rotation=(0.1, 0.2, 0.3))
    parent = bpy.context.object
    parent.scale = (1, -2, 3)
    bpy.ops.mesh.primitive_cube_add(size=2)
    cube = bpy.context.object
    cube.name = "sheared cube"
    cube.location, cube.rotation_euler, cube.scale = (5, 6, 7), (1, 2, 3), (3, 1, 0.5)
    cube.parent = parent
    bpy.context.view_layer.update()
    with open(sys.argv[-2] + ".positions", "w", encoding="utf-8") as file:
        for vertex in cube.data.vertices:
            x, y, z = cube.matrix_world @ vertex.co
            file.write(f"{x:.9g} {z:.9g} {-y:.9g}\n")


def loose_matrix():
    """The cube of `sheared_cube` without its parent: one matrix that no scale and rotation give."""
    sheared_cube()
    cube = bpy.data.objects["sheared cube"]
    cube.parent.hide_render = True


def new_curve_and_modifier():
    bpy.ops.mesh.primitive_plane_add(size=2)
    bpy.context.object.name = "doubled"
    bpy.context.object.modifiers.new("array", "ARRAY").count = 2
    bpy.ops.object.text_add()
    bpy.context.object.data.body = "l"
    bpy.context.object.name = "text"


def new_lamps():
    for kind in ("POINT", "SUN", "AREA"):
        lamp = bpy.data.lights.new(kind, kind)
        lamp.energy = 10
        if kind == "AREA":
            lamp.shape, lamp.size, lamp.size_y = "ELLIPSE", 2, 1
        bpy.context.collection.objects.link(bpy.data.objects.new(kind, lamp))


def pull_vertex_of_knot():
    knot = bpy.data.objects["knot"]
    bpy.context.view_layer.objects.active = knot
    bpy.ops.object.mode_set(mode="EDIT")
    import bmesh
    mesh = bmesh.from_edit_mesh(knot.data)
    mesh.verts.ensure_lookup_table()
    mesh.verts[0].co.z += 0.05
    bmesh.update_edit_mesh(knot.data)


def stay_in_edit_mode():
    for obj in bpy.data.objects:
        if obj.type == "MESH":
            obj.select_set(True)
            bpy.context.view_layer.objects.active = obj
    bpy.ops.object.mode_set(mode="EDIT")
    assert sum(obj.mode == "EDIT" for obj in bpy.data.objects) > 1


def save_and_load():
    """Goes through a file of Blender, and through edit mode."""
    import os
    for obj in [obj for obj in bpy.data.objects if obj.type == "MESH"]:
        bpy.context.view_layer.objects.active = obj
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.object.mode_set(mode="OBJECT")
    path = sys.argv[-2] + ".blend"
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    assert os.path.exists(path)


def move_camera():
    bpy.context.scene.camera.location.z += 100


# Faults that the comparison has to find.

def swap_axes():
    for mesh in bpy.data.meshes:
        for vertex in mesh.vertices:
            vertex.co = vertex.co.yxz


def lose_material_index():
    for mesh in bpy.data.meshes:
        if len(mesh.materials) > 1:
            for polygon in mesh.polygons:
                polygon.material_index = 0


def lose_texture_coordinates():
    for mesh in bpy.data.meshes:
        for layer in mesh.uv_layers:
            layer.data[0].uv.x += 0.01


def turn_normals():
    for mesh in bpy.data.meshes:
        if "grf_normal" in mesh.attributes:
            mesh.attributes["grf_normal"].data[1].vector.x += 1e-4


def move_instances():
    for obj in bpy.data.objects:
        obj.location.x *= 1.001


CHANGES = {function.__name__: function for function in list(globals().values())
           if callable(function) and getattr(function, "__module__", None) == __name__}


def main():
    folder, program, source, target, *changes = sys.argv[sys.argv.index("--") + 1:]
    sys.dont_write_bytecode = True
    sys.path.insert(0, folder)
    addon_utils.enable("granada", default_set=True)
    if program != "PATH":
        bpy.context.preferences.addons["granada"].preferences.program = program
    empty_scene()
    bpy.ops.import_scene.granada(filepath=source)
    for change in changes:
        CHANGES[change]()
    bpy.ops.export_scene.granada(filepath=target)
    addon_utils.disable("granada", default_set=True)
    print("the add-on was run")


try:
    main()
except Exception:
    traceback.print_exc()
    sys.exit(1)
