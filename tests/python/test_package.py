"""The package as such: its names, its types and its documentation."""

import ast
import importlib.resources
import inspect
import re

import granada


def stubs():
    text = importlib.resources.files("granada").joinpath("__init__.pyi").read_text()
    return [node for node in ast.parse(text).body if not getattr(node, "name", "_").startswith("_")]


def members(node):
    return {child.name for child in node.body if isinstance(child, ast.FunctionDef)} | {
        child.target.id for child in node.body if isinstance(child, ast.AnnAssign)
    }


def parameters_of(function):
    """The names of parameters by the signature in pybind11's documentation."""
    arguments = re.match(r"\w+\((.*)\) -> ", function.__doc__.splitlines()[0]).group(1)
    names = re.findall(r"(?:^|, )\*{0,2}(\w+)(?::|$|,)", re.sub(r"\[[^\]]*\]", "", arguments))
    return [name for name in names if name not in ("self", "kwargs")]


def test_has_a_version():
    assert re.fullmatch(r"\d+\.\d+\.\d+", granada.__version__)


def test_stubs_name_everything():
    named = {node.name for node in stubs()} | {"__version__"}
    assert named == set(granada.__all__)
    assert importlib.resources.files("granada").joinpath("py.typed").is_file()
    for node in stubs():
        value = getattr(granada, node.name)
        assert value.__module__ == "granada" or not inspect.isclass(value)
        if isinstance(node, ast.ClassDef):
            own = {name for name in vars(value) if not name.startswith("_")}
            assert {name for name in members(node) if not name.startswith("_")} == own, node.name


def test_stubs_have_the_parameters():
    for node in stubs():
        functions = [(node, getattr(granada, node.name))] if isinstance(node, ast.FunctionDef) else []
        if isinstance(node, ast.ClassDef):
            functions = [
                (child, getattr(getattr(granada, node.name), child.name))
                for child in node.body
                if isinstance(child, ast.FunctionDef) and not child.decorator_list and child.name != "__bool__"
            ]
        for stub, function in functions:
            expected = [argument.arg for argument in stub.args.args if argument.arg != "self"]
            assert parameters_of(function) == expected, stub.name


def test_everything_is_documented():
    for name in granada.__all__:
        value = getattr(granada, name)
        if name == "__version__":
            continue
        assert len(inspect.getdoc(value)) > 20, name
        if inspect.isclass(value) and name != "Error":
            for member in (member for member in vars(value) if not member.startswith("_")):
                assert inspect.getdoc(getattr(value, member)), f"{name}.{member}"
