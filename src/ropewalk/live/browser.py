"""Opening an address in the browser without showing its token to other users of the computer.

Whoever can list processes can read their command lines, and a browser is started with what it is to open. So
that is a small file that only the user can read, and that leads to the address.
"""

from __future__ import annotations

import html
import os
import platform
import sys
import tempfile
import time
import webbrowser
from pathlib import Path
from threading import Thread

SECONDS = 30.0  # that the file stays for a slow browser
_PAGE = """<!doctype html>
<meta charset="utf-8"><meta name="referrer" content="no-referrer">
<meta http-equiv="refresh" content="0; url={address}">
<title>Ropewalk</title><p><a href="{address}">Open Ropewalk</a>
"""


def open_browser(address: str) -> Thread:
    """Open an address in the user's browser; in a thread, for one in the terminal ends when it is closed."""
    made = Thread(target=_open, args=[address], name="ropewalk-browser", daemon=True)
    made.start()
    return made


def _open(address: str) -> None:
    if not shows_command_lines():
        webbrowser.open(address)
        return
    with tempfile.TemporaryDirectory(prefix="ropewalk-", dir=_readable()) as folder:
        webbrowser.open(leading_file(Path(folder), address).as_uri())
        time.sleep(SECONDS)


def leading_file(folder: Path, address: str) -> Path:
    """Write a page that leads to an address, for the user's eyes only; return its path."""
    path = folder / "open.html"
    with open(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w") as file:
        file.write(_PAGE.format(address=html.escape(address, quote=True)))
    return path


def shows_command_lines() -> bool:
    """Whether other users can see how a browser was started; on Windows, and from its Linux, they cannot."""
    return sys.platform != "win32" and "microsoft" not in platform.release().lower()


def _readable() -> Path | None:
    """Where a browser can read files of ours; None: as usual. Those in snaps have a /tmp of their own."""
    home = Path.home()
    return home if Path("/snap/bin").is_dir() and os.access(home, os.W_OK) else None
