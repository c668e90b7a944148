"""The page of the live view: what is shipped, and budgets of its sources."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SHIPPED = ROOT / "src/ropewalk/live/page"
SOURCES = sorted((ROOT / "page").glob("src/**/*.*")) + sorted((ROOT / "page").glob("test/*.js"))
LINES, WIDTH = 400, 120


def breaches(html: str) -> list[str]:
    """Name what a content-security policy without inline code would refuse in a page."""
    found = re.findall(
        r"<script(?![^>]*\bsrc=)[^>]*>|<style|\sstyle=|\son[a-z]+=|javascript:", html
    )
    return [text.strip() for text in found]


def test_the_page_is_shipped_with_its_licences() -> None:
    names = {path.name for path in SHIPPED.iterdir()}
    assert {"index.html", "bundle.js", "style.css", "LICENSES.txt"} <= names
    licences = (SHIPPED / "LICENSES.txt").read_text(encoding="utf-8")
    for name in json.loads((ROOT / "page/package.json").read_text())["dependencies"]:
        assert re.search(rf"^{name} \d", licences, re.MULTILINE)
    assert licences.count("Permission is hereby granted") == 3


def test_the_page_has_no_inline_code() -> None:
    assert breaches((SHIPPED / "index.html").read_text(encoding="utf-8")) == []
    assert breaches('<p style="x">') == ["style="]
    assert breaches("<script>x</script>") == ["<script>"]
    assert breaches('<script src="bundle.js"></script>') == []


def test_the_page_loads_nothing_from_elsewhere() -> None:
    style = (SHIPPED / "style.css").read_text(encoding="utf-8")
    assert re.findall(r"@import|url\((?!data:)", style) == []
    assert "@font-face" not in style  # the policy allows no fonts
    html = (SHIPPED / "index.html").read_text(encoding="utf-8")
    assert re.findall(r"""(?:src|href)=["'](?:https?:)?//""", html) == []


def test_the_lock_file_names_no_addresses() -> None:
    lock = (ROOT / "page/package-lock.json").read_text(encoding="utf-8")
    assert '"integrity"' in lock
    assert '"resolved"' not in lock
    package = json.loads((ROOT / "page/package.json").read_text())
    versions = {**package["dependencies"], **package["devDependencies"]}
    assert all(re.fullmatch(r"\d+\.\d+\.\d+", version) for version in versions.values())


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_source_files_of_the_page_keep_their_budget(path: Path) -> None:
    lines = path.read_text(encoding="utf-8").splitlines()
    assert len(lines) <= LINES
    assert [i for i, line in enumerate(lines, 1) if len(line) > WIDTH] == []
