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
from mathutils import Euler, Matrix, Vector

TOKEN = re.compile(r'//[^\n]*|("[^"]*)"|([()=]|[^\s()=,"]+)')

# Turns y-up into Blender's z-up so that an environment map needs no rotation: its centre, GRF's -z, is Blender's +x.
TO_BLENDER = Matrix(((0, 0, -1, 0), (-1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 0, 1)))


def tokens_of(path):
    """The words of a file; strings begin with a quote."""
    text = path.read_text()
    return [m.group(1) or m.group(2) for m in TOKEN.finditer(text) if not m.group().startswith("//")]


def to_blender(p):
    return TO_BLENDER @ Vector(p)


class Mesh:
    """A mesh in Blender's axes. A surface is a BRDF and the path of a texture or None."""

    def __init__(self):
        self.positions, self.normals, self.uvs, self.faces = [], [], [], []
        self.surfaces, self.surface_of_face = [], []

    def add_face(self, corners, surface):
        if surface not in self.surfaces:
            self.surfaces.append(surface)
        self.faces.append(corners)
        self.surface_of_face.append(self.surfaces.index(surface))


class GrfReader:
    """The placed meshes and the lights of a file."""

    def __init__(self, path):
        # A BRDF is a keyword and parameters as pairs, or a tuple of BRDFs for a sum.
        self.scope = {}  # name: BRDF or Mesh
        self.meshes = []  # (Mesh, its matrix in Blender's axes)
        self.lights = []  # (radiance, corner, edge, edge)
        self.read(path, Matrix())

    def read(self, path, placing):
        outer = getattr(self, "tokens", None), getattr(self, "at", 0)
        self.tokens, self.at = tokens_of(path), 0
        while self.at < len(self.tokens):
            self.block(path.parent, placing)
        self.tokens, self.at = outer

    def peek(self):
        return self.tokens[self.at]

    def next(self):
        self.at += 1
        return self.tokens[self.at - 1]

    def expect(self, *words):
        for word in words:
            found = self.next()
            if found != word:
                raise ValueError(f"expected {word}, found {found}")

    def vector(self, count=3):
        self.expect("(")
        values = Vector([float(self.next()) for _ in range(count)])
        self.expect(")")
        return values

    def block(self, folder, placing):
        word = self.next()
        if word == "def":
            self.definitions(folder, placing)
        elif word == "begin" and self.peek() == "mesh":
            self.place(self.mesh(folder), placing)
        elif word == "use":
            self.place(self.scope[self.next()], placing)
        elif word == "begin":
            self.blocks_until_end(folder, placing)
        elif word == "light":
            self.light(placing)
        elif word == "include":
            self.read(folder / self.next()[1:], placing)
        elif word == "transform":
            placing = placing @ self.transform()
            self.expect("begin")
            self.blocks_until_end(folder, placing)
        else:
            raise ValueError(f"'{word}' is not in the scenes of the benchmark")

    def blocks_until_end(self, folder, placing):
        while self.peek() != "end":
            self.block(folder, placing)
        self.expect("end")

    def place(self, mesh, placing):
        self.meshes.append((mesh, TO_BLENDER @ placing @ TO_BLENDER.inverted()))

    def transform(self):
        """The steps act in the order written."""
        matrix = Matrix()
        while self.peek() != "begin":
            step = self.next()
            v = self.vector()
            if step == "scale":
                matrix = Matrix.Diagonal((*v, 1)) @ matrix
            elif step == "rotation":
                matrix = Euler(v, "XYZ").to_matrix().to_4x4() @ matrix
            else:
                matrix = Matrix.Translation(v) @ matrix
        return matrix

    def definitions(self, folder, placing):
        outer = dict(self.scope)
        self.at -= 1
        while self.peek() == "def":
            self.expect("def")
            name = self.next()
            self.expect("=")
            word = self.next()
            self.scope[name] = self.mesh(folder) if word == "begin" else self.brdf()
        self.expect("begin")
        self.blocks_until_end(folder, placing)
        self.scope = outer

    def brdf(self):
        keyword = self.next()
        if keyword == "combine":
            terms = []
            while self.peek() == "1":
                self.expect("1")
                terms.append(self.scope[self.next()])
            return tuple(terms)
        parameters = []
        while self.tokens[self.at + 1] == "=":
            parameter = self.next()
            self.expect("=")
            parameters.append((parameter, tuple(self.vector()) if self.peek() == "(" else self.value()))
        return keyword, tuple(parameters)

    def value(self):
        """A number, or a word."""
        word = self.next()
        return word if word.isalpha() else float(word)

    def light(self, placing):
        self.expect("begin", "rgb")
        radiance, corner, edge1, edge2 = (self.vector() for _ in range(4))
        self.expect("end")
        turn = TO_BLENDER.to_3x3() @ placing.to_3x3()
        self.lights.append((radiance, TO_BLENDER @ placing @ corner, turn @ edge1, turn @ edge2))

    def attribute(self, folder, surface):
        word = self.next()
        if word == "brdf":
            return self.scope[self.next()], surface[1]
        if word == "texture":
            return surface[0], folder / self.next()[1:]
        raise ValueError(f"'{word}' is no attribute in the scenes of the benchmark")

    def mesh(self, folder):
        self.expect("mesh")
        mesh, surface = Mesh(), (None, None)
        if self.peek().startswith('"'):
            self.next()
        while self.peek() != "begin":
            surface = self.attribute(folder, surface)
        self.expect("begin", "vertexs")
        while self.peek() != "end":
            if self.peek() == "normal":
                self.expect("normal")
                mesh.normals.append(to_blender(self.vector()))
            if self.peek() == "uv":
                self.expect("uv")
                mesh.uvs.append(self.vector(2))
            mesh.positions.append(to_blender(self.vector()))
        self.expect("end", "vertexs", "begin", "faces")
        while self.peek() != "end":
            if self.peek() != "(":
                surface = self.attribute(folder, surface)
                continue
            end = self.tokens.index(")", self.at)
            mesh.add_face([int(corner) for corner in self.tokens[self.at + 1 : end]], surface)
            self.at = end + 1
        self.expect("end", "faces", "end", "mesh")
        return mesh


