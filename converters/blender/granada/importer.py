"""Makes Blender's objects, meshes and materials of a scene of GRF."""
import array
import os
import tempfile

import bpy

from . import grf_text, grfconvert, materials, op_file, transforms
from .gltf_file import GltfFile

HAS_NORMAL, HAS_COLOUR, HAS_UV = 1, 2, 4


def open_scene(context, path, program, report):
    """Opens a GRF file, or an OP file with the scene that it names and the camera that it has."""
    options = None
    if path.lower().endswith(".op"):
        options = op_file.read(path)
        path = options.path_of("BPT_Scene")
        if not path:
            raise grf_text.GrfError("the OP file names no scene")
    with tempfile.TemporaryDirectory(prefix="granada") as folder:
        target = os.path.join(folder, "scene.gltf")
        for line in grfconvert.convert(program, path, target):
            report("WARNING", line)
        importer = Importer(context, GltfFile(target), path, report)
        importer.run()
    if options:
        op_file.make_camera(context, options)
    return importer.collection


def show_text(material, program):
    """Makes the nodes of a material anew from its text, by a scene of one triangle. Returns the warnings."""
    surface = grf_text.read_surface(material.get(materials.DEFINITIONS, ""), material[materials.SURFACE])
    with tempfile.TemporaryDirectory(prefix="granada") as folder:
        source, target = os.path.join(folder, "material.grf"), os.path.join(folder, "material.gltf")
        with open(source, "w", encoding="utf-8") as file:
            file.write(surface.definitions_text() + ("\nbegin" if surface.definitions else ""))
            file.write("\nbegin mesh\n" + surface.attributes_text())
            file.write("\nbegin vertexs uv (0, 0) (0, 0, 0) uv (1, 0) (1, 0, 0) uv (0, 1) (0, 1, 0) end vertexs\n"
                       "begin faces (0, 1, 2) end faces\nend mesh" + ("\nend" if surface.definitions else ""))
        warnings = grfconvert.convert(program, source, target)
        gltf = GltfFile(target)
        primitive = gltf.json["meshes"][0]["primitives"][0]
        shown = gltf.json["materials"][primitive["material"]]
        materials.show(material, shown, gltf.image_path(shown))
    materials.set_text(material, surface)
    return warnings


