"""Reads and writes the part of GRF text that the add-on needs.

`grfconvert` writes the text that is read here, so it has no errors, no includes, and references that are defined: the
grammar is that of grf/FORMAT.md without its tolerance."""
import os
import re
import struct
from dataclasses import dataclass, field

TOKEN = re.compile(
    r'//[^\n]*|"(?P<string>[^"\n]*)"|\u201c(?P<quoted>[^\u201d\n]*)\u201d|(?P<sign>[(),=])|(?P<word>[^\s(),="]+)')
ATTRIBUTES = ("rgb", "brdf", "pdf", "texture", "light", "opacity")
RESERVED = ("begin", "end", "def", "none", "use", "true", "false")
IDENTIFIER = re.compile(r"[A-Za-z_$][A-Za-z0-9_$]*\Z")


class GrfError(ValueError):
    """A text that is no GRF, or that refers to what is not defined."""


def tokens_of(text):
    tokens = []
    for match in TOKEN.finditer(text):
        if match["string"] is not None:
            tokens.append('"' + match["string"] + '"')
        elif match["quoted"] is not None:
            tokens.append('"' + match["quoted"] + '"')
        elif match["sign"] or match["word"]:
            tokens.append(match["sign"] or match["word"])
    return tokens


def first_comment(text):
    """The comment with which a text begins."""
    return re.match(r"(?:[ \t]*//[^\n]*\n)*", text)[0].rstrip("\n")


def text_of(tokens):
    text = ""
    for token in tokens:
        tight = not text or token in "),=" or text[-1] in "(="
        text += token if tight else " " + token
    return text


def with_paths(tokens, path_of):
    """Replaces file names, which are the only strings of surfaces."""
    return [f'"{path_of(token[1:-1])}"' if token.startswith('"') else token for token in tokens]


def absolute_in(folder):
    return lambda name: os.path.normpath(os.path.join(folder, name.replace("\\", "/"))).replace("\\", "/")


def relative_to(folder):
    def relative(name):
        try:
            return os.path.relpath(name, folder).replace("\\", "/")
        except ValueError:  # another drive of Windows
            return name
    return relative


def identifier_of(text):
    """An identifier for any text: characters that it cannot have are written as $hex$."""
    if not text:
        return "$$"
    escape_first = text[0].isdigit() or text.lower() in RESERVED
    identifier = ""
    for i, byte in enumerate(text.encode()):
        c = chr(byte)
        plain = byte < 128 and (c.isalnum() or c == "_") and not (i == 0 and escape_first)
        identifier += c if plain else f"${byte:02x}$"
    return identifier


def text_from_identifier(identifier):
    plain = re.sub(r"\$([0-9a-fA-F]{2})\$", lambda match: chr(int(match[1], 16)), identifier)
    return plain.replace("$$", "").encode("latin-1", "replace").decode(errors="replace")


def number(value):
    """Digits enough for any float; `grfconvert` writes the fewest."""
    return f"{value:.9g}"


def vector(values):
    return "(" + ", ".join(number(value) for value in values) + ")"


def short_number(value):
    """The fewest digits that give the same float, for texts that people edit."""
    single = struct.pack("f", value)
    return next((text for text in (f"{value:.{digits}g}" for digits in range(6, 9))
                 if struct.pack("f", float(text)) == single), number(value))


def short_vector(values):
    return "(" + ", ".join(short_number(value) for value in values) + ")"


@dataclass
class Surface:
    """What faces share: tokens of each attribute, and the definitions that these name, in an order that may be read."""
    attributes: dict = field(default_factory=dict)
    definitions: dict = field(default_factory=dict)

    def definitions_text(self):
        return "\n".join(f"def {name} = {text_of(body)}" for name, body in self.definitions.items())

    def attributes_text(self):
        return "\n".join(text_of([kind] + tokens) for kind, tokens in self.attributes.items())

    def with_paths(self, path_of):
        return Surface({kind: with_paths(tokens, path_of) for kind, tokens in self.attributes.items()},
                       {name: with_paths(body, path_of) for name, body in self.definitions.items()})

    def is_light(self):
        return list(self.attributes) == ["light"]


@dataclass
class Mesh:
    name: str
    surfaces: list  # one for each stub triangle
    kind: str = "mesh"  # or "mesh light"
    definition: str = ""
    index: int = 0  # its place among the lists of meshes
    used: bool = False


@dataclass
class Light:
    corner: list
    edge1: list
    edge2: list
    surface: Surface
    text: str
    index: int = 0


@dataclass
class Use:
    mesh: Mesh


@dataclass
class Transform:
    steps: list  # (kind, [x, y, z])
    text: str
    body: list


