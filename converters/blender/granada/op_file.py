"""OP files, the render options of `bpt`: the camera becomes Blender's, and all other lines are kept."""
import json
import os
import re
from math import atan, degrees, radians

import bpy
from mathutils import Matrix, Vector

from .grf_text import number
from .transforms import flattened, is_close, point_to_blender, point_to_grf

CAMERA_KEYS = ("BPT_Viewer", "BPT_VLook", "BPT_Up", "BPT_FieldOfView", "BPT_Image_Resolution")
PATH_KEYS = ("BPT_Scene", "BPT_EM_Background", "BPT_Output_Image", "BPT_Pdf_Factors_File", "BPT_Checkpoint")


class Options:
    """The lines of an OP file. Keys are compared without regard to case."""

    def __init__(self, text, folder):
        self.lines = text.splitlines()
        self.folder = folder

    @staticmethod
    def split(line):
        """The key and the values of a line, without its comment."""
        line = re.sub(r'(^|\s)(#|//).*', "", line).strip()
        key, _, values = line.partition(" ") if " " in line else line.partition("\t")
        return key, values.strip()

    def values(self, key):
        for line in self.lines:
            found, values = self.split(line)
            if found.lower() == key.lower():
                return values
        return ""

    def numbers(self, key):
        return [float(word) for word in re.findall(r"[-+.\deE]+", self.values(key))]

    def path_of(self, key):
        value = self.values(key).strip("\"")
        return os.path.normpath(os.path.join(self.folder, value.replace("\\", "/"))) if value else ""

    def set(self, key, values):
        for place, line in enumerate(self.lines):
            if self.split(line)[0].lower() == key.lower():
                if self.split(line)[1] != values:
                    self.lines[place] = f"{key} {values}"
                return
        self.lines.append(f"{key} {values}")

    def move_to(self, folder):
        """Keeps paths that are relative to the folder of the file right in another folder."""
        for key in PATH_KEYS:
            value = self.values(key).strip("\"")
            if value and not os.path.isabs(value) and os.path.realpath(folder) != os.path.realpath(self.folder):
                self.set(key, '"' + os.path.relpath(self.path_of(key), folder).replace("\\", "/") + '"')
        self.folder = folder

    def text(self):
        return "\n".join(self.lines) + "\n"


def read(path):
    with open(path, encoding="utf-8") as file:
        return Options(file.read(), os.path.dirname(os.path.abspath(path)))


def make_camera(context, options):
    scene = context.scene
    scene["grf_op"] = options.text()
    scene["grf_op_folder"] = options.folder
    resolution = options.numbers("BPT_Image_Resolution")
    if len(resolution) == 2:
        scene.render.resolution_x, scene.render.resolution_y = (int(x) for x in resolution)
        scene.render.resolution_percentage = 100
    viewer, look = options.numbers("BPT_Viewer"), options.numbers("BPT_VLook")
    if len(viewer) != 3 or len(look) != 3:
        return
    data = bpy.data.cameras.new("camera")
    obj = bpy.data.objects.new("camera", data)
    scene.collection.objects.link(obj)
    scene.camera = obj
    eye, target = Vector(point_to_blender(viewer)), Vector(point_to_blender(look))
    up = Vector(point_to_blender((options.numbers("BPT_Up") or [0, 1, 0])[:3]))
    back = (eye - target).normalized()
    right = up.cross(back)
    if right.length < 1e-6 * up.length:
        right = Vector(point_to_blender((0, 0, 1))).cross(back)
    right.normalize()
    rotation = Matrix((right, back.cross(right), back)).transposed().to_4x4()
    obj.matrix_world = Matrix.Translation(eye) @ rotation
    data.sensor_fit = "VERTICAL"
    data.angle = radians((options.numbers("BPT_FieldOfView") or [45])[0])
    distance = (eye - target).length
    data.clip_start, data.clip_end = distance / 1000, max(1000, 100 * distance)
    context.view_layer.update()
    obj["grf_camera"] = json.dumps({"matrix": flattened(obj.matrix_world), "angle": vertical_angle(scene, data),
                                    "distance": distance})


def vertical_angle(scene, camera):
    width, height = scene.render.resolution_x, scene.render.resolution_y
    if camera.sensor_fit == "VERTICAL":
        return 2 * atan(camera.sensor_height / 2 / camera.lens)
    half = camera.sensor_width / 2 / camera.lens
    return 2 * atan(half if camera.sensor_fit == "AUTO" and height > width else half * height / width)


def write(context, path, scene_path, report):
    """Writes the camera and the options that the scene was opened with beside a scene."""
    scene, folder = context.scene, os.path.dirname(os.path.abspath(path))
    options = Options(scene.get("grf_op", ""), scene.get("grf_op_folder", folder))
    options.move_to(folder)
    name = os.path.relpath(scene_path, folder).replace("\\", "/")
    options.set("BPT_Scene", f'"{name}"' if " " in name else name)
    scale = scene.render.resolution_percentage / 100
    width, height = (int(size * scale) for size in (scene.render.resolution_x, scene.render.resolution_y))
    options.set("BPT_Image_Resolution", f"{width} {height}")
    camera = scene.camera
    if camera is None:
        report("WARNING", "the scene has no camera: bpt frames the scene")
    elif camera.data.type != "PERSP":
        report("WARNING", "the camera was not written: GRF's are perspective")
    else:
        set_camera(scene, camera, options)
    with open(path, "w", encoding="utf-8") as file:
        file.write(options.text())


def set_camera(scene, camera, options):
    angle = vertical_angle(scene, camera.data)
    kept = json.loads(camera.get("grf_camera", "{}"))
    if not kept or not is_close(kept["matrix"], flattened(camera.matrix_world)):
        eye = camera.matrix_world.to_translation()
        rotation = camera.matrix_world.to_quaternion()
        target = eye + rotation @ Vector((0, 0, -kept.get("distance", 1)))
        for key, value in (("BPT_Viewer", eye), ("BPT_VLook", target), ("BPT_Up", rotation @ Vector((0, 1, 0)))):
            options.set(key, " ".join(number(x) for x in point_to_grf(value)))
    if not kept or abs(kept["angle"] - angle) > 1e-6:
        options.set("BPT_FieldOfView", number(degrees(angle)))
