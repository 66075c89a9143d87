"""Materials: the exact text of GRF in custom properties, and nodes that show about the same in Blender.

What the nodes said when they were made is kept beside the text, one value per aspect. Where an aspect of the nodes
still says that, the text is written; where it was changed, the nodes are."""
import json
import os
from math import pi

import bpy

from .grf_text import GrfError, Surface, Parser, identifier_of, read_surface, short_number, short_vector, tokens_of

SURFACE, DEFINITIONS, SHOWN = "grf_surface", "grf_definitions", "grf_shown"
ASPECTS = ("brdf", "texture", "light", "opacity")
BSDF_INPUTS = ("Base Color", "Metallic", "Specular", "Roughness", "Anisotropic", "Anisotropic Rotation", "Sheen",
               "Clearcoat", "Clearcoat Roughness", "IOR", "Transmission")


def principled_of(material):
    if not material.use_nodes or not material.node_tree:
        return None
    output = material.node_tree.get_output_node("ALL")
    if output is None or not output.inputs["Surface"].is_linked:
        return None
    return output.inputs["Surface"].links[0].from_node


def plain(value):
    """A value of a socket as JSON has it."""
    if hasattr(value, "__len__") and not isinstance(value, str):
        return [float(x) for x in value]
    return value if isinstance(value, (str, bool, int)) else float(value)


def colour_and_image(socket):
    """The colour of a socket as a factor, and the image that it is multiplied by. The last value is false if nodes are
    between that are not read."""
    if not socket.is_linked:
        return list(socket.default_value)[:3], None, True
    node = socket.links[0].from_node
    if node.type == "TEX_IMAGE":
        return [1.0, 1.0, 1.0], node.image, True
    if node.type == "MIX_RGB" and node.blend_type == "MULTIPLY" and node.inputs[0].default_value == 1:
        factors = [colour_and_image(node.inputs[i]) for i in (1, 2)]
        if sum(image is not None for _, image, _ in factors) <= 1:
            product = [a * b for a, b in zip(factors[0][0], factors[1][0])]
            return product, factors[0][1] or factors[1][1], factors[0][2] and factors[1][2]
    if node.type == "RGB":
        return list(node.outputs[0].default_value)[:3], None, True
    return list(socket.default_value)[:3], None, False


def image_path(image):
    if not image or not image.filepath:
        return ""
    return os.path.normpath(bpy.path.abspath(image.filepath, library=image.library)).replace("\\", "/")


def required_path(image):
    path = image_path(image)
    if not path:
        raise GrfError(f"the image '{image.name}' has no file yet: save it first")
    return path


def aspects_of(material):
    """What the nodes of a material say: a value of JSON for the BRDF, the texture, the emission and the opacity."""
    node = principled_of(material)
    said = {"brdf": None, "texture": None, "light": None, "opacity": None, "readable": True}
    if node is None:
        said["brdf"] = {"Base Color": [float(x) for x in material.diffuse_color[:3]],
                        "Metallic": float(material.metallic), "Roughness": float(material.roughness)}
    elif node.type == "EMISSION":
        colour, _, said["readable"] = colour_and_image(node.inputs["Color"])
        said["light"] = [x * node.inputs["Strength"].default_value for x in colour]
    elif node.type in ("BSDF_PRINCIPLED", "BSDF_DIFFUSE"):
        base = node.inputs["Base Color" if node.type == "BSDF_PRINCIPLED" else "Color"]
        colour, image, said["readable"] = colour_and_image(base)
        said["brdf"] = {"Base Color": colour}
        if image:
            said["texture"] = image_path(image) or image.name
        if node.type == "BSDF_PRINCIPLED":
            read_principled(node, material, said)
    else:
        said["readable"] = False
        said["brdf"] = {"Base Color": [float(x) for x in material.diffuse_color[:3]]}
    return said


def read_principled(node, material, said):
    for name in BSDF_INPUTS[1:]:
        said["brdf"][name] = plain(node.inputs[name].default_value)
        said["readable"] &= not node.inputs[name].is_linked
    emission, _, readable = colour_and_image(node.inputs["Emission"])
    said["readable"] &= readable
    emission = [x * node.inputs["Emission Strength"].default_value for x in emission]
    if any(emission):
        said["light"] = emission
    alpha = node.inputs["Alpha"]
    if alpha.is_linked:
        mask = material.blend_method == "CLIP"
        said["opacity"] = ["mask", float(material.alpha_threshold)] if mask else ["blend", 1.0]
    elif alpha.default_value != 1:
        said["opacity"] = ["", float(alpha.default_value)]


