"""The glossary: every word of the house that it explains is one of the sources."""

from __future__ import annotations

import re
from pathlib import Path

from architecture.sources import SOURCES

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs/reference/glossary.md").read_text(encoding="utf-8")


def terms(page: str) -> list[str]:
    """Return the words of the first columns of all tables."""
    cells = [line.split("|")[1].strip() for line in page.splitlines() if line.startswith("|")]
    return [
        term.strip()
        for cell in cells
        if cell != "here" and not set(cell) <= {"-"}
        for term in cell.split(",")
    ]


def absent(words: list[str]) -> list[str]:
    """Return those that no source has, as a word, part of a name, or words one after another."""
    text = "\n".join(path.read_text(encoding="utf-8") for path in SOURCES)
    return [
        word
        for word in words
        if not re.search(rf"(?<![a-z]){word.replace(' ', '[ _-]+')}(?![a-z])", text, re.IGNORECASE)
    ]


def test_every_word_is_one_of_the_sources() -> None:
    words = terms(PAGE)
    assert {"across", "soft", "rubs", "carries", "leap", "misfit", "island", "kink"} <= set(words)
    assert len(words) > 55
    assert absent(words) == []


def test_a_word_that_is_none_is_found() -> None:
    assert absent(["across", "gadzooks", "band sweep"]) == ["gadzooks"]


def test_the_ways_to_it() -> None:
    for name in ("CONTRIBUTING.md", "docs/index.md"):
        assert "reference/glossary.md" in (ROOT / name).read_text(encoding="utf-8")
