"""Documents of the tree become pages of the site: links between them are rewritten, and what they link to follows."""

import os
import pathlib
import re

PICTURES = {".png", ".svg", ".jpg"}
LANGUAGES = {".cpp": "cpp", ".h": "cpp", ".glsl": "glsl", ".py": "python", ".cmake": "cmake", ".json": "json"}
LINK = re.compile(r"(!?\[(?:[^\[\]]|\[[^\]]*\])*\]\()([^)\s]+)(\))")


class LinkError(Exception):
    """A document links to something that does not exist."""


class Site:
    """The source folder of the site, with the pages that documents of the tree become."""

    def __init__(self, tree, folder, page_of):
        self.tree = pathlib.Path(tree)
        self.folder = pathlib.Path(folder)
        self.page_of = dict(page_of)  # the page's name by the document's path in the tree
        self.anchors = {}  # (document, anchor) -> (page, anchor), where a section moved to a page of its own
        self.code = set()  # files of the tree that pages show as listings
        self.written = set()
        self.has_other_pages = False  # than the run before

    def write(self, page, text):
        """Writes the text of a page, and leaves it alone if it is the same: Sphinx then does nothing either."""
        path = self.folder / f"{page}.md"
        self.written.add(path)
        path.parent.mkdir(parents=True, exist_ok=True)
        self.has_other_pages |= not path.exists()
        if not path.exists() or path.read_text() != text:
            path.write_text(text)

    def read(self, document):
        return (self.tree / document).read_text()

    def relinked(self, text, document, page):
        """Returns the text of a document with its links as they are seen from the page."""
        out, prose, fence = [], [], None
        for line in text.split("\n") + ["```"]:
            mark = re.match(r"\s*(```+|~~~+)", line)
            if mark is None:
                (prose if fence is None else out).append(line)
            elif fence is None:
                # A link may begin on one line and end on the next.
                out += [self._relinked(prose, document, page), line]
                prose, fence = [], mark.group(1)
            else:
                out.append(line)
                fence = None if line.strip() == fence else fence
        return "\n".join(out[:-1])

    def _relinked(self, lines, document, page):
        return LINK.sub(lambda m: m.group(1) + self.target(m.group(2), document, page) + m.group(3), "\n".join(lines))

    def target(self, link, document, page):
        """Returns where a link of the document leads, seen from the page."""
        if re.match(r"[a-z]+:", link):
            return link
        path, _, anchor = link.partition("#")
        here = pathlib.PurePosixPath(document).parent
        wanted = os.path.normpath(here / path) if path else document
        if (wanted, anchor) in self.anchors:
            other, anchor = self.anchors[wanted, anchor]
        elif wanted in self.page_of:
            other = self.page_of[wanted]
        elif f"{wanted}/README.md" in self.page_of:
            other = self.page_of[f"{wanted}/README.md"]
        else:
            return self._file(wanted, link, document, page)
        if other == page and anchor:
            return f"#{anchor}"
        relative = os.path.relpath(f"{other}.md", os.path.dirname(page) or ".")
        return f"{relative}#{anchor}" if anchor else relative

    def _file(self, wanted, link, document, page):
        source = self.tree / wanted
        if not source.exists():
            raise LinkError(f"{document}: the link to {link} leads nowhere")
        if source.is_dir():
            raise LinkError(f"{document}: the link to {link} leads to a folder without a document")
        if source.suffix in PICTURES:
            copy = self.folder / "files" / wanted
            copy.parent.mkdir(parents=True, exist_ok=True)
            if not copy.is_symlink():
                copy.symlink_to(source.resolve())
            return os.path.relpath(f"files/{wanted}", os.path.dirname(page) or ".")
        self.code.add(wanted)
        return os.path.relpath(f"code/{wanted}.md", os.path.dirname(page) or ".")

    def write_listings(self):
        """Writes a page for each file of the tree that others link to."""
        for path in sorted(self.code):
            text = self.read(path)
            fence = "~" * (max([2] + [len(run) for run in re.findall("~+", text)]) + 1)
            language = LANGUAGES.get(pathlib.PurePosixPath(path).suffix, "text")
            head = "---\norphan: true\nnosearch: true\n---\n"
            self.write(f"code/{path}", f"{head}\n# `{path}`\n\n{fence}{language}\n{text.rstrip()}\n{fence}\n")

    def remove_others(self):
        """Removes pages of an earlier run that no longer exist."""
        for path in self.folder.rglob("*.md"):
            if path not in self.written:
                path.unlink()
                self.has_other_pages = True


def with_contents(text, pages, depth=2):
    """Appends a page's list of the pages below it, which the site's navigation shows."""
    if not pages:
        return text
    entries = "\n".join(f"/{page}" for page in pages)
    return f"{text.rstrip()}\n\n```{{toctree}}\n:hidden:\n:maxdepth: {depth}\n\n{entries}\n```\n"
