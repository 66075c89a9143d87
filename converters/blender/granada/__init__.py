"""Opens and writes scenes of GRF, the format of Granada with a BRDF per face, by the converter `grfconvert`."""
import bpy
from bpy.props import BoolProperty, StringProperty
from bpy_extras.io_utils import ExportHelper, ImportHelper

from . import exporter, grf_text, grfconvert, importer, materials

bl_info = {
    "name": "Granada scenes (GRF, OP)",
    "author": "Granada maintainers",
    "version": (1, 0, 0),
    "blender": (3, 4, 0),
    "location": "File > Import, File > Export, Material properties",
    "description": "Opens and writes GRF scenes, and keeps the exact BRDFs of materials",
    "category": "Import-Export",
}

PROBLEMS = (grfconvert.ConversionError, grf_text.GrfError, OSError)


class GranadaPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    program: StringProperty(
        name="grfconvert", subtype="FILE_PATH", default="",
        description="Path of the converter grfconvert; if empty, it is looked up on PATH")

    def draw(self, _context):
        self.layout.prop(self, "program")


def program_of(context):
    addon = context.preferences.addons.get(__package__)
    return grfconvert.find(bpy.path.abspath(addon.preferences.program) if addon and addon.preferences.program else "")


def reporter(operator):
    """A function that shows a message of a kind of Blender, such as WARNING."""
    return lambda kind, text: operator.report({kind}, text)


class ImportGrf(bpy.types.Operator, ImportHelper):
    """Open a GRF scene, or an OP file with its scene and camera"""
    bl_idname = "import_scene.granada"
    bl_label = "Import Granada"
    bl_options = {"REGISTER", "UNDO"}

    filename_ext = ".grf"
    filter_glob: StringProperty(default="*.grf;*.igrf;*.op", options={"HIDDEN"})

    def execute(self, context):
        try:
            importer.open_scene(context, self.filepath, program_of(context), reporter(self))
        except PROBLEMS as problem:
            self.report({"ERROR"}, str(problem))
            return {"CANCELLED"}
        return {"FINISHED"}


class ExportGrf(bpy.types.Operator, ExportHelper):
    """Write the scene as GRF; materials that were not changed keep their exact BRDFs"""
    bl_idname = "export_scene.granada"
    bl_label = "Export Granada"

    filename_ext = ".grf"
    filter_glob: StringProperty(default="*.grf;*.op", options={"HIDDEN"})
    selected: BoolProperty(name="Selected Only", default=False, description="Write only the selected objects")
    with_options: BoolProperty(
        name="Write OP File", default=False,
        description="Write the camera and the image size to an OP file beside the scene, for bpt")

    def check(self, context):
        return False if self.filepath.lower().endswith(".op") else super().check(context)

    def execute(self, context):
        try:
            path = exporter.save_scene(context, self.filepath, program_of(context),
                                       reporter(self), self.selected, self.with_options)
        except PROBLEMS as problem:
            self.report({"ERROR"}, str(problem))
            return {"CANCELLED"}
        self.report({"INFO"}, f"Wrote {path}")
        return {"FINISHED"}


class CheckMaterial(bpy.types.Operator):
    """Check the GRF text of the material by grfconvert, and show about the same in Blender"""
    bl_idname = "material.granada_check"
    bl_label = "Check and Preview"
    bl_options = {"UNDO"}

    @classmethod
    def poll(cls, context):
        return context.material is not None and materials.SURFACE in context.material

    def execute(self, context):
        try:
            for line in importer.show_text(context.material, program_of(context)):
                self.report({"WARNING"}, line)
        except PROBLEMS as problem:
            self.report({"ERROR"}, str(problem))
            return {"CANCELLED"}
        return {"FINISHED"}


class WriteText(bpy.types.Operator):
    """Give the material a GRF text that says what its nodes say, to edit it"""
    bl_idname = "material.granada_write_text"
    bl_label = "Make GRF Text of Nodes"
    bl_options = {"UNDO"}

    @classmethod
    def poll(cls, context):
        return context.material is not None

    def execute(self, context):
        try:
            surface = materials.surface_of(context.material, reporter(self), materials.required_path)
        except PROBLEMS as problem:
            self.report({"ERROR"}, str(problem))
            return {"CANCELLED"}
        materials.set_text(context.material, surface)
        return {"FINISHED"}


class MaterialPanel(bpy.types.Panel):
    bl_idname = "MATERIAL_PT_granada"
    bl_label = "Granada"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"

    @classmethod
    def poll(cls, context):
        return context.material is not None

    def draw(self, context):
        material, layout = context.material, self.layout
        if materials.SURFACE not in material:
            layout.label(text="No GRF text: the Principled BSDF is written")
            layout.operator(WriteText.bl_idname)
            return
        layout.prop(material, "granada_definitions")
        layout.prop(material, "granada_surface")
        changed = materials.changed_aspects(material)
        if changed:
            layout.label(text="Changed in Blender, written from nodes: " + ", ".join(changed), icon="INFO")
            layout.operator(WriteText.bl_idname)
        layout.operator(CheckMaterial.bl_idname)


def text_property(key, name, description):
    """A text field of one line for a custom property. What is typed applies even if the nodes were changed before."""
    def get(material):
        return " ".join(material.get(key, "").split())

    def set_value(material, text):
        material[key] = text
        materials.keep_shown(material)

    return StringProperty(name=name, description=description, get=get, set=set_value)


def draw_import(menu, _context):
    menu.layout.operator(ImportGrf.bl_idname, text="Granada (.grf/.op)")


def draw_export(menu, _context):
    menu.layout.operator(ExportGrf.bl_idname, text="Granada (.grf/.op)")


CLASSES = (GranadaPreferences, ImportGrf, ExportGrf, CheckMaterial, WriteText, MaterialPanel)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Material.granada_definitions = text_property(
        materials.DEFINITIONS, "Definitions", "Definitions of GRF that the surface names: def NAME = brdf MODEL ...")
    bpy.types.Material.granada_surface = text_property(
        materials.SURFACE, "Surface",
        "Attributes of GRF for the faces of this material: brdf, rgb, pdf, texture, light rgb, opacity. "
        "Exactly this is written unless the nodes are changed")
    bpy.types.TOPBAR_MT_file_import.append(draw_import)
    bpy.types.TOPBAR_MT_file_export.append(draw_export)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(draw_export)
    bpy.types.TOPBAR_MT_file_import.remove(draw_import)
    del bpy.types.Material.granada_surface
    del bpy.types.Material.granada_definitions
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