def colour_of(value):
    return (value, value, value, 1) if isinstance(value, float) else (*value, 1)


def reflectance_at_normal(n, k):
    return ((n - 1) ** 2 + k * k) / ((n + 1) ** 2 + k * k)


def set_colour(nodes, links, socket, colour, tint):
    """Sets the colour of a closure: a value or a socket, times the texture's socket if there is one."""
    if tint is None and isinstance(colour, bpy.types.NodeSocket):
        links.new(colour, socket)
    elif tint is None:
        socket.default_value = colour
    else:
        product = nodes.new("ShaderNodeMixRGB")
        product.blend_type = "MULTIPLY"
        product.inputs["Fac"].default_value = 1
        links.new(tint, product.inputs["Color1"])
        set_colour(nodes, links, product.inputs["Color2"], colour, None)
        links.new(product.outputs[0], socket)


def add_ggx(nodes, parameters):
    """Returns the closure of GGX facets: glossy if they are white, else principled. The fresnel of principled is that
    of a dielectric; for metals it is scaled to go from F0 to 1, and water's is the nearest to Schlick's."""
    f0 = colour_of(parameters.get("F0", 0.0))
    node = nodes.new("ShaderNodeBsdfGlossy" if f0[:3] == (1, 1, 1) else "ShaderNodeBsdfPrincipled")
    node.distribution = "GGX" if parameters.get("scattering") == "single" else "MULTI_GGX"
    node.inputs["Roughness"].default_value = math.sqrt(parameters["alpha"])  # Cycles squares it
    if f0[:3] == (1, 1, 1):
        node.inputs["Color"].default_value = f0
        return node.outputs[0]
    is_metal = any(channel > 0 for channel in f0[:3])
    ior = 1.33 if is_metal else parameters["nreal"]
    node.inputs["Base Color"].default_value = f0
    node.inputs["Metallic"].default_value = 1 if is_metal else 0
    node.inputs["Specular"].default_value = reflectance_at_normal(ior, 0) / 0.08  # Cycles' own scale
    return node.outputs[0]