def principled_brdf(said):
    """The model `gltf` of GRF for what a Principled BSDF says, as tokens."""
    colour = [min(max(x, 0), 1) for x in said["Base Color"]]
    metallic, specular = said.get("Metallic", 0), said.get("Specular", 0)
    coat, sheen = said.get("Clearcoat", 0), said.get("Sheen", 0)
    colour_tokens = tokens_of(short_vector(colour))
    if metallic == 0 and specular == 0 and coat == 0 and sheen == 0:
        return ["diffuse", "kd", "=", *colour_tokens]
    tokens = ["gltf", "baseColor", "=", *colour_tokens]

    def add(name, value, lowest, highest, default):
        value = min(max(value, lowest), highest)
        if value != default:
            tokens.extend([name, "=", short_number(value)])

    add("metallic", metallic, 0, 1, 0)
    add("roughness", said.get("Roughness", 0.5), 0, 1, 0.5)
    if specular == 0:
        add("specular", 0, 0, 1, 1)
    else:
        # Blender's reflectance at normal incidence is 0.08 times the value; that of the index 1.5 is 0.04.
        add("specularColor", 2 * specular, 0, 25, 1)
    add("anisotropy", said.get("Anisotropic", 0), 0, 1, 0)
    if said.get("Anisotropic", 0):
        turn = said.get("Anisotropic Rotation", 0) % 1
        add("rotation", 2 * pi * (turn if turn <= 0.5 else turn - 1), -3.1415926, 3.1415926, 0)
    add("clearcoat", coat, 0, 1, 0)
    if coat:
        add("coatRoughness", said.get("Clearcoat Roughness", 0), 0, 1, 0)
    add("sheenColor", sheen, 0, 1, 0)
    return tokens


def set_text(material, surface):
    """Keeps the text of a surface, and what the nodes say now as what was made of it."""
    material[DEFINITIONS] = surface.definitions_text()
    material[SURFACE] = surface.attributes_text()
    keep_shown(material)


def keep_shown(material):
    """Takes what the nodes say now for what the text looks like."""
    material[SHOWN] = json.dumps(aspects_of(material))


def changed_aspects(material):
    said, shown = aspects_of(material), json.loads(material.get(SHOWN, "{}"))
    return [aspect for aspect in ASPECTS if aspect not in shown or shown[aspect] != said[aspect]]


def surface_of(material, report, save_image):
    """The surface to write for a material: its text where the nodes are as they were, else what they say."""
    said = aspects_of(material)
    text = material.get(SURFACE)
    changed = ASPECTS if text is None else changed_aspects(material)
    if text is None:
        surface = Surface()
    else:
        try:
            surface = read_surface(material.get(DEFINITIONS, ""), text)
        except GrfError as problem:
            raise GrfError(f"the GRF text of the material '{material.name}' cannot be read: {problem}") from problem
    if changed and not said["readable"]:
        report("WARNING", f"the material '{material.name}' has nodes that GRF cannot represent: "
                          "plain values are written")
    for aspect in changed:
        write_aspect(surface, aspect, said[aspect], material, save_image)
    return needed(surface) if changed else surface


def needed(surface):
    """A surface without definitions that it no longer names."""
    parser = Parser("")
    parser.scope = [surface.definitions]
    return parser.surface(surface.attributes)


def write_aspect(surface, aspect, said, material, save_image):
    attributes = surface.attributes
    attributes.pop(aspect, None)
    if aspect == "brdf":
        attributes.pop("pdf", None)
        attributes.pop("rgb", None)
        surface.definitions = needed(surface).definitions
        if said:
            name = identifier_of(material.name)
            while name in surface.definitions:
                name += "_"
            surface.definitions[name] = ["brdf", *principled_brdf(said)]
            attributes["brdf"] = [name]
    elif said and aspect == "texture":
        node_image = next((image for image in bpy.data.images if (image_path(image) or image.name) == said), None)
        attributes["texture"] = [f'"{save_image(node_image)}"']
    elif said and aspect == "light":
        attributes["light"] = ["rgb", *tokens_of(short_vector(said))]
    elif said and aspect == "opacity":
        attributes["opacity"] = [word for word in (said[0], short_number(said[1])) if word]


