"""Writes Blender's scene as GRF text, which `grfconvert` checks and puts into its own style."""
import array
import os
import tempfile
from collections import Counter
from math import cos, pi, sin

import bpy
from mathutils import Vector

from . import grf_text, grfconvert, materials, op_file, transforms
from .importer import HAS_COLOUR, HAS_NORMAL, HAS_UV
from .transforms import flattened, is_close, is_identity, point_to_grf

GEOMETRY = ("MESH", "CURVE", "SURFACE", "META", "FONT")
# How far Blender's normals may be from those that it had at first, where nothing was edited.
NORMAL_ROUNDING = 1e-5
LAMP_CORNERS = 64
# Cycles gives a lamp of P watts the radiance P/(4 area); a Lambertian emitter of that power has P/(pi area).
RADIANCE_DIVISOR = 4


def save_scene(context, path, program, report, selected=False, with_options=False):
    """Writes a GRF file, and an OP file with the camera beside it if wanted; returns the path of the GRF file."""
    is_options = path.lower().endswith(".op")
    scene_path = os.path.splitext(path)[0] + ".grf" if is_options else path
    folder = os.path.dirname(os.path.abspath(scene_path))
    text = Exporter(context, folder, report, selected).text()
    # Names of files are relative to the folder of the text, so it is written there first.
    handle, draft = tempfile.mkstemp(suffix=".grf", prefix=".granada", dir=folder)
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(text)
        for line in grfconvert.convert(program, draft, scene_path):
            report("WARNING", line.replace(draft, scene_path))
    finally:
        os.remove(draft)
    if is_options or with_options:
        op_file.write(context, os.path.splitext(scene_path)[0] + ".op", scene_path, report)
    return scene_path


