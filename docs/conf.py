"""Settings of the documentation site."""

from __future__ import annotations

import sys
from importlib.metadata import version as version_of
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parent / "_ext"))

project = "Ropewalk"
author = "The Ropewalk authors"
copyright = "The Ropewalk authors, MIT licence"
version = release = version_of("ropewalk")

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.mathjax",
    "sphinx.ext.napoleon",
    "sphinx-mathjax-offline",  # formulas can be read without a network
    "gallery",
    "lessons",
    "tables",
]
exclude_patterns = ["_build", "images/*.py"]
source_suffix = {".md": "markdown"}
root_doc = "index"

myst_enable_extensions = ["amsmath", "deflist", "dollarmath", "fieldlist"]
myst_heading_anchors = 3

html_theme = "furo"
html_title = "Ropewalk"
html_static_path = ["_static"]
html_css_files = ["site.css", "print.css"]
html_copy_source = False

autodoc_member_order = "bysource"
autodoc_typehints = "none"  # docstrings give units and shapes, which types do not
autodoc_preserve_defaults = True
napoleon_google_docstring = True
napoleon_use_ivar = True

# Every link inside the site must lead somewhere; types of other packages have no page here.
nitpicky = True
nitpick_ignore_regex = [(r"py:.*", r".*")]
default_role = "code"  # docstrings write names as `name`


_COLON = "\ue000"  # a character of no meaning


def hide_colons(app: Any, what: str, name: str, thing: Any, options: Any, lines: list[str]) -> None:
    """Keep napoleon from taking what stands before a property's first colon for its type."""
    if what in ("attribute", "property"):
        lines[:] = [line.replace(":", _COLON) for line in lines]


def show_colons(app: Any, what: str, name: str, thing: Any, options: Any, lines: list[str]) -> None:
    """Put the colons back."""
    lines[:] = [line.replace(_COLON, ":") for line in lines]


def setup(app: Any) -> None:
    """Stand on both sides of napoleon, whose priority is 500."""
    app.connect("autodoc-process-docstring", hide_colons, priority=400)
    app.connect("autodoc-process-docstring", show_colons, priority=600)
