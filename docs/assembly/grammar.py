"""The grammar of GRF, grf/grammar.ebnf: its rules as trees, and their railroad diagrams.

A node is ('text', keyword), ('rule', name), ('sequence', nodes), ('choice', nodes), ('optional', node) or
('repeat', node).
"""

import html
import io
import re

TOKENS = ("number", "integer", "string", "word")


def rules_of(text):
    """Returns the tree of each rule by its name, in the order of the text."""
    text = re.sub(r"^#.*\n", "", text, flags=re.MULTILINE)
    tokens = re.findall(r'"[^"]*"|\w+|\S', text)
    rules = {}
    while tokens:
        name, equals = tokens.pop(0), tokens.pop(0)
        assert equals == "=", name
        rules[name] = read_choice(tokens)
        assert tokens.pop(0) == ";", name
    return rules


def read_choice(tokens):
    choices = [read_sequence(tokens)]
    while tokens[0] == "|":
        tokens.pop(0)
        choices.append(read_sequence(tokens))
    return choices[0] if len(choices) == 1 else ("choice", choices)


def read_sequence(tokens):
    nodes = []
    while tokens[0] not in ("|", ";", ")", "]", "}"):
        nodes.append(read_item(tokens))
    return nodes[0] if len(nodes) == 1 else ("sequence", nodes)


def read_item(tokens):
    token = tokens.pop(0)
    for opening, closing, kind in (("(", ")", None), ("[", "]", "optional"), ("{", "}", "repeat")):
        if token == opening:
            node = read_choice(tokens)
            assert tokens.pop(0) == closing
            return (kind, node) if kind else node
    return ("text", token.strip('"')) if token.startswith('"') else ("rule", token)


def item_of(node):
    """Returns a node as an item of a railroad diagram; a rule is a link to its own diagram."""
    import railroad

    kind, value = node
    if kind == "text":
        return railroad.Terminal(value)
    if kind == "rule":
        return railroad.NonTerminal(value, href=None if value in TOKENS else f"#grammar-{value}")
    if kind == "optional":
        return railroad.Optional(item_of(value))
    if kind == "repeat":
        return railroad.ZeroOrMore(item_of(value))
    items = [item_of(one) for one in value]
    return railroad.Choice(0, *items) if kind == "choice" else railroad.Sequence(*items)


def diagram_of(node):
    """Returns the SVG of a rule, without the style that the library brings: the site's own is in granada.css."""
    import railroad

    text = io.StringIO()
    railroad.Diagram(item_of(node), type="complex", css=None).writeSvg(text.write)
    return text.getvalue()


def to_markdown(text):
    """Returns a section with the diagram of each rule."""
    out = "\n## Grammar\n\n" \
        "Rounded boxes are keywords, which are case-insensitive; square boxes are other rules and, in italics, tokens.\n" \
        "White space and comments separate tokens. A test compares these rules with the parser.\n\n"
    for name, node in rules_of(text).items():
        svg = re.sub(r">\n+", ">", diagram_of(node)).strip().replace("\n", " ")
        caption = f"<figcaption>{html.escape(name)}</figcaption>"
        out += f'<figure class="railroad" id="grammar-{name}">{caption}{svg}</figure>\n\n'
    return out