class Exporter:
    def __init__(self, context, folder, report, selected):
        self.context = context
        self.folder = folder
        self.report = report
        self.relative = grf_text.relative_to(folder)
        self.definitions = grf_text.Definitions()
        self.mesh_definitions = {}  # keys of shared meshes: their names
        self.mesh_texts = []
        self.surfaces = {}
        self.objects = [obj for obj in context.view_layer.objects
                        if not obj.hide_render and (not selected or obj.select_get())]

    def text(self):
        for obj in self.objects:
            if obj.mode == "EDIT":
                obj.update_from_editmode()
        self.context.view_layer.update()
        self.depsgraph = self.context.evaluated_depsgraph_get()
        self.count_instances()
        self.add_kept_definitions()
        self.included = set(self.objects)
        self.objects.sort(key=self.order)
        self.children = {}
        for obj in self.objects:
            self.children.setdefault(obj.parent if obj.parent in self.included else None, []).append(obj)
        blocks = [text for obj in self.children.get(None, []) for text in self.object_blocks(obj)]
        self.add_unused_meshes()
        self.warn_of_losses()
        parts = [self.context.scene[key] for key in ("grf_comment", "grf_params") if self.context.scene.get(key)]
        definitions = [f"def {name} = {grf_text.text_of(body)}" for name, body in self.definitions.bodies.items()
                       if isinstance(body, list)] + self.mesh_texts
        if definitions:
            parts += definitions + ["begin"] + blocks + ["end"]
        else:
            parts += blocks
        return "\n".join(parts) + "\n"

    @staticmethod
    def order(obj):
        return (obj.get("grf_order", float("inf")), obj.name)

    def add_kept_definitions(self):
        text = self.context.scene.get("grf_definitions")
        if text:
            self.definitions.add(grf_text.read_surface(text, "").with_paths(self.relative))

    def warn_of_losses(self):
        lamps = sum(obj.type == "LIGHT" and obj.data.type != "AREA" for obj in self.objects)
        if lamps:
            self.report("WARNING", f"{lamps} lamps that are no area lights were not written: GRF has none")
        collections = sum(obj.instance_type == "COLLECTION" for obj in self.objects)
        if collections:
            self.report("WARNING", f"{collections} instances of collections were not written: make them real first")

    # Objects

    def object_blocks(self, obj):
        """The blocks of an object and its children, in a transform if it has one."""
        chain = self.unmoved_chain(obj)
        inner = chain[-1] if chain else obj
        blocks = self.own_blocks(inner)
        for child in self.children.get(inner, []):
            blocks += self.object_blocks(child)
        if not blocks:
            return []
        if chain:
            return [f"transform {obj['grf_transform']} begin", *blocks, "end"]
        steps = self.steps_of(obj)
        if steps is None:
            self.report("WARNING", f"'{obj.name}' was not written: its scale is zero")
            return []
        return [f"transform {steps} begin", *blocks, "end"] if steps else blocks

    def unmoved_chain(self, obj):
        """The objects that stand for one `transform` of several, if all of them are as they were."""
        chain = [obj]
        for _ in range(obj.get("grf_steps", 1) - 1):
            children = self.children.get(chain[-1], [])
            if len(children) != 1 or children[0].get("grf_transform") != "":
                return None
            chain.append(children[0])
        text_is_whole = len(chain) > 1 and all(self.is_unmoved(part) for part in chain)
        return chain if text_is_whole else None

    def local_matrix(self, obj):
        """The matrix relative to the parent, exact where nothing but the object's own values makes it."""
        is_plain = not obj.constraints and obj.animation_data is None and obj.parent_type == "OBJECT"
        if obj.parent is not None and obj.parent not in self.included:
            return obj.matrix_world
        if is_plain:
            return obj.matrix_parent_inverse @ obj.matrix_basis if obj.parent else obj.matrix_basis
        return obj.parent.matrix_world.inverted_safe() @ obj.matrix_world if obj.parent else obj.matrix_world

    def is_unmoved(self, obj):
        return "grf_matrix" in obj and is_close(list(obj["grf_matrix"]), flattened(self.local_matrix(obj)))

    def steps_of(self, obj):
        if obj.get("grf_transform") and obj.get("grf_steps", 1) == 1 and self.is_unmoved(obj):
            return obj["grf_transform"]
        matrix = self.local_matrix(obj)
        return "" if is_identity(matrix) else transforms.steps_text(matrix)

    def own_blocks(self, obj):
        if obj.type == "LIGHT" and obj.data.type == "AREA":
            return self.lamp(obj.data)
        if obj.type not in GEOMETRY:
            return []
        slots = tuple(slot.material for slot in obj.material_slots)
        if not self.is_shared(obj, slots):
            return self.mesh_blocks(obj, slots, self.name_of(obj, obj.name))
        return [f"use {self.definition_of(obj, slots)}"]

    @staticmethod
    def name_of(owner, name):
        """The name of GRF for what still has the name that it was given for that."""
        kept = owner.get("grf_name")
        return kept[1] if kept and kept[0] == name else name

    # Instances

    def count_instances(self):
        self.instances = Counter(self.key_of(obj, tuple(slot.material for slot in obj.material_slots))
                                 for obj in self.objects if obj.type == "MESH")

    @staticmethod
    def key_of(obj, slots):
        return (obj.data.name, tuple(material.name if material else "" for material in slots))

    def is_shared(self, obj, slots):
        if obj.type != "MESH" or self.has_modifiers(obj) or obj.data.get("grf_kind"):
            return False
        return self.instances[self.key_of(obj, slots)] > 1 or "grf_definition" in obj.data

    @staticmethod
    def has_modifiers(obj):
        has_keys = obj.type == "MESH" and obj.data.shape_keys is not None
        return has_keys or any(modifier.show_viewport for modifier in obj.modifiers)

    def definition_of(self, obj, slots):
        key = self.key_of(obj, slots)
        if key not in self.mesh_definitions:
            self.mesh_definitions[key] = self.define(obj.data, slots)
        return self.mesh_definitions[key]

    def define(self, data, slots):
        kept = self.name_of(data, data.name)
        name = kept if "grf_definition" in data else data.name
        identifier = data.get("grf_definition") or grf_text.identifier_of(data.name)
        name_of_definition = self.definitions.unique(identifier)
        text = self.mesh_text(data, slots, name)
        self.mesh_texts.append(f"def {name_of_definition} = {text}")
        return name_of_definition

    def add_unused_meshes(self):
        used = {name for name, _ in self.mesh_definitions}
        for data in bpy.data.meshes:
            if data.get("grf_definition") and data.use_fake_user and data.name not in used and data.users == 1:
                self.define(data, tuple(data.materials))

    # Lights

    def lamp(self, lamp):
        """A lamp of Blender, which shines along its negative z axis, with the radiance that Cycles gives it."""
        x = lamp.size / 2
        y = x if lamp.shape in ("SQUARE", "DISK") else lamp.size_y / 2
        is_round = lamp.shape in ("DISK", "ELLIPSE")
        area = pi * x * y if is_round else 4 * x * y
        radiance = grf_text.vector([lamp.energy * c / (RADIANCE_DIVISOR * area) for c in lamp.color])
        if not is_round:
            vectors = [(-x, y, 0), (2 * x, 0, 0), (0, -2 * y, 0)]
            texts = " ".join(grf_text.vector(point_to_grf(v)) for v in vectors)
            return [f"light begin {texts} rgb {radiance} end"]
        angles = [-2 * pi * i / LAMP_CORNERS for i in range(LAMP_CORNERS)]
        vertices = " ".join(grf_text.vector(point_to_grf((x * cos(a), y * sin(a), 0))) for a in angles)
        face = ", ".join(str(i) for i in range(LAMP_CORNERS))
        return [f"mesh light begin rgb {radiance}", f"begin vertexs {vertices} end vertexs",
                f"begin faces ({face}) end faces end"]

    def light_text(self, mesh, attributes):
        """A parallelogram light, if the mesh is still one."""
        if len(mesh.polygons) != 1 or len(mesh.vertices) != 4 or len(mesh.polygons[0].vertices) != 4:
            return None
        corners = [mesh.vertices[v].co for v in mesh.polygons[0].vertices]
        size = max((corners[i] - corners[0]).length for i in range(1, 4))
        if (corners[0] - corners[1] + corners[2] - corners[3]).length > 1e-5 * size:
            return None
        flat = [x for vertex in mesh.vertices for x in vertex.co]
        if "grf_light" in mesh and list(mesh["grf_light_corners"]) == flat:
            texts = mesh["grf_light"]
        else:
            vectors = (corners[0], corners[1] - corners[0], corners[3] - corners[0])
            texts = " ".join(grf_text.vector(point_to_grf(v)) for v in vectors)
        return f"light begin {texts} {grf_text.text_of(attributes[0]['light'])} end"

    # Meshes

    def mesh_blocks(self, obj, slots, name):
        if obj.type == "MESH" and not self.has_modifiers(obj):
            return [self.mesh_text(obj.data, slots, name)] if obj.data.vertices else []
        evaluated = obj.evaluated_get(self.depsgraph)
        mesh = evaluated.to_mesh(preserve_all_data_layers=True, depsgraph=self.depsgraph)
        try:
            slots = tuple(slot.material for slot in evaluated.material_slots)
            return [self.mesh_text(mesh, slots, name)] if mesh and mesh.vertices else []
        finally:
            evaluated.to_mesh_clear()

    def attributes_of(self, material):
        """The attributes of a material, with its definitions added; a slot without one shows Blender's grey."""
        material = self.original(material)
        if material not in self.surfaces:
            if material is None:
                surface = grf_text.read_surface("", "brdf diffuse kd=0.8")
            else:
                surface = materials.surface_of(material, self.report, self.image_file).with_paths(self.relative)
            self.surfaces[material] = self.definitions.add(surface)
        return self.surfaces[material]

    @staticmethod
    def original(material):
        return material.original if material is not None else None

    def image_file(self, image):
        """The file of an image. One that has none is saved beside the scene."""
        path = materials.image_path(image)
        if path and not image.packed_file:
            return path
        path = os.path.join(self.folder, bpy.path.clean_name(os.path.splitext(image.name)[0]) + ".png")
        save_copy(image, path)
        return path

    def mesh_text(self, mesh, slots, name):
        """The block of a mesh. One that is in edit mode shows no attributes, but its copy does."""
        if not mesh.is_editmode:
            return self.plain_mesh_text(mesh, slots, name)
        copy = mesh.copy()
        try:
            return self.plain_mesh_text(copy, slots, name)
        finally:
            bpy.data.meshes.remove(copy)

    def plain_mesh_text(self, mesh, slots, name):
        used = sorted({min(polygon.material_index, max(len(slots) - 1, 0)) for polygon in mesh.polygons})
        attributes = {i: self.attributes_of(slots[i] if i < len(slots) else None) for i in used}
        kind = mesh.get("grf_kind", "mesh")
        if kind != "mesh" and any(list(values) != ["light"] for values in attributes.values()):
            kind = "mesh"
        if kind == "light" and used:
            text = self.light_text(mesh, [attributes[used[0]]])
            if text:
                return text
            kind = "mesh light"
        has_texture = any("texture" in values for values in attributes.values())
        vertices, faces = MeshWriter(mesh, has_texture).run()
        lines = ["mesh light begin" if kind == "mesh light" else f"begin mesh {quoted(name)}"]
        if kind == "mesh light":
            attributes = {i: {"rgb": values["light"][1:]} for i, values in attributes.items()}
        # What all faces share is said of the mesh.
        all_share = len({str(values) for values in attributes.values()}) == 1
        current = attributes[used[0]] if all_share else {}
        lines += [f"{key} {grf_text.text_of(value)}" for key, value in current.items()]
        lines += ["begin vertexs", *vertices, "end vertexs", "begin faces"]
        for polygon, face in zip(mesh.polygons, faces):
            wanted = attributes[min(polygon.material_index, max(len(slots) - 1, 0))]
            lines += [f"{key} none" for key in current if key not in wanted]
            lines += [f"{key} {grf_text.text_of(value)}" for key, value in wanted.items() if current.get(key) != value]
            current = wanted
            lines.append(face)
        lines += ["end faces", "end" if kind == "mesh light" else "end mesh"]
        return "\n".join(lines)


