"""The shaders of the live pages: the GLSL of a model's formula, as bpt prints it, becomes GLSL ES 3.00 for WebGL 2.

glslang compiles the text and SPIRV-Cross writes it again, with the conversions that GLSL ES wants to be explicit.
"""

import hashlib
import json
import pathlib
import re
import subprocess
import tempfile

LIVE = pathlib.Path(__file__).resolve().parent.parent / "live"
REFLECTANCE = LIVE.parent.parent / "renderer/reflectance"


def arguments_of(text, function):
    """Returns the names of a function's parameters."""
    found = re.search(rf"\bvec3 {function}\(([^)]*)\) *{{", text)
    return [parameter.split()[-1] for parameter in found[1].split(",")] if found else None


def call_arguments(text, keyword):
    """Returns the arguments with which `brdf_value` calls the model, by the names of the model's parameters."""
    call = re.search(rf"return {keyword}\((.*)\); }}", text)[1]
    return dict(zip(arguments_of(text, keyword), re.split(r", (?![^(]*\))", call)))


def specular_function(text, keyword):
    """Returns the delta part of a model as the function that lit_surface.glsl calls."""
    names = arguments_of(text, f"{keyword}_specular")
    if names:
        values = call_arguments(text, keyword)
        value = f"{keyword}_specular({', '.join(values[name] for name in names)})"
    else:
        # The ideal mirror has no function for what is its only parameter.
        value = "brdf_parameters[0]" if keyword == "specular" else "vec3(0.0)"
    return f"vec3 brdf_specular(vec3 u) {{ return {value}; }}\n"


def to_es(text):
    """Returns a fragment shader of GLSL 3.30 in GLSL ES 3.00."""
    with tempfile.TemporaryDirectory() as folder:
        source, binary = f"{folder}/shader.frag", f"{folder}/shader.spv"
        pathlib.Path(source).write_text("#version 330 core\n" + text)
        made = subprocess.run(["glslangValidator", "-G", "--aml", source, "-o", binary], capture_output=True, text=True)
        if made.returncode:
            raise RuntimeError(f"glslangValidator: {made.stdout}")
        return subprocess.run(["spirv-cross", binary, "--version", "300", "--es"], check=True, capture_output=True,
                              text=True).stdout


def sources(brdf, keyword):
    files = [REFLECTANCE / "studio.glsl", LIVE / "sphere_before.glsl", REFLECTANCE / "lit_surface.glsl",
             LIVE / "sphere.frag"]
    sphere = [brdf, specular_function(brdf, keyword), *map(pathlib.Path.read_text, files)]
    return {"evaluator": brdf + (LIVE / "evaluator.frag").read_text(), "sphere": "".join(sphere)}


def write_model(folder, info, brdf):
    """Writes the script that a model's page loads, unless it is there and made from the same."""
    texts = sources(brdf, info["keyword"])
    digest = hashlib.sha256(json.dumps([info, texts]).encode()).hexdigest()
    path = folder / f"{info['keyword']}.js"
    if path.exists() and path.read_text().startswith(f"// {digest}"):
        return
    model = {"keyword": info["keyword"], "example": info["example"], "parameters": info["parameters"]}
    model.update((name, to_es(text)) for name, text in texts.items())
    folder.mkdir(parents=True, exist_ok=True)
    path.write_text(f"// {digest}\nconst brdfModel = {json.dumps(model, indent=1)};\n")
