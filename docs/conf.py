"""Settings of the documentation site."""

from __future__ import annotations

import sys
from importlib.metadata import version as version_of
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "_ext"))

project = "Ropewalk"
author = "The Ropewalk authors"
copyright = "The Ropewalk authors, MIT licence"
version = release = version_of("ropewalk")

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.mathjax", "sphinx.ext.napoleon", "tables"]
exclude_patterns = ["_build", "images/*.py"]
source_suffix = {".md": "markdown"}
root_doc = "index"

myst_enable_extensions = ["amsmath", "deflist", "dollarmath", "fieldlist"]
myst_heading_anchors = 3

html_theme = "furo"
html_title = "Ropewalk"
html_static_path: list[str] = []
html_copy_source = False

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_preserve_defaults = True
napoleon_google_docstring = True
napoleon_use_ivar = True

# Every link inside the site must lead somewhere; types of other packages have no page here.
nitpicky = True
nitpick_ignore_regex = [(r"py:.*", r".*")]