@dataclass
class Scene:
    blocks: list
    meshes: list  # Mesh and Light in the order of the text
    params: list
    unused: Surface  # definitions that nothing refers to


class Parser:
    def __init__(self, text):
        self.tokens = tokens_of(text)
        self.at = 0
        self.scope = [{}]
        self.meshes = []
        self.params = []
        self.all_definitions = {}
        self.referred = set()

    def peek(self, ahead=0):
        place = self.at + ahead
        return self.tokens[place] if place < len(self.tokens) else ""

    def word(self, ahead=0):
        return self.peek(ahead).lower()

    def next(self):
        self.at += 1
        if self.at > len(self.tokens):
            raise GrfError("the text ends too early")
        return self.tokens[self.at - 1]

    def expect(self, *words):
        for word in words:
            found = self.next()
            if found.lower() != word:
                raise GrfError(f"'{word}' was expected in place of '{found}'")

    def tuple(self):
        start = self.at
        self.expect("(")
        while self.next() != ")":
            pass
        return self.tokens[start:self.at]

    def numbers(self):
        return [float(token.rstrip("fFdD")) for token in self.tuple() if token not in "(),"]

    def scene(self):
        blocks = self.blocks()
        if self.at != len(self.tokens):
            raise GrfError(f"'{self.peek()}' is no block")
        unused = {name: body for name, body in self.all_definitions.items() if name not in self.referred}
        needed = {}
        for name, body in unused.items():
            needed.update(self.closure(body, self.all_definitions))
            needed[name] = body
        return Scene(blocks, self.meshes, self.params, Surface({}, needed))

    def blocks(self):
        blocks = []
        while self.peek() and self.word() != "end":
            blocks += self.block()
        return blocks

    def block(self):
        first, second = self.word(), self.word(1)
        if first == "def":
            return self.definitions_and_body()
        if first == "begin":
            return [self.mesh()]
        if first == "mesh" and second == "light":
            return [self.mesh_light()]
        if first == "light":
            return [self.light()]
        if first == "transform":
            return [self.transform()]
        if first == "use":
            self.next()
            mesh = self.find(self.next())
            mesh.used = True
            return [Use(mesh)]
        if first == "params":
            start = self.at
            while self.next().lower() != "end":
                pass
            self.params.append(text_of(self.tokens[start:self.at]))
            return []
        raise GrfError(f"'{self.peek()}' is no block")

    def find(self, name):
        for scope in reversed(self.scope):
            if name in scope:
                return scope[name]
        raise GrfError(f"'{name}' is not defined")

    def visible(self):
        names = {}
        for scope in self.scope:
            names.update(scope)
        return names

    def definitions_and_body(self):
        self.scope.append({})
        self.definitions()
        self.expect("begin")
        body = self.blocks()
        self.expect("end")
        self.scope.pop()
        return body

    def definitions(self):
        while self.word() == "def" or self.peek(1) == "=":
            if self.word() == "def":
                self.next()
            name = self.next()
            self.expect("=")
            if self.word() == "begin":
                body = self.mesh()
                body.definition = name
            else:
                start = self.at
                kind = self.next().lower()
                self.attribute(kind)
                body = self.tokens[start:self.at]
                self.all_definitions[name] = body
            self.scope[-1][name] = body

    def attribute(self, kind):
        """Passes the tokens of an attribute after its keyword."""
        if self.word() == "none":
            return [self.next()]
        start = self.at
        if kind in ("rgb", "light"):
            if kind == "light":
                self.expect("rgb")
            self.tuple() if self.peek() == "(" else self.next()
        elif kind == "texture":
            self.next()
        elif kind == "opacity":
            if self.word() in ("mask", "blend"):
                self.next()
            self.next()
        elif self.peek().startswith('"'):
            self.next()
        elif self.next().lower() == "combine":
            while self.is_number(self.peek()) and self.word(1) not in ("", "(", ","):
                self.at += 2
                if self.peek() == ",":
                    self.next()
        else:
            if self.peek().startswith('"'):
                self.next()
            while self.peek(1) == "=" and self.peek() not in ATTRIBUTES:
                self.at += 2
                self.tuple() if self.peek() == "(" else self.next()
        return self.tokens[start:self.at]

    @staticmethod
    def is_number(token):
        try:
            float(token.rstrip("fFdD"))
        except ValueError:
            return False
        return True

    def closure(self, tokens, names):
        """The definitions that tokens name, those that are named by others first."""
        needed = {}
        for place in references(tokens):
            name = tokens[place]
            body = names.get(name)
            if isinstance(body, list):
                self.referred.add(name)
                needed.update(self.closure(body, names))
                needed[name] = body
        return needed

    def surface(self, attributes):
        names = self.visible()
        definitions = {}
        for kind, tokens in attributes.items():
            definitions.update(self.closure([kind] + tokens, names))
        return Surface(dict(attributes), definitions)

    def mesh(self):
        self.expect("begin", "mesh")
        name = self.next()[1:-1] if self.peek().startswith('"') else ""
        mesh = Mesh(name, [], index=len(self.meshes))
        self.meshes.append(mesh)
        self.mesh_body(mesh, {})
        self.expect("mesh")
        return mesh

    def mesh_body(self, mesh, attributes):
        while True:
            kind = self.next().lower()
            if kind == "end":
                return
            if kind == "begin":
                what = self.next().lower()
                if what in ("vertexs", "vertices"):
                    while self.next().lower() != "end":
                        pass
                    self.next()
                else:
                    self.faces(mesh, attributes)
            else:
                attributes[kind] = self.attribute(kind)

    def faces(self, mesh, attributes):
        current = dict(attributes)
        while self.word() != "end":
            kind = self.word()
            if kind in ATTRIBUTES:
                self.next()
                value = self.attribute(kind)
                if value == ["none"]:
                    current.pop(kind, None)
                else:
                    current[kind] = value
            elif kind == "(":
                self.tuple()
                mesh.surfaces.append(self.surface(current))
            else:
                self.next()  # the number of corners
        self.expect("end", "faces")

    def mesh_light(self):
        self.expect("mesh", "light", "begin")
        mesh = Mesh("", [], "mesh light", index=len(self.meshes))
        self.meshes.append(mesh)
        self.mesh_body(mesh, {})
        for surface in mesh.surfaces:
            surface.attributes = {"light": ["rgb"] + surface.attributes.pop("rgb", tokens_of("(1, 1, 1)"))}
        return mesh

    def light(self):
        self.expect("light", "begin")
        vectors, texts, radiance = [], [], tokens_of("(1, 1, 1)")
        while self.word() != "end":
            if self.peek() == "(":
                start = self.at
                vectors.append(self.numbers())
                texts.append(text_of(self.tokens[start:self.at]))
            else:
                self.next()
                radiance = self.tuple()
        self.expect("end")
        light = Light(*vectors, Surface({"light": ["rgb"] + radiance}), " ".join(texts), len(self.meshes))
        self.meshes.append(light)
        return light

    def transform(self):
        self.expect("transform")
        start, steps = self.at, []
        while self.word() != "begin":
            kind = self.next().lower()
            steps.append((kind, self.numbers()))
        text = text_of(self.tokens[start:self.at])
        self.next()
        body = self.blocks()
        self.expect("end")
        return Transform(steps, text, body)


