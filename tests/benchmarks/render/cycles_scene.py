"""Renders a scene of the benchmark by Blender's Cycles:

    blender --background --factory-startup --debug-cycles --python cycles_scene.py -- \
        SCENE.op IMAGE.exr SIZE SAMPLES SEED THREADS

Reads the part of OP and GRF that those scenes use; anything else in them is an error. The log has Cycles' own
times; the last line of this script is the peak memory in bytes.
"""

import math
import re
import resource
import sys
from pathlib import Path

import bpy
from mathutils import Matrix, Vector

TOKEN = re.compile(r'//[^\n]*|"([^"]*)"|([()=]|[^\s()=,"]+)')


def tokens_of(path):
    text = path.read_text()
    return [m.group(1) or m.group(2) for m in TOKEN.finditer(text) if not m.group().startswith("//")]


def to_blender(p):
    """Turns y-up into Blender's z-up so that an environment map needs no rotation: its centre, GRF's -z, is
    Blender's +x."""
    return (-p[2], -p[0], p[1])


class GrfReader:
    """The meshes, lights and BRDFs of a file, in Blender's axes."""

    def __init__(self, path):
        self.brdfs = {}  # name: (keyword, {parameter: number or triple}), or a list of names for a sum
        self.meshes = []  # (brdf's name, positions, normals or [], faces)
        self.lights = []  # (radiance, corner, edge, edge)
        self.read(path, Vector((0, 0, 0)))

    def read(self, path, offset):
        outer = getattr(self, "tokens", None), getattr(self, "at", 0)
        self.tokens, self.at = tokens_of(path), 0
        while self.at < len(self.tokens):
            self.block(path.parent, offset)
        self.tokens, self.at = outer

    def next(self):
        self.at += 1
        return self.tokens[self.at - 1]

    def expect(self, *words):
        for word in words:
            found = self.next()
            if found != word:
                raise ValueError(f"expected {word}, found {found}")

    def vector(self):
        self.expect("(")
        values = Vector([float(self.next()) for _ in range(3)])
        self.expect(")")
        return values

    def block(self, folder, offset):
        word = self.next()
        if word == "def":
            self.definition()
        elif word == "begin" and self.tokens[self.at] == "mesh":
            self.mesh(offset)
        elif word == "begin":
            while self.tokens[self.at] != "end":
                self.block(folder, offset)
            self.expect("end")
        elif word == "light":
            self.light(offset)
        elif word == "include":
            self.read(folder / self.next(), offset)
        elif word == "transform":
            self.expect("translation")
            moved = offset + self.vector()
            self.block(folder, moved)
        else:
            raise ValueError(f"'{word}' is not in the scenes of the benchmark")

    def definition(self):
        name = self.next()
        self.expect("=", "brdf")
        keyword = self.next()
        if keyword == "combine":
            self.brdfs[name] = []
            while self.tokens[self.at] == "1":
                self.expect("1")
                self.brdfs[name].append(self.next())
            return
        parameters = {}
        while self.tokens[self.at + 1] == "=":
            parameter = self.next()
            self.expect("=")
            parameters[parameter] = self.vector() if self.tokens[self.at] == "(" else float(self.next())
        self.brdfs[name] = (keyword, parameters)

    def light(self, offset):
        self.expect("begin", "rgb")
        radiance, corner, edge1, edge2 = (self.vector() for _ in range(4))
        self.expect("end")
        self.lights.append((radiance, to_blender(corner + offset), to_blender(edge1), to_blender(edge2)))

    def mesh(self, offset):
        self.expect("mesh")
        self.next()
        self.expect("brdf")
        brdf = self.next()
        self.expect("begin", "vertexs")
        positions, normals = [], []
        while self.tokens[self.at] != "end":
            if self.tokens[self.at] == "normal":
                self.expect("normal")
                normals.append(to_blender(self.vector()))
            positions.append(to_blender(self.vector() + offset))
        self.expect("end", "vertexs", "begin", "faces")
        faces = []
        while self.next() == "(":
            end = self.tokens.index(")", self.at)
            faces.append([int(corner) for corner in self.tokens[self.at : end]])
            self.at = end + 1
        self.expect("faces", "end", "mesh")
        self.meshes.append((brdf, positions, normals, faces))


def colour_of(value):
    return (value, value, value, 1) if isinstance(value, float) else (*value, 1)


def reflectance_at_normal(n, k):
    return ((n - 1) ** 2 + k * k) / ((n + 1) ** 2 + k * k)


def add_brdf(nodes, links, brdfs, name):
    """Returns the output socket of a BRDF's closure."""
    brdf = brdfs[name]
    if isinstance(brdf, list):
        total = nodes.new("ShaderNodeAddShader")
        for socket, term in zip(total.inputs, brdf, strict=True):
            links.new(add_brdf(nodes, links, brdfs, term), socket)
        return total.outputs[0]
    keyword, parameters = brdf
    if keyword == "diffuse":
        node = nodes.new("ShaderNodeBsdfDiffuse")
        node.inputs["Color"].default_value = colour_of(parameters["kd"])
        return node.outputs[0]
    if keyword != "torrance" or parameters["kd"] != 0:
        raise ValueError(f"no node for {keyword}")
    node = nodes.new("ShaderNodeBsdfGlossy")
    node.distribution = "BECKMANN"
    node.inputs["Roughness"].default_value = math.sqrt(parameters["rough"])  # Cycles squares it
    if parameters["nimag"] > 0:
        reflectance = reflectance_at_normal(parameters["nreal"], parameters["nimag"])
        node.inputs["Color"].default_value = [reflectance * c for c in colour_of(parameters["ks"])[:3]] + [1]
    else:
        fresnel = nodes.new("ShaderNodeFresnel")
        fresnel.inputs["IOR"].default_value = parameters["nreal"]
        links.new(fresnel.outputs[0], node.inputs["Color"])
    return node.outputs[0]