# Nodes that show about what the text says, by the material of the glTF file.

def show(material, gltf, path):
    """Makes the nodes of a material from one of glTF and the path of its image."""
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    output.location = (300, 0)
    extensions = gltf.get("extensions", {})
    strength = extensions.get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1)
    emission = gltf.get("emissiveFactor", [0, 0, 0])
    factors = gltf.get("pbrMetallicRoughness", {})
    base = factors.get("baseColorFactor", [1, 1, 1, 1])
    if any(emission) and not any(base[:3]):
        node = tree.nodes.new("ShaderNodeEmission")
        node.inputs["Color"].default_value = (*emission, 1)
        node.inputs["Strength"].default_value = strength
        tree.links.new(node.outputs["Emission"], output.inputs["Surface"])
        return
    node = tree.nodes.new("ShaderNodeBsdfPrincipled")
    tree.links.new(node.outputs["BSDF"], output.inputs["Surface"])
    set_principled(node, factors, extensions)
    node.inputs["Emission"].default_value = (*emission, 1)
    node.inputs["Emission Strength"].default_value = strength if any(emission) else 1
    mode = gltf.get("alphaMode", "OPAQUE")
    material.blend_method = {"MASK": "CLIP", "BLEND": "BLEND"}.get(mode, "OPAQUE")
    material.shadow_method = "HASHED" if mode != "OPAQUE" else "OPAQUE"
    material.alpha_threshold = gltf.get("alphaCutoff", 0.5)
    node.inputs["Alpha"].default_value = base[3]
    material.diffuse_color = (*base[:3], 1)
    if path:
        add_image(tree, node, path, base, mode)


def set_principled(node, factors, extensions):
    def extension(name, value, default):
        return extensions.get("KHR_materials_" + name, {}).get(value, default)

    inputs = node.inputs
    inputs["Base Color"].default_value = (*factors.get("baseColorFactor", [1, 1, 1, 1])[:3], 1)
    inputs["Metallic"].default_value = factors.get("metallicFactor", 1)
    inputs["Roughness"].default_value = factors.get("roughnessFactor", 1)
    ior = extension("ior", "ior", 1.5)
    colour = extension("specular", "specularColorFactor", [1, 1, 1])
    reflectance = ((ior - 1) / (ior + 1)) ** 2 * extension("specular", "specularFactor", 1) * sum(colour) / 3
    inputs["Specular"].default_value = reflectance / 0.08 if ior != 1.5 else reflectance / 0.04 * 0.5
    inputs["IOR"].default_value = max(ior, 1)
    inputs["Anisotropic"].default_value = extension("anisotropy", "anisotropyStrength", 0)
    inputs["Anisotropic Rotation"].default_value = extension("anisotropy", "anisotropyRotation", 0) / (2 * pi) % 1
    inputs["Clearcoat"].default_value = extension("clearcoat", "clearcoatFactor", 0)
    inputs["Clearcoat Roughness"].default_value = extension("clearcoat", "clearcoatRoughnessFactor", 0)
    inputs["Sheen"].default_value = sum(extension("sheen", "sheenColorFactor", [0, 0, 0])) / 3


def add_image(tree, node, path, base, mode):
    texture = tree.nodes.new("ShaderNodeTexImage")
    texture.location = (-600, 0)
    if os.path.exists(path):
        texture.image = bpy.data.images.load(path, check_existing=True)
    else:
        texture.image = bpy.data.images.new(os.path.basename(path), 1, 1)
        texture.image.source = "FILE"
        texture.image.filepath = path
    colour = texture.outputs["Color"]
    if any(factor != 1 for factor in base[:3]):
        product = tree.nodes.new("ShaderNodeMixRGB")
        product.location = (-250, 0)
        product.blend_type = "MULTIPLY"
        product.inputs[0].default_value = 1
        product.inputs[2].default_value = (*base[:3], 1)
        tree.links.new(colour, product.inputs[1])
        colour = product.outputs[0]
    tree.links.new(colour, node.inputs["Base Color"])
    if mode == "MASK" or (mode == "BLEND" and base[3] == 1):
        tree.links.new(texture.outputs["Alpha"], node.inputs["Alpha"])