class Importer:
    def __init__(self, context, gltf, path, report):
        self.context = context
        self.gltf = gltf
        self.path = path
        self.report = report
        self.scene = grf_text.read_scene(gltf.grf["scene"])
        self.absolute = grf_text.absolute_in(gltf.folder)
        self.materials = {}
        self.meshes = {}
        self.order = 0
        self.dropped = 0
        self.irradiance = 0

    def run(self):
        self.collection = bpy.data.collections.new(os.path.splitext(os.path.basename(self.path))[0])
        self.context.scene.collection.children.link(self.collection)
        self.assign_lists()
        self.context.scene["grf_comment"] = grf_text.first_comment(self.gltf.grf["scene"])
        unused = self.scene.unused.with_paths(self.absolute)
        self.context.scene["grf_definitions"] = unused.definitions_text()
        self.context.scene["grf_params"] = "\n".join(self.scene.params)
        for mesh in self.scene.meshes:
            if isinstance(mesh, grf_text.Mesh) and mesh.definition and not mesh.used:
                self.mesh_of(mesh).use_fake_user = True
        self.add(self.scene.blocks, None)
        self.context.view_layer.update()
        self.keep_transforms()
        if self.dropped:
            self.report("WARNING", f"{self.dropped} faces that have a vertex twice were dropped: Blender has none")
        if self.irradiance:
            self.report("WARNING", f"{self.irradiance} meshes lost their irradiance: Blender has none")

    def assign_lists(self):
        """Finds the lists and the glTF mesh of each mesh of the text, which all are in one order."""
        lists = iter(self.gltf.grf["meshes"])
        self.lists, self.gltf_mesh, next_mesh = {}, {}, 0
        for mesh in self.scene.meshes:
            record = None if isinstance(mesh, grf_text.Light) else next(lists)
            self.lists[mesh.index] = record
            if record is None or record["faces"] > 0:
                self.gltf_mesh[mesh.index] = next_mesh
                next_mesh += 1

    # Objects

    def add(self, blocks, parent):
        for block in blocks:
            if isinstance(block, grf_text.Transform):
                self.add_transform(block, parent)
            else:
                self.add_object(block, parent)

    def add_object(self, block, parent):
        if isinstance(block, grf_text.Use):
            data = self.mesh_of(block.mesh)
            name = grf_text.text_from_identifier(block.mesh.definition)
        else:
            data = self.mesh_of(block)
            name = data.name
        obj = self.new_object(name, data, parent)
        if not isinstance(block, (grf_text.Use, grf_text.Light)) and block.kind == "mesh":
            obj["grf_name"] = [obj.name, block.name]
        return obj

    def new_object(self, name, data, parent):
        obj = bpy.data.objects.new(name, data)
        self.collection.objects.link(obj)
        obj.parent = parent
        obj["grf_order"] = self.order
        self.order += 1
        return obj

    def add_transform(self, block, parent):
        groups = transforms.step_groups(block.steps)
        body = block.body
        is_simple = len(groups) == 1 and len(body) == 1 and not isinstance(body[0], grf_text.Transform)
        if is_simple:
            obj = self.add_object(body[0], parent)
            transforms.place(obj, groups[0])
            obj["grf_transform"] = block.text
            return
        for place, group in enumerate(reversed(groups)):
            obj = self.new_object("transform", None, parent)
            obj.empty_display_size = 0.1
            transforms.place(obj, group)
            # The outermost of several objects has the text of all; the others are written only if one was moved.
            obj["grf_transform"] = block.text if place == 0 else ""
            obj["grf_steps"] = len(groups) if place == 0 else 0
            parent = obj
        self.add(body, parent)

    def keep_transforms(self):
        for obj in self.collection.objects:
            if "grf_transform" in obj:
                obj["grf_matrix"] = transforms.flattened(obj.matrix_basis)

    # Meshes

    def mesh_of(self, mesh):
        if mesh.index not in self.meshes:
            self.meshes[mesh.index] = self.light_mesh(mesh) if isinstance(mesh, grf_text.Light) else self.new_mesh(mesh)
        return self.meshes[mesh.index]

    def light_mesh(self, light):
        primitive = self.gltf.json["meshes"][self.gltf_mesh[light.index]]["primitives"][0]
        positions = self.gltf.accessor(primitive["attributes"]["POSITION"])
        data = self.geometry("light", positions, [4], [0, 1, 2, 3])
        data["grf_kind"] = "light"
        data["grf_light"] = light.text
        data["grf_light_corners"] = [x for vertex in data.vertices for x in vertex.co]
        data.materials.append(self.material_of(light.surface, primitive["material"]))
        return data

    def geometry(self, name, positions, sizes, corners):
        data = bpy.data.meshes.new(name)
        data.vertices.add(len(positions) // 3)
        turned = array.array("f", positions)
        turned[1::3] = array.array("f", (-z for z in positions[2::3]))
        turned[2::3] = positions[1::3]
        data.vertices.foreach_set("co", turned)
        starts, start = [], 0
        for size in sizes:
            starts.append(start)
            start += size
        data.loops.add(len(corners))
        data.loops.foreach_set("vertex_index", array.array("i", corners))
        data.polygons.add(len(sizes))
        data.polygons.foreach_set("loop_start", array.array("i", starts))
        data.polygons.foreach_set("loop_total", array.array("i", sizes))
        data.update(calc_edges=True)
        return data

    def new_mesh(self, mesh):
        lists = self.lists[mesh.index]
        positions = self.gltf.list(lists, "positions") or []
        all_corners = self.gltf.list(lists, "corners") or []
        all_sizes = self.gltf.list(lists, "sizes") or [3] * lists["faces"]
        all_surfaces = self.gltf.list(lists, "surfaces") or [0] * lists["faces"]
        sizes, corners, surfaces, first = [], [], [], 0
        for size, surface in zip(all_sizes, all_surfaces):
            face = all_corners[first:first + size]
            first += size
            if len(set(face)) < size:
                self.dropped += 1
                continue
            sizes.append(size)
            corners.extend(face)
            surfaces.append(surface)
        name = mesh.name or grf_text.text_from_identifier(mesh.definition) or mesh.kind
        data = self.geometry(name, positions, sizes, corners)
        if mesh.kind != "mesh":
            data["grf_kind"] = mesh.kind
        if mesh.definition:
            data["grf_definition"] = mesh.definition
            data["grf_name"] = [data.name, mesh.name]
        if lists["faces"] > 0:
            found = self.gltf.materials_of_surfaces(self.gltf_mesh[mesh.index], all_sizes, all_corners, all_surfaces)
            slots = [self.slot_of(data, surface, found.get(i)) for i, surface in enumerate(mesh.surfaces)]
            data.polygons.foreach_set("material_index", array.array("i", (slots[surface] for surface in surfaces)))
        self.add_attributes(data, lists, corners)
        self.irradiance += "irradiance" in lists or "rayCounts" in lists
        return data

    def slot_of(self, data, surface, gltf_material):
        material = self.material_of(surface, gltf_material)
        place = data.materials.find(material.name)
        if place < 0:
            data.materials.append(material)
            place = len(data.materials) - 1
        return place

    def add_attributes(self, data, lists, corners):
        normals, colours, uvs = (self.gltf.list(lists, name) for name in ("normals", "colours", "uvs"))
        present = self.gltf.list(lists, "present")
        count = len(data.vertices)
        if present is not None:
            data.attributes.new("grf_present", "INT", "POINT").data.foreach_set("value", array.array("i", present))
        if colours is not None:
            rgba = array.array("f", [1.0]) * (4 * count)
            for i in range(3):
                rgba[i::4] = colours[i::3]
            data.attributes.new("rgb", "FLOAT_COLOR", "POINT").data.foreach_set("color", rgba)
        if uvs is not None:
            layer = data.uv_layers.new(name="uv")
            layer.data.foreach_set("uv", array.array("f", (x for v in corners for x in uvs[2 * v:2 * v + 2])))
        if normals is not None:
            self.set_normals(data, normals, present)

    def set_normals(self, data, normals, present):
        """Faces whose corners all have normals are smooth. Blender rounds normals, so the exact ones are kept, too."""
        turned = [transforms.point_to_blender(normals[3 * v:3 * v + 3]) for v in range(len(data.vertices))]
        flat = array.array("f", (x for normal in turned for x in normal))
        data.attributes.new("grf_normal", "FLOAT_VECTOR", "POINT").data.foreach_set("vector", flat)
        has = [present is None or present[v] & HAS_NORMAL for v in range(len(data.vertices))]
        loop_normals = []
        for polygon in data.polygons:
            polygon.use_smooth = all(has[v] for v in polygon.vertices)
            for v in polygon.vertices:
                loop_normals.append(turned[v] if polygon.use_smooth else (0, 0, 0))
        data.use_auto_smooth = True
        data.auto_smooth_angle = 3.1415926
        data.normals_split_custom_set(loop_normals)
        # What Blender makes of them tells later which were edited.
        data.calc_normals_split()
        shown = array.array("f", [0]) * (3 * len(data.loops))
        data.loops.foreach_get("normal", shown)
        data.attributes.new("grf_shown_normal", "FLOAT_VECTOR", "CORNER").data.foreach_set("vector", shown)

    # Materials

    def material_of(self, surface, gltf_material):
        surface = surface.with_paths(self.absolute)
        key = (surface.definitions_text(), surface.attributes_text())
        if key not in self.materials:
            material = bpy.data.materials.new(self.name_of(surface))
            gltf = self.gltf.json["materials"][gltf_material] if gltf_material is not None else {}
            materials.show(material, gltf, self.gltf.image_path(gltf) if gltf else None)
            materials.set_text(material, surface)
            self.materials[key] = material
        return self.materials[key]

    @staticmethod
    def name_of(surface):
        brdf = surface.attributes.get("brdf")
        if not brdf:
            return "light" if "light" in surface.attributes else "default"
        if len(brdf) == 1 and brdf[0].startswith('"'):
            return os.path.splitext(os.path.basename(brdf[0][1:-1]))[0]
        return grf_text.text_from_identifier(brdf[0])