def references(tokens):
    """The places of words that may be names of definitions."""
    places = []
    for place, token in enumerate(tokens):
        before = tokens[place - 1].lower() if place else ""
        if not IDENTIFIER.match(token) or token.lower() in RESERVED:
            continue
        is_value = before == "=" or before in ATTRIBUTES or Parser.is_number(before)
        if is_value and (place + 1 == len(tokens) or tokens[place + 1] != "="):
            places.append(place)
    return places


def read_scene(text):
    return Parser(text).scene()


def read_surface(definitions, attributes):
    """Reads the texts of a material: lines of `def name = ...`, and attributes of faces."""
    parser = Parser(definitions or "")
    parser.definitions()
    if parser.at != len(parser.tokens):
        raise GrfError(f"'def' was expected in place of '{parser.peek()}'")
    names = parser.scope[-1]
    parser.tokens, parser.at = tokens_of(attributes or ""), 0
    found = {}
    while parser.peek():
        kind = parser.next().lower()
        if kind not in ATTRIBUTES:
            raise GrfError(f"'{kind}' is no attribute of faces: {', '.join(ATTRIBUTES)}")
        found[kind] = parser.attribute(kind)
    return Surface(found, dict(names))


class Definitions:
    """Gathers the definitions of materials for one scope. A name that means something else already gets a number."""

    def __init__(self):
        self.bodies = {}

    def add(self, surface):
        """Adds the definitions of a surface; returns its attributes with the names that these have now."""
        names = {}
        for name, body in surface.definitions.items():
            body = self.renamed(body, names)
            names[name] = self.place(name, body)
        return {kind: self.renamed([kind] + tokens, names)[1:] for kind, tokens in surface.attributes.items()}

    def place(self, name, body):
        count, free = 1, name
        while self.bodies.get(free, body) != body:
            count += 1
            free = f"{name}_{count}"
        self.bodies[free] = body
        return free

    def unique(self, name):
        """A name for a definition of a mesh, which shares the names."""
        return self.place(name, object())

    @staticmethod
    def renamed(tokens, names):
        places = set(references(tokens))
        return [names.get(token, token) if place in places else token for place, token in enumerate(tokens)]
