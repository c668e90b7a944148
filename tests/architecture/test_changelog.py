"""The changelog is a first release's: what there is, by area, each line with a way to what it tells of."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from ropewalk import library
from ropewalk.plots import PLOTS
from ropewalk.record.store import FORMAT, READABLE
from ropewalk.scene.presets import names as presets

ROOT = Path(__file__).resolve().parents[2]
TEXT = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
LONGEST_TEXT = 30_000  # bytes; beyond that it is no list any more that somebody reads
LONGEST_LINE = 480  # characters, links included
LINK = re.compile(r"\]\(([^)#\s]*)(?:#([^)\s]+))?\)")


def slug(heading: str) -> str:
    """Return the anchor that a heading of Markdown has."""
    words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", words).replace(" ", "-")


def dead_links(text: str) -> list[str]:
    """Return the links whose file, or heading in it, is not there."""
    dead = []
    for name, anchor in LINK.findall(text):
        if name.startswith("http"):
            continue
        path = ROOT / name
        if not path.is_file():
            dead.append(name)
        elif anchor:
            page = path.read_text(encoding="utf-8")
            headings = re.findall(r"^#+ (.+)$", page, re.MULTILINE)
            if anchor not in map(slug, headings):
                dead.append(f"{name}#{anchor}")
    return dead


def test_it_can_be_read() -> None:
    assert len(TEXT.encode()) < LONGEST_TEXT
    assert [line[:60] for line in TEXT.splitlines() if len(line) > LONGEST_LINE] == []
    areas = re.findall(r"^#### (.+)$", TEXT, re.MULTILINE)
    assert len(areas) == len(set(areas)) > 10


def without_area(text: str) -> list[str]:
    """Return the lines under `### Added` that stand above its first area."""
    added = text.partition("### Added\n")[2].partition("\n#")[0]
    return [line for line in added.splitlines() if line]


def test_every_line_is_under_its_area() -> None:
    assert without_area(TEXT) == []


def test_a_line_without_an_area_is_found() -> None:
    assert without_area("### Added\n\n* A thing.\n\n#### Area\n\n* Another.\n") == ["* A thing."]


def test_links_lead_somewhere() -> None:
    assert len(LINK.findall(TEXT)) > 60
    assert dead_links(TEXT) == []


def test_a_dead_link_is_found() -> None:
    text = "[a](README.md) [b](README.md#nowhere) [c](docs/none.md) [d](README.md#three-commands)"
    assert dead_links(text) == ["README.md#nowhere", "docs/none.md"]


@pytest.mark.parametrize(
    "words",
    [
        f"\n* {len(presets())} [presets]",
        f"[library](docs/how-to/ropes.md) of {len(library.names())} ropes",
        f"\n* {['Nine', 'Ten', 'Eleven', 'Twelve'][len(PLOTS) - 9]} [figures]",
        f"formats {READABLE[0]} to {READABLE[-2]}]",
        f"The format is {FORMAT}.",
    ],
)
def test_its_numbers_are_those_of_the_code(words: str) -> None:
    assert words in TEXT