def add_brdf(nodes, links, brdf, tint):
    """Returns the output socket of a BRDF's closure."""
    if not isinstance(brdf[0], str):
        total = nodes.new("ShaderNodeAddShader")
        for socket, term in zip(total.inputs, brdf, strict=True):
            links.new(add_brdf(nodes, links, term, tint), socket)
        return total.outputs[0]
    keyword, parameters = brdf[0], dict(brdf[1])
    if keyword == "diffuse":
        node = nodes.new("ShaderNodeBsdfDiffuse")
        set_colour(nodes, links, node.inputs["Color"], colour_of(parameters["kd"]), tint)
        return node.outputs[0]
    if keyword == "ggx":
        return add_ggx(nodes, parameters)
    if keyword != "torrance" or parameters["kd"] != 0:
        raise ValueError(f"no node for {keyword}")
    node = nodes.new("ShaderNodeBsdfGlossy")
    node.distribution = "BECKMANN"
    node.inputs["Roughness"].default_value = math.sqrt(parameters["rough"])  # Cycles squares it
    if parameters["nimag"] > 0:
        reflectance = reflectance_at_normal(parameters["nreal"], parameters["nimag"])
        colour = [reflectance * c for c in colour_of(parameters["ks"])[:3]] + [1]
    else:
        fresnel = nodes.new("ShaderNodeFresnel")
        fresnel.inputs["IOR"].default_value = parameters["nreal"]
        colour = fresnel.outputs[0]
    set_colour(nodes, links, node.inputs["Color"], colour, tint)
    return node.outputs[0]


def material_of(surface):
    brdf, texture = surface
    material = bpy.data.materials.new("material")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    tint = None
    if texture is not None:
        image = nodes.new("ShaderNodeTexImage")
        image.image = bpy.data.images.load(str(texture))
        tint = image.outputs["Color"]
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(add_brdf(nodes, links, brdf, tint), output.inputs["Surface"])
    return material


def blender_mesh(source, materials):
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata(source.positions, [], source.faces)
    for material in materials:
        mesh.materials.append(material)
    mesh.polygons.foreach_set("material_index", source.surface_of_face)
    if source.uvs:
        corners = [corner for face in source.faces for corner in face]
        mesh.uv_layers.new().data.foreach_set("uv", [x for corner in corners for x in source.uvs[corner]])
    if source.normals:
        mesh.polygons.foreach_set("use_smooth", [True] * len(source.faces))
        mesh.use_auto_smooth = True
        mesh.normals_split_custom_set_from_vertices(source.normals)
    mesh.update()
    return mesh


def add_meshes(placed_meshes):
    """Adds an object per placed mesh; those of one mesh are its instances."""
    materials, meshes = {}, {}
    for source, matrix in placed_meshes:
        if id(source) not in meshes:
            for surface in source.surfaces:
                if surface not in materials:
                    materials[surface] = material_of(surface)
            meshes[id(source)] = blender_mesh(source, [materials[surface] for surface in source.surfaces])
        placed = bpy.data.objects.new("mesh", meshes[id(source)])
        placed.matrix_world = matrix
        bpy.context.collection.objects.link(placed)


def add_light(radiance, corner, edge1, edge2):
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
    """Adds a quad just behind an area light, since in Cycles those are invisible to the camera and occlude nothing:
    it emits to the camera only, and is black for all other rays."""
    material = bpy.data.materials.new("light")
    material.use_nodes = True
    material.cycles.sample_as_light = False
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    emission, geometry, path = (
        nodes.new("ShaderNode" + name) for name in ("Emission", "NewGeometry", "LightPath")
    )
    emission.inputs["Color"].default_value = (*radiance, 1)
    front, seen = nodes.new("ShaderNodeMath"), nodes.new("ShaderNodeMath")
    front.operation, seen.operation = "SUBTRACT", "MULTIPLY"
    front.inputs[0].default_value = 1
    links.new(geometry.outputs["Backfacing"], front.inputs[1])
    links.new(front.outputs[0], seen.inputs[0])
    links.new(path.outputs["Is Camera Ray"], seen.inputs[1])
    links.new(seen.outputs[0], emission.inputs["Strength"])
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(emission.outputs[0], output.inputs["Surface"])
    corner = corner - 1e-3 * edge1.length * edge1.cross(edge2).normalized()
    quad = bpy.data.meshes.new("light")
    quad.from_pydata([corner, corner + edge1, corner + edge1 + edge2, corner + edge2], [], [(0, 1, 2, 3)])
    quad.materials.append(material)
    bpy.context.collection.objects.link(bpy.data.objects.new("light", quad))


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
    eye, target = to_blender(eye), to_blender(target)
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
    add_meshes(grf.meshes)
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
