"""Run the presets and write their pictures: `python -m ropewalk.live.thumbnails [NAME...]`."""

from __future__ import annotations

import sys
from pathlib import Path

from ropewalk.live.thumbnails.telling import picture
from ropewalk.scene.presets import names

if __name__ == "__main__":
    for name in sys.argv[1:] or names():
        Path(__file__).with_name(f"{name}.svg").write_text(picture(name) + "\n", "utf-8")
