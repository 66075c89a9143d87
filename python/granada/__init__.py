"""Granada for Python: scenes with exact, arbitrary surface reflectance.

>>> import granada
>>> brdf = granada.BRDF("ward sx=0.1 sy=0.3")
>>> f = brdf.eval(wi, wo)                       # arrays of shape (..., 3), values in 1/sr
>>> scene = granada.read("model.glb")           # any format that grfconvert reads
>>> scene.write("model.grf")
>>> image = granada.render("scene.op", samples=16, size=(64, 64)).image
"""

from granada._granada import (
    BRDF,
    Diagnostic,
    Error,
    Mesh,
    Progress,
    Render,
    Report,
    Samples,
    Scene,
    Surface,
    __version__,
    check,
    convert,
    models,
    read,
    read_image,
    read_text,
    render,
    write_image,
)

__all__ = [
    "BRDF",
    "Diagnostic",
    "Error",
    "Mesh",
    "Progress",
    "Render",
    "Report",
    "Samples",
    "Scene",
    "Surface",
    "__version__",
    "check",
    "convert",
    "models",
    "read",
    "read_image",
    "read_text",
    "render",
    "write_image",
]

# In messages and in help, names are those that programs use.
for _name in __all__:
    if isinstance(globals()[_name], type):
        globals()[_name].__module__ = "granada"
