"""Reads the glTF files that `grfconvert` writes: the text and the lists of a scene of GRF in their extras."""
import array
import json
import os
import sys
from urllib.parse import unquote

COMPONENTS = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
SIZES = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
UNSIGNED_INT = "I" if array.array("I").itemsize == 4 else "L"


class GltfFile:
    def __init__(self, path):
        self.folder = os.path.dirname(path)
        with open(path, encoding="utf-8") as file:
            self.json = json.load(file)
        self.buffers = []
        for buffer in self.json.get("buffers", []):
            with open(os.path.join(self.folder, unquote(buffer["uri"])), "rb") as file:
                self.buffers.append(file.read())
        self.grf = self.json["extras"]["grf"]

    def accessor(self, index):
        """The numbers of an accessor in one array."""
        accessor = self.json["accessors"][index]
        code = COMPONENTS[accessor["componentType"]]
        numbers = array.array(UNSIGNED_INT if code == "I" else code)
        count = accessor["count"] * SIZES[accessor["type"]]
        if "bufferView" not in accessor:
            return array.array(numbers.typecode, [0] * count)
        view = self.json["bufferViews"][accessor["bufferView"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        element = numbers.itemsize * SIZES[accessor["type"]]
        stride = view.get("byteStride", element)
        data = self.buffers[view["buffer"]]
        if stride == element:
            numbers.frombytes(data[start:start + element * accessor["count"]])
        else:
            for i in range(accessor["count"]):
                numbers.frombytes(data[start + i * stride:start + i * stride + element])
        if sys.byteorder == "big":
            numbers.byteswap()
        return numbers

    def list(self, lists, name):
        return self.accessor(lists[name]) if name in lists else None

    def image_path(self, material):
        texture = material.get("pbrMetallicRoughness", {}).get("baseColorTexture")
        if texture is None:
            return None
        image = self.json["images"][self.json["textures"][texture["index"]]["source"]]
        return os.path.normpath(os.path.join(self.folder, unquote(image["uri"])))

    def materials_of_surfaces(self, mesh, sizes, corners, surfaces):
        """The glTF material of each surface of a mesh, as indices: primitives have the triangles of their faces in the
        order of these, and begin in the order in which faces need them."""
        primitives = [(primitive["material"], self.accessor(primitive["indices"]))
                      for primitive in self.json["meshes"][mesh]["primitives"]]
        places = [0] * len(primitives)
        started, found, first = 0, {}, 0
        for face, size in enumerate(sizes):
            surface = surfaces[face] if surfaces else 0
            face_corners = set(corners[first:first + size])
            first += size
            for i in range(min(started + 1, len(primitives))):
                material, indices = primitives[i]
                if found.get(surface, material) != material:
                    continue
                end = places[i] + 3 * (size - 2)
                if end <= len(indices) and face_corners.issuperset(indices[places[i]:end]):
                    places[i] = end
                    found.setdefault(surface, material)
                    started = max(started, i + 1)
                    break
        return found
