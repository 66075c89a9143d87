"""MODELS.md becomes a page of the models and one of each model, with its formula in mathematics."""

import re

from assembly import formula

BEGIN, END = "<!-- generated: documents_test -->\n", "<!-- end -->\n"
DOCUMENT = "renderer/MODELS.md"
FOLDER = "reference/models"
LIVE_SCRIPTS = ["models/KEYWORD.js", "brdf_evaluator.js", "brdf_lobe.js", "brdf.js"]


def is_live(info):
    """Returns whether a model is one formula, of which a shader can be made: those have an example."""
    return bool(info["example"])


class Parts:
    """The text before, between and after the models, and the section of each model by its keyword."""

    def __init__(self, before, summary, sections, after, infos):
        self.before, self.summary, self.sections, self.after = before, summary, sections, after
        self.infos = infos


def split(text, infos):
    """Splits the document at the headings of its models."""
    before, rest = text.split(BEGIN)
    generated, after = rest.split(END)
    pieces = re.split(r"^### (\w+): (.*)\n", generated, flags=re.MULTILINE)
    # The list of links to the models is the site's navigation.
    summary = pieces[0].split("\n\n", 1)[1]
    sections = {pieces[i]: (pieces[i + 1], pieces[i + 2]) for i in range(1, len(pieces), 3)}
    return Parts(before, summary, sections, after, {info["keyword"]: info for info in infos})


def slug(heading):
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def anchors_of(parts):
    """Returns where the anchors of the models' headings are now."""
    return {(DOCUMENT, slug(f"{keyword}: {title}")): (f"{FOLDER}/{keyword}", "")
            for keyword, (title, _) in parts.sections.items()}


def with_mathematics(section, info):
    """Replaces the formula, which is a block of indented lines, by mathematics."""
    if not info["formula"]:
        return section
    block = "".join(f"    {line}\n" for line in info["formula"].split("\n"))
    assert block in section, info["keyword"]
    names = [parameter["name"] for parameter in info["parameters"]]
    return section.replace(block, "## Formula\n\n" + formula.to_markdown(info["formula"], names) + "## Parameters\n")


def with_live_part(section):
    """Puts a lobe, a sphere and sliders before the picture, which is there without WebGL, too."""
    scripts = "".join(f'<script src="../../_static/{name}"></script>\n' for name in LIVE_SCRIPTS)
    return section.replace("\n![", f'\n<div id="brdf-live" hidden></div>\n{scripts}\n![', 1)


def model_page(parts, keyword):
    title, section = parts.sections[keyword]
    info = parts.infos[keyword]
    if is_live(info):
        section = with_live_part(section).replace("KEYWORD", keyword)
    return f"# {keyword}: {title}\n{with_mathematics(section, info)}"


def linked_summary(parts):
    """Links the first cell of each row to its model."""
    return re.sub(r"^\| (\w+) \|(?= (?:yes|not always) )",
                  lambda m: f"| [{m[1]}](#{slug(f'{m[1]}: {parts.sections[m[1]][0]}')}) |", parts.summary,
                  flags=re.MULTILINE)


def write_pages(site, page, parts):
    entries = "\n".join(f"/{FOLDER}/{keyword}" for keyword in parts.sections)
    contents = f"```{{toctree}}\n:hidden:\n:maxdepth: 1\n\n{entries}\n```\n"
    text = parts.before + linked_summary(parts) + contents + parts.after
    site.write(page, site.relinked(text, DOCUMENT, page))
    for keyword in parts.sections:
        own = f"{FOLDER}/{keyword}"
        site.write(own, site.relinked(model_page(parts, keyword), DOCUMENT, own))
