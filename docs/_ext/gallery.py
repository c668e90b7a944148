"""Runs of the gallery: presets run when the site is built, each written as a page to share.

A directive `gallery` has a line for each, `NAME SECONDS: sentence`; the first is shown in the page itself.
"""

from __future__ import annotations

import html
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from docutils import nodes
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

import ropewalk as rw
from ropewalk.live.share import share_run
from ropewalk.scene.presets import preset

FOLDER = "gallery"
MOST_BYTES = 1_100_000  # four fifths of them are the viewer itself


class Gallery(SphinxDirective):
    """The list of runs with links to their pages."""

    has_content = True

    def run(self) -> list[nodes.Node]:
        """Note what is to be run; return the list."""
        rows = []
        for i, line in enumerate(self.content):
            about, text = line.split(":", 1)
            name, seconds = about.split()
            wanted = getattr(self.env, "gallery", {})
            self.env.gallery = {**wanted, name: float(seconds)}  # type: ignore[attr-defined]
            address, title = f"{FOLDER}/{name}.html", html.escape(preset(name).name)
            rows.append(f'<p><a href="{address}"><strong>{title}</strong></a>: {text.strip()}</p>')
            if i == 0:
                rows.append(
                    f'<iframe src="{address}" title="{title}" loading="lazy" '
                    'style="width: 100%; height: 32rem; border: 1px solid #8884"></iframe>'
                )
        return [nodes.raw("", "\n".join(rows), format="html")]


def write_pages(app: Any, error: Exception | None) -> None:
    """Run the presets and write their pages beside the site."""
    if error is not None or app.builder.format != "html":
        return
    folder = Path(app.outdir) / FOLDER
    for name, seconds in getattr(app.env, "gallery", {}).items():
        scene = preset(name)
        path = folder / f"{name}.html"
        with TemporaryDirectory() as made:
            run = Path(made) / "run"
            with suppress(rw.Broken):  # one that breaks is shown up to there
                rw.run(scene.replace(run=scene.run.replace(duration=seconds)), run)
            share_run(run, path, overwrite=True)
        if path.stat().st_size > MOST_BYTES:
            raise ExtensionError(f"{path} is larger than {MOST_BYTES} bytes; run {name} shorter")


def setup(app: Any) -> dict[str, bool]:
    """Add the directive and the end of the build."""
    app.add_directive("gallery", Gallery)
    app.connect("build-finished", write_pages)
    return {"parallel_read_safe": False}
