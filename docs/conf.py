"""Sphinx's settings for the documentation that docs/make_docs puts together."""

import os

project = "Granada"
author = "the Granada authors"
copyright = "2026 the Granada authors"
release = version = os.environ["GRANADA_VERSION"]

extensions = ["myst_parser", "sphinx_copybutton"]
myst_enable_extensions = ["dollarmath", "deflist", "colon_fence", "attrs_image"]
myst_heading_anchors = 4
myst_dmath_allow_labels = False
# A level of headings may be left out: the model's pages are sections of one document.
suppress_warnings = ["myst.header"]
source_suffix = {".md": "markdown"}
exclude_patterns = ["files"]
# The prompt of commands is not copied.
copybutton_prompt_text = "$ "
highlight_language = "text"
pygments_style = "friendly"
pygments_dark_style = "native"

html_theme = "furo"
html_title = "Granada"
html_static_path = ["theme"]
html_css_files = ["katex/katex.min.css", "granada.css"]
html_js_files = ["katex/katex.min.js", "mathematics.js"]
html_show_sphinx = False
html_copy_source = False
html_theme_options = {
    "light_css_variables": {
        "color-brand-primary": "#a8431f",
        "color-brand-content": "#a8431f",
        "font-stack": "Inter, 'Source Sans 3', 'Segoe UI', Roboto, 'DejaVu Sans', system-ui, sans-serif",
        "font-stack--monospace": "'JetBrains Mono', 'Source Code Pro', 'DejaVu Sans Mono', ui-monospace, monospace",
    },
    # All of them: Debian's Furo has lost its colours for systems that are set to dark.
    "dark_css_variables": {
        "color-brand-primary": "#f0a27f",
        "color-brand-content": "#f0a27f",
        "color-problematic": "#ee5151",
        "color-foreground-primary": "#e6e6e6",
        "color-foreground-secondary": "#a4a8ad",
        "color-foreground-muted": "#868b92",
        "color-foreground-border": "#5c6066",
        "color-background-primary": "#141517",
        "color-background-secondary": "#1b1d20",
        "color-background-hover": "#22252a",
        "color-background-hover--transparent": "#22252a00",
        "color-background-border": "#32363a",
        "color-background-item": "#444444",
        "color-highlighted-background": "#083563",
        "color-highlight-on-target": "#3a3312",
        "color-admonition-background": "#18181a",
        "color-card-background": "#18181a",
        "color-card-marginals-background": "#22252a",
    },
}


def as_katex(is_block):
    """KaTeX, which is part of the site, sets mathematics in the browser: theme/mathematics.js."""

    def visit(self, node):
        from docutils.nodes import SkipNode

        tag = "div" if is_block else "span"
        self.body.append(self.starttag(node, tag, "", CLASS="math").rstrip("\n") + self.encode(node.astext()) + f"</{tag}>")
        raise SkipNode

    return visit, None


def setup(app):
    app.add_html_math_renderer("katex", as_katex(False), as_katex(True))
    app.config.html_math_renderer = "katex"