def quoted(name):
    return '"' + name.replace('"', "'").replace("\n", " ") + '"' if name else ""


def save_copy(image, path):
    """Saves an image without a file, and leaves the image as it is."""
    copy = image.copy()
    try:
        copy.filepath_raw = path
        copy.file_format = "PNG"
        copy.save()
    finally:
        bpy.data.images.remove(copy)


class MeshWriter:
    """Vertices and faces of a mesh as lines. A vertex of Blender becomes several where its corners differ."""

    def __init__(self, mesh, has_texture):
        self.mesh = mesh
        # It adds a layer, which moves the others in memory, so values are read after it.
        mesh.calc_normals_split()
        self.present = self.values("grf_present", "value", 1)
        self.exact = self.values("grf_normal", "vector", 3)
        self.shown = self.values("grf_shown_normal", "vector", 3, "CORNER")
        self.colours = self.values("rgb", "color", 4)
        layer = mesh.uv_layers.active if has_texture or "uv" in mesh.uv_layers else None
        self.uvs = None
        if layer is not None:
            self.uvs = array.array("f", [0.0]) * (2 * len(mesh.loops))
            layer.data.foreach_get("uv", self.uvs)

    def values(self, name, member, size, domain="POINT"):
        attribute = self.mesh.attributes.get(name)
        count = len(self.mesh.vertices if domain == "POINT" else self.mesh.loops)
        if attribute is None or attribute.domain != domain or len(attribute.data) != count:
            return None
        numbers = array.array("i" if member == "value" else "f", [0]) * (size * count)
        attribute.data.foreach_get(member, numbers)
        return numbers

    def has(self, vertex, bit):
        return self.present is None or bool(self.present[vertex] & bit)

    def run(self):
        mesh = self.mesh
        places, keys, faces = {}, [[] for _ in mesh.vertices], []
        for polygon in mesh.polygons:
            face = []
            for loop_index in polygon.loop_indices:
                vertex = mesh.loops[loop_index].vertex_index
                key = (self.normal(polygon, loop_index, vertex), self.uv(loop_index, vertex))
                if key not in keys[vertex]:
                    keys[vertex].append(key)
                face.append((vertex, keys[vertex].index(key)))
            faces.append(face)
        # The first of each vertex keep its place, the others follow.
        lines = []
        for vertex, found in enumerate(keys):
            places[(vertex, 0)] = len(lines)
            lines.append(self.line(vertex, found[0] if found else self.loose(vertex)))
        for vertex, found in enumerate(keys):
            for i, key in enumerate(found[1:], 1):
                places[(vertex, i)] = len(lines)
                lines.append(self.line(vertex, key))
        return lines, ["(" + ", ".join(str(places[corner]) for corner in face) + ")" for face in faces]

    def exact_normal(self, vertex):
        return Vector(self.exact[3 * vertex:3 * vertex + 3]) if self.exact and self.has(vertex, HAS_NORMAL) else None

    def normal(self, polygon, loop_index, vertex):
        exact = self.exact_normal(vertex)
        if not polygon.use_smooth:
            # In GRF such a face is flat because a corner lacks a normal, which others may have.
            lacks_one = self.exact and not all(self.has(v, HAS_NORMAL) for v in polygon.vertices)
            return tuple(exact) if exact is not None and lacks_one else None
        normal = self.mesh.loops[loop_index].normal
        if exact is not None and self.shown:
            shown = self.shown[3 * loop_index:3 * loop_index + 3]
            if all(abs(x - y) <= NORMAL_ROUNDING for x, y in zip(normal, shown)):
                return tuple(exact)
        return tuple(normal)

    def uv(self, loop_index, vertex):
        if self.uvs is None or not self.has(vertex, HAS_UV):
            return None
        return tuple(self.uvs[2 * loop_index:2 * loop_index + 2])

    def loose(self, vertex):
        exact = self.exact_normal(vertex)
        return (tuple(exact) if exact is not None else None, None)

    def line(self, vertex, key):
        normal, uv = key
        parts = []
        if normal is not None:
            parts.append("normal " + grf_text.vector(point_to_grf(normal)))
        if self.colours is not None and self.has(vertex, HAS_COLOUR):
            parts.append("rgb " + grf_text.vector(max(x, 0) for x in self.colours[4 * vertex:4 * vertex + 3]))
        if uv is not None:
            parts.append("uv " + grf_text.vector(uv))
        parts.append(grf_text.vector(point_to_grf(self.mesh.vertices[vertex].co)))
        return " ".join(parts)
