"""The lab's page with the scenes of the lessons, written when the site is built.

A role `lab` with a scene's name is a link into it.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.errors import ExtensionError

from ropewalk.lessons import NAMES, lesson_scene, lesson_scenes
from ropewalk.live.lab import write_lab

PAGE = "lab.html"


def lab_link(
    name: str, rawtext: str, text: str, lineno: int, inliner: Any, *_: Any
) -> tuple[list[nodes.Node], list[nodes.system_message]]:
    """Return a link to the lab's page with a scene chosen."""
    if text not in NAMES:
        raise ExtensionError(f"no lesson has a scene {text!r}; there are {', '.join(NAMES)}")
    title = lesson_scene(text).name
    link = nodes.reference(
        rawtext, f"lab, scene {title}", refuri=f"{PAGE}#{title.replace(' ', '%20')}"
    )
    return [link], []


def write_page(app: Any, error: Exception | None) -> None:
    """Write the lab's page beside the lessons."""
    if error is None and app.builder.format == "html":
        write_lab(Path(app.outdir) / "teach" / PAGE, lesson_scenes())


def setup(app: Any) -> dict[str, bool]:
    """Add the role and the end of the build."""
    app.add_role("lab", lab_link)
    app.connect("build-finished", write_page)
    return {"parallel_read_safe": True}
