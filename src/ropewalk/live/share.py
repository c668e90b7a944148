"""A page to share: one HTML file with program and run inside, that needs no server and no network.

Its content-security policy names the one script and the one style sheet by their hashes and allows nothing
else, so that no name in a scene can become code.
"""

from __future__ import annotations

import base64
import hashlib
import html
import json
import re
from pathlib import Path
from typing import Any

from ropewalk.live.packed_run import Recording, record
from ropewalk.record.errors import RunError
from ropewalk.record.files import write, writing
from ropewalk.record.result import Result

FRAME_RATE = 60.0
HERE = Path(__file__).parent / "page"
_PAGE = """<!doctype html>
<html lang="en" data-theme="light">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1, viewport-fit=cover">
<meta name="color-scheme" content="light dark">
<meta name="referrer" content="no-referrer">
<meta name="generator" content="Ropewalk {version}">
<title>{title}</title>
<link rel="icon" href="data:,">
<style>{style}</style>
</head>
<body>
<div id="app" class="app"><noscript>This page needs JavaScript. {about}</noscript></div>
<script type="application/json" id="recording">{header}</script>
<script type="text/plain" id="recording-data">{data}</script>
<script>{script}</script>
</body>
</html>
"""


def share_run(
    folder: Path,
    path: Path,
    *,
    frame_rate: float = FRAME_RATE,
    overwrite: bool = False,
) -> Recording:
    """Write the run in a folder, or a live session with all its parts, as a page; return what is in it.

    Raises RunError when the run has nothing to show, or the page exists or cannot be written.
    """
    return _share(folder, path, frame_rate, overwrite)


def share_result(
    result: Result,
    path: str | Path,
    *,
    frame_rate: float = FRAME_RATE,
    overwrite: bool = False,
) -> Path:
    """Write a result as a page that replays it; return its path. Raises as `share_run`."""
    _share(result, Path(path), frame_rate, overwrite)
    return Path(path)


def _share(run: Path | Result, path: Path, frame_rate: float, overwrite: bool) -> Recording:
    if path.is_dir():
        raise RunError(path, "is a folder; name a file in it")
    if path.exists() and not overwrite:
        raise RunError(path, "exists already; take another name, or allow to overwrite")
    recording = record(run, frame_rate)
    with writing(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        write(path, page(recording).encode())
    return recording


def page(recording: Recording) -> str:
    """Return the page of a recording."""
    script = in_script((HERE / "bundle.js").read_text("utf-8"))
    style = (HERE / "style.css").read_text("utf-8").replace("</style", "<\\/style")
    header = recording.header
    return _PAGE.format(
        policy=policy(script, style),
        version=html.escape(header["ropewalk"]),
        title=html.escape(f"{header['title']} – Ropewalk"),
        style=style,
        about=html.escape(header["about"]),
        header=as_data(header),
        data=base64.b64encode(recording.data).decode(),
        script=script,
    )


def policy(script: str, style: str) -> str:
    return (
        f"default-src 'none'; script-src 'sha256-{_hash(script)}'; "
        f"style-src 'sha256-{_hash(style)}'; img-src data: blob:; base-uri 'none'; form-action 'none'"
    )


def _hash(text: str) -> str:
    return base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def in_script(text: str) -> str:
    """Return a script that HTML cannot end, or take for a comment, half-way."""
    text = re.sub(r"</(script)", r"<\\/\1", text, flags=re.IGNORECASE)
    return text.replace("<!--", "<\\!--").replace("\r\n", "\n").strip()


def as_data(value: Any) -> str:
    """Return JSON in which no markup is left."""
    text = json.dumps(value, allow_nan=False, separators=(",", ":"), ensure_ascii=True)
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")