def material_of(brdfs, name):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(add_brdf(nodes, links, brdfs, name), output.inputs["Surface"])
    return material


def add_mesh(material, positions, normals, faces):
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata(positions, [], faces)
    mesh.materials.append(material)
    if normals:
        mesh.polygons.foreach_set("use_smooth", [True] * len(faces))
        mesh.use_auto_smooth = True
        mesh.normals_split_custom_set_from_vertices(normals)
    mesh.update()
    placed = bpy.data.objects.new("mesh", mesh)
    bpy.context.collection.objects.link(placed)
    return placed


def add_light(radiance, corner, edge1, edge2):
    corner, edge1, edge2 = Vector(corner), Vector(edge1), Vector(edge2)
    light = bpy.data.lights.new("light", "AREA")
    light.shape = "RECTANGLE"
    light.size, light.size_y = edge1.length, edge2.length
    light.energy = 4 * edge1.length * edge2.length  # of radiance 1: Cycles takes a quarter of it per area
    light.color = radiance
    light.cycles.use_multiple_importance_sampling = True
    light.cycles.max_bounces = 1024
    # A light emits along its -z.
    x, z = edge1.normalized(), -edge1.cross(edge2).normalized()
    placed = bpy.data.objects.new("light", light)
    placed.matrix_world = Matrix.Translation(corner + (edge1 + edge2) / 2) @ Matrix((x, z.cross(x), z)).transposed().to_4x4()
    bpy.context.collection.objects.link(placed)
    add_visible_light(radiance, corner, edge1, edge2)


def add_visible_light(radiance, corner, edge1, edge2):
    """Adds a quad that only the camera sees, since area lights are invisible to it in Cycles."""
    material = bpy.data.materials.new("light")
    material.use_nodes = True
    material.cycles.sample_as_light = False
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    emission, geometry = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeNewGeometry")
    emission.inputs["Color"].default_value = (*radiance, 1)
    front = nodes.new("ShaderNodeMath")
    front.operation = "SUBTRACT"
    front.inputs[0].default_value = 1
    links.new(geometry.outputs["Backfacing"], front.inputs[1])
    links.new(front.outputs[0], emission.inputs["Strength"])
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(emission.outputs[0], output.inputs["Surface"])
    corners = [corner, corner + edge1, corner + edge1 + edge2, corner + edge2]
    quad = add_mesh(material, corners, [], [(0, 1, 2, 3)])
    quad.visible_diffuse = quad.visible_glossy = quad.visible_shadow = quad.visible_transmission = False


def add_environment(path):
    world = bpy.data.worlds.new("world")
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    texture = nodes.new("ShaderNodeTexEnvironment")
    texture.image = bpy.data.images.load(str(path))
    texture.interpolation = "Closest"
    links.new(texture.outputs["Color"], nodes["Background"].inputs["Color"])
    world.cycles.max_bounces = 1024
    bpy.context.scene.world = world


def add_camera(eye, target, field_of_view):
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "VERTICAL"
    camera.angle = math.radians(field_of_view)
    camera.clip_start, camera.clip_end = 1e-3, 1e5
    eye, target = Vector(to_blender(eye)), Vector(to_blender(target))
    placed = bpy.data.objects.new("camera", camera)
    placed.matrix_world = Matrix.Translation(eye) @ (target - eye).to_track_quat("-Z", "Y").to_matrix().to_4x4()
    bpy.context.collection.objects.link(placed)
    bpy.context.scene.camera = placed


def read_op(path):
    lines = (re.sub(r"(^|\s)(#|//).*", "", line).split() for line in path.read_text().splitlines())
    return {words[0]: words[1:] for words in lines if words}


def set_up(options, size, samples, seed, threads):
    """Sets up the same estimator as bpt's: a box filter, all light paths, no clamping."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x = scene.render.resolution_y = size
    scene.render.resolution_percentage = 100
    scene.render.threads_mode, scene.render.threads = "FIXED", threads
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples, cycles.seed = samples, seed
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.light_sampling_threshold = 0
    # In bpt direct light counts as a bounce: depth 1 is 0 bounces of Cycles.
    bounces = int(options["BPT_Depth"][0]) - 1
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = bounces
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.caustics_reflective = True
    cycles.blur_glossy = 0
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1
    cycles.debug_bvh_type = "STATIC_BVH"


def main(op_file, image, size, samples, seed, threads):
    path = Path(op_file).resolve()
    options = read_op(path)
    for placed in list(bpy.data.objects):
        bpy.data.objects.remove(placed)
    bpy.context.scene.world = None
    set_up(options, int(size), int(samples), int(seed), int(threads))
    grf = GrfReader(path.parent / options["BPT_Scene"][0])
    materials = {name: material_of(grf.brdfs, name) for name in grf.brdfs}
    for brdf, positions, normals, faces in grf.meshes:
        add_mesh(materials[brdf], positions, normals, faces)
    for light in grf.lights:
        add_light(*light)
    if "BPT_EM_Background" in options:
        add_environment(path.parent / options["BPT_EM_Background"][0])
    eye, target = ([float(x) for x in options[key]] for key in ("BPT_Viewer", "BPT_VLook"))
    add_camera(eye, target, float(options["BPT_FieldOfView"][0]))
    bpy.context.scene.render.filepath = str(Path(image).resolve())
    bpy.ops.render.render(write_still=True)
    print("peak memory:", 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)


try:
    main(*sys.argv[sys.argv.index("--") + 1 :])
except Exception as error:  # Blender itself would continue and exit with 0
    print(f"cycles_scene.py: {error!r}", file=sys.stderr)
    sys.exit(1)
